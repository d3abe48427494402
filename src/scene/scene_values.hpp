#pragma once

#include <vector>

#include "scene/condition.hpp"

namespace bempd::scene {

// Values of all supports and of all loads, in the order of their ids.
struct SceneValues {
  std::vector<Values> supports, loads;
};

// Whether a condition with the values `other` can get the values `one`. Values at places fit always; samples fit unless
// `other` has another number of samples; a function fits if it is not null and `other` has no samples. Removed
// conditions have empty samples, which fit empty samples only.
bool are_alike(const Values& one, const Values& other);

// Zero values, as of a body at rest, with the same numbers of samples and the same places as `like`.
SceneValues at_rest(const SceneValues& like);

// Values that change linearly from `start` at the load factor `from` to `end` at the load factor `to`. Both must belong
// to the same supports and loads.
SceneValues line_between(const SceneValues& start, double from, const SceneValues& end, double to);

}  // namespace bempd::scene

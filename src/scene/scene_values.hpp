#pragma once

#include <vector>

#include "scene/condition.hpp"

namespace bempd::scene {

// Values of all supports and loads, in their order.
struct SceneValues {
  std::vector<Values> supports, loads;
};

// Whether values of one condition can be those of another one: as many samples as there are, or a function that is
// known, or values at places.
bool are_alike(const Values& one, const Values& other);

// Zero values of a body at rest, in the form of the given ones.
SceneValues at_rest(const SceneValues& like);

// Values that go linearly from `start` at one load factor to `end` at another one. Both belong to the same supports and
// loads.
SceneValues line_between(const SceneValues& start, double from, const SceneValues& end, double to);

}  // namespace bempd::scene

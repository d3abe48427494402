#pragma once

#include "scene/scene_values.hpp"

namespace bempd::scene {

// Values for a load factor that is counted from `load_factor` on: the proportional part at `load_factor` is added to
// the constant part.
SceneValues moved(const SceneValues& values, double load_factor);

// Values fixed at what they are at a load factor: constant parts only, proportional parts 0.
Values fixed_at(const Values& values, double load_factor);
SceneValues fixed_at(const SceneValues& values, double load_factor);

}  // namespace bempd::scene

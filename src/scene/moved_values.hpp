#pragma once

#include "scene/scene_values.hpp"

namespace bempd::scene {

// Values for a load factor that is counted from `load_factor` on: the proportional part at `load_factor` is added to
// the constant part.
SceneValues moved(const SceneValues& values, double load_factor);

}  // namespace bempd::scene

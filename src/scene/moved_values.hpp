#pragma once

#include "scene/scene_values.hpp"

namespace bempd::scene {

// Values of which the origin of the load factor is moved to `load_factor`.
SceneValues moved(const SceneValues& values, double load_factor);

}  // namespace bempd::scene

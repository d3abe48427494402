#pragma once

#include "scene/scene_values.hpp"

namespace bempd::scene {

// The same values with the origin of the load factor moved to `load_factor`.
SceneValues moved(const SceneValues& values, double load_factor);

}  // namespace bempd::scene

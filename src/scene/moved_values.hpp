#pragma once

#include "scene/scene_values.hpp"

namespace bempd::scene {

// Values for a load factor that counts from `load_factor` on: the proportional part there joins the constant part.
SceneValues moved(const SceneValues& values, double load_factor);

}  // namespace bempd::scene

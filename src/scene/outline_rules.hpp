#pragma once

#include <vector>

#include "geometry/outline.hpp"

namespace bempd::scene {

// Throws Error (argument) for coordinates that are not numbers; `what` names one of the points.
void require_points(const std::vector<Point>& points, const char* what);

// Throws Error (argument) for an outline that crosses itself, is turned the wrong way, and the like.
void require_sound(const Outline& outline);

}  // namespace bempd::scene

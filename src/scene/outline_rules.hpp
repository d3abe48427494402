#pragma once

#include <string>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd::scene {

// "(x, y)" for sentences.
std::string place_of(const Point& p);

// Throws Error (argument) for coordinates that are not numbers; `what` names one of the points.
void require_points(const std::vector<Point>& points, const char* what);

// Throws Error (argument) for an outline that crosses itself, has the wrong orientation, or has another defect.
void require_sound(const Outline& outline);

// Throws Error (argument) unless centre and radius make a circle.
void require_circle(const Point& centre, double radius);

// Appends a loop of edges, which are straight where bulges are not given or 0, else arcs. A bulge is the tangent of a
// quarter of the angle that the arc turns, counter-clockwise positive (as in DXF files). Throws Error (argument) for
// bulges that are not finite.
void append_loop(Outline& outline, const std::vector<Point>& vertices, const std::vector<double>& bulges);

// Appends a loop of four quarter circles, the first of which begins at the place with the largest x.
void append_circle(Outline& outline, const Point& centre, double radius, bool clockwise);

}  // namespace bempd::scene

#pragma once

#include <string>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd::scene {

// Coordinates as the text "(x, y)", for use in messages.
std::string place_of(const Point& p);

// Throws Error (argument) if a coordinate is not a finite number; `what` names one of the points in the message.
void require_points(const std::vector<Point>& points, const char* what);

// Throws Error (argument) for an outline that crosses itself, has the wrong orientation, or has another defect.
void require_sound(const Outline& outline);

// Throws Error (argument) unless the centre is finite and the radius finite and positive.
void require_circle(const Point& centre, double radius);

// Appends a loop of edges: arcs where a bulge is given that is not 0, else straight edges. A bulge is the tangent of a
// quarter of the angle by which the arc turns, positive counter-clockwise (as in DXF files). Throws Error (argument)
// for bulges that are not finite.
void append_loop(Outline& outline, const std::vector<Point>& vertices, const std::vector<double>& bulges);

// Appends a circle as a loop of four quarter arcs, the first of which begins at the place with the largest x.
void append_circle(Outline& outline, const Point& centre, double radius, bool clockwise);

}  // namespace bempd::scene

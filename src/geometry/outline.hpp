#pragma once

#include <map>
#include <vector>

#include "geometry/edge.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Body bounded by closed loops of edges. loops[0] is the outer loop, counter-clockwise; the other loops are holes,
// clockwise, so that every edge has the body on its left. Vertices and edges are numbered through all loops; edge k
// starts at vertex k.
struct Outline {
  std::vector<std::vector<Point>> loops;
  std::map<int, Edge> curved{};  // edges that are not straight, by number from 0

  Edge edge(int number) const;
};

// Edges of the outline in order, numbered through all loops.
std::vector<Edge> edges_of(const Outline& outline);

Box bounding_box(const Outline& outline);

// Geometric tolerance, below which two places count as one: 1e-9 of the box's diagonal, but never less than the
// rounding of the coordinates themselves (which matters for small bodies far from the origin).
double geometric_tolerance(const Box& box);

// Area inside a loop of edges, positive if the loop is counter-clockwise.
double signed_area(const std::vector<Edge>& loop);

// Area of the body without its holes.
double area(const Outline& outline);

enum class Location { inside, on_boundary, outside };

// Location of the point `p` with respect to a body; points closer to an edge than `tolerance` are on the boundary.
// `boundary` has all edges of the body in any order.
Location locate(const std::vector<Edge>& boundary, const Point& p, double tolerance);
Location locate(const Outline& outline, const Point& p, double tolerance);

}  // namespace bempd

#pragma once

#include <vector>

#include "scene/region.hpp"

namespace bempd::scene {

// Changes to the shape of a described region: holes, curves in place of straight edges, and the elements of edges. Each
// call throws Error (argument) for an edge that the region does not have, and for a shape that the region cannot have.
class RegionShape {
 public:
  RegionShape(Region& region, int id) : region_(region), id_(id) {}

  // Adds a hole and returns the number of its first edge.
  int add_hole(const std::vector<Point>& vertices, const std::vector<double>& bulges = {});
  int add_circular_hole(const Point& centre, double radius);
  // Makes the edge a circular arc through the place `between`.
  void set_arc(int edge, const Point& between);
  // Makes the edge a circular arc about `centre`; both ends of the edge must have the distance `radius` from it.
  void set_arc_about(int edge, const Point& centre, double radius, bool clockwise);
  // Makes the edges first_edge .. last_edge of one loop a smooth curve through their vertices.
  void set_smooth(int first_edge, int last_edge);
  void set_mesh(int edge, const EdgeMesh& mesh);

 private:
  void require_edge_to_bend(int edge) const;

  Region& region_;
  int id_;
};

}  // namespace bempd::scene

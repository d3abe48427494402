#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "elasticity/crack_tip_field.hpp"
#include "geometry/point.hpp"

namespace bempd::regions {

// Crack behind a tip that may bend, in the axes of the tip, which is their origin.
//
// Fields about the tip (Williams' terms) have no tractions on the straight line behind it. Here their angle jumps at
// the crack itself instead, so that they have tractions on the bent part of its faces.
class BentCrack {
 public:
  // `path` ends at the tip. Only what lies within `radius` of the tip counts.
  BentCrack(const std::vector<Point>& path, double radius);

  // Polar coordinates of a place about a centre on the tip's line. The angle does not jump between places on the same
  // side of the crack.
  TipPolar polar(const Point& place, const Point& centre) const;

  // Short part of a face with the nodes beside it. Their displacements times these shares give that of its middle, if
  // displacements are linear in the place.
  struct Part {
    Point middle, area;                          // `area`: outward normal of the material times the length
    bool is_left;                                // of the crack
    std::vector<std::pair<int, double>> shares;  // by index of the node
  };
  // Divides the bent parts of both faces into short ones. `nodes` are places in the axes of the tip.
  // A part beside which no node is seen has no material and is left out.
  void divide(const std::vector<Point>& nodes, double spacing);
  const std::vector<Part>& parts() const { return parts_; }
  // Calls add(node, force) with the nodal forces, per unit of thickness, of the tractions of a field about a centre.
  void add_forces(const CrackTipField& field, const Point& centre,
                  const std::function<void(int node, const Point& force)>& add) const;

 private:
  bool is_beside_line(const Point& place) const;
  void add_part(const Part& part, const std::vector<Point>& nodes, double spacing);

  std::vector<Point> path_;    // from the tip on
  std::vector<Point> beside_;  // corners of the area between the crack and the tip's line
  std::vector<Part> parts_;
};

}  // namespace bempd::regions

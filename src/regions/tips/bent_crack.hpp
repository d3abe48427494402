#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "elasticity/crack_tip_field.hpp"
#include "geometry/point.hpp"

namespace bempd::regions {

// Crack that may bend behind its tip, in coordinates with the origin at the tip and the x axis pointing ahead.
//
// The fields of Williams' expansion about a tip have no tractions on the straight line behind the tip, where their
// angle jumps. In this class the angle jumps at the bent crack instead, so that the fields have tractions on the bent
// parts of the crack's faces.
class BentCrack {
 public:
  // Takes the crack's polyline `path`, which ends at the tip, as far as about three times `radius` from the tip.
  BentCrack(const std::vector<Point>& path, double radius);

  // Polar coordinates of a place about a centre on the straight line through the tip. The angle does not jump between
  // places on the same side of the crack.
  TipPolar polar(const Point& place, const Point& centre) const;

  // Short part of a crack face, and the nodes beside it. The sum of the nodes' displacements times `shares` is the
  // displacement at the middle of the part, exactly if displacements are linear in the place.
  struct Part {
    Point middle, area;                          // `area`: outward normal of the material times the part's length
    bool is_left;                                // whether the part is on the crack's left face
    std::vector<std::pair<int, double>> shares;  // node (an index) and its share
  };
  // Divides the bent parts of both crack faces into short parts. `nodes` are the places of nodes in the coordinates of
  // the tip. A part from which no node can be seen has no material beside it and is left out.
  void divide(const std::vector<Point>& nodes, double spacing);
  const std::vector<Part>& parts() const { return parts_; }
  // Calls add(node, force) with the nodal forces, per unit of thickness, of the tractions that a field about a centre
  // has on the bent parts of the crack's faces.
  void add_forces(const CrackTipField& field, const Point& centre,
                  const std::function<void(int node, const Point& force)>& add) const;

 private:
  bool is_beside_line(const Point& place) const;
  void add_part(const Part& part, const std::vector<Point>& nodes, double spacing);

  std::vector<Point> path_;    // the crack from the tip on
  std::vector<Point> beside_;  // corners of the area between the crack and the straight line behind the tip
  std::vector<Part> parts_;
};

}  // namespace bempd::regions

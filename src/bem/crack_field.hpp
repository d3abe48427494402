#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bem/cracked_operator.hpp"

namespace bempd::bem {

// Displacement and stress inside a body on account of the openings of its cracks: the double layer over every element,
// in closed form close to it, so that it is as exact beside the crack as elsewhere and jumps by the opening across it.
// On a crack itself the values are those of its left face, or of the right one if that is chosen. In lengths over
// `boundary.length` and stresses over the shear modulus.
class CrackField {
 public:
  // `openings` [m], all of them.
  CrackField(const ScaledBoundary& boundary, const CrackMesh& cracks, double nu, const Eigen::VectorXd& openings);

  void look_from_right(bool right) { from_right_ = right; }

  struct Value {
    Point displacement = Point::Zero();
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();  // xx, yy, xy; infinite at a tip
  };
  // Without one element if that is named.
  Value at(const Point& x, int skipped = -1) const;

  // As at(), also at ends of elements, where the sums of closed forms lose all digits: the means of displacements right
  // beside them, and of stresses inside the elements that meet, whose openings bend there.
  Value anywhere(const Point& x) const;

  // Distance of the nearest tip over the length of its element.
  double nearness_of_tip(const Point& x) const;

 private:
  // Along its own axis from 0 to 1 the opening, in components along the axis and to the left of it, is
  // sum of terms[k] s^k, or sigma (terms[0] + terms[1] sigma^2) with s = sigma^2 at a tip.
  struct Piece {
    Point start, axis;  // unit vector
    double length;
    bool tip, reversed;
    std::array<Point, 3> terms;
  };

  void add(const Piece& piece, const Point& x, Value& value) const;

  double nu_;
  bool from_right_ = false;
  std::vector<Piece> pieces_;
};

}  // namespace bempd::bem

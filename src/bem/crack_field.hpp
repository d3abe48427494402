#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bem/cracked_operator.hpp"

namespace bempd::bem {

// Displacement and stress inside a body due to the openings of its cracks: the double layer over every crack element,
// in closed form near the element. The field is as exact beside the crack as elsewhere, and jumps by the opening across
// it. A point on a crack gets the values of the left face, or of the right one after choose_right_face(). Lengths are
// in units of `boundary.length`, stresses in units of the shear modulus.
class CrackField {
 public:
  // Prepares the field of `openings` [m], which has all opening nodes, 2 * node + component; `nu` is the effective
  // Poisson's ratio.
  CrackField(const ScaledBoundary& boundary, const CrackMesh& cracks, double nu, const Eigen::VectorXd& openings);

  void choose_right_face(bool right) { right_face_ = right; }

  struct Value {
    Point displacement = Point::Zero();
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();  // xx, yy, xy; infinite at a tip
  };
  // Displacement and stress at x due to all crack elements, or to all but element `skipped`.
  Value at(const Point& x, int skipped = -1) const;

  // Displacement and stress at x, also at ends of elements, where terms of at() that are infinite should cancel but do
  // not. At an end the displacement is the mean of those close to it, and the stress the mean of those inside the
  // elements that meet, whose openings have a kink there.
  Value anywhere(const Point& x) const;

  // Distance from x to the tip that is nearest in units of its element's length, in these units; infinite without tips.
  double nearness_of_tip(const Point& x) const;

 private:
  // Crack element with its opening, in components along the axis and to the left of it: the sum of terms[k] s^k with 0
  // <= s <= 1. At a tip it is sigma (terms[0] + terms[1] sigma^2), where s = sigma^2 is the distance from the tip.
  struct Piece {
    Point start, axis;  // unit vector
    double length;
    bool tip, reversed;
    std::array<Point, 3> terms;
  };

  void add(const Piece& piece, const Point& x, Value& value) const;

  double nu_;
  bool right_face_ = false;
  std::vector<Piece> pieces_;
};

}  // namespace bempd::bem

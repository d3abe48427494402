#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bem/cracked_operator.hpp"

namespace bempd::bem {

// Displacement and stress inside a body due to the openings of its cracks: the double layer over every crack element,
// in closed form near the element. The field is as exact beside a crack as elsewhere, and jumps by the opening across
// the crack. A point on a crack gets the values of the left face, or of the right face after choose_right_face().
// Lengths are in units of `boundary.length`, stresses in units of the shear modulus.
class CrackField {
 public:
  // Prepares the field of `openings` [m], numbered 2 * node + component over all opening nodes; `nu` is the effective
  // Poisson's ratio.
  CrackField(const ScaledBoundary& boundary, const CrackMesh& cracks, double nu, const Eigen::VectorXd& openings);

  void choose_right_face(bool right) { right_face_ = right; }

  struct Value {
    Point displacement = Point::Zero();
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();  // xx, yy, xy; infinite at a tip
  };
  // Displacement and stress at x due to all crack elements, or to all but element `skipped`.
  Value at(const Point& x, int skipped = -1) const;

  // Displacement and stress at x, also at ends of elements, where at() sums infinite terms that cancel only in exact
  // arithmetic. At such an end the displacement is the mean of the values just inside the elements that meet there. The
  // stress is the mean of the values a little further inside, because the openings have a kink at the end.
  Value anywhere(const Point& x) const;

  // Distance from x to a tip over the length of that tip's element, the smallest of all tips; infinite without tips.
  double nearness_of_tip(const Point& x) const;

 private:
  // Crack element with the components of its opening along its axis and to the left of the axis. With the fraction 0 <=
  // s <= 1 of the length from `start`, the opening is the sum of terms[k] s^k. If the start is a tip, the opening is
  // sigma (terms[0] + terms[1] sigma^2) with s = sigma^2.
  struct Piece {
    Point start, axis;  // `axis` is a unit vector
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

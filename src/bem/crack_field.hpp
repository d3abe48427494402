#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bem/cracked_operator.hpp"

namespace bempd::bem {

// Displacement and stress inside a body that the openings of its cracks cause: the double layer over every crack
// element, in closed form close to it. The field is as exact beside the crack as elsewhere, and jumps by the opening
// across it. On a crack the values are those of its left face, or of the right one after choose_right_face(). Lengths
// are in units of `boundary.length`, stresses in units of the shear modulus.
class CrackField {
 public:
  // `openings` [m], all of them.
  CrackField(const ScaledBoundary& boundary, const CrackMesh& cracks, double nu, const Eigen::VectorXd& openings);

  void choose_right_face(bool right) { right_face_ = right; }

  struct Value {
    Point displacement = Point::Zero();
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();  // xx, yy, xy; infinite at a tip
  };
  // Displacement and stress of all elements, or of all but `skipped`.
  Value at(const Point& x, int skipped = -1) const;

  // Displacement and stress as at(), also at ends of elements, where the closed forms cancel to no digit. There the
  // result is the mean of displacements right beside the end, and of stresses inside the elements that meet, whose
  // openings have a kink there.
  Value anywhere(const Point& x) const;

  // Distance of the nearest tip over the length of its element.
  double nearness_of_tip(const Point& x) const;

 private:
  // One crack element. The opening along its axis, in components along the axis and to the left of it, is the sum of
  // terms[k] s^k with 0 <= s <= 1, or sigma (terms[0] + terms[1] sigma^2) with s = sigma^2 at a tip.
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

#pragma once

#include <Eigen/Core>
#include <complex>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// Polar coordinates about a crack tip. Angles count from the direction of straight growth; they may exceed pi at places
// beside a crack that is not quite straight.
struct TipPolar {
  double radius, angle;
};

// Term of Williams' expansion (J. Appl. Mech. 24, 1957) at the tip of a straight crack with free faces, in the axes of
// the tip. The term has Muskhelishvili's potentials phi = A z^p, psi = B z^p, where z is the place as a complex number,
// p is a multiple of 1/2 and A, B are complex coefficients, with
//   2 G (u_x + i u_y) = kappa phi - z conj(phi') - conj(psi)
// (G: shear modulus, kappa: Kolosov's constant). Free faces require B = conj(A) - p A if p is an odd multiple of 1/2,
// and B = -conj(A) - p A if p is whole. The term p = 1/2 has A = (K_I - i K_II) / sqrt(2 pi), the term p = 1 has A =
// T/4 with the T-stress T. Negative powers are the dual fields of reciprocal_work().
class CrackTipField {
 public:
  CrackTipField(const PlaneElasticity& elasticity, double power, std::complex<double> factor);

  Point displacement(const TipPolar& place) const;      // [m] in the tip's axes
  Eigen::Vector3d stress(const TipPolar& place) const;  // xx, yy, xy in the tip's axes [Pa]

 private:
  double power_, shear_modulus_, kappa_;
  std::complex<double> phi_, psi_;
};

// Reciprocal work, per thickness, of the term with power p and coefficient `a` and its dual term with power -p and
// coefficient `dual`: the work of the tractions of the term on the displacements of its dual, less the work of the
// tractions of the dual on the displacements of the term. It is the same along any path round the tip from the lower
// face to the upper face, with the normal outwards. No other term of the expansion has reciprocal work with this dual,
// so the dual finds the coefficient of the term with power p in any field (Stern, Becker and Dunham, Int. J. Fract. 12,
// 1976, for p = 1/2).
double reciprocal_work(const PlaneElasticity& elasticity, double power, std::complex<double> a,
                       std::complex<double> dual);

}  // namespace bempd

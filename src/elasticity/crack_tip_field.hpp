#pragma once

#include <Eigen/Core>
#include <complex>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/point.hpp"

namespace bempd {

// A place seen from the tip of a crack: angles count from the direction in which it would go straight on, and may go
// beyond pi for places beside a crack that is not quite straight.
struct TipPolar {
  double radius, angle;
};

// One term of Williams' expansion (J. Appl. Mech. 24, 1957) at the tip of a straight crack with free faces, in the axes
// of the tip: the potentials of Muskhelishvili phi = A z^p, psi = B z^p, p a multiple of 1/2, with
//   2 G (u_x + i u_y) = kappa phi - z conj(phi') - conj(psi),
// where free faces ask for B = conj(A) - p A if p is a half, and for B = -conj(A) - p A if it is whole.
// p = 1/2: A = (K_I - i K_II) / sqrt(2 pi). p = 1: A = T/4. Negative powers are the duals of these, see
// reciprocal_work().
class CrackTipField {
 public:
  CrackTipField(const PlaneElasticity& elasticity, double power, std::complex<double> factor);

  Point displacement(const TipPolar& place) const;      // [m] in the tip's axes
  Eigen::Vector3d stress(const TipPolar& place) const;  // xx, yy, xy in the tip's axes [Pa]

 private:
  double power_, shear_modulus_, kappa_;
  std::complex<double> phi_, psi_;
};

// Work of the tractions of the term of power p and factor `a` on the displacements of the one of power -p and factor
// `dual`, less that of its tractions on those, along any way round the tip from the lower face to the upper one, with
// the normal outwards, per thickness. Other terms do no work on the dual: so it picks its partner out of any field
// (Stern, Becker and Dunham, Int. J. Fract. 12, 1976, for p = 1/2).
double reciprocal_work(const PlaneElasticity& elasticity, double power, std::complex<double> a,
                       std::complex<double> dual);

}  // namespace bempd

#include "elasticity/crack_tip_field.hpp"

#include <cmath>
#include <numbers>

#include "elasticity/griffith.hpp"

namespace bempd {

namespace {

bool is_whole(double power) { return std::floor(power) == power; }

std::complex<double> raised(const TipPolar& z, double power) {
  return std::polar(std::pow(z.radius, power), power * z.angle);
}

}  // namespace

CrackTipField::CrackTipField(const PlaneElasticity& elasticity, double power, std::complex<double> factor)
    : power_(power),
      shear_modulus_(elasticity.shear_modulus()),
      kappa_(3 - 4 * elasticity.effective_poisson_ratio()),
      phi_(factor),
      psi_((is_whole(power) ? -1.0 : 1.0) * std::conj(factor) - power * factor) {}

Point CrackTipField::displacement(const TipPolar& place) const {
  const std::complex<double> z = raised(place, 1), zp = raised(place, power_);
  const std::complex<double> slope = power_ * phi_ * raised(place, power_ - 1);
  const std::complex<double> u = kappa_ * phi_ * zp - z * std::conj(slope) - std::conj(psi_ * zp);
  return Point(u.real(), u.imag()) / (2 * shear_modulus_);
}

Eigen::Vector3d CrackTipField::stress(const TipPolar& place) const {
  const std::complex<double> z = raised(place, 1), slope = power_ * raised(place, power_ - 1);
  const std::complex<double> curvature = power_ * (power_ - 1) * raised(place, power_ - 2);
  const double sum = 4 * (phi_ * slope).real();
  const std::complex<double> difference = 2.0 * (std::conj(z) * phi_ * curvature + psi_ * slope);
  return {0.5 * (sum - difference.real()), 0.5 * (sum + difference.real()), 0.5 * difference.imag()};
}

double reciprocal_work(const PlaneElasticity& elasticity, double power, std::complex<double> a,
                       std::complex<double> dual) {
  const double both = 16 * std::numbers::pi * power / plane_modulus(elasticity) * (a * std::conj(dual)).real();
  return is_whole(power) ? both : -both;
}

}  // namespace bempd

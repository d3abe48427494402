// A plane with a crack, pulled across it, in plane stress.
#pragma once

#include <complex>

#include "host.hpp"

namespace host {

// A crack |x| < a on the x axis of a plate under the stress 1 across it: H. M. Westergaard, J. Appl. Mech. 6 (1939).
struct CrackedPlane {
  static constexpr double young = 1, poisson = 1.0 / 3;
  double a;

  Vector displacement(double x, double y) const {
    const std::complex<double> root = std::sqrt(std::complex(x - a, y)) * std::sqrt(std::complex(x + a, y));
    const double z = std::real(std::complex(x, y) / root), iz = std::imag(std::complex(x, y) / root);
    const double shear = young / (2 * (1 + poisson)), k = (3 - poisson) / (1 + poisson);
    return {((k - 1) / 2 * root.real() - y * iz) / (2 * shear) - x / young,
            ((k + 1) / 2 * root.imag() - y * z) / (2 * shear) + poisson * y / young};
  }
  std::array<double, 3> stress(double x, double y) const {
    const std::complex<double> root = std::sqrt(std::complex(x - a, y)) * std::sqrt(std::complex(x + a, y));
    const std::complex<double> z = std::complex(x, y) / root, slope = -a * a / (root * root * root);
    return {z.real() - y * slope.imag() - 1, z.real() + y * slope.imag(), -y * slope.real()};
  }
};

}  // namespace host

#pragma once

#include <array>
#include <complex>

// Disk of radius 1 in an infinite plate under unit tension along x, bonded (Goodier 1933), or a hole (Kirsch 1898), by
// Muskhelishvili's potentials: outside phi = (z + A / z) / 4, psi = -(z + B / z + C / z^3) / 2, inside linear ones.
class CircularInclusion {
 public:
  struct Solid {
    double shear, kolosov;
  };
  static Solid plane_strain(double young, double poisson) { return {young / (2 * (1 + poisson)), 3 - 4 * poisson}; }

  explicit CircularInclusion(const Solid& plate) : plate_(plate), a_(2), b_(1) {}
  CircularInclusion(const Solid& plate, const Solid& disk) : plate_(plate), disk_(disk) {
    a_ = (2 / disk.shear - 2 / plate.shear) / (plate.kolosov / plate.shear + 1 / disk.shear);
    b_ = ((disk.kolosov - 1) / disk.shear - (plate.kolosov - 1) / plate.shear) /
         (2 / plate.shear + (disk.kolosov - 1) / disk.shear);
  }

  std::array<double, 2> displacement(double x, double y) const {
    const Complex z(x, y);
    const Potentials p = at(z);
    const Solid& solid = inside(z) ? disk_ : plate_;
    const Complex u = (solid.kolosov * p.phi - z * std::conj(p.slope) - std::conj(p.psi)) / (2 * solid.shear);
    return {u.real(), u.imag()};
  }
  // xx, yy, xy
  std::array<double, 3> stress(double x, double y) const {
    const Complex z(x, y);
    const Potentials p = at(z);
    const double sum = 4 * p.slope.real();
    const Complex difference = 2.0 * (std::conj(z) * p.curvature + p.psi_slope);
    return {0.5 * (sum - difference.real()), 0.5 * (sum + difference.real()), 0.5 * difference.imag()};
  }

 private:
  using Complex = std::complex<double>;
  struct Potentials {
    Complex phi, slope, curvature, psi, psi_slope;
  };

  bool inside(const Complex& z) const { return disk_.shear > 0 && std::abs(z) < 1; }
  Potentials at(const Complex& z) const {
    if (inside(z)) {
      const double d = 0.25 * (1 - b_), f = -0.5 * (1 - 0.5 * a_);
      return {d * z, d, 0, f * z, f};
    }
    const double c = -0.5 * a_;
    const Complex z2 = z * z, z3 = z2 * z;
    return {0.25 * (z + a_ / z), 0.25 * (1.0 - a_ / z2), 0.5 * a_ / z3, -0.5 * (z + b_ / z + c / z3),
            -0.5 * (1.0 - b_ / z2 - 3 * c / (z2 * z2))};
  }

  Solid plate_, disk_{0, 0};
  double a_ = 0, b_ = 0;
};

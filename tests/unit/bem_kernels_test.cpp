#include <gtest/gtest.h>

#include "bem/kelvin_solution.hpp"

namespace {

using namespace bempd;
using bem::KelvinSolution;

// Plane-strain stress of a displacement field's gradient for unit shear modulus.
Eigen::Matrix2d stress_of(const Eigen::Matrix2d& gradient, double nu) {
  Eigen::Matrix2d stress = gradient + gradient.transpose();
  stress.diagonal().array() += 2 * nu / (1 - 2 * nu) * gradient.trace();
  return stress;
}

// Gradient of f at x by fourth-order central differences: column j is the derivative along axis j.
template <typename Function>
Eigen::Matrix2d gradient_of(const Function& f, const Point& x) {
  const double h = 1e-3;
  Eigen::Matrix2d g;
  for (int j = 0; j < 2; ++j) {
    const Point d = h * Point::Unit(j);
    g.col(j) = (8 * (f(x + d) - f(x - d)) - (f(x + 2 * d) - f(x - 2 * d))) / (12 * h);
  }
  return g;
}

const Point distance{0.7, -0.4}, normal{0.6, 0.8};

TEST(KelvinSolution, displacement_is_symmetric_and_even) {
  const KelvinSolution kelvin{0.3};
  const Eigen::Matrix2d u = kelvin.displacement(distance);
  EXPECT_EQ(u(0, 1), u(1, 0));
  EXPECT_EQ((u - kelvin.displacement(-distance)).norm(), 0);
}

TEST(KelvinSolution, traction_is_that_of_the_displacement_field) {
  for (const double nu : {0.0, 0.25, 0.3, 0.49}) {
    const KelvinSolution kelvin{nu};
    for (int force = 0; force < 2; ++force) {
      const auto field = [&](const Point& r) -> Point { return kelvin.displacement(r).row(force).transpose(); };
      const Point expected = stress_of(gradient_of(field, distance), nu) * normal;
      EXPECT_NEAR((kelvin.traction(distance, normal).row(force).transpose() - expected).norm(), 0, 1e-9) << nu;
    }
  }
}

TEST(KelvinSolution, traction_on_a_circle_balances_the_force) {
  const KelvinSolution kelvin{0.3};
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  const int count = 24;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const Point n(std::cos(angle), std::sin(angle));
    sum += kelvin.traction(0.5 * n, n) * (0.5 * 2 * std::numbers::pi / count);
  }
  EXPECT_NEAR((sum + Eigen::Matrix2d::Identity()).norm(), 0, 1e-14);
}

TEST(KelvinSolution, stress_kernels_are_those_of_the_displacement_kernels) {
  const Point t{0.3, -1.1}, u{-0.8, 0.5};
  for (const double nu : {0.0, 0.25, 0.3, 0.49}) {
    const KelvinSolution kelvin{nu};
    // The field point moves while the source stays.
    const auto single = [&](const Point& x) -> Point { return kelvin.displacement(distance - x) * t; };
    const auto layer = [&](const Point& x) -> Point { return kelvin.traction(distance - x, normal) * u; };
    const Eigen::Matrix2d a = stress_of(gradient_of(single, Point::Zero()), nu);
    const Eigen::Matrix2d b = stress_of(gradient_of(layer, Point::Zero()), nu);
    const Eigen::Vector3d from_t = kelvin.stress_from_traction(distance, t);
    const Eigen::Vector3d from_u = kelvin.stress_from_displacement(distance, normal, u);
    EXPECT_NEAR((from_t - Eigen::Vector3d(a(0, 0), a(1, 1), a(0, 1))).norm(), 0, 1e-9) << nu;
    EXPECT_NEAR((from_u - Eigen::Vector3d(b(0, 0), b(1, 1), b(0, 1))).norm(), 0, 1e-8) << nu;
  }
}

}  // namespace

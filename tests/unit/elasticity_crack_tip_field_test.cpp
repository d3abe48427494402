// Terms of Williams' expansion: free faces, Hooke's law, and the work of a term on its dual by integration.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "elasticity/crack_tip_field.hpp"
#include "elasticity/griffith.hpp"

namespace {

using namespace bempd;
using Complex = std::complex<double>;

using std::numbers::pi;

TipPolar polar(const Point& p) { return {p.norm(), std::atan2(p.y(), p.x())}; }

PlaneElasticity solid(PlaneState state) { return {3.0, 0.3, state, 1.0}; }

Point traction(const CrackTipField& field, const TipPolar& at, const Point& normal) {
  const Eigen::Vector3d s = field.stress(at);
  return {s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y()};
}

// Trapezoidal rule with ends that the integrand does not vanish at: Simpson's.
double work_round(const CrackTipField& one, const CrackTipField& other, double radius) {
  constexpr int pieces = 2000;
  double sum = 0;
  for (int k = 0; k <= pieces; ++k) {
    const TipPolar at{radius, -pi + 2 * pi * k / pieces};
    const Point normal(std::cos(at.angle), std::sin(at.angle));
    const double weight = (k == 0 || k == pieces ? 1 : k % 2 == 1 ? 4 : 2) / 3.0;
    sum += weight * (traction(one, at, normal).dot(other.displacement(at)) -
                     traction(other, at, normal).dot(one.displacement(at)));
  }
  return sum * radius * 2 * pi / pieces;
}

TEST(CrackTipField, has_free_faces) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const double power : {-1.0, -0.5, 0.5, 1.0, 1.5, 2.0})
      for (const Complex factor : {Complex(1, 0), Complex(0, 1), Complex(0.3, -2)}) {
        const CrackTipField field(solid(state), power, factor);
        for (const double side : {pi, -pi}) {
          const Eigen::Vector3d s = field.stress({0.7, side});
          EXPECT_NEAR(s[1], 0, 1e-13);
          EXPECT_NEAR(s[2], 0, 1e-13);
        }
      }
}

TEST(CrackTipField, obeys_hookes_law) {
  const double h = 1e-5;
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const double power : {-1.0, -0.5, 0.5, 1.0, 1.5}) {
      const PlaneElasticity elasticity = solid(state);
      const CrackTipField field(elasticity, power, Complex(0.4, 1.1));
      const Point at(-0.3, 0.8);
      const Point dx =
          (field.displacement(polar(at + Point(h, 0))) - field.displacement(polar(at - Point(h, 0)))) / (2 * h);
      const Point dy =
          (field.displacement(polar(at + Point(0, h))) - field.displacement(polar(at - Point(0, h)))) / (2 * h);
      const Eigen::Vector3d s = field.stress(polar(at));
      EXPECT_NEAR(s[0], elasticity.c11() * dx.x() + elasticity.c12() * dy.y(), 1e-7);
      EXPECT_NEAR(s[1], elasticity.c12() * dx.x() + elasticity.c11() * dy.y(), 1e-7);
      EXPECT_NEAR(s[2], elasticity.shear_modulus() * (dx.y() + dy.x()), 1e-7);
    }
}

TEST(CrackTipField, of_a_stress_intensity_has_its_stress_ahead) {
  const CrackTipField field(solid(PlaneState::stress), 0.5, Complex(2, -3) / std::sqrt(2 * pi));
  const Eigen::Vector3d s = field.stress({0.5, 0});
  EXPECT_NEAR(s[1], 2 / std::sqrt(pi), 1e-14);
  EXPECT_NEAR(s[2], 3 / std::sqrt(pi), 1e-14);
  EXPECT_NEAR(CrackTipField(solid(PlaneState::stress), 1, 1.75).stress({0.4, 2})[0], 7, 1e-13);
}

TEST(CrackTipField, does_the_work_on_its_dual_that_is_told) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain})
    for (const double power : {0.5, 1.0, -0.5})
      for (const Complex dual : {Complex(1, 0), Complex(0, 1)}) {
        const Complex factor(0.7, -1.3);
        const double work =
            work_round(CrackTipField(solid(state), power, factor), CrackTipField(solid(state), -power, dual), 0.6);
        EXPECT_NEAR(work, reciprocal_work(solid(state), power, factor, dual), 1e-9);
      }
}

TEST(CrackTipField, does_no_work_on_other_duals) {
  for (const double power : {0.5, 1.0, 1.5, 2.0})
    for (const double dual : {-0.5, -1.0}) {
      if (power + dual == 0) continue;
      EXPECT_NEAR(work_round(CrackTipField(solid(PlaneState::stress), power, Complex(0.7, -1.3)),
                             CrackTipField(solid(PlaneState::stress), dual, Complex(1, 0.4)), 0.6),
                  0, 1e-9);
    }
}

}  // namespace

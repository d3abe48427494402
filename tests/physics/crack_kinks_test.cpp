// Kinks of cracks: criteria of growth against the boundary elements' own kinked cracks and published angles.
#include <gtest/gtest.h>

#include <cmath>

#include "elasticity/kinked_tip.hpp"
#include "physics/cracked_bodies.hpp"

namespace bempd::crack_test {
namespace crack_kinks_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
const PlaneElasticity material{1, 0.3, PlaneState::stress, 1};

// Factors of a crack of length 2 with a kink at its right end, over those of a straight one.
Point kinked(double angle, double length, const Eigen::Matrix2d& stress, const bem::CrackGrading& grading = {}) {
  std::vector<Point> points{{-1, 0}, {1, 0}};
  if (length > 0) points.emplace_back(1 + length * std::cos(angle), length * std::sin(angle));
  const CrackedBody body({plate(1000, 1000, 500)}, {points}, material, 500, grading, 1e-11);
  return body.tips(body.solve([&](const Point&) { return stress; }))[1].factors / std::sqrt(pi);
}

TEST(Kink, factors_of_amestoy_and_leblond_are_those_of_a_tiny_kink) {
  Eigen::Matrix2d pull = Eigen::Matrix2d::Identity(), shear;
  shear << 0, 1, 1, 0;
  for (const double degrees : {3.0, 15.0, 45.0, 75.0, -60.0}) {
    const Point one = kinked(degrees * degree, 1e-4, pull), two = kinked(degrees * degree, 1e-4, shear);
    const Point known_one = kinked_factors({1, 0}, degrees * degree);
    const Point known_two = kinked_factors({0, 1}, degrees * degree);
    std::printf("%g degrees: %.5f %.5f %.5f %.5f, known %.5f %.5f %.5f %.5f\n", degrees, one.x(), one.y(), two.x(),
                two.y(), known_one.x(), known_one.y(), known_two.x(), known_two.y());
    EXPECT_LE((one - known_one).norm(), 1e-3) << degrees;
    EXPECT_LE((two - known_two).norm(), 1e-3) << degrees;
  }
}

// The energy release rate has more digits than the shares of the modes. At 80 degrees the series has its largest terms.
TEST(Kink, energy_release_rates_of_amestoy_and_leblond_are_those_of_a_tiny_kink) {
  Eigen::Matrix2d pull = Eigen::Matrix2d::Identity(), shear;
  shear << 0, 1, 1, 0;
  for (const double degrees : {80.0, -70.0}) {
    for (const Point& factors : {Point(1, 0), Point(0, 1), Point(1, 1), Point(1, -1)}) {
      const Point found = kinked(degrees * degree, 1e-5, factors.x() * pull + factors.y() * shear, {8, 4, 8});
      const double known = kinked_factors(factors, degrees * degree).squaredNorm();
      std::printf("%g degrees, factors (%g, %g): %.6f, known %.6f\n", degrees, factors.x(), factors.y(),
                  found.squaredNorm(), known);
      EXPECT_NEAR(found.squaredNorm(), known, 6e-5 * known);
    }
  }
}

// A stress along a straight crack gives no factors before the crack kinks, and then a multiple of the root of the
// kink's length (Amestoy and Leblond 1992, G).
TEST(Kink, growth_by_a_stress_along_the_crack_is_that_of_a_short_kink) {
  Eigen::Matrix2d along;
  along << 1, 0, 0, 0;
  constexpr double length = 1e-3;
  for (const double degrees : {20.0, 50.0, 75.0, -60.0}) {
    const Point found = kinked(degrees * degree, length, along) * std::sqrt(pi / length);
    const Point known = kink_growth(degrees * degree);
    std::printf("%g degrees: %.5f %.5f, known %.5f %.5f\n", degrees, found.x(), found.y(), known.x(), known.y());
    EXPECT_LE((found - known).norm(), 1e-3) << degrees;
  }
}

TEST(Kink, goes_to_the_largest_energy_release_rate) {
  using enum KinkCriterion;
  // Pure shear: 75.6 degrees, between hoop stress (70.5) and vanishing K_II (77.3); Amestoy and Leblond 1992.
  EXPECT_NEAR(kink_of({0, 1}, energy_release_rate).angle / degree, -75.6, 0.3);
  EXPECT_NEAR(kink_of({0, -1}, energy_release_rate).angle / degree, 75.6, 0.3);
  EXPECT_EQ(kink_of({2, 0}, energy_release_rate).angle, 0);
  EXPECT_EQ(kink_of({2, 0}, energy_release_rate).equivalent_factor, 2);
  EXPECT_LT(kink_of({-2, 0}, energy_release_rate).equivalent_factor, 0);
  // The angle is 2 K_II / K_I for a little shear by either criterion.
  EXPECT_NEAR(kink_of({1, 0.01}, energy_release_rate).angle, -0.02, 2e-5);
  EXPECT_NEAR(kink_of({1, 0.01}, hoop_stress).angle, -0.02, 2e-5);
  for (const double two : {0.1, 0.5, 1.0, 5.0}) {
    const Kink best = kink_of({1, two}, energy_release_rate);
    for (double angle = -1.8; angle <= 1.8; angle += 0.01)
      EXPECT_LE(kinked_factors({1, two}, angle).norm(), best.equivalent_factor * (1 + 1e-12));
  }
}

TEST(Kink, load_factor_brings_the_equivalent_factor_to_the_toughness) {
  for (const auto criterion : {KinkCriterion::hoop_stress, KinkCriterion::energy_release_rate}) {
    for (const auto& [constant, proportional] :
         {std::pair(Point(0, 0), Point(1, 0.5)), std::pair(Point(-1, 0.3), Point(2, -1)),
          std::pair(Point(0.5, 0), Point(0, 1))}) {
      const double factor = growth_load_factor(constant, proportional, 3, criterion);
      EXPECT_NEAR(kink_of(constant + factor * proportional, criterion).equivalent_factor, 3, 1e-10);
    }
    EXPECT_EQ(growth_load_factor({5, 0}, {1, 0}, 3, criterion), 0);
    EXPECT_TRUE(std::isinf(growth_load_factor({0, 0}, {-1, 0}, 3, criterion)));
    EXPECT_TRUE(std::isinf(growth_load_factor({0, 0}, {1, 0}, 0, criterion)));
  }
}

// The kink that is worth most is the first one that opens at all; found a rounding beside it, it opens or does not.
TEST(Kink, of_a_tip_that_is_pressed_shut_is_worth_as_much_whatever_rounding_does) {
  const Point factors(-0.0036662905948943144, -0.002734347828404617);
  const double worth = kink_of(factors, KinkCriterion::energy_release_rate).equivalent_factor;
  EXPECT_GT(worth, 0);
  for (int k = 1; k <= 100; ++k) {
    const double share = 0.037 * k;
    EXPECT_NEAR(kink_of(share * factors, KinkCriterion::energy_release_rate).equivalent_factor / share, worth,
                1e-9 * worth);
    EXPECT_NEAR(growth_load_factor({0, 0}, share * factors, 1e-3, KinkCriterion::energy_release_rate) * share * worth,
                1e-3, 1e-9);
  }
}

// Elements half as long give the same digits: the faces of a sharp kink lie close to each other.
TEST(Kink, that_nearly_closes_keeps_its_digits) {
  Eigen::Matrix2d pull = Eigen::Matrix2d::Identity();
  for (const double degrees : {120.0, 150.0, 170.0, 177.0}) {
    const double angle = degrees * degree;
    const std::vector<Point> points{{-1, 0}, {1, 0}, {1 + 0.5 * std::cos(angle), 0.5 * std::sin(angle)}};
    Point factors[2];
    for (int fine = 0; fine < 2; ++fine) {
      const bem::CrackGrading grading{fine ? 16 : 8, 4, fine ? 6 : 4};
      const CrackedBody body({plate(100, 100, fine ? 25 : 50)}, {points}, material, fine ? 25 : 50, grading, 1e-9);
      factors[fine] = body.tips(body.solve([&](const Point&) { return pull; }))[1].factors;
    }
    const Point straight = kinked(0, 0, pull) * std::sqrt(pi);
    std::printf("%g degrees: K_I %.6f, K_II %.6f; finer %.6f, %.6f\n", degrees, factors[0].x(), factors[0].y(),
                factors[1].x(), factors[1].y());
    EXPECT_LE((factors[0] - factors[1]).norm(), 2e-4 * straight.norm()) << degrees;
  }
}

}  // namespace
}  // namespace crack_kinks_test
}  // namespace bempd::crack_test

#include <gtest/gtest.h>

#include <claims.hpp>
#include <numbers>

#include "bem/coarse_level.hpp"
#include "elasticity/kinked_tip.hpp"
#include "physics/cracked_bodies.hpp"

// Stress intensity factors against closed forms and published values.
namespace crack_factors_test {
namespace {

using namespace bempd;
using namespace bempd::crack_test;
using std::numbers::pi;

const PlaneElasticity unit{1, 0.3, PlaneState::stress, 1};

void expect_close(const char* what, double value, double reference, double tolerance) {
  std::printf("%s: %.6f, reference %.6f, relative difference %.1e\n", what, value, reference, value / reference - 1);
  EXPECT_NEAR(value, reference, tolerance * std::abs(reference)) << what;
}

// Isida's series for the strip with a centre crack (Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook,
// 3rd ed., section 2.1), a over half the width 0.1 .. 0.8.
TEST(StressIntensity, centre_cracks_of_a_strip) {
  constexpr double reference[] = {1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033, 1.4882, 1.8160};
  for (int i = 0; i < 8; ++i) {
    const double a = 0.1 * (i + 1);
    const CrackedBody body({plate(1, 3, 0.25)}, {{{-a, 0}, {a, 0}}}, unit, 0.25);
    const auto tips = body.tips(body.solve(constant_stress(0, 1, 0)));
    expect_close("centre crack", tips[0].factors.x() / std::sqrt(pi * a), reference[i],
                 std::min(claims::tip_centre, claims::tip_factors));
    EXPECT_NEAR(tips[1].factors.x(), tips[0].factors.x(), 1e-9);
    EXPECT_NEAR(tips[0].factors.y(), 0, 1e-9);
  }
}

// Kaya and Erdogan, Quarterly of Applied Mathematics 45, 1987; crack over width 0.1 .. 0.6.
TEST(StressIntensity, single_edge_cracks_of_a_strip) {
  constexpr double reference[] = {1.1892, 1.3673, 1.6599, 2.1114, 2.8246, 4.0332};
  for (int i = 0; i < 6; ++i) {
    const double a = 0.1 * (i + 1);
    const auto strip = bem_test::polygon({{0, -3}, {1, -3}, {1, 3}, {0, 3}}, 0.125);
    const CrackedBody body({strip}, {{{0, 0}, {a, 0}}}, unit, 0.125);
    const auto tips = body.tips(body.solve(constant_stress(0, 1, 0)));
    expect_close("edge crack", tips[0].factors.x() / std::sqrt(pi * a), reference[i],
                 std::min(claims::tip_edge, claims::tip_factors));
  }
}

// Newman, NASA TN D-6376, 1971: two cracks from a circular hole of radius 1 in a large plate, their ends 1.1 .. 2 from
// its centre.
TEST(StressIntensity, cracks_from_a_hole) {
  std::vector<Panel> hole;
  const Point corners[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  for (int i = 0; i < 4; ++i)
    hole.push_back({corners[i], corners[(i + 1) % 4], element_stations(pi / 2, 0.4, 1, -pi / 2), -pi / 2});
  for (const auto& [a, reference] : {std::pair(1.1, 0.8400), {1.2, 0.9851}, {1.5, 1.0582}, {2.0, 1.0409}}) {
    const CrackedBody body({plate(200, 200, 50), hole}, {{{1, 0}, {a, 0}}, {{-1, 0}, {-a, 0}}}, unit, 50);
    const auto stress = [](const Point& x) {
      Eigen::Matrix2d s = Eigen::Matrix2d::Zero();
      if (x.norm() > 2) s(1, 1) = 1;
      return s;
    };
    const auto tips = body.tips(body.solve(stress));
    expect_close("crack from a hole", tips[0].factors.x() / std::sqrt(pi * a), reference, claims::tip_hole);
  }
}

// A crack at 20 degrees in a plate 20 times its size: 1.0034 and 1.0026 of the infinite plate's.
TEST(StressIntensity, an_inclined_crack) {
  const double angle = 20 * pi / 180;
  const Point end(std::cos(angle), std::sin(angle));
  const auto factors = [&](int elements) {
    const CrackedBody body({plate(20, 20, 5)}, {{-end, end}}, unit, 5, {elements, 4});
    return body.tips(body.solve(constant_stress(0, 1, 0)))[1].factors;
  };
  const Point coarse = factors(8), fine = factors(48);
  const double infinite = std::sqrt(pi) * std::cos(angle);
  expect_close("K_I of an inclined crack", coarse.x(), fine.x(), claims::tip_inclined);
  expect_close("K_II of an inclined crack", coarse.y(), fine.y(), claims::tip_inclined);
  expect_close("K_I and the infinite plate", coarse.x(), infinite * std::cos(angle), 4e-3);
  expect_close("K_II and the infinite plate", coarse.y(), infinite * std::sin(angle), 4e-3);
}

// Amestoy and Leblond, Int. J. Solids Struct. 29, 1992: an infinitesimal kink of 45 degrees has 0.79090 and 0.32328 of
// K_I. Loaded from all sides there is no stress along the crack, so that what is left is of the order of the kink.
TEST(StressIntensity, an_infinitesimal_kink) {
  const auto factors = [&](const std::vector<Point>& crack) {
    const CrackedBody body({plate(1000, 1000, 500)}, {crack}, unit, 500);
    return body.tips(body.solve(constant_stress(1, 1, 0)))[1].factors;
  };
  const double straight = factors({{-1, 0}, {1, 0}}).x(), kink = 1e-4 * std::sqrt(0.5);
  const Point kinked = factors({{-1, 0}, {1, 0}, {1 + kink, kink}});
  expect_close("K_I of a kink", kinked.x() / straight, 0.79090, claims::tip_kink);
  expect_close("K_II of a kink", kinked.y() / straight, 0.32328, claims::tip_kink);
}

// Sneddon, Proc. R. Soc. A 187, 1946: K = p sqrt(pi a), and the opening is an ellipse.
TEST(StressIntensity, pressure_in_a_crack) {
  const CrackedBody body({plate(1000, 1000, 500)}, {{{-1, 0}, {1, 0}}}, unit, 500);
  const auto state =
      body.solve(constant_stress(0, 0, 0), [](int, const Point&, const Point& n) -> Point { return -n; });
  expect_close("K_I of a pressure", body.tips(state)[0].factors.x(), std::sqrt(pi), claims::tip_pressure);
  expect_close("stress along it", bem::stresses_along_crack(*body.op, state)[0], -1, claims::tip_stress_along);
  for (std::size_t n = 1; n + 1 < body.cracks.nodes.size(); ++n) {
    const double x = body.cracks.nodes[n].x();
    EXPECT_NEAR(state.openings[2 * n + 1], 4 * std::sqrt(1 - x * x), 4 * 5e-4);
  }
}

// Two cracks of length 2 in a row, the gap 1 % and less of that (Tada, Paris and Irwin, section 7.1).
TEST(StressIntensity, two_cracks_close_to_each_other) {
  for (const double c : {0.1, 0.01, 0.001}) {
    const double b = c + 2, k = std::sqrt(1 - c * c / (b * b)), ratio = std::comp_ellint_2(k) / std::comp_ellint_1(k);
    const double inner = std::sqrt(pi / c) * (b * b * ratio - c * c) / std::sqrt(b * b - c * c);
    const double outer = std::sqrt(pi * b) * (1 - ratio) * b / std::sqrt(b * b - c * c);
    const CrackedBody body({plate(1000, 1000, 500)}, {{{-b, 0}, {-c, 0}}, {{c, 0}, {b, 0}}}, unit, 500);
    const auto tips = body.tips(body.solve(constant_stress(0, 1, 0)));
    expect_close("inner tip", tips[1].factors.x(), inner, claims::tip_two);
    expect_close("outer tip", tips[0].factors.x(), outer, claims::tip_two);
  }
}

// A crack along an arc of 90 degrees under tension from all sides (Cotterell and Rice, Int. J. Fract. 16, 1980), made
// of chords that touch the arc.
TEST(StressIntensity, an_arc) {
  const double half = pi / 4, part = 2 * half / 64;
  std::vector<Point> points{{-std::sin(half), std::cos(half)}};
  for (int i = 0; i < 64; ++i) {
    const double angle = pi / 2 + half - part * (i + 0.5);
    points.push_back(Point(std::cos(angle), std::sin(angle)) / std::cos(part / 2));
  }
  points.emplace_back(std::sin(half), std::cos(half));
  const CrackedBody body({plate(1000, 1000, 500)}, {points}, unit, 500);
  const auto tips = body.tips(body.solve(constant_stress(1, 1, 0)));
  const double scale = std::sqrt(pi * std::sin(half)) / (1 + std::pow(std::sin(half / 2), 2));
  expect_close("K_I of an arc", tips[0].factors.x(), scale * std::cos(half / 2), claims::tip_arc);
  expect_close("K_II of an arc", std::abs(tips[0].factors.y()), scale * std::sin(half / 2), claims::tip_arc);
}

// The difference of the levels is of the size of the error, or larger.
TEST(StressIntensity, the_error_figure_covers_the_error) {
  for (const double h : {1.0, 0.5, 0.25}) {
    const auto strip = bem_test::polygon({{0, -3}, {1, -3}, {1, 3}, {0, 3}}, h);
    const CrackedBody body({strip}, {{{0, 0}, {0.5, 0}}}, unit, h);
    const auto state = body.solve(constant_stress(0, 1, 0));
    const auto levels = bem::stress_intensities(*body.op, {state, bem::coarse_state(*body.op, state)})[0];
    const double error = std::abs(levels[0].factors.x() - 2.82460 * std::sqrt(pi / 2));
    const double figure = (levels[0].factors - levels[1].factors).norm() / 3;
    std::printf("elements of %g: error %.1e, figure %.1e\n", h, error, figure);
    EXPECT_GE(figure, error);
    EXPECT_LE(figure, 30 * error);
  }
}

TEST(Kink, angles_of_the_largest_hoop_stress) {
  for (const auto& [ratio, degrees] : {std::pair(0.1, 11.20), {0.25, 25.33}, {0.5, 40.21}, {1.0, 53.13}, {2.0, 61.34}})
    EXPECT_NEAR(kink_of({1, ratio}).angle * 180 / pi, -degrees, 0.01);
  EXPECT_NEAR(kink_of({0, 1}).angle * 180 / pi, -70.53, 0.01);
  EXPECT_NEAR(kink_of({0, 5e-324}).angle * 180 / pi, -70.53, 0.01);  // the smallest number
  EXPECT_NEAR(kink_of({0, 1e308}).angle * 180 / pi, -70.53, 0.01);
  EXPECT_EQ(kink_of({2, 0}).angle, 0);
  EXPECT_EQ(kink_of({2, 0}).equivalent_factor, 2);
}

}  // namespace
}  // namespace crack_factors_test

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "dense.hpp"
#include "physics/cracked_bodies.hpp"

// Cracks that are small, close to each other or to edges, many, and in any units.
namespace crack_extremes_test {
namespace {

using namespace bempd;
using namespace bempd::crack_test;
using std::numbers::pi;

const PlaneElasticity unit{1, 0.3, PlaneState::stress, 1};

double first_factor(const CrackedBody& body, double stress) {
  return body.tips(body.solve(constant_stress(0, stress, 0)))[0].factors.x();
}

TEST(CrackExtremes, cracks_down_to_1e_8_of_the_body) {
  for (const double a : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const CrackedBody body({plate(1, 1, 0.5)}, {{{0.1 - a, 0.2}, {0.1 + a, 0.2}}}, unit, 0.5, {}, 1e-14);
    EXPECT_NEAR(first_factor(body, 1), std::sqrt(pi * a), 3e-4 * std::sqrt(pi * a)) << a;
    const CrackedBody edge({plate(1, 1, 0.5)}, {{{-1, 0.2}, {-1 + a, 0.2}}}, unit, 0.5, {}, 1e-14);
    EXPECT_NEAR(first_factor(edge, 1), 1.12152 * std::sqrt(pi * a), 1e-3 * std::sqrt(pi * a)) << a;
  }
}

// A tip at 0.004 of its crack from a free edge, against twice as many elements.
TEST(CrackExtremes, a_tip_next_to_an_edge) {
  const auto factor = [](int elements, double h) {
    const CrackedBody body({plate(1, 3, h)}, {{{-0.004, 0}, {-0.999, 0}}}, unit, h, {elements, 4});
    return body.tips(body.solve(constant_stress(0, 1, 0)))[1].factors.x();
  };
  const double coarse = factor(8, 0.25), fine = factor(24, 0.125);
  std::printf("tip next to an edge: %.6f, finer %.6f\n", coarse, fine);
  EXPECT_NEAR(coarse, fine, 1e-3 * fine);
}

TEST(CrackExtremes, sizes_and_moduli_do_not_matter) {
  const auto factor = [](double size, double modulus) {
    std::vector<std::vector<Panel>> loops{
        bem_test::polygon({{-size, -size}, {size, -size}, {size, size}, {-size, size}}, 0.5 * size)};
    const CrackedBody body(loops, {{{-0.5 * size, 0}, {0.3 * size, 0.2 * size}}}, {modulus, 0.3, PlaneState::stress, 1},
                           0.5 * size, {}, 1e-10 * size);
    return first_factor(body, modulus) / (modulus * std::sqrt(size));
  };
  const double reference = factor(1, 1);
  double worst = 0;
  for (const auto& [size, modulus] : {std::pair(1e-9, 1.0), {1e9, 1.0}, {1.0, 1e-12}, {1.0, 1e15}})
    worst = std::max(worst, std::abs(factor(size, modulus) / reference - 1));
  std::printf("other sizes and moduli: %.1e\n", worst);
  EXPECT_LE(worst, 1e-12);
}

// Stress intensity factors of a loaded body in plane strain do not depend on Poisson's ratio.
TEST(CrackExtremes, incompressible_plane_strain) {
  for (const double nu : {0.0, 0.3, 0.49, 0.49999, 0.5}) {
    const CrackedBody body({plate(1, 3, 0.25)}, {{{-0.5, 0}, {0.5, 0}}}, {1, nu, PlaneState::strain, 1}, 0.25);
    EXPECT_NEAR(first_factor(body, 1) / std::sqrt(pi / 2), 1.1867, 1e-4) << nu;
  }
}

TEST(CrackExtremes, a_hundred_cracks) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.03, 0.03), turn(0, pi);
  std::vector<std::vector<Point>> cracks;
  for (int i = 0; i < 100; ++i) {
    const Point centre(0.18 * (i % 10) - 0.81 + place(random), 0.18 * (i / 10) - 0.81 + place(random));
    const double angle = turn(random);
    const Point half = 0.05 * Point(std::cos(angle), std::sin(angle));
    cracks.push_back({centre - half, centre + half});
  }
  const CrackedBody body({plate(1, 1, 0.25)}, cracks, unit, 0.25, {4, 4});
  const Eigen::VectorXd values = dense::eigenvalues(body.op->full_stiffness());
  const CrackedBody one({plate(1, 1, 0.25)}, {cracks[0]}, unit, 0.25, {4, 4});
  const Eigen::VectorXd fewer = dense::eigenvalues(one.op->full_stiffness());
  std::printf("softest over stiffest: one crack %.1e, a hundred %.1e\n", fewer[3] / fewer[fewer.size() - 1],
              values[3] / values[values.size() - 1]);
  EXPECT_LE(std::abs(values[2]), 1e-14 * values[values.size() - 1]);
  EXPECT_GE(values[3] / values[values.size() - 1], 0.1 * fewer[3] / fewer[fewer.size() - 1]);
  const auto tips = body.tips(body.solve(constant_stress(0, 1, 0)));
  EXPECT_EQ(tips.size(), 200u);
}

}  // namespace
}  // namespace crack_extremes_test

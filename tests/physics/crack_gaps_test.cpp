// Narrow gaps between cracks, and between a crack and an edge: few elements along them, and the right intensities.
#include <gtest/gtest.h>

#include <numbers>

#include "physics/cracked_bodies.hpp"

namespace crack_gaps_test {
namespace {

using namespace bempd;
using namespace bempd::crack_test;
using std::numbers::pi;

const PlaneElasticity unit{1, 0.3, PlaneState::stress, 1};

std::size_t elements(const CrackedBody& body) { return body.mesh.elements.size() + body.cracks.elements.size(); }

Eigen::Matrix2d uniform_tension(const Point&) { return Eigen::Vector2d(0, 1).asDiagonal(); }

// Two tips of parallel cracks at one end together release what the tip of one crack does, in the limit of no gap.
TEST(CrackGaps, two_parallel_cracks_release_what_one_does) {
  const auto released = [](const CrackedBody& body, std::size_t tips) {
    const auto all = body.tips(body.solve(uniform_tension));
    double sum = 0;
    for (std::size_t t = 0; t < tips; ++t) sum += all[2 * t + 1].factors.squaredNorm();
    return sum;
  };
  const double one = released(CrackedBody({plate(5, 5, 0.5)}, {{{-1, 0}, {1, 0}}}, unit, 0.5), 1);
  double before = 1;
  for (const double gap : {0.1, 0.02, 0.01, 0.004}) {
    const CrackedBody body({plate(5, 5, 0.5)}, {{{-1, -gap / 2}, {1, -gap / 2}}, {{-1, gap / 2}, {1, gap / 2}}}, unit,
                           0.5);
    const double more = released(body, 2) / one - 1;
    std::printf("gap %g: %zu elements, released over that of one crack - 1: %.6f\n", gap, elements(body), more);
    EXPECT_GT(more, 0);
    EXPECT_LT(more, 0.4 * gap);
    EXPECT_LT(more, before);
    EXPECT_LE(static_cast<double>(elements(body)), 220 + 2 / gap) << gap;
    before = more;
  }
}

// The root of a thin strip that is pulled off, against the closed form for a layer on a half-plane under the moment and
// the force of the strip: J. W. Hutchinson, Z. Suo, Adv. Appl. Mech. 29 (1992), eq. 3.13, without the force across it.
TEST(CrackGaps, a_strip_along_an_edge_bends_as_it_must) {
  for (const double height : {0.04, 0.02}) {
    const double length = 4;
    const CrackedBody body({plate(5, 5, 0.5)}, {{{5 - length, 5 - height}, {5, 5 - height}}}, unit, 0.5);
    // Pulled up at its upper side, and the plate down at its lower one.
    const Point factors = body.tips(body.solve(uniform_tension))[0].factors;
    const double moment = 0.5 * length * length, omega = 52.07 * pi / 180;
    const double scale = std::sqrt(6.0) * moment / std::pow(height, 1.5);
    const Point known(scale * std::sin(omega), scale * std::cos(omega));
    std::printf("strip of %g: %zu elements, K_I %.3f, K_II %.3f of the known ones\n", height, elements(body),
                factors.x() / known.x(), std::abs(factors.y()) / known.y());
    EXPECT_NEAR(factors.x(), known.x(), 1.0 * height * known.x());
    EXPECT_NEAR(std::abs(factors.y()), known.y(), 1.0 * height * known.y());
    EXPECT_LE(static_cast<double>(elements(body)), 120 + 5.5 / height) << height;
  }
}

// Cracks that overlap by half, against elements of half the length.
TEST(CrackGaps, long_elements_in_a_gap_change_no_intensity) {
  for (const double gap : {0.05, 0.02}) {
    const std::vector<std::vector<Point>> cracks{{{-1.5, -gap / 2}, {0.5, -gap / 2}},
                                                 {{-0.5, gap / 2}, {1.5, gap / 2}}};
    const CrackedBody body({plate(5, 5, 0.5)}, cracks, unit, 0.5);
    const CrackedBody finer({plate(5, 5, 0.25)}, cracks, unit, 0.25, {64, 4});
    const auto tips = body.tips(body.solve(uniform_tension)), fine = finer.tips(finer.solve(uniform_tension));
    for (std::size_t t = 0; t < tips.size(); ++t)
      EXPECT_LE((tips[t].factors - fine[t].factors).norm(), 1e-3 * fine[t].factors.norm()) << gap << ", tip " << t;
  }
}

}  // namespace
}  // namespace crack_gaps_test

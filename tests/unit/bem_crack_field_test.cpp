// The field of a crack's openings against sums of Kelvin's solution along the crack.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "bem/crack_field.hpp"
#include "bem/kelvin_solution.hpp"
#include "geometry/turning.hpp"
#include "physics/cracked_bodies.hpp"

namespace bem_crack_field_test {
namespace {

using namespace bempd;
using bem::CrackField;
using bem::KelvinSolution;

constexpr double nu = 0.3, unit = 2;  // unit: of lengths
const Point centre(0.2, -0.1);

// A crack of three elements with a tip at either end; the openings have both components.
const std::array<Point, 4> ends{Point(0, 0), Point(0.3, 0.1), Point(0.7, 0.2), Point(0.9, 0.5)};
const std::array<Point, 7> openings{Point(0, 0),      Point(0.1, 0.3),  Point(-0.2, 0.5), Point(0.3, 0.4),
                                    Point(0.2, -0.1), Point(0.05, 0.2), Point(0, 0)};

CrackField field() {
  bem::ScaledBoundary boundary(mesh_boundary({crack_test::plate(1, 1, 1)}));
  boundary.centre = centre, boundary.length = unit;
  bem::CrackMesh cracks;
  for (int node = 0; node < 7; ++node)
    cracks.nodes.push_back(node % 2 == 0 ? ends[node / 2] : Point(0.5 * (ends[node / 2] + ends[node / 2 + 1])));
  cracks.elements = {{{0, 1, 2}, 0, 0, 1, bem::TipEnd::start},
                     {{2, 3, 4}, 0, 1, 2, bem::TipEnd::none},
                     {{4, 5, 6}, 0, 2, 3, bem::TipEnd::end}};
  Eigen::VectorXd values(14);
  for (int node = 0; node < 7; ++node) values.segment<2>(2 * node) = openings[node];
  return {boundary, cracks, nu, values};
}

// Opening of an element at the share s of its way; at tips it is a sum of the powers 1/2 and 3/2 of the distance.
Point opening(int element, double s) {
  const Point &first = openings[2 * element], &mid = openings[2 * element + 1], &last = openings[2 * element + 2];
  if (element == 1) return (1 - s) * (1 - 2 * s) * first + 4 * s * (1 - s) * mid + s * (2 * s - 1) * last;
  const double root = std::sqrt(element == 0 ? s : 1 - s), cube = root * root * root;
  return 8.0 / 3 * (root - cube) * mid + (4 * cube - root) / 3 * (element == 0 ? last : first);
}

// Sum over the crack by the rule of Simpson, whose points crowd at the tips.
CrackField::Value known(const Point& x) {
  const KelvinSolution kelvin{nu};
  CrackField::Value sum;
  constexpr int parts = 4000;
  for (int element = 0; element < 3; ++element) {
    const Point start = (ends[element] - centre) / unit, way = (ends[element + 1] - ends[element]) / unit;
    const Point normal = -left_of(Point(way.normalized()));  // outwards from the left face
    for (int k = 0; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts, s = element == 0 ? t * t : element == 2 ? 1 - t * t : t;
      const double weight = (k == 0 || k == parts ? 1
                             : k % 2 == 1         ? 4
                                                  : 2) /
                            (3.0 * parts) * (element == 1 ? 1 : 2 * t) * way.norm();
      const Point r = start + s * way - x, w = opening(element, s) / unit;
      sum.displacement -= weight * kelvin.traction(r, normal) * w;
      sum.stress -= weight * kelvin.stress_from_displacement(r, normal, w);
    }
  }
  return sum;
}

TEST(CrackField, is_the_sum_of_double_layers) {
  const CrackField found = field();
  for (const Point& place :
       {Point(0.1, 0.1), Point(0.12, -0.05), Point(-0.06, 0.01), Point(0.5, 0.25), Point(0.52, 0.05), Point(0.9, 0.3),
        Point(0.75, 0.4), Point(0.95, 0.56), Point(0.4, 1.2), Point(-3, 2)}) {
    const Point x = (place - centre) / unit;
    const CrackField::Value at = found.at(x), expected = known(x);
    EXPECT_LE((at.displacement - expected.displacement).norm(), 1e-9 * expected.displacement.norm()) << place;
    EXPECT_LE((at.stress - expected.stress).norm(), 1e-8 * expected.stress.norm()) << place;
  }
}

TEST(CrackField, jumps_by_the_opening_across_each_element) {
  CrackField left = field(), right = field();
  right.choose_right_face(true);
  for (int element = 0; element < 3; ++element)
    for (const double s : {0.2, 0.55, 0.9}) {
      const Point x = (ends[element] + s * (ends[element + 1] - ends[element]) - centre) / unit;
      const Point jump = left.at(x).displacement - right.at(x).displacement;
      EXPECT_NEAR((jump - opening(element, s) / unit).norm(), 0, 1e-12) << element << ' ' << s;
    }
}

// Terms of two elements that are infinite at their common end cancel; the displacement of a face goes on evenly there.
TEST(CrackField, is_a_mean_of_both_elements_at_their_common_end) {
  const CrackField found = field();
  for (const int end : {1, 2}) {
    const Point place = (ends[end] - centre) / unit;
    const Point back = (ends[end - 1] - ends[end]) / unit, on = (ends[end + 1] - ends[end]) / unit;
    const CrackField::Value at_end = found.anywhere(place);
    const Point across = left_of(Point((on.normalized() - back.normalized()).normalized()));
    EXPECT_LE((at_end.displacement - found.at(place + 1e-6 * across).displacement).norm(), 1e-4) << end;
    const Eigen::Vector3d mean = 0.5 * (found.at(place + 0.02 * back).stress + found.at(place + 0.02 * on).stress);
    EXPECT_LE((at_end.stress - mean).norm(), 1e-9 * mean.norm()) << end;
  }
  const Point inside = (0.5 * (ends[1] + ends[2]) - centre) / unit;
  EXPECT_EQ((found.anywhere(inside).stress - found.at(inside).stress).norm(), 0);
}

TEST(CrackField, knows_its_nearest_tip) {
  const CrackField found = field();
  const double first = (ends[1] - ends[0]).norm(), last = (ends[3] - ends[2]).norm();
  EXPECT_NEAR(found.nearness_of_tip((Point(-0.03, 0.04) - centre) / unit), 0.05 / first, 1e-12);
  EXPECT_NEAR(found.nearness_of_tip((Point(0.9, 0.48) - centre) / unit), 0.02 / last, 1e-12);
}

}  // namespace
}  // namespace bem_crack_field_test

// Coarsest elements of a body by its shape, and meshes that are halved or merged.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "geometry/coarse_sizes.hpp"
#include "geometry/halving.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

std::vector<Panel> panels_of(const std::vector<Point>& loop) {
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < loop.size(); ++k) panels.push_back({loop[k], loop[(k + 1) % loop.size()], {0, 1}, 0});
  return panels;
}

std::vector<Panel> circle_of_panels(const Point& centre, double radius) {
  std::vector<Panel> panels;
  for (int k = 0; k < 4; ++k) {
    const auto at = [&](int quarter) {
      const double angle = -quarter * std::numbers::pi / 2;
      return Point(centre + radius * Point(std::cos(angle), std::sin(angle)));
    };
    panels.push_back({at(k), at(k + 1), {0, 1}, -std::numbers::pi / 2});
  }
  return panels;
}

double longest(const std::vector<double>& stations) {
  double most = 0;
  for (std::size_t i = 1; i < stations.size(); ++i) most = std::max(most, stations[i] - stations[i - 1]);
  return most;
}

TEST(CoarseSizes, elements_are_at_most_an_eighth_of_the_outline_and_of_a_circle) {
  const CoarseSizes sizes({panels_of(box_loop(0, 0, 4, 4)), circle_of_panels({2, 2}, 1)});
  for (int panel = 0; panel < 4; ++panel) EXPECT_EQ(sizes.stations(panel), (std::vector<double>{0, 0.5, 1}));
  for (int panel = 4; panel < 8; ++panel) EXPECT_EQ(sizes.stations(panel).size(), 3u);
}

TEST(CoarseSizes, elements_along_a_narrow_ligament_are_at_most_twice_as_long_as_it_is_wide) {
  for (const double gap : {0.4, 0.1, 0.02}) {
    const CoarseSizes sizes({panels_of(box_loop(0, 0, 4, 4)), circle_of_panels({2, 1 + gap}, 1)});
    const std::vector<double> below = sizes.stations(0);
    double beside = 0;  // length of the element under the hole's lowest point
    for (std::size_t i = 1; i < below.size(); ++i)
      if (below[i - 1] < 0.5 && below[i] >= 0.5) beside = 4 * (below[i] - below[i - 1]);
    EXPECT_LE(beside, 2 * gap + 1e-9) << gap;
    EXPECT_GT(beside, 0.4 * gap) << gap;
    EXPECT_GT(4 * longest(below), 0.4) << "elements become longer away from the ligament";
  }
}

TEST(CoarseSizes, elements_grow_away_from_a_short_panel) {
  const CoarseSizes sizes({panels_of({{0, 0}, {4, 0}, {4, 4}, {0.01, 4}, {0, 4}})});
  const std::vector<double> left = sizes.stations(4), top = sizes.stations(2);
  EXPECT_LE(4 * left[1], 0.01 * (1 + 1e-9));
  EXPECT_LE(3.99 * (1 - top[top.size() - 2]), 0.01 * (1 + 1e-9));
  EXPECT_LT(left.size(), 20u);
}

TEST(CoarseSizes, loops_that_touch_take_a_bounded_number_of_elements) {
  const CoarseSizes sizes({panels_of(box_loop(0, 0, 4, 4)), circle_of_panels({2, 1}, 1)});
  for (int panel = 0; panel < 8; ++panel) EXPECT_LT(sizes.stations(panel).size(), 300u);
}

TEST(Halving, halves_and_merges_elements) {
  const std::vector<double> stations{0, 0.2, 0.6, 1};
  EXPECT_EQ(halved(stations, 0), stations);
  EXPECT_EQ(halved(stations, 1), (std::vector<double>{0, 0.1, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_EQ(halved(halved(stations, 2), -2), stations);
  EXPECT_EQ(halved(stations, -1), (std::vector<double>{0, 0.6, 1}));
  EXPECT_EQ(halved(stations, -5), (std::vector<double>{0, 1}));
}

}  // namespace

// Regions that nearly touch: what the tolerance bonds, and gaps that are reported.

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/arrangement.hpp"
#include "geometry/gaps.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

std::vector<Gap> gaps_of(const std::vector<Outline>& regions, double reach) {
  return close_gaps(regions, std::vector<double>(regions.size(), reach));
}

TEST(Gaps, edges_are_bonded_within_the_tolerance_and_reported_above_it) {
  // The tolerance is 1e-9 of the diagonal, sqrt(5).
  for (const double gap : {1e-10, 1e-9, 2e-9, 1e-8, 1e-6, 1e-4, 1e-3}) {
    const std::vector<Outline> regions{box(0, 0, 1, 1), box(1 + gap, 0, 2, 1)};
    const std::vector<Gap> gaps = gaps_of(regions, 0.01);
    if (arrange(regions).contacts.empty()) {
      ASSERT_EQ(gaps.size(), 1u) << gap;
      EXPECT_EQ(gaps[0].region_a, 0);
      EXPECT_EQ(gaps[0].region_b, 1);
      EXPECT_NEAR(gaps[0].width, gap, 1e-15);
      EXPECT_NEAR(gaps[0].where.x(), 1 + gap / 2, 1e-15);
    } else {
      EXPECT_LE(gap, 2.5e-9);
      EXPECT_TRUE(gaps.empty()) << gap;
    }
  }
}

TEST(Gaps, reach_of_both_regions_counts) {
  const std::vector<Outline> regions{box(0, 0, 1, 1), box(1.001, 0, 2, 1)};
  EXPECT_EQ(close_gaps(regions, {0.01, 0.01}).size(), 1u);
  EXPECT_TRUE(close_gaps(regions, {0.01, 0.0005}).empty());
  EXPECT_TRUE(close_gaps(regions, {0.0005, 0.01}).empty());
}

TEST(Gaps, wedges_that_open_from_a_common_corner_are_gaps) {
  const std::vector<Outline> regions{box(0, 0, 1, 1), {{{{1, 0}, {2, 0}, {2, 1}, {1.003, 1}}}}};
  const std::vector<Gap> gaps = gaps_of(regions, 0.01);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_NEAR(gaps[0].width, 0.003, 1e-5);
}

TEST(Gaps, thin_layers_and_small_details_are_none) {
  // A layer of 0.001 between two blocks.
  EXPECT_TRUE(gaps_of({box(0, 0, 1, 1), box(1, 0, 1.001, 1), box(1.001, 0, 2, 1)}, 0.01).empty());
  // A corner cut off by 0.002 beside an interface.
  const Outline cut{{{{1, 0.002}, {1.002, 0}, {2, 0}, {2, 1}, {1, 1}}}};
  EXPECT_TRUE(gaps_of({box(0, 0, 1, 1), cut}, 0.01).empty());
  // Far apart, or a slot within one region.
  EXPECT_TRUE(gaps_of({box(0, 0, 1, 1), box(1.5, 0, 2, 1)}, 0.01).empty());
  EXPECT_TRUE(gaps_of({{{box_loop(0, 0, 1, 1), reversed(box_loop(0.4, 0.5, 0.6, 0.501))}}}, 0.01).empty());
}

TEST(Gaps, disk_in_a_hole_and_disk_beside_a_block) {
  const auto circle = [](double radius, double direction) {
    Outline outline{{{}}};
    for (int k = 0; k < 4; ++k) {
      const double angle = direction * 0.5 * std::numbers::pi * k;
      outline.loops[0].emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    for (int k = 0; k < 4; ++k) {
      const auto& v = outline.loops[0];
      outline.curved.insert({k, Edge(Arc{v[k], v[(k + 1) % 4], direction * 0.5 * std::numbers::pi})});
    }
    return outline;
  };
  Outline plate = box(-2, -2, 2, 2);
  const Outline hole = circle(1.001, -1);
  plate.loops.push_back(hole.loops[0]);
  for (const auto& [k, edge] : hole.curved) plate.curved.insert({4 + k, edge});
  const std::vector<Gap> gaps = gaps_of({plate, circle(1, 1)}, 0.01);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_NEAR(gaps[0].width, 0.001, 1e-12);
  EXPECT_EQ(gaps_of({circle(1, 1), box(1.002, -1, 2, 1)}, 0.01).size(), 1u);
}

}  // namespace

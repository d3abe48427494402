// Many regions, holes, vertices and segments: known counts, at sizes where comparing everything with everything takes
// minutes.

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "geometry/arrangement.hpp"
#include "geometry/box_tree.hpp"
#include "geometry/outline_check.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

TEST(BoxTree, finds_what_a_search_through_all_finds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1), size(0, 0.05);
  for (const int count : {0, 1, 8, 9, 500}) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
      const Point low(place(random), place(random));
      boxes.emplace_back(low, low + Point(size(random), size(random)));
    }
    const BoxTree tree(boxes);
    for (int trial = 0; trial < 200; ++trial) {
      const Point low(place(random), place(random));
      const Box query(low, low + Point(size(random), size(random)));
      std::vector<int> expected;
      for (int i = 0; i < count; ++i)
        if (boxes[i].intersects(query)) expected.push_back(i);
      EXPECT_EQ(tree.meeting(query), expected);
    }
  }
}

TEST(Many, squares_that_fill_a_square_share_all_inner_edges) {
  constexpr int side = 200;
  std::vector<Outline> regions;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) regions.push_back(box(i, j, i + 1, j + 1));
  const Arrangement arrangement = arrange(regions);
  EXPECT_EQ(arrangement.contacts.size(), 2u * 2 * side * (side - 1));
  EXPECT_TRUE(arrangement.hinges.empty());
  EXPECT_FALSE(arrangement.overlap);
}

TEST(Many, squares_of_one_colour_touch_in_hinges) {
  constexpr int side = 200;
  std::vector<Outline> regions;
  for (int i = 0; i < side; ++i)
    for (int j = i % 2; j < side; j += 2) regions.push_back(box(i, j, i + 1, j + 1));
  const Arrangement arrangement = arrange(regions);
  EXPECT_TRUE(arrangement.contacts.empty());
  EXPECT_EQ(arrangement.hinges.size(), static_cast<std::size_t>((side - 1) * (side - 1)));
}

TEST(Many, inclusions_fill_the_holes_of_a_plate) {
  constexpr int side = 100;
  std::vector<Outline> regions{box(0, 0, side, side)};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const std::vector<Point> loop = box_loop(i + 0.25, j + 0.25, i + 0.75, j + 0.75);
      regions[0].loops.push_back(reversed(loop));
      regions.push_back({{loop}});
    }
  EXPECT_TRUE(check_outline(regions[0]).sound());
  const Arrangement arrangement = arrange(regions);
  EXPECT_EQ(arrangement.contacts.size(), 2u * 4 * side * side);
  EXPECT_TRUE(arrangement.hinges.empty());
  EXPECT_FALSE(arrangement.overlap);
}

TEST(Many, vertices_of_a_fine_outline_are_checked) {
  constexpr int count = 200000;
  Outline wavy{{{}}};
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count, radius = 1 + 0.1 * std::sin(50 * angle);
    wavy.loops[0].emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  EXPECT_TRUE(check_outline(wavy).sound());
  // One vertex pulled across the other side.
  wavy.loops[0][count / 3] *= -1.5;
  EXPECT_EQ(check_outline(wavy).defect, OutlineDefect::self_crossing);
}

}  // namespace

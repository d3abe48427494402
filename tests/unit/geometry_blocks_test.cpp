// Sets of blocks of a grid: those near a segment, and those without gaps.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/blocks.hpp"

namespace {

using namespace bempd;

Blocks all_near(const BlockGrid& grid, const Segment& segment, double reach) {
  Blocks found;
  for (int i = -40; i < 40; ++i)
    for (int j = -40; j < 40; ++j)
      if (distance(grid.box({i, j}), segment) < reach) found.insert({i, j});
  return found;
}

TEST(Blocks, near_a_segment_are_those_of_the_whole_grid_that_are_near) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-3, 3), reach(0.01, 1);
  const BlockGrid grid{{0.07, -0.03}, 0.2};
  for (int k = 0; k < 200; ++k) {
    const Point start(place(random), place(random)), other(place(random), place(random));
    const Point end = k % 4 == 0 ? Point(start.x(), other.y()) : k % 4 == 1 ? Point(other.x(), start.y()) : other;
    const double away = reach(random);
    EXPECT_EQ(grid.near({start, end}, away), all_near(grid, {start, end}, away)) << k;
  }
  EXPECT_EQ(grid.near({{1, 1}, {1, 1}}, 0.5), all_near(grid, {{1, 1}, {1, 1}}, 0.5));
}

// Blocks that a set of blocks encloses, by a flood from outside.
Blocks enclosed_by(const Blocks& blocks, int size) {
  Blocks outside{{-1, -1}};
  std::vector<Block> waiting{{-1, -1}};
  while (!waiting.empty()) {
    const Block at = waiting.back();
    waiting.pop_back();
    for (const auto& [x, y] : {Block{1, 0}, Block{-1, 0}, Block{0, 1}, Block{0, -1}}) {
      const Block next{at[0] + x, at[1] + y};
      const bool is_within = std::min(next[0], next[1]) >= -1 && std::max(next[0], next[1]) <= size;
      if (is_within && !blocks.contains(next) && outside.insert(next).second) waiting.push_back(next);
    }
  }
  Blocks found;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      if (!blocks.contains({i, j}) && !outside.contains({i, j})) found.insert({i, j});
  return found;
}

TEST(Blocks, that_are_enclosed_are_the_gaps_that_may_be_closed) {
  std::mt19937 random(3);
  constexpr int size = 12;
  for (int k = 0; k < 200; ++k) {
    Blocks blocks;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        if (random() % 100 < 55) blocks.insert({i, j});
    const Blocks enclosed = enclosed_by(blocks, size), before = blocks;
    const bool is_closed = close_gaps(blocks, [](const Block&) { return true; });
    EXPECT_TRUE(is_closed && enclosed_by(blocks, size).empty()) << k;
    for (const Block& block : enclosed) EXPECT_TRUE(blocks.contains(block)) << k;
    Blocks same = before;
    EXPECT_LE(close_gaps(same, [](const Block&) { return false; }), enclosed.empty()) << k;
    EXPECT_EQ(same, before);
  }
}

// A box around this diagonal has 4e8 blocks.
TEST(Blocks, along_a_long_diagonal_take_time_by_its_length) {
  const BlockGrid grid{{0, 0}, 1};
  Blocks blocks = grid.near({{0, 0}, {2e4, 2e4}}, 1.5);
  const std::size_t count = blocks.size();
  EXPECT_GT(count, 8e4);
  EXPECT_TRUE(close_gaps(blocks, [](const Block&) { return true; }));
  EXPECT_LT(blocks.size(), 1.1 * static_cast<double>(count));
}

}  // namespace

#include "geometry/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bempd {

namespace {

constexpr std::array<Block, 4> sides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Block beside(const Block& block, const Block& step, int count = 1) {
  return {block[0] + count * step[0], block[1] + count * step[1]};
}

// Missing blocks that `blocks` enclose.
Blocks enclosed(const Blocks& blocks) {
  if (blocks.empty()) return {};
  Block low = *blocks.begin(), high = low;
  for (const Block& block : blocks)
    for (int k = 0; k < 2; ++k) low[k] = std::min(low[k], block[k] - 1), high[k] = std::max(high[k], block[k] + 1);
  Blocks outside{low};
  std::vector<Block> waiting{low};
  while (!waiting.empty()) {
    const Block block = waiting.back();
    waiting.pop_back();
    for (const Block& side : sides) {
      const Block next = beside(block, side);
      const bool within = next[0] >= low[0] && next[0] <= high[0] && next[1] >= low[1] && next[1] <= high[1];
      if (within && !blocks.count(next) && outside.insert(next).second) waiting.push_back(next);
    }
  }
  Blocks found;
  for (int i = low[0]; i <= high[0]; ++i)
    for (int j = low[1]; j <= high[1]; ++j)
      if (!blocks.count({i, j}) && !outside.count({i, j})) found.insert({i, j});
  return found;
}

// Missing blocks that close gaps of one block in a row or a column.
Blocks between(const Blocks& blocks) {
  Blocks found;
  for (const Block& block : blocks)
    for (const Block& step : {sides[0], sides[1]})
      if (!blocks.count(beside(block, step)) && blocks.count(beside(block, step, 2))) found.insert(beside(block, step));
  return found;
}

// Pairs of missing blocks at the corners where two blocks meet without a common side. Either block of a pair would join
// the two blocks.
std::vector<std::array<Block, 2>> hinges(const Blocks& blocks) {
  std::vector<std::array<Block, 2>> found;
  for (const Block& block : blocks)
    for (const int up : {1, -1}) {
      const Block right = beside(block, {1, 0}), over = beside(block, {0, up});
      if (blocks.count({block[0] + 1, block[1] + up}) && !blocks.count(right) && !blocks.count(over))
        found.push_back({right, over});
    }
  return found;
}

}  // namespace

double distance(const Box& box, const Segment& segment) {
  if (box.contains(segment.start) || box.contains(segment.end)) return 0;
  double least = std::numeric_limits<double>::infinity();
  const std::array<Point, 4> corners{box.min(), Point(box.max().x(), box.min().y()), box.max(),
                                     Point(box.min().x(), box.max().y())};
  for (std::size_t k = 0; k < 4; ++k)
    least = std::min(least, closest_approach({corners[k], corners[(k + 1) % 4]}, segment).distance);
  return least;
}

Blocks BlockGrid::near(const Segment& segment, double reach) const {
  const auto number = [&](double coordinate, int axis) {
    return static_cast<int>(std::floor((coordinate - origin[axis]) / size));
  };
  const Point low = segment.start.cwiseMin(segment.end), high = segment.start.cwiseMax(segment.end);
  Blocks found;
  for (int i = number(low.x() - reach, 0); i <= number(high.x() + reach, 0); ++i)
    for (int j = number(low.y() - reach, 1); j <= number(high.y() + reach, 1); ++j)
      if (distance(box({i, j}), segment) < reach) found.insert({i, j});
  return found;
}

bool close_gaps(Blocks& blocks, const std::function<bool(const Block&)>& may_add) {
  for (bool grows = true; grows;) {
    grows = false;
    for (const Blocks& missing : {between(blocks), enclosed(blocks)})
      for (const Block& block : missing)
        if (may_add(block)) grows |= blocks.insert(block).second;
    for (const auto& [first, second] : hinges(blocks)) {
      if (blocks.count(first) || blocks.count(second)) continue;
      if (may_add(first) || may_add(second)) grows |= blocks.insert(may_add(first) ? first : second).second;
    }
  }
  return hinges(blocks).empty() && enclosed(blocks).empty();
}

std::vector<Blocks> connected_parts(const Blocks& blocks) {
  std::vector<Blocks> parts;
  Blocks left = blocks;
  while (!left.empty()) {
    std::vector<Block> waiting{*left.begin()};
    left.erase(left.begin());
    parts.emplace_back();
    while (!waiting.empty()) {
      const Block block = waiting.back();
      waiting.pop_back();
      parts.back().insert(block);
      for (const Block& side : sides)
        if (left.erase(beside(block, side)) > 0) waiting.push_back(beside(block, side));
    }
  }
  return parts;
}

std::vector<Point> loop_around(const Blocks& blocks, const BlockGrid& grid) {
  std::map<Block, Block> next;  // next corner of the grid along the outline
  for (const Block& block : blocks) {
    const auto [i, j] = block;
    const std::array<Block, 4> corners{{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i, j}}};
    for (std::size_t k = 0; k < 4; ++k)
      if (!blocks.count(beside(block, sides[k]))) next[corners[k]] = corners[(k + 1) % 4];
  }
  const Block first = next.begin()->first;  // lowest one of the leftmost corners, where the outline turns
  std::vector<Point> loop;
  Block before = first, at = first;
  do {
    const Block behind = next.at(at);
    const bool is_corner =
        at == first || (behind[0] - at[0]) != (at[0] - before[0]) || (behind[1] - at[1]) != (at[1] - before[1]);
    if (is_corner) loop.push_back(grid.corner(at[0], at[1]));
    before = at, at = behind;
  } while (at != first);
  return loop;
}

}  // namespace bempd

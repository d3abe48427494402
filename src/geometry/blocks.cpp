#include "geometry/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "cancellation.hpp"

namespace bempd {

namespace {

constexpr std::array<Block, 4> sides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Block beside(const Block& block, const Block& step, int count = 1) {
  return {block[0] + count * step[0], block[1] + count * step[1]};
}

// Blocks of a column that are not in a set, from the row `low` to `high`, and the number of their connected part.
struct FreeRows {
  int column, low, high, part;
};

// Gaps in the columns of a set of blocks and in one column on either side. Each reaches at most one row past the set.
std::vector<FreeRows> free_rows_beside(const Blocks& blocks) {
  int lowest = (*blocks.begin())[1], highest = lowest;
  for (const Block& block : blocks) lowest = std::min(lowest, block[1]), highest = std::max(highest, block[1]);
  const int first = (*blocks.begin())[0] - 1, last = (*blocks.rbegin())[0] + 1;
  std::vector<FreeRows> gaps;
  auto block = blocks.begin();
  for (int column = first; column <= last; ++column) {
    int low = lowest - 1;
    const auto add = [&](int high) {
      if (low <= high) gaps.push_back({column, low, high, static_cast<int>(gaps.size())});
    };
    for (; block != blocks.end() && (*block)[0] == column; ++block) add((*block)[1] - 1), low = (*block)[1] + 1;
    add(highest + 1);
  }
  return gaps;
}

// Missing blocks that `blocks` enclose. The gaps of neighbouring columns are joined where they have a row in common, so
// that the work grows with the number of blocks, and not with the box around them.
Blocks enclosed(const Blocks& blocks) {
  if (blocks.empty()) return {};
  std::vector<FreeRows> gaps = free_rows_beside(blocks);
  const auto part_of = [&](int gap) {
    while (gaps[static_cast<std::size_t>(gap)].part != gap) {
      int& part = gaps[static_cast<std::size_t>(gap)].part;
      gap = part = gaps[static_cast<std::size_t>(part)].part;
    }
    return gap;
  };
  for (std::size_t one = 0, other = 0; one < gaps.size(); ++one) {
    const FreeRows& gap = gaps[one];
    while (other < gaps.size() &&
           (gaps[other].column <= gap.column || (gaps[other].column == gap.column + 1 && gaps[other].high < gap.low)))
      ++other;
    for (std::size_t k = other; k < gaps.size() && gaps[k].column == gap.column + 1 && gaps[k].low <= gap.high; ++k) {
      const int a = part_of(static_cast<int>(one)), b = part_of(static_cast<int>(k));
      gaps[static_cast<std::size_t>(std::max(a, b))].part = std::min(a, b);
    }
  }
  Blocks found;
  for (std::size_t k = 0; k < gaps.size(); ++k)
    if (part_of(static_cast<int>(k)) != 0)
      for (int row = gaps[k].low; row <= gaps[k].high; ++row) found.insert({gaps[k].column, row});
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

// Only the part of the segment beside a column is looked at there, so that the work grows with the segment's length.
Blocks BlockGrid::near(const Segment& segment, double reach) const {
  const auto number = [&](double coordinate, int axis) {
    return static_cast<int>(std::floor((coordinate - origin[axis]) / size));
  };
  const Point low = segment.start.cwiseMin(segment.end), high = segment.start.cwiseMax(segment.end);
  const double run = segment.end.x() - segment.start.x();
  Blocks found;
  for (int i = number(low.x() - reach, 0); i <= number(high.x() + reach, 0); ++i) {
    check_cancelled();
    const double left = corner(i, 0).x() - reach - 0.5 * size, right = corner(i + 1, 0).x() + reach + 0.5 * size;
    double bottom = low.y(), top = high.y();
    if (std::abs(run) > right - left) {
      const auto height = [&](double x) { return segment.at(std::clamp((x - segment.start.x()) / run, 0.0, 1.0)).y(); };
      std::tie(bottom, top) = std::minmax({height(left), height(right)});
    }
    for (int j = number(bottom - reach, 1); j <= number(top + reach, 1); ++j)
      if (distance(box({i, j}), segment) < reach) found.insert({i, j});
  }
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

#include <gtest/gtest.h>

#include <map>

#include "linalg/disjoint_sets.hpp"
#include "regions/cell_splits.hpp"

namespace regions_cell_splits_test {
namespace {

using namespace bempd;
using regions::SplitCells;

// Nodes at whole places, 0 .. n in both directions, and the cells between them.
struct Grid {
  explicit Grid(int cells_a_side) : n(cells_a_side) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) nodes.emplace_back(i, j);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) cells.insert(cells.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  int at(int i, int j) const { return j * (n + 1) + i; }
  // Parts of the split cells that hang together.
  int parts(const SplitCells& split) const {
    const int count = static_cast<int>(nodes.size() + split.added.size());
    linalg::DisjointSets joined(count);
    std::vector<char> used(static_cast<std::size_t>(count), 0);
    for (std::size_t c = 0; c < split.nodes.size(); ++c) {
      used[split.nodes[c]] = 1;
      joined.join(split.nodes[c], split.nodes[c - c % 4]);
    }
    int parts = 0;
    for (int k = 0; k < count; ++k) parts += used[k] && joined.find(k) == k ? 1 : 0;
    return parts;
  }
  double area(const SplitCells& split) const {
    const auto place = [&](int k) {
      return k < static_cast<int>(nodes.size()) ? nodes[k] : split.added[k - nodes.size()].place;
    };
    double sum = 0;
    for (std::size_t c = 0; c < split.nodes.size(); c += 4)
      sum += 0.5 * cross(place(split.nodes[c + 2]) - place(split.nodes[c]),
                         place(split.nodes[c + 3]) - place(split.nodes[c + 1]));
    return sum;
  }

  int n;
  std::vector<Point> nodes;
  std::vector<std::int32_t> cells;
};

TEST(CellSplits, whole_cells_stay_as_they_are) {
  const Grid grid(3);
  const SplitCells split = regions::split_cells(grid.nodes, grid.cells, {});
  EXPECT_TRUE(split.added.empty());
  EXPECT_EQ(split.nodes, grid.cells);
}

TEST(CellSplits, crack_through_the_grid_leaves_two_parts) {
  const Grid grid(4);
  std::vector<std::array<int, 2>> parted;
  for (int j = 0; j <= 4; ++j) parted.push_back({grid.at(2, j), grid.at(1, j)});
  const SplitCells split = regions::split_cells(grid.nodes, grid.cells, parted);
  EXPECT_EQ(grid.parts(split), 2);
  EXPECT_DOUBLE_EQ(grid.area(split), 16);
  // What is added on the crack takes its values from its own side.
  for (const regions::AddedPoint& added : split.added) {
    if (added.place.x() != 1.5) continue;
    const bool left = added.nodes[0] % 5 <= 1;
    for (const int node : added.nodes) EXPECT_EQ(node % 5 <= 1, left);
  }
}

TEST(CellSplits, crack_that_ends_inside_leaves_one_part) {
  const Grid grid(4);
  const std::vector<std::array<int, 2>> parted{{grid.at(1, 0), grid.at(2, 0)}, {grid.at(1, 1), grid.at(2, 1)}};
  const SplitCells split = regions::split_cells(grid.nodes, grid.cells, parted);
  EXPECT_EQ(grid.parts(split), 1);
  EXPECT_DOUBLE_EQ(grid.area(split), 16);
  EXPECT_EQ(split.nodes.size(), 4u * (16 - 2 + 2 + 4));
}

TEST(CellSplits, crack_opens_where_it_steps_sideways) {
  const Grid grid(4);
  // The crack runs up between columns 1 and 2, then between 2 and 3: the bond along the step between them, (2,1) to
  // (2,2), is whole.
  const std::vector<std::array<int, 2>> parted{{grid.at(1, 0), grid.at(2, 0)},
                                               {grid.at(1, 1), grid.at(2, 1)},
                                               {grid.at(2, 2), grid.at(3, 2)},
                                               {grid.at(2, 3), grid.at(3, 3)},
                                               {grid.at(2, 4), grid.at(3, 4)}};
  EXPECT_EQ(grid.parts(regions::split_cells(grid.nodes, grid.cells, parted)), 2);
}

TEST(CellSplits, pieces_fit_the_cells_beside) {
  const Grid grid(4);
  std::vector<std::array<int, 2>> parted;
  for (int j = 0; j <= 4; ++j) parted.push_back({grid.at(1, j), grid.at(2, j)});
  parted.push_back({grid.at(2, 2), grid.at(2, 3)});
  parted.push_back({grid.at(3, 2), grid.at(3, 3)});
  parted.push_back({grid.at(4, 2), grid.at(4, 3)});
  const SplitCells split = regions::split_cells(grid.nodes, grid.cells, parted);
  EXPECT_EQ(grid.parts(split), 3);
  EXPECT_DOUBLE_EQ(grid.area(split), 16);
  // Sides of one piece only lie on the outline or on the crack.
  std::map<std::pair<int, int>, int> sides;
  for (std::size_t c = 0; c < split.nodes.size(); c += 4)
    for (std::size_t k = 0; k < 4; ++k) ++sides[std::minmax(split.nodes[c + k], split.nodes[c + (k + 1) % 4])];
  const auto place = [&](int k) {
    return k < static_cast<int>(grid.nodes.size()) ? grid.nodes[k] : split.added[k - grid.nodes.size()].place;
  };
  for (const auto& [side, count] : sides) {
    if (count == 2) continue;
    const Point middle = 0.5 * (place(side.first) + place(side.second));
    const bool outline = middle.minCoeff() == 0 || middle.maxCoeff() == 4;
    EXPECT_TRUE(outline || middle.x() == 1.5 || middle.y() == 2.5) << middle.transpose();
  }
}

// A triangle has its last corner twice.
TEST(CellSplits, triangles_part_too) {
  Grid grid(1);
  grid.cells = {0, 1, 3, 3, 0, 3, 2, 2};
  const std::vector<std::array<int, 2>> parted{{0, 1}, {0, 2}, {0, 3}};
  const SplitCells split = regions::split_cells(grid.nodes, grid.cells, parted);
  EXPECT_EQ(grid.parts(split), 2);
  EXPECT_DOUBLE_EQ(grid.area(split), 1);
}

TEST(CellSplits, node_without_bonds_comes_loose) {
  const Grid grid(2);
  const std::vector<std::array<int, 2>> parted{{grid.at(1, 1), grid.at(0, 1)},
                                               {grid.at(1, 1), grid.at(2, 1)},
                                               {grid.at(1, 1), grid.at(1, 0)},
                                               {grid.at(1, 1), grid.at(1, 2)}};
  const SplitCells split = regions::split_cells(grid.nodes, grid.cells, parted);
  EXPECT_EQ(grid.parts(split), 2);
  EXPECT_DOUBLE_EQ(grid.area(split), 4);
}

}  // namespace
}  // namespace regions_cell_splits_test

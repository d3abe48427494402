#include "regions/cell_splits.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace bempd::regions {

namespace {

using Pair = std::array<int, 2>;

Pair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

class CellSplitter {
 public:
  CellSplitter(std::span<const Point> nodes, std::span<const std::int32_t> cells, std::span<const Pair> parted)
      : nodes_(nodes), cells_(cells) {
    for (const Pair& pair : parted) parted_.insert(ordered(pair[0], pair[1]));
    open_steps();
  }

  SplitCells split() {
    for (std::size_t c = 0; c < cells_.size() / 4; ++c) {
      if (parted_sides(c) == 0)
        result_.nodes.insert(result_.nodes.end(), {corner(c, 0), corner(c, 1), corner(c, 2), corner(c, 3)});
      else
        split(c);
    }
    return std::move(result_);
  }

 private:
  int corner(std::size_t cell, std::size_t k) const { return cells_[4 * cell + k % 4]; }
  Pair side(std::size_t cell, std::size_t k) const { return ordered(corner(cell, k), corner(cell, k + 1)); }
  bool is_parted(std::size_t cell, std::size_t k) const { return parted_.contains(side(cell, k)); }
  int parted_sides(std::size_t cell) const {
    int count = 0;
    for (std::size_t k = 0; k < 4; ++k) count += is_parted(cell, k) ? 1 : 0;
    return count;
  }

  void open_steps();
  Point place(std::size_t cell, std::size_t k) const { return nodes_[static_cast<std::size_t>(corner(cell, k))]; }
  void split(std::size_t cell);
  int middle(std::size_t cell, std::size_t k, std::size_t seen_from);
  int centre(std::size_t cell, std::size_t first, std::size_t count);
  int add(const std::vector<int>& key, const Point& at, const std::vector<int>& nodes);

  std::span<const Point> nodes_;
  std::span<const std::int32_t> cells_;
  std::set<Pair> parted_;
  std::map<std::vector<int>, int> made_;
  SplitCells result_;
};

// Opens (adds to `parted_`) the side that two neighbouring cells share if each of the cells has exactly one parted side
// (side whose bond is broken) and the shared side meets both parted sides. A crack steps from one row of cells to the
// next at such a side.
void CellSplitter::open_steps() {
  std::map<Pair, int> ends;  // sides next to the only parted side of a cell
  for (std::size_t c = 0; c < cells_.size() / 4; ++c) {
    if (parted_sides(c) != 1) continue;
    for (std::size_t k = 0; k < 4; ++k)
      if (is_parted(c, k + 1) || is_parted(c, k + 3)) ++ends[side(c, k)];
  }
  for (const auto& [pair, count] : ends)
    if (count == 2) parted_.insert(pair);
}

// Adds a point with the mean values of `nodes` and returns its number; returns the number of the existing point if one
// has this `key`. Points for different faces of a crack lie at one place and have different keys.
int CellSplitter::add(const std::vector<int>& key, const Point& at, const std::vector<int>& nodes) {
  const auto [found, is_new] = made_.try_emplace(key, static_cast<int>(nodes_.size() + result_.added.size()));
  if (is_new) result_.added.push_back({at, nodes});
  return found->second;
}

// Middle of side k of a cell. On an intact side it has the mean values of both ends. On a parted side (side whose bond
// is broken) there are two copies of it, each with the values of one end; the copy of the corner `seen_from` is
// returned.
int CellSplitter::middle(std::size_t cell, std::size_t k, std::size_t seen_from) {
  const Pair ends = side(cell, k);
  const Point at = 0.5 * (place(cell, k) + place(cell, k + 1));
  if (!is_parted(cell, k)) return add({ends[0], ends[1]}, at, {ends[0], ends[1]});
  const int own = corner(cell, seen_from);
  return add({ends[0], ends[1], own}, at, {own});
}

// Centre of a cell for one of the pieces into which the cell is split: a copy with the mean values of the piece's
// corners, which are `count` corners from the corner `first` on.
int CellSplitter::centre(std::size_t cell, std::size_t first, std::size_t count) {
  std::vector<int> group, key{-1, static_cast<int>(cell)};
  for (std::size_t k = first; k < first + count; ++k) group.push_back(corner(cell, k));
  key.insert(key.end(), group.begin(), group.end());
  return add(key, 0.25 * (place(cell, 0) + place(cell, 1) + place(cell, 2) + place(cell, 3)), group);
}

// Splits a cell along the crack through its parted sides (sides whose bonds are broken). Intact sides get no middle
// point, so that the pieces fit the neighbouring cells, except in a cell with one parted side, in which a crack ends.
void CellSplitter::split(std::size_t cell) {
  const auto piece = [&](int a, int b, int c, int d) { result_.nodes.insert(result_.nodes.end(), {a, b, c, d}); };
  const auto at = [&](std::size_t k) { return corner(cell, k); };
  if (parted_sides(cell) == 1) {
    for (std::size_t k = 0; k < 4; ++k) piece(at(k), middle(cell, k, k), centre(cell, 0, 4), middle(cell, k + 3, k));
    return;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (!is_parted(cell, k + 3)) continue;  // this corner is connected to the corner before
    std::size_t count = 1;
    while (!is_parted(cell, k + count - 1)) ++count;
    const int before = middle(cell, k + 3, k), behind = middle(cell, k + count - 1, k + count - 1);
    if (count == 2) {
      piece(at(k), at(k + 1), behind, before);
      continue;
    }
    const int inner = centre(cell, k, count);
    if (count == 1) {
      piece(at(k), behind, inner, before);
    } else {
      piece(at(k), at(k + 1), inner, before);
      piece(at(k + 1), at(k + 2), behind, inner);
    }
  }
}

}  // namespace

SplitCells split_cells(std::span<const Point> nodes, std::span<const std::int32_t> cells,
                       std::span<const Pair> parted) {
  return CellSplitter(nodes, cells, parted).split();
}

}  // namespace bempd::regions

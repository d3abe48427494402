#include "regions/patches_back.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/measured_path.hpp"

namespace bempd::regions {

namespace {

// Least length of the path behind a tip that stays in the lattice [blocks]. With six horizons behind the tip, load
// factors of growth are within 6e-4 of those in a whole lattice.
constexpr double least_behind = 3;

// Least length of path that is given back at a time [blocks].
constexpr double least_given = 3;

// Least cosine of the angle between a crack's path and the normal of a new border, at the place where the path crosses
// this border.
constexpr double least_cosine = 0.6;

// Length of path before and behind its crossing with a new border, in blocks, from which the path's direction at the
// border is taken.
constexpr double piece_at_border = 0.5;

// Distance from a new border, in blocks along the path, within which a block stays if it lies on the right side of the
// straight border. For other blocks, the place of the path nearest to the block decides.
constexpr double straight_border = 3;

// Least distance of blocks that stay from the path in blocks that are given back [blocks]. It is required only of
// pieces of the path that are farther than half of straight_border from a new border.
constexpr double least_apart = 0.5;

// Least distance of blocks that are given back from the paths of other cracks, in blocks.
constexpr double apart_from_others = 0.5;

// Least number of blocks without lattice between the two parts into which a patch falls, as between two patches.
constexpr int between_parts = 2;

// New border across a path: the path's crossing with a line of the grid, and the side of this line on which blocks stay
// (1: side of greater coordinates, -1: other side).
struct NewBorder {
  GridCrossing crossing;
  int kept_side;

  Block block(int side, int row) const {
    Block found;
    found[crossing.axis] = crossing.line - (side > 0 ? 0 : 1), found[1 - crossing.axis] = row;
    return found;
  }
  bool keeps(const Block& block) const { return (block[crossing.axis] >= crossing.line) == (kept_side > 0); }
};

class GivingPatch {
 public:
  GivingPatch(const std::vector<Patch>& patches, std::size_t number, MeasuredPath path,
              std::vector<MeasuredPath> others)
      : patches_(patches),
        number_(number),
        path_(std::move(path)),
        others_(std::move(others)),
        crossings_(crossings_of(path_, grid())) {}

  // Blocks that the patch can give back behind the path's last point, which is a tip in the patch.
  std::optional<GivenBack> behind_tip() const {
    const double size = grid().size, length = path_.length();
    for (auto at = crossings_.rbegin(); at != crossings_.rend(); ++at) {
      if (at->way > length - least_behind * size) continue;
      const std::optional<NewBorder> border = border_at(*at, 1);
      if (!border) continue;
      const double entry = entry_before(at->way);
      if (at->way - entry < least_given * size) return std::nullopt;
      if (entry > 0) {
        if (auto given = given_between(std::nullopt, *border, entry)) return given;
        continue;
      }
      for (const GridCrossing& other : crossings_) {
        if (other.way < least_behind * size) continue;
        if (at->way - other.way < least_given * size) break;
        if (const auto first = border_at(other, -1))
          if (auto given = given_between(first, *border, other.way)) return given;
      }
    }
    return std::nullopt;
  }

 private:
  const Patch& own() const { return patches_[number_]; }
  const BlockGrid& grid() const { return own().grid; }

  Block block_around(const Point& place) const {
    const Point at = (place - grid().origin) / grid().size;
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  }

  // New border of the patch at a crossing of the path with a line of the grid; empty if the path does not cross this
  // line straight enough. Blocks stay on the side to which the path goes if `kept` is 1, on the side from which it
  // comes if `kept` is -1.
  std::optional<NewBorder> border_at(const GridCrossing& crossing, int kept) const {
    const double piece = piece_at_border * grid().size;
    const Point along = (path_.at(crossing.way + piece) - path_.at(crossing.way - piece)).normalized();
    const double normal = along[static_cast<Eigen::Index>(crossing.axis)];
    if (std::abs(normal) < least_cosine) return std::nullopt;
    return NewBorder{crossing, normal > 0 ? kept : -kept};
  }

  // Calls visit(block, start, end) for the pieces of the path between lines of the grid, from the distance `from` along
  // the path to the distance `to`, until a call returns false. Each piece lies in `block`, between the distances
  // `start` and `end`. Returns whether all calls returned true.
  template <class Visit>
  bool each_cell(double from, double to, const Visit& visit) const {
    double start = from;
    const auto piece_to = [&](double end) {
      const bool goes_on =
          end - start <= 1e-9 * grid().size || visit(block_around(path_.at(0.5 * (start + end))), start, end);
      start = end;
      return goes_on;
    };
    for (const GridCrossing& crossing : crossings_)
      if (crossing.way > from && crossing.way < to && !piece_to(crossing.way)) return false;
    return piece_to(to);
  }

  // Distance along the path at which the path enters the patch for the last time before the distance `way`; 0 if the
  // path begins in the patch.
  double entry_before(double way) const {
    double entry = 0;
    each_cell(0, way, [&](const Block& block, double, double end) {
      if (!own().blocks.contains(block)) entry = end;
      return true;
    });
    return entry;
  }

  // All patches after the blocks between two new borders have been given back; without a first border, after all blocks
  // before the second one have. The path runs in these blocks from the distance `from` on. Empty if the blocks cannot
  // be given back.
  std::optional<GivenBack> given_between(const std::optional<NewBorder>& first, const NewBorder& second,
                                         double from) const {
    const double to = second.crossing.way;
    Blocks kept;
    for (const Block& block : own().blocks)
      if (!is_left_behind(block, first, second)) kept.insert(block);
    const auto may_add = [&](const Block& block) { return own().blocks.contains(block); };
    if (!close_gaps(kept, may_add)) return std::nullopt;
    std::vector<Blocks> parts;
    const Block at_tip = block_around(path_.at(path_.length())), at_start = block_around(path_.at(0));
    for (Blocks& part : connected_parts(kept)) {
      const bool has_tip = part.contains(at_tip), has_start = first && part.contains(at_start);
      if (has_tip && has_start) return std::nullopt;
      if (has_tip || has_start) {
        parts.insert(has_tip ? parts.begin() : parts.end(), std::move(part));
      } else if (std::ranges::any_of(part, [&](const Block& block) { return is_near_path(block); })) {
        return std::nullopt;
      }
    }
    if (parts.size() != (first ? 2U : 1U) || (first && !are_apart(parts[0], parts[1]))) return std::nullopt;
    kept.clear();
    for (const Blocks& part : parts) kept.insert(part.begin(), part.end());
    Blocks given;
    std::ranges::set_difference(own().blocks, kept, std::inserter(given, given.end()));
    if (!is_sound(kept, given, first, second, from)) return std::nullopt;
    return GivenBack{patches_with(parts), from, to, std::move(given), number_};
  }

  bool is_left_behind(const Block& block, const std::optional<NewBorder>& first, const NewBorder& second) const {
    const Point centre = grid().box(block).center();
    const MeasuredPath::Nearest nearest = path_.nearest(centre);
    const double straight = straight_border * grid().size;
    const auto is_kept_by = [&](const NewBorder& border, int side) {
      const double beyond = side * (nearest.way - border.crossing.way);
      return std::abs(beyond) <= straight ? border.keeps(block) : beyond > 0;
    };
    if (is_kept_by(second, 1) || (first && is_kept_by(*first, -1))) return false;
    return std::ranges::none_of(
        others_, [&](const MeasuredPath& other) { return other.nearest(centre).distance < nearest.distance; });
  }

  // Whether any crack passes near a block.
  bool is_near_path(const Block& block) const {
    const auto is_near = [&](const MeasuredPath& path) {
      for (std::size_t i = 0; i < path.pieces(); ++i)
        if (distance(grid().box(block), path.piece(i)) < apart_from_others * grid().size) return true;
      return false;
    };
    return is_near(path_) || std::ranges::any_of(others_, is_near);
  }

  static bool are_apart(const Blocks& one, const Blocks& other) {
    return std::ranges::none_of(one, [&](const Block& a) {
      return std::ranges::any_of(other, [&](const Block& b) {
        return std::abs(a[0] - b[0]) <= between_parts && std::abs(a[1] - b[1]) <= between_parts;
      });
    });
  }

  // Whether the path crosses the new borders away from their corners, and keeps a distance from the blocks that stay
  // where it runs through blocks that are given back. Other cracks must keep a distance from the blocks that are given
  // back, too.
  bool is_sound(const Blocks& kept, const Blocks& given, const std::optional<NewBorder>& first, const NewBorder& second,
                double from) const {
    const auto is_straight = [&](const NewBorder& border) {
      for (const int step : {-1, 0, 1}) {
        const int row = border.crossing.row + step;
        if (!kept.contains(border.block(border.kept_side, row)) || kept.contains(border.block(-border.kept_side, row)))
          return false;
      }
      return true;
    };
    if (!is_straight(second) || (first && !is_straight(*first))) return false;
    const double to = second.crossing.way, size = grid().size, near = 0.5 * straight_border * size;
    const auto is_given = [&](const Block& block, double start, double end) {
      if (!given.contains(block)) return false;
      if (end > to - near || (first && start < from + near)) return true;
      const Segment piece{path_.at(start), path_.at(end)};
      return std::ranges::none_of(kept,
                                  [&](const Block& b) { return distance(grid().box(b), piece) < least_apart * size; });
    };
    const auto is_kept = [&](const Block& block, double, double) { return kept.contains(block); };
    if (!each_cell(from, to, is_given) || !each_cell(to, path_.length(), is_kept)) return false;
    if (first && !each_cell(0, from, is_kept)) return false;
    return std::ranges::none_of(others_, [&](const MeasuredPath& other) {
      for (std::size_t i = 0; i < other.pieces(); ++i)
        for (const Block& block : given)
          if (distance(grid().box(block), other.piece(i)) < apart_from_others * size) return true;
      return false;
    });
  }

  std::vector<Patch> patches_with(const std::vector<Blocks>& parts) const {
    std::vector<Patch> all = patches_;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Patch& patch = k == 0 ? all[number_] : all.emplace_back(own());
      patch.outline = loop_around(parts[k], grid());
      patch.blocks = parts[k];
    }
    return all;
  }

  const std::vector<Patch>& patches_;
  std::size_t number_;
  MeasuredPath path_;
  std::vector<MeasuredPath> others_;
  std::vector<GridCrossing> crossings_;
};

}  // namespace

std::optional<GivenBack> given_back(const std::vector<Patch>& patches, const std::vector<std::vector<Point>>& paths,
                                    int crack, int end) {
  const auto own = static_cast<std::size_t>(crack) - 1;
  std::vector<Point> points = paths[own];
  if (points.size() < 2) return std::nullopt;
  if (end == 0) std::ranges::reverse(points);
  const std::size_t number = patch_around(patches, points.back());
  if (number == patches.size()) return std::nullopt;
  std::vector<MeasuredPath> others;
  for (std::size_t c = 0; c < paths.size(); ++c)
    if (c != own && paths[c].size() > 1) others.emplace_back(paths[c]);
  MeasuredPath path(std::move(points));
  const double length = path.length();
  std::optional<GivenBack> given = GivingPatch(patches, number, std::move(path), std::move(others)).behind_tip();
  if (given && end == 0) given->from = length - std::exchange(given->to, length - given->from);
  return given;
}

}  // namespace bempd::regions

#include "model/given_back.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "crack/path.hpp"
#include "geometry/segment.hpp"
#include "model/driven_growth.hpp"
#include "model/prepared_scene.hpp"

// Parts of crack lines (cracks in lattices) that lattice patches give back to boundary elements.
namespace bempd::model {

namespace {

// Largest distance, in spacings, by which a crack's path may shift if a point is left out of it where boundary elements
// carry the crack.
constexpr double off_path = 0.02;

// Distance in spacings from a crack's path within which a bond counts as broken by the crack, or a material point as
// lying on it.
constexpr double beside_path = 0.25;

// Marks points of a polyline between the points `first` and `last`, until no point is farther than `off` from the
// polyline through the marked points (Douglas-Peucker).
void mark_needed(const std::vector<Point>& points, std::size_t first, std::size_t last, double off,
                 std::vector<char>& is_needed) {
  std::size_t farthest = first;
  double most = off;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double apart = distance(Segment{points[first], points[last]}, points[i]); apart > most)
      most = apart, farthest = i;
  if (farthest == first) return;
  is_needed[farthest] = 1;
  mark_needed(points, first, farthest, off, is_needed);
  mark_needed(points, farthest, last, off, is_needed);
}

// Leaves out points of a crack that growth has added, where the path then moves by at most `off`: only points whose
// distance along the crack is between `from` and `to`.
void leave_out_points(scene::Crack& crack, double from, double to, double off) {
  const std::vector<Point>& points = crack.points;
  const std::size_t count = points.size(), first_given = static_cast<std::size_t>(crack.grown_at_start),
                    last_given = count - 1 - static_cast<std::size_t>(crack.grown_at_end);
  std::vector<char> is_needed(count, 0);
  double way = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) way += (points[i] - points[i - 1]).norm();
    const bool is_end = i == 0 || i + 1 == count;
    is_needed[i] = is_end || way <= from || way >= to || (i >= first_given && i <= last_given) ? 1 : 0;
  }
  const std::vector<char> anchors = is_needed;
  for (std::size_t i = 0, next; i + 1 < count; i = next) {
    for (next = i + 1; !anchors[next];) ++next;
    mark_needed(points, i, next, off, is_needed);
  }
  scene::Crack shorter = crack;
  shorter.points.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (is_needed[i]) {
      shorter.points.push_back(points[i]);
    } else {
      --(i < first_given ? shorter.grown_at_start : shorter.grown_at_end);
    }
  }
  crack = std::move(shorter);
}

}  // namespace

std::optional<ShorterPatches> shorter_patches(const scene::Scene& scene, const std::vector<regions::Patch>& patches,
                                              std::span<const crack::Extension> extensions) {
  const crack::TipId tip = extensions.back().tip();
  std::vector<scene::Crack> cracks = scene.cracks();
  const auto number = static_cast<std::size_t>(tip.crack) - 1;
  if (number >= cracks.size() || cracks[number].has_begun || cracks[number].points.empty()) return std::nullopt;
  int count = static_cast<int>(cracks.size());
  for (const crack::Extension& e : extensions) count = std::max(count, e.crack);
  if (static_cast<std::size_t>(count) > cracks.size() + extensions.size()) return std::nullopt;  // altered bytes
  std::vector<std::vector<Point>> paths;
  for (int id = 1; id <= count; ++id) {
    const auto place = static_cast<std::size_t>(id) - 1;
    if (place >= cracks.size() || cracks[place].has_begun) {
      paths.push_back(points_of_path(crack::path_of(id, {}, extensions)));
      continue;
    }
    scene::Crack& crack = cracks[place];
    for (const int end : {0, 1}) add_extensions(crack, {id, end}, extensions);
    paths.push_back(crack.points);
  }
  std::optional<regions::GivenBack> layout = regions::given_back(patches, paths, tip.crack, tip.end);
  if (!layout) return std::nullopt;
  scene::Crack longer = std::move(cracks[number]);
  leave_out_points(longer, layout->from, layout->to, off_path * patches[layout->number].spacing);
  ShorterPatches back{std::move(*layout), scene.cracks(), tip.crack, std::move(paths[number])};
  back.cracks[number] = std::move(longer);
  return back;
}

bool has_separated_faces(const PreparedScene& prepared, const ShorterPatches& back) {
  const std::vector<Point>& positions = prepared.discretization.positions;
  const regions::Patch& patch = back.layout.patches[back.layout.number];
  const fracture::EvolutionState& state = prepared.evolution->progress();
  std::vector<char> is_left(positions.size(), 0);
  for (std::size_t node = 0; node < positions.size(); ++node) {
    const Point at = (positions[node] - patch.grid.origin) / patch.grid.size;
    const Block block{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
    is_left[node] = back.layout.blocks.contains(block) &&
                    regions::patch_around(back.layout.patches, positions[node]) == back.layout.patches.size();
    if (is_left[node] && state.unloaded[node]) return false;
  }
  if (std::ranges::any_of(state.springs, [&](const auto& s) { return is_left[static_cast<std::size_t>(s.node)] != 0; }))
    return false;
  const double beside = beside_path * patch.spacing;
  const auto distance_from_path = [&](const Segment& bond) {
    double least = 2 * beside;
    for (std::size_t i = 0; i + 1 < back.path.size() && least > 0; ++i) {
      const Segment piece{back.path[i], back.path[i + 1]};
      if ((piece.at(0.5) - bond.at(0.5)).norm() > 0.5 * (piece.length() + bond.length()) + beside) continue;
      least = std::min(least, closest_approach(piece, bond).distance);
    }
    return least;
  };
  // Energy terms are bonds, or cell squares (elements of a lattice cell) whose sides and diagonals count like bonds.
  const coupling::Terms& terms = prepared.system->terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    std::vector<Point> places;
    bool is_there = false;
    terms.for_each_node(t, [&](int node) { is_there |= is_left[static_cast<std::size_t>(node)] != 0; });
    if (!is_there) continue;
    terms.for_each_node(t, [&](int node) { places.push_back(positions[static_cast<std::size_t>(node)]); });
    const bool is_virgin = state.stages[t] == 0;
    if (!is_virgin && !terms.is_broken(t, state.stages[t])) return false;
    bool is_at_path = false;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        const double apart = distance_from_path({places[i], places[j]});
        const bool is_across = apart == 0 && distance_from_path({places[i], places[i]}) > beside &&
                               distance_from_path({places[j], places[j]}) > beside;
        if (is_virgin && is_across) return false;
        is_at_path |= apart <= beside;
      }
    if (!is_virgin && !is_at_path) return false;
  }
  return true;
}

}  // namespace bempd::model

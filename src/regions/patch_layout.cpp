#include "regions/patch_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cancellation.hpp"
#include "error.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/memory_limit.hpp"

namespace bempd::regions {

namespace {

constexpr int usual_horizon_ratio = 4;

// Least length of a crack, in spacings, for each of its tips.
constexpr double least_per_tip = 16;

// Number of blocks of lattice ahead of a tip that may grow, besides the blocks on every side of the tip.
constexpr double blocks_ahead = 2;

// Least number of blocks between a tip and the nearest wall (edge or crack with elements): one of elements, one of
// lattice, and one because the grid of blocks may lie anywhere.
constexpr double blocks_of_room = 3;

// Distance from a mouth (end of a crack on an edge), in blocks, within which the crack may have elements in place of
// lattice.
constexpr double blocks_at_mouth = 5;

// Loop of a wall that is a crack in a lattice.
constexpr int other_lattice_crack = -2;

std::string name_of(const CrackInBody& crack) { return text("crack ", crack.crack.id); }

}  // namespace

PatchWalls::PatchWalls(const Outline& body) : edges_(edges_of(body)) {
  constexpr double largest_turn = 0.05;  // [rad]
  int number = 0;
  for (std::size_t loop = 0; loop < body.loops.size(); ++loop)
    for (std::size_t k = 0; k < body.loops[loop].size(); ++k, ++number) {
      const Edge edge = body.edge(number);
      double turn = 0;
      for (int p = 0; p < edge.piece_count(); ++p) turn += std::abs(edge.piece(p).sweep);
      const int count = std::max(1, static_cast<int>(std::ceil(turn / largest_turn)));
      for (int i = 0; i < count; ++i)
        walls_.push_back({{edge.at(i / static_cast<double>(count)), edge.at((i + 1) / static_cast<double>(count))},
                          static_cast<int>(loop),
                          text("edge ", number + 1)});
    }
}

void PatchWalls::add_crack(const Segment& piece, int crack) { walls_.push_back({piece, -1, text("crack ", crack)}); }

const Wall* PatchWalls::nearest_to(const Box& block) const {
  const Wall* nearest = nullptr;
  double least = block.sizes().x() * less_rounding;
  for (const Wall& wall : walls_) {
    const Point middle = wall.piece.at(0.5);
    if (block.exteriorDistance(middle) - 0.5 * wall.piece.length() >= least) continue;
    const double apart = distance(block, wall.piece);
    if (apart < least) least = apart, nearest = &wall;
  }
  if (nearest || locate(edges_, block.center(), 0) == Location::inside) return nearest;
  return &walls_.front();
}

std::vector<Segment> pieces_between(const std::vector<Point>& points, const std::vector<Edge>& edges) {
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    std::vector<double> ends{0, 1};
    for (const Edge& edge : edges)
      for (const Crossing& meeting : meeting_points(Edge(points[i], points[i + 1]), edge))
        ends.push_back(meeting.fraction_a);
    std::sort(ends.begin(), ends.end());
    const Segment whole{points[i], points[i + 1]};
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      if (ends[k + 1] - ends[k] > 1e-9) pieces.push_back({whole.at(ends[k]), whole.at(ends[k + 1])});
  }
  return pieces;
}

PatchLayout::PatchLayout(const scene::Scene& scene, const scene::Options& options, int body,
                         std::vector<CrackInBody> cracks, const BodyLattice& lattice)
    : body_(body), cracks_(std::move(cracks)), walls_(scene.region(body).outline()) {
  for (int id = 1; id <= static_cast<int>(scene.cracks().size()); ++id) {
    const std::vector<Point>& points = scene.cracks()[static_cast<std::size_t>(id) - 1].points;
    const bool is_ours =
        std::any_of(cracks_.begin(), cracks_.end(), [&](const CrackInBody& c) { return c.crack.id == id; });
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Segment piece{points[i], points[i + 1]};
      is_ours ? own_cracks_.push_back({piece, other_lattice_crack, text("crack ", id)}) : walls_.add_crack(piece, id);
    }
  }
  ratio_ = lattice.horizon_ratio > 0 ? lattice.horizon_ratio : usual_horizon_ratio;
  std::string reason;
  spacing_ = lattice.spacing > 0 ? lattice.spacing : chosen_spacing(reason);
  require_memory_of_bands(scene.material_of(body), reason, options);
  grid_ = {origin(), 2 * ratio_ * spacing_};
}

// Largest lattice spacing with which every crack is long enough in spacings, and the blocks around the tips have room.
// `reason` becomes the wall or the other crack that asks for so small a spacing, if one does.
double PatchLayout::chosen_spacing(std::string& reason) const {
  const double spacings_between_cracks = 3 * ratio_;
  const double room = blocks_of_room * 2 * ratio_;  // in spacings
  double spacing = std::numeric_limits<double>::infinity();
  for (const CrackInBody& crack : cracks_) {
    const double points = least_per_tip * std::max<double>(1, static_cast<double>(crack.tips.size()));
    const double along = crack.length() / std::max(points, crack.mouths.empty() ? 0 : room);
    if (along < spacing) spacing = along, reason.clear();
    for (const CrackInBody::Tip& tip : crack.tips) {
      const auto leave_room = [&](const Wall& wall, double spacings) {
        const double apart = distance(wall.piece, tip.place);
        if (apart / spacings >= spacing) return;
        spacing = apart / spacings;
        reason = text(", because ", name_of(crack), " ends ", apart, " away from ", wall.name);
        require(apart > 0, name_of(crack), " ends on ", wall.name, " at (", tip.place.x(), ", ", tip.place.y(),
                "), so that no spacing of its lattice patch leaves room between them; give it another treatment",
                wall.loop == other_lattice_crack ? ", or choose the spacing with bempd_set_body_lattice()" : "");
      };
      for (const Wall& wall : walls_.all()) leave_room(wall, room);
      for (const Wall& wall : own_cracks_)
        if (wall.name != name_of(crack)) leave_room(wall, spacings_between_cracks);
    }
  }
  return spacing;
}

// Throws Error (argument) if the blocks along one crack need more memory than there is, before any are laid.
void PatchLayout::require_memory_of_bands(const scene::Material& material, const std::string& reason,
                                          const scene::Options& options) const {
  constexpr double most_bonds = std::numeric_limits<int>::max();
  double longest = 0;  // in blocks, without what mouths leave out
  for (const CrackInBody& crack : cracks_)
    longest = std::max(
        longest, crack.length() / (2 * ratio_ * spacing_) - blocks_at_mouth * static_cast<double>(crack.mouths.size()));
  const double cells_of_block = std::pow(2 * ratio_, 2);
  scene::SizeEstimate least;
  add_size_of_cells(material, 2 * least_patch_reach * longest * cells_of_block, ratio_, least);
  const std::string spacing = text(" with a spacing of ", spacing_, reason);
  const std::string advice = "choose a larger spacing with bempd_set_body_lattice(), or another treatment of the crack";
  require(least.bonds <= most_bonds, "lattice patches of body ", body_, " would have more than ", least.bonds, " bonds",
          spacing, "; the limit is ", most_bonds, ": ", advice);
  require_memory_for(least.bytes, text("lattice patches of body ", body_, spacing), advice, options);
}

// Distance of the first crack from the material points if the lattice has this origin, in spacings, at most 1.
double PatchLayout::clearance(const Point& origin) const {
  double least = 1;
  for (const Segment& piece : cracks_.front().pieces) {
    const Segment scaled{(piece.start - origin) / spacing_, (piece.end - origin) / spacing_};
    const int count = static_cast<int>(std::ceil(4 * scaled.length()));
    for (int i = 0; i <= count; ++i) {
      if (i % 1024 == 0) check_cancelled();
      const Point cell = scaled.at(static_cast<double>(i) / count).array().floor();
      for (const Point& corner : {Point(0, 0), Point(1, 0), Point(0, 1), Point(1, 1)})
        least = std::min(least, distance(scaled, cell + corner));
    }
  }
  return least;
}

// Origin of the grid of blocks: of the origins that are tried, the one with which the first crack passes the material
// points at the largest distance.
Point PatchLayout::origin() const {
  constexpr int parts = 8;            // number of steps of the origin in a spacing
  constexpr double is_better = 1.01;  // ratio of clearances above which an origin is better
  const CrackInBody& first = cracks_.front();
  const Point tip = first.tips.empty() ? first.pieces.front().at(0.5) : first.tips.front().place;
  const Point corner = tip - Point::Constant(ratio_ * spacing_);
  Point best = corner - Point::Constant(0.5 * spacing_);
  double most = clearance(best);
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const Point other = corner - spacing_ / parts * Point(i, j);
      const double apart = clearance(other);
      if (apart > is_better * most) most = apart, best = other;
    }
  return best;
}

// Throws Error (argument) if a wall (edge or crack with elements) is less than two blocks from the piece `along` of a
// crack. Walls of the boundary loop on which a mouth of the crack lies nearby are allowed, unless `along` is a tip.
void PatchLayout::require_room(const CrackInBody& crack, const Segment& along, bool is_tip) {
  for (const Block& block : grid_.near(along, grid_.size * less_rounding)) {
    check_cancelled();
    const Wall* wall = walls_.nearest_to(grid_.box(block));
    if (!wall) continue;
    const Point centre = grid_.box(block).center();
    const bool at_mouth = std::any_of(crack.mouths.begin(), crack.mouths.end(), [&](const auto& mouth) {
      return wall->loop == mouth.second && (mouth.first - centre).norm() < blocks_at_mouth * grid_.size;
    });
    require(at_mouth && !is_tip, name_of(crack), " has ", wall->name, " within ", 2 * grid_.size, " of it at (",
            centre.x(), ", ", centre.y(), "), where its lattice patch needs two blocks of ", grid_.size, "; ",
            advice());
  }
}

void PatchLayout::add_band(const CrackInBody& crack, double reach) {
  const auto add = [&](const Segment& line) {
    for (const Block& block : grid_.near(line, reach * grid_.size * less_rounding))
      if (is_allowed(block)) blocks_.insert(block);
  };
  for (const Segment& piece : crack.pieces) require_room(crack, piece, false), add(piece);
  for (const CrackInBody::Tip& tip : crack.tips) {
    require_room(crack, {tip.place, tip.place}, true);
    if (tip.grows) add({tip.place, tip.place + blocks_ahead * grid_.size * tip.direction});
  }
}

std::vector<Patch> PatchLayout::patches() {
  const auto lay_blocks = [&](double reach) {
    blocks_.clear();
    for (const CrackInBody& crack : cracks_) add_band(crack, reach);
    return close_gaps(blocks_, [&](const Block& block) { return is_allowed(block); });
  };
  require(lay_blocks(usual_patch_reach) || lay_blocks(least_patch_reach), "lattice patches of body ", body_,
          " would enclose a hole or another crack; ", advice());
  std::vector<Patch> all;
  for (const Blocks& part : connected_parts(blocks_)) {
    Patch patch{body_, loop_around(part, grid_), spacing_, ratio_, {}, grid_, part};
    for (const CrackInBody& crack : cracks_) {
      const bool passes = std::any_of(crack.pieces.begin(), crack.pieces.end(), [&](const Segment& piece) {
        return std::any_of(part.begin(), part.end(),
                           [&](const Block& b) { return distance(grid_.box(b), piece) == 0; });
      });
      if (passes) patch.cracks.push_back(crack.crack.id);
    }
    if (!patch.cracks.empty()) all.push_back(std::move(patch));
  }
  for (const CrackInBody& crack : cracks_) {
    const auto has_crack = [&](const Patch& patch) { return std::ranges::count(patch.cracks, crack.crack.id) > 0; };
    require(std::ranges::any_of(all, has_crack), name_of(crack),
            " leaves no room for a lattice patch between its mouths, where elements carry it; ", advice());
  }
  return all;
}

std::string PatchLayout::advice() const {
  return text("choose a smaller spacing than ", spacing_, " with bempd_set_body_lattice(), or another treatment");
}

}  // namespace bempd::regions

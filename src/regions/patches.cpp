#include "regions/patches.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "error.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/patch_layout.hpp"

namespace bempd::regions {

namespace {

// Part of a crack inside a region; it has no pieces if the crack does not pass through the region.
CrackInBody part_of(const scene::Scene& scene, int region, const LatticeCrack& crack, double tolerance) {
  const Outline& outline = scene.region(region).outline();
  const std::vector<Edge> edges = edges_of(outline);
  const std::vector<Point>& points = scene.crack(crack.id).points;
  CrackInBody found{crack, {}, {}, {}};
  for (const Segment& piece : pieces_between(points, edges))
    if (locate(edges, piece.at(0.5), tolerance) == Location::inside) found.pieces.push_back(piece);
  const auto loop_at = [&](const Point& place) {
    int number = 0;
    for (std::size_t loop = 0; loop < outline.loops.size(); ++loop)
      for (std::size_t k = 0; k < outline.loops[loop].size(); ++k, ++number)
        if (distance(outline.edge(number), place) <= tolerance) return static_cast<int>(loop);
    return -1;
  };
  for (const Segment& piece : found.pieces)
    for (const Point& end : {piece.start, piece.end})
      if (const int loop = loop_at(end); loop >= 0) found.mouths.emplace_back(end, loop);
  const auto add_tip = [&](const Point& tip, const Point& before, int end) {
    if (locate(edges, tip, tolerance) == Location::inside)
      found.tips.push_back({tip, (tip - before).normalized(), crack.grows[static_cast<std::size_t>(end)]});
  };
  if (found.pieces.empty()) return found;
  add_tip(points.front(), points[1], 0);
  add_tip(points.back(), points.end()[-2], 1);
  return found;
}

}  // namespace

std::vector<Patch> lay_out_patches(const scene::Scene& scene, const scene::Options& options,
                                   const std::vector<LatticeCrack>& cracks,
                                   const std::map<int, BodyLattice>& lattices) {
  const double tolerance = 10 * geometric_tolerance(scene.bounding_box());
  std::map<int, std::vector<CrackInBody>> in_body;
  for (const LatticeCrack& crack : cracks) {
    std::optional<CrackInBody> found;
    int region = 0;
    for (const int id : scene.region_ids()) {
      CrackInBody part = part_of(scene, id, crack, tolerance);
      if (part.pieces.empty() || !scene.region(id).has_elements()) continue;
      require(!found, "crack ", crack.id, " runs through the regions ", region, " and ", id,
              "; lattice patches are laid for cracks in one body: give it another treatment");
      found = std::move(part), region = id;
    }
    if (!found) continue;
    require(is_body(scene.region(region)), "crack ", crack.id, " lies in region ", region,
            ", whose elements the host has chosen; lattice patches are laid in bodies: make it one with "
            "bempd_add_body(), or give the crack another treatment");
    in_body[region].push_back(std::move(*found));
  }
  std::vector<Patch> all;
  for (auto& [body, inside_it] : in_body) {
    const auto lattice = lattices.find(body);
    PatchLayout layout(scene, options, body, std::move(inside_it),
                       lattice == lattices.end() ? BodyLattice{} : lattice->second);
    for (Patch& patch : layout.patches()) all.push_back(std::move(patch));
  }
  return all;
}

int lattice_around(const scene::Scene& scene, int crack) {
  if (scene.cracks()[static_cast<std::size_t>(crack) - 1].points.empty()) return 0;  // it was removed
  const double tolerance = 10 * geometric_tolerance(scene.bounding_box());
  for (const int id : scene.region_ids())
    if (!scene.region(id).has_elements() && !part_of(scene, id, {crack, {}}, tolerance).pieces.empty()) return id;
  return 0;
}

namespace {

// Copy of a body's description with patches cut out.
std::unique_ptr<BoundaryDescription> cut_body(const BoundaryDescription& body, int id,
                                              const std::vector<Patch>& patches) {
  auto cut = std::make_unique<BoundaryDescription>(body);
  cut->fill_cut_outs();
  std::vector<std::vector<Point>> loops;
  double horizon = 0;  // the same in all patches of a body
  for (const Patch& patch : patches)
    if (patch.body == id) horizon = patch.horizon_ratio * patch.spacing, loops.push_back(patch.outline);
  if (!loops.empty()) cut->cut_out(loops, horizon);
  return cut;
}

std::unique_ptr<scene::Region> part_of_body(const scene::Scene& scene, const Patch& patch) {
  const scene::Region& body = scene.region(patch.body);
  auto part = std::make_unique<PeridynamicDescription>(
      body.material(), scene.material_of(patch.body), Outline{{patch.outline}, {}}, patch.spacing, patch.horizon_ratio);
  part->make_part_of(patch.body);
  part->set_fracture_energies(body.fracture_energies());
  return part;
}

}  // namespace

PatchedBodies::PatchedBodies(const scene::Scene& scene, const std::vector<Patch>& patches, int count)
    : count_(count), regions_(static_cast<std::size_t>(count)) {
  for (int id = 1; id <= count; ++id)
    if (const auto* body = dynamic_cast<const BoundaryDescription*>(scene.region_or_null(id)); body && body->is_body())
      bodies_.emplace_back(id, cut_body(*body, id, patches));
  for (const Patch& patch : patches) regions_.push_back(part_of_body(scene, patch));
}

PatchedBodies::PatchedBodies(PatchedBodies&&) noexcept = default;
PatchedBodies& PatchedBodies::operator=(PatchedBodies&&) noexcept = default;
PatchedBodies::~PatchedBodies() = default;

void PatchedBodies::exchange(scene::Scene& scene) noexcept {
  exchange_parts(scene, regions_, count_);
  for (auto& [id, body] : bodies_)
    static_cast<BoundaryDescription*>(scene.region_or_null(id))->exchange_cut_outs(*body);
}

namespace {

// Number of blocks ahead of a tip, besides the blocks on every side of it, below which the patch around the tip grows.
// With six horizons ahead of the tip the fit to the stress there is undisturbed; with fewer, the load factors of growth
// change by up to 3e-3.
constexpr double least_ahead = 2;

// Number of blocks ahead of a tip, besides the blocks on every side of it, after its patch has grown.
constexpr double blocks_to_follow = 5;

// Least number of blocks without lattice between two patches.
constexpr int blocks_between = 2;

// Block of a patch that contains a place, inside or on its border; empty if no block of the patch does.
std::optional<Block> block_at(const Patch& patch, const Point& place) {
  for (const Block& block : patch.grid.near({place, place}, (1 - less_rounding) * patch.grid.size))
    if (patch.blocks.contains(block)) return block;
  return std::nullopt;
}

// Walls from which new blocks of a body's patches keep a distance: edges, and pieces of cracks that lie in no patch.
PatchWalls walls_around(const scene::Scene& scene, const std::vector<Patch>& patches, int body) {
  PatchWalls walls(dynamic_cast<const BoundaryDescription&>(scene.region(body)).whole_outline());
  std::vector<Edge> borders;
  std::vector<std::vector<Edge>> loops;
  for (const Patch& patch : patches) {
    loops.push_back(edges_of(Outline{{patch.outline}, {}}));
    borders.insert(borders.end(), loops.back().begin(), loops.back().end());
  }
  for (std::size_t c = 0; c < scene.cracks().size(); ++c)
    for (const Segment& piece : pieces_between(scene.cracks()[c].points, borders)) {
      const auto holds = [&](const std::vector<Edge>& loop) {
        return locate(loop, piece.at(0.5), 0) != Location::outside;
      };
      if (std::ranges::none_of(loops, holds)) walls.add_crack(piece, static_cast<int>(c) + 1);
    }
  return walls;
}

bool has_one_near(const Blocks& blocks, const Block& block) {
  return std::ranges::any_of(blocks, [&](const Block& other) {
    return std::abs(other[0] - block[0]) <= blocks_between && std::abs(other[1] - block[1]) <= blocks_between;
  });
}

bool has_all(const Blocks& blocks, const Blocks& wanted) { return std::ranges::includes(blocks, wanted); }

// Growth of one patch of a scene by blocks that may be added to it.
class GrowingPatch {
 public:
  GrowingPatch(const scene::Scene& scene, const std::vector<Patch>& patches, std::size_t number)
      : patches_(patches), number_(number), walls_(walls_around(scene, patches, own().body)) {}

  bool can_get_some(const Blocks& wanted) const {
    return std::ranges::any_of(wanted, [&](const Block& b) { return !own().blocks.contains(b) && may_add(b); });
  }

  // All patches, with new blocks in this patch: the blocks of `wanted` for which walls and other patches leave room,
  // and blocks that close gaps. Empty if no block is added, if the patch would fall into parts, or if it would lack
  // some of the `needed` blocks.
  std::optional<std::vector<Patch>> with_added(const Blocks& wanted, const Blocks& needed) const {
    Blocks blocks = own().blocks;
    for (const Block& block : wanted)
      if (may_add(block)) blocks.insert(block);
    const bool is_sound =
        close_gaps(blocks, [&](const Block& block) { return may_add(block); }) && connected_parts(blocks).size() == 1;
    if (!is_sound || !has_all(blocks, needed) || blocks == own().blocks) return std::nullopt;
    std::vector<Patch> all = patches_;
    all[number_].outline = loop_around(blocks, own().grid);
    all[number_].blocks = std::move(blocks);
    return all;
  }

 private:
  const Patch& own() const { return patches_[number_]; }
  bool may_add(const Block& block) const {
    const auto is_beside = [&](const Patch& other) {
      return &other != &own() && other.body == own().body && has_one_near(other.blocks, block);
    };
    return !walls_.nearest_to(own().grid.box(block)) && std::ranges::none_of(patches_, is_beside);
  }

  const std::vector<Patch>& patches_;
  std::size_t number_;
  PatchWalls walls_;
};

}  // namespace

std::size_t patch_around(const std::vector<Patch>& patches, const Point& place) {
  const auto found =
      std::ranges::find_if(patches, [&](const Patch& patch) { return block_at(patch, place).has_value(); });
  return static_cast<std::size_t>(found - patches.begin());
}

std::optional<std::vector<Patch>> grown_ahead_of(const scene::Scene& scene, const std::vector<Patch>& patches,
                                                 const SteppedTip& tip) {
  const std::size_t number = patch_around(patches, tip.place);
  if (number == patches.size()) return std::nullopt;
  const BlockGrid& grid = patches[number].grid;
  const auto along = [&](double blocks, double reach) {
    const Segment way{tip.place, tip.place + blocks * grid.size * tip.direction};
    return grid.near(way, reach * grid.size * less_rounding);
  };
  const Blocks around = along(least_ahead, usual_patch_reach);
  if (has_all(patches[number].blocks, around)) return std::nullopt;
  const GrowingPatch patch(scene, patches, number);
  if (!patch.can_get_some(around)) return std::nullopt;
  for (const double reach : {usual_patch_reach, least_patch_reach})
    if (auto all = patch.with_added(along(blocks_to_follow, reach), along(0, least_patch_reach))) return all;
  return std::nullopt;
}

namespace {

// Distance from a broken bond, in blocks, within which the bond's patch needs all blocks: two and a half horizons. For
// horizons of four spacings, load factors are then within 3e-4 of those in a large lattice; with two horizons they
// would be within 6e-4.
constexpr double least_around_break = 1.25;

// Distance in blocks from the block of a broken bond, within which a growing patch gets all blocks that it may have.
constexpr double blocks_around_break = 2.2;

// Ranges of the numbers by which layout_number() encodes a broken bond: columns and rows of blocks from -half_of_rows
// on, and indices of patches.
constexpr std::int64_t half_of_rows = 1 << 13, block_rows = 2 * half_of_rows, most_patches = 1 << 8;

}  // namespace

std::int64_t layout_number(const BrokenBondNearBorder& broken) {
  std::int64_t number = static_cast<std::int64_t>(broken.extensions) * most_patches + broken.patch;
  for (const int place : broken.block) number = number * block_rows + place + half_of_rows;
  return -1 - number;
}

BrokenBondNearBorder broken_bond_of(std::int64_t number) {
  number = -1 - number;
  const auto next = [&](std::int64_t count) { return static_cast<int>(std::exchange(number, number / count) % count); };
  const int row = next(block_rows), column = next(block_rows), patch = next(most_patches);
  return {static_cast<std::size_t>(number),
          patch,
          {column - static_cast<int>(half_of_rows), row - static_cast<int>(half_of_rows)}};
}

std::optional<BrokenBondNearBorder> broken_bond_near_border(const std::vector<Patch>& patches, const Point& place,
                                                            std::size_t extensions) {
  const std::size_t number = patch_around(patches, place);
  if (number == patches.size()) return std::nullopt;
  const BlockGrid& grid = patches[number].grid;
  if (has_all(patches[number].blocks, grid.near({place, place}, least_around_break * grid.size))) return std::nullopt;
  return BrokenBondNearBorder{extensions, static_cast<int>(number), *block_at(patches[number], place)};
}

std::optional<std::vector<Patch>> grown_around(const scene::Scene& scene, const std::vector<Patch>& patches,
                                               const BrokenBondNearBorder& broken) {
  const auto number = static_cast<std::size_t>(broken.patch);
  const auto has_number = [](int place) { return std::abs(place) < half_of_rows; };
  if (number >= patches.size() || number >= most_patches || !std::ranges::all_of(broken.block, has_number))
    return std::nullopt;
  const BlockGrid& grid = patches[number].grid;
  Blocks wanted;
  const Box centre = grid.box(broken.block);
  for (const Block& block : grid.near({centre.center(), centre.center()}, (blocks_around_break + 1) * grid.size))
    if (grid.box(block).exteriorDistance(centre) < blocks_around_break * grid.size) wanted.insert(block);
  return GrowingPatch(scene, patches, number).with_added(wanted, {broken.block});
}

}  // namespace bempd::regions

#include "regions/patches.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "error.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/patch_layout.hpp"

namespace bempd::regions {

namespace {

// The part of a crack inside a region; no pieces if none is.
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

std::vector<Patch> lay_out_patches(const scene::Scene& scene, const std::vector<LatticeCrack>& cracks,
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
    PatchLayout layout(scene, body, std::move(inside_it), lattice == lattices.end() ? BodyLattice{} : lattice->second);
    for (Patch& patch : layout.patches()) all.push_back(std::move(patch));
  }
  return all;
}

int lattice_around(const scene::Scene& scene, int crack) {
  if (scene.crack(crack).points.empty()) return 0;
  const double tolerance = 10 * geometric_tolerance(scene.bounding_box());
  for (const int id : scene.region_ids())
    if (!scene.region(id).has_elements() && !part_of(scene, id, {crack, {}}, tolerance).pieces.empty()) return id;
  return 0;
}

namespace {

void cut_out(scene::Scene& scene, const std::vector<Patch>& patches) {
  std::map<int, std::vector<std::vector<Point>>> loops;
  for (const Patch& patch : patches) loops[patch.body].push_back(patch.outline);
  for (const auto& of_body : loops) {
    const int body = of_body.first;
    const auto first = std::find_if(patches.begin(), patches.end(), [&](const Patch& p) { return p.body == body; });
    boundary_in(scene, body)->cut_out(of_body.second, first->horizon_ratio * first->spacing);
  }
}

}  // namespace

void add_patches(scene::Scene& scene, const std::vector<Patch>& patches) {
  for (const Patch& patch : patches) {
    const scene::Region& body = scene.region(patch.body);
    auto part =
        std::make_unique<PeridynamicDescription>(body.material(), scene.material_of(patch.body),
                                                 Outline{{patch.outline}, {}}, patch.spacing, patch.horizon_ratio);
    part->make_part_of(patch.body);
    part->set_fracture_energies(body.fracture_energies());
    scene.add_region(std::move(part));
  }
  cut_out(scene, patches);
}

void move_patches(scene::Scene& scene, const std::vector<Patch>& patches, int count) {
  for (const int id : scene.region_ids())
    if (BoundaryDescription* boundary = boundary_in(scene, id)) boundary->make_whole();
  int id = count;
  for (const Patch& patch : patches)
    const_cast<scene::Region&>(scene.region(++id)).set_outline(Outline{{patch.outline}, {}});
  cut_out(scene, patches);
}

void remove_patches(scene::Scene& scene, int count) {
  remove_parts(scene, count);
  for (const int id : scene.region_ids())
    if (BoundaryDescription* boundary = boundary_in(scene, id)) boundary->make_whole();
}

namespace {

// Blocks that a tip has ahead of it, besides those on every side of it: fewer let its patch grow, to so many. Where the
// fit to the stress ahead of a tip comes near a border, loads change by up to 3e-3; that is so from six horizons on.
constexpr double least_ahead = 2, blocks_to_follow = 5;

// Blocks of elements that stay between two patches, at least.
constexpr int blocks_between = 2;

// Rounding of distances from blocks.
constexpr double hardly_less = 1 - 1e-9;

Block block_at(const BlockGrid& grid, const Point& place) {
  const Point number = ((place - grid.origin) / grid.size).array().floor();
  return {static_cast<int>(number.x()), static_cast<int>(number.y())};
}

// Pieces of cracks that lie in elements are walls.
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

}  // namespace

std::optional<std::vector<Patch>> followed(const scene::Scene& scene, const std::vector<Patch>& patches,
                                           const FollowedTip& tip) {
  const auto own = std::ranges::find_if(
      patches, [&](const Patch& patch) { return patch.blocks.contains(block_at(patch.grid, tip.place)); });
  if (own == patches.end()) return std::nullopt;
  const BlockGrid& grid = own->grid;
  const auto way = [&](double blocks) -> Segment {
    return {tip.place, tip.place + blocks * grid.size * tip.direction};
  };
  const Blocks around = grid.near(way(least_ahead), usual_patch_reach * grid.size * hardly_less);
  if (has_all(own->blocks, around)) return std::nullopt;
  const PatchWalls walls = walls_around(scene, patches, own->body);
  const auto may_add = [&](const Block& block) {
    const auto is_beside = [&](const Patch& other) {
      return &other != &*own && other.body == own->body && has_one_near(other.blocks, block);
    };
    return !walls.beside(grid.box(block)) && std::ranges::none_of(patches, is_beside);
  };
  const auto is_missing = [&](const Block& block) { return !own->blocks.contains(block) && may_add(block); };
  if (std::ranges::none_of(around, is_missing)) return std::nullopt;
  for (const double reach : {usual_patch_reach, least_patch_reach}) {
    Blocks blocks = own->blocks;
    for (const Block& block : grid.near(way(blocks_to_follow), reach * grid.size * hardly_less))
      if (may_add(block)) blocks.insert(block);
    const bool is_sound = close_gaps(blocks, may_add) && connected_parts(blocks).size() == 1;
    const bool goes_on = has_all(blocks, grid.near(way(0), least_patch_reach * grid.size * hardly_less));
    if (!is_sound || !goes_on || blocks == own->blocks) continue;
    std::vector<Patch> all = patches;
    Patch& larger = all[static_cast<std::size_t>(own - patches.begin())];
    larger.outline = loop_around(blocks, grid);
    larger.blocks = std::move(blocks);
    return all;
  }
  return std::nullopt;
}

}  // namespace bempd::regions

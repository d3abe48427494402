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

// Pieces of a polyline between the places at which it meets edges.
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

void add_patches(scene::Scene& scene, const std::vector<Patch>& patches) {
  std::map<int, std::vector<std::vector<Point>>> loops;
  for (const Patch& patch : patches) loops[patch.body].push_back(patch.outline);
  for (const Patch& patch : patches) {
    const scene::Region& body = scene.region(patch.body);
    auto part =
        std::make_unique<PeridynamicDescription>(body.material(), scene.material_of(patch.body),
                                                 Outline{{patch.outline}, {}}, patch.spacing, patch.horizon_ratio);
    part->make_part_of(patch.body);
    part->set_fracture_energies(body.fracture_energies());
    scene.add_region(std::move(part));
  }
  for (const auto& of_body : loops) {
    const int body = of_body.first;
    const auto first = std::find_if(patches.begin(), patches.end(), [&](const Patch& p) { return p.body == body; });
    boundary_in(scene, body)->cut_out(of_body.second, first->horizon_ratio * first->spacing);
  }
}

void remove_patches(scene::Scene& scene, int count) {
  remove_parts(scene, count);
  for (const int id : scene.region_ids())
    if (BoundaryDescription* boundary = boundary_in(scene, id)) boundary->make_whole();
}

}  // namespace bempd::regions

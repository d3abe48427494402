#include "results/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/outline.hpp"
#include "results/inside_picture.hpp"
#include "results/picture_arrays.hpp"

namespace bempd::results {

namespace {

using output::VtuGrid;
using regions::Field;
using regions::FieldValues;
using regions::SnapshotBlock;

// Numbers of the parts of a snapshot other than regions; larger numbers are shown later.
constexpr int number_of_inside = 50, number_of_cracks = 100, number_of_tips = 101;

VtuGrid grid_of_regions() {
  VtuGrid grid;
  grid.cell_data.push_back({"region", 1, std::vector<std::int32_t>()});
  return grid;
}

// Appends the mean of the values at the entries `of`, component by component.
void add_mean(std::vector<double>& values, int components, const std::vector<int>& of) {
  for (int c = 0; c < components; ++c) {
    double sum = 0;
    for (const int entry : of)
      sum +=
          values[static_cast<std::size_t>(components) * static_cast<std::size_t>(entry) + static_cast<std::size_t>(c)];
    values.push_back(sum / static_cast<double>(of.size()));
  }
}

void add_region(VtuGrid& grid, const SnapshotBlock& block, const regions::Region& region,
                const regions::Solution& solution, const FieldsOfScene& fields) {
  const auto first = static_cast<std::int64_t>(grid.points.size());
  const regions::RegionPicture picture = region.results().picture(solution);
  const FieldValues& positions = fields(region.id(), Field::position);
  for (std::size_t i = 0; i < positions.values.size(); i += 2)
    grid.points.emplace_back(positions.values[i], positions.values[i + 1]);
  for (const regions::AddedPoint& added : picture.added) grid.points.push_back(added.place);
  for (const SnapshotBlock::Array& array : block.arrays) {
    FieldValues shown = region.results().at_nodes(array.field, fields(region.id(), array.field));
    for (const regions::AddedPoint& added : picture.added) add_mean(shown.values, shown.components, added.nodes);
    if (array.field == Field::stress)
      append_stress(grid.point_data, region.elasticity(), shown.values);
    else
      append(grid.point_data, array.name, shown.components, shown.values);
  }
  const regions::Cells& cells = picture.cells;
  for (std::size_t e = 0; e < cells.nodes.size(); e += static_cast<std::size_t>(cells.nodes_per_cell)) {
    std::vector<std::int64_t> nodes;
    nodes.reserve(static_cast<std::size_t>(cells.nodes_per_cell));
    for (std::size_t k = 0; k < static_cast<std::size_t>(cells.nodes_per_cell); ++k)
      nodes.push_back(first + cells.nodes[e + k]);
    // VTK lists the ends of a quadratic edge before its mid node.
    if (block.cell == output::VtuCell::quadratic_edge) std::swap(nodes[1], nodes[2]);
    // Triangles in a mesh of quadrangles have one corner twice; the second copy is left out.
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (nodes.size() > 2 && nodes.front() == nodes.back()) nodes.pop_back();
    grid.add_cell(nodes.size() == 3 && block.cell == output::VtuCell::quad ? output::VtuCell::triangle : block.cell,
                  nodes);
    std::get<std::vector<std::int32_t>>(grid.cell_data[0].values).push_back(region.id());
  }
}

// Grid of the cracks: a quadratic edge for each element, with the opening and the displacement.
VtuGrid grid_of(const std::vector<regions::CrackPicture>& cracks) {
  VtuGrid grid;
  std::vector<double> openings, displacements;
  std::vector<std::int32_t> numbers;
  for (const regions::CrackPicture& crack : cracks) {
    for (std::size_t i = 0; i < crack.places.size(); i += 3) {
      const auto first = static_cast<std::int64_t>(grid.points.size());
      grid.add_cell(output::VtuCell::quadratic_edge, {first, first + 2, first + 1});
      numbers.push_back(crack.crack);
      for (std::size_t k = i; k < i + 3; ++k) {
        grid.points.push_back(crack.places[k]);
        openings.insert(openings.end(), {crack.openings[k].x(), crack.openings[k].y()});
        displacements.insert(displacements.end(), {crack.displacements[k].x(), crack.displacements[k].y()});
      }
    }
  }
  grid.point_data.push_back({"opening", 2, std::move(openings)});
  grid.point_data.push_back({"displacement", 2, std::move(displacements)});
  grid.cell_data.push_back({"crack", 1, std::move(numbers)});
  return grid;
}

// Grid of the crack tips: a point for each tip, with its values.
VtuGrid grid_of(const std::vector<regions::TipValues>& tips) {
  VtuGrid grid;
  std::vector<double> directions;
  std::vector<std::int32_t> cracks, ends, methods;
  for (const regions::TipValues& tip : tips) {
    grid.add_cell(output::VtuCell::vertex, {static_cast<std::int64_t>(grid.points.size())});
    grid.points.push_back(tip.place);
    directions.insert(directions.end(), {tip.direction.x(), tip.direction.y()});
    cracks.push_back(tip.crack), ends.push_back(tip.end + 1), methods.push_back(static_cast<std::int32_t>(tip.method));
  }
  const auto add = [&](const char* name, const auto& value_of) {
    std::vector<double> values;
    values.reserve(tips.size());
    for (const regions::TipValues& tip : tips) values.push_back(value_of(tip));
    grid.point_data.push_back({name, 1, std::move(values)});
  };
  using Tip = regions::TipValues;
  add("stress_intensity_1", [](const Tip& tip) { return tip.factors.x(); });
  add("stress_intensity_2", [](const Tip& tip) { return tip.factors.y(); });
  add("energy_release_rate", [](const Tip& tip) { return tip.energy_release_rate; });
  add("t_stress", [](const Tip& tip) { return tip.stress_along; });
  add("error", [](const Tip& tip) { return tip.error; });
  add("kink_angle", [](const Tip& tip) { return tip.kink_angle; });
  add("critical_load_factor", [](const Tip& tip) { return tip.critical_load_factor; });
  add("critical_load_factor_down", [](const Tip& tip) { return tip.critical_load_factor_down; });
  add("critical_kink_angle", [](const Tip& tip) { return tip.critical_kink_angle; });
  add("straight_load_factor", [](const Tip& tip) { return tip.straight_load_factor; });
  add("felt_ahead", [](const Tip& tip) { return tip.felt_ahead; });
  add("load_error", [](const Tip& tip) { return tip.load_error; });
  add("valid_radius", [](const Tip& tip) { return tip.valid_radius; });
  grid.point_data.push_back({"direction", 2, std::move(directions)});
  grid.point_data.push_back({"crack", 1, std::move(cracks)});
  grid.point_data.push_back({"end", 1, std::move(ends)});
  grid.point_data.push_back({"method", 1, std::move(methods)});
  return grid;
}

// Whether the scene can have cracks, now or later, because all moments of a series must have the same parts.
bool may_have_cracks(const scene::Scene& scene, const regions::Discretization& d) {
  for (const auto& region : d.regions)
    if (region->bonds()) return true;
  return !scene.cracks().empty();
}

}  // namespace

std::vector<PicturePart> pictures(const scene::Scene& scene, const regions::Discretization& d,
                                  const regions::Solution& solution, const FieldsOfScene& fields,
                                  const CracksShown& cracks, double inside_divisions) {
  std::map<int, PicturePart> parts;
  const auto part = [&](int number, const std::string& name) -> VtuGrid& {
    return parts.try_emplace(number, PicturePart{number, name, grid_of_regions()}).first->second.grid;
  };
  for (const auto& region : d.regions) {
    const SnapshotBlock block = region->results().snapshot_block();
    add_region(part(block.number, block.name), block, *region, solution, fields);
    if (!region->results().has_inside() || inside_divisions <= 0) continue;
    const scene::Region& described = scene.region(region->id());
    const double size = std::sqrt(area(described.outline())) / inside_divisions;
    add_inside(part(number_of_inside, "inside"), *region, described, size, solution,
               [&](Field field) -> const FieldValues& { return fields(region->id(), field); });
  }
  if (may_have_cracks(scene, d))
    parts.emplace(number_of_cracks, PicturePart{number_of_cracks, "cracks", grid_of(cracks.faces)});
  if (!cracks.tips.empty()) parts.emplace(number_of_tips, PicturePart{number_of_tips, "tips", grid_of(cracks.tips)});
  std::vector<PicturePart> all;
  all.reserve(parts.size());
  for (auto& [number, shown] : parts) all.push_back(std::move(shown));
  return all;
}

}  // namespace bempd::results

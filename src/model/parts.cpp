#include "model/parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/model.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"

namespace bempd::model {

std::vector<Part> parts_of(Model& model) {
  const PreparedScene& prepared = model.accuracy().scene_of_plan();
  const scene::Scene& scene = model.scene();
  const CrackTreatments& treatments = model.treatments();
  std::vector<Part> parts;
  for (const auto& region : prepared.discretization.regions) {
    const scene::Region& described = scene.region(region->id());
    regions::RegionStatistics sizes;
    region->add_statistics(sizes);
    Part part;
    part.region = region->id();
    part.body = described.part_of() > 0 ? described.part_of() : part.region;
    part.is_lattice = !described.has_elements();
    part.elements = sizes.boundary_elements, part.points = sizes.material_points;
    if (regions::is_body(described)) part.reason = PartReason::body;
    if (const auto* lattice = dynamic_cast<const regions::PeridynamicDescription*>(&described))
      part.spacing = lattice->spacing(), part.horizon_ratio = lattice->horizon_ratio();
    if (const int number = part.region - treatments.own_regions(); number > 0) {
      const std::vector<int>& cracks = treatments.patches()[static_cast<std::size_t>(number) - 1].cracks;
      part.reason = PartReason::crack, part.crack = cracks.front();
      part.growth_load = first_load(model.accuracy().loads_by_plan(), cracks);
      part.growth_load_of_elements = first_load(treatments.loads_of_elements(), cracks);
    }
    part.outline = described.outline();
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<Point> polyline_of(const Outline& outline, std::size_t loop) {
  constexpr double step = std::numbers::pi / 36;
  std::size_t first = 0;
  for (std::size_t k = 0; k < loop; ++k) first += outline.loops[k].size();
  std::vector<Point> points;
  for (std::size_t k = 0; k < outline.loops[loop].size(); ++k) {
    const Edge edge = outline.edge(static_cast<int>(first + k));
    double turn = 0;
    for (int p = 0; p < edge.piece_count(); ++p) turn += std::abs(edge.piece(p).sweep);
    const int count = std::max(1, static_cast<int>(std::ceil(turn / step)));
    for (int i = 0; i < count; ++i) points.push_back(edge.at(static_cast<double>(i) / count));
  }
  return points;
}

}  // namespace bempd::model

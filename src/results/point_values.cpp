#include <cmath>
#include <map>

#include "bem/interior.hpp"
#include "error.hpp"
#include "model/model.hpp"

namespace bempd::model {

namespace {

// On an interface the region comes first whose values are at hand: the peridynamic one if its points lie there.
int region_at(const Scene& scene, const Discretization& d, const Point& place) {
  const RegionKind preferred = d.formulation.cell_centred ? RegionKind::boundary_elements : RegionKind::peridynamics;
  int found = 0;
  for (int id = 1; id <= static_cast<int>(scene.regions().size()); ++id) {
    const Region& region = scene.region(id);
    if (locate(region.outline, place, d.tolerance) == Location::outside) continue;
    if (region.kind == preferred) return id;
    if (found == 0) found = id;
  }
  return found;
}

// Bilinear interpolation in a cell of the grid; half a spacing beyond it where the points are the centres of the cells.
struct CellWeights {
  std::array<int, 4> points;
  std::array<double, 4> weights;
};

CellWeights cell_weights(const LatticePart& part, const Point& place) {
  const Point p = part.to_grid(place);
  const double reach = (part.cell_centred ? 0.5 : 0.0) + 1e-6;
  const Eigen::Vector2i base(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
  // On a boundary the cell may lie on the other side of a lattice line.
  for (const Eigen::Vector2i& shift :
       {Eigen::Vector2i(0, 0), {-1, 0}, {0, -1}, {-1, -1}, {1, 0}, {0, 1}, {1, 1}, {-1, 1}, {1, -1}}) {
    const Eigen::Vector2i cell = base + shift;
    const Point local = p - cell.cast<double>();
    if (!part.lattice->has_cell(cell) || (local.array() < -reach).any() || (local.array() > 1 + reach).any()) continue;
    const double x = local.x(), y = local.y();
    return {part.lattice->cell_corners(cell), {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y}};
  }
  fail(Failure::argument, "the place (", place.x(), ", ", place.y(), ") lies in no lattice cell");
}

}  // namespace

std::vector<PointValue> Model::evaluate(const std::vector<Point>& places, bool with_stress) {
  ensure_equilibrium();
  const Discretization& d = prepared_->discretization;
  std::vector<PointValue> values(places.size());
  std::map<int, bem::InteriorEvaluator> evaluators;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point& place = places[i];
    require(place.allFinite(), "point ", i, " is (", place.x(), ", ", place.y(),
            "); coordinates must be finite numbers");
    const int region = region_at(scene_, d, place);
    require(region > 0, "point ", i, ", (", place.x(), ", ", place.y(), "), lies outside the body");
    PointValue& value = values[i];
    value.region = region;
    if (const LatticePart* part = d.lattice_of(region)) {
      const CellWeights cell = cell_weights(*part, place);
      const FieldValues& displacement = field(region, Field::displacement);
      const FieldValues* stress = with_stress ? &field(region, Field::stress) : nullptr;
      for (int k = 0; k < 4; ++k) {
        value.displacement += cell.weights[k] * Eigen::Map<const Point>(&displacement.values[2 * cell.points[k]]);
        if (stress)
          value.stress += cell.weights[k] * Eigen::Map<const Eigen::Vector3d>(&stress->values[3 * cell.points[k]]);
      }
      continue;
    }
    const BoundaryPart& part = *d.boundary_of(region);
    auto found = evaluators.find(region);
    if (found == evaluators.end()) {
      const Eigen::VectorXd displacement = part.mesh_displacement(prepared_->evolution->state().total_displacement);
      found = evaluators
                  .emplace(region,
                           bem::InteriorEvaluator(part.mesh, scene_.material(scene_.region(region).material).elasticity,
                                                  displacement, boundary_tractions(part)))
                  .first;
    }
    if (with_stress) {
      const auto at = found->second.at(place);
      value.displacement = at.displacement;
      value.stress = at.stress;
    } else {
      value.displacement = found->second.displacement_at(place);
    }
  }
  for (const auto& [region, evaluator] : evaluators) {
    prepared_->interior_kernel_evaluations += evaluator.kernel_evaluations();
  }
  return values;
}

}  // namespace bempd::model

#include <cmath>

#include "error.hpp"
#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

Cells LatticeRegion::cells() const {
  Cells cells{4, {}};
  for (int i = 0; i < grid_.point_count(); ++i) {
    const Eigen::Vector2i corner = grid_.point(i);
    if (!grid_.has_cell(corner)) continue;
    const auto corners = grid_.cell_corners(corner);
    // Corners are reordered from rows to counter-clockwise.
    cells.nodes.insert(cells.nodes.end(), {corners[0], corners[1], corners[3], corners[2]});
  }
  return cells;
}

// Evaluates places in a lattice by bilinear interpolation in a cell of the grid.
class LatticeRegion::LatticeEvaluator final : public Evaluator {
 public:
  LatticeEvaluator(const LatticeRegion& region, const FieldsOfRegion& fields, bool with_stress)
      : region_(region),
        displacement_(fields(Field::displacement)),
        stress_(with_stress ? &fields(Field::stress) : nullptr) {}

  PointValue at(const Point& place) override {
    const CellWeights cell = weights_at(place);
    PointValue value;
    value.region = region_.id();
    for (int k = 0; k < 4; ++k) {
      value.displacement += cell.weights[k] * Eigen::Map<const Point>(&displacement_.values[2 * cell.points[k]]);
      if (stress_)
        value.stress += cell.weights[k] * Eigen::Map<const Eigen::Vector3d>(&stress_->values[3 * cell.points[k]]);
    }
    return value;
  }

 private:
  struct CellWeights {
    std::array<int, 4> points;
    std::array<double, 4> weights;
  };

  CellWeights weights_at(const Point& place) const {
    const Point p = region_.to_grid(place);
    const double reach = region_.reach_beyond_cells() + 1e-6;
    const Eigen::Vector2i base(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
    // A place on the boundary may be rounded into a neighbouring cell that does not exist, so neighbours are tried too.
    for (const Eigen::Vector2i& shift :
         {Eigen::Vector2i(0, 0), {-1, 0}, {0, -1}, {-1, -1}, {1, 0}, {0, 1}, {1, 1}, {-1, 1}, {1, -1}}) {
      const Eigen::Vector2i cell = base + shift;
      const Point local = p - cell.cast<double>();
      if (!region_.grid().has_cell(cell) || (local.array() < -reach).any() || (local.array() > 1 + reach).any())
        continue;
      const double x = local.x(), y = local.y();
      return {region_.grid().cell_corners(cell), {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y}};
    }
    fail(Failure::argument, "the place (", place.x(), ", ", place.y(), ") lies in no lattice cell");
  }

  const LatticeRegion& region_;
  const FieldValues& displacement_;
  const FieldValues* stress_;
};

std::unique_ptr<Evaluator> LatticeRegion::evaluator(const Solution&, const FieldsOfRegion& fields,
                                                    bool with_stress) const {
  return std::make_unique<LatticeEvaluator>(*this, fields, with_stress);
}

}  // namespace bempd::regions

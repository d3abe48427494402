#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "pd/cell_squares.hpp"
#include "pd/deformation.hpp"
#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

Eigen::Vector3d LatticeRegion::stress_of_squares(const Solution& solution, int first_square) const {
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  auto term = static_cast<std::size_t>(first_square);
  for (const pd::CellSquare& square : pd::cell_squares(elasticity())) {
    const double force = solution.bonds.tension(term, solution.bonds.stiffness[term], solution.displacement.data(),
                                                solution.load_factor);
    stress += force / (spacing() * elasticity().thickness) * pd::unit_stress(square);
    ++term;
  }
  return stress;
}

void LatticeRegion::correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                                      const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const {
  if (bonds_.squares.empty()) return;
  std::vector<char> lost(points_.size() + bonds_.far_points.size(), 0);
  for (std::size_t b = 0; b < states.share.size(); ++b) {
    if (states.share[b] < 1) lost[network()->bonds[b].first] = lost[network()->bonds[b].second] = 1;
  }
  const auto each_cell = [&](const auto& visit) {
    for (int i = 0; i < grid_->point_count(); ++i) {
      const int square = bonds_.squares[i];
      if (square >= 0) visit(square, solution.intact[square] != 0, grid_->cell_corners(grid_->point(i)));
    }
  };
  each_cell([&](int, bool intact, const std::array<int, 4>& corners) {
    for (const int corner : corners) lost[corner] = lost[corner] || !intact;
  });
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    if (lost[i]) stresses[i] = pd::bond_stress(strains[i], elasticity());
  }
  each_cell([&](int square, bool intact, const std::array<int, 4>& corners) {
    const bool counts = intact && std::any_of(corners.begin(), corners.end(), [&](int corner) { return lost[corner]; });
    if (!counts) return;
    const Eigen::Vector3d stress = stress_of_squares(solution, square);
    for (const int corner : corners) {
      if (lost[corner]) stresses[corner] += stress / grid_->cells_around(corner);
    }
  });
}

Cells LatticeRegion::cells() const {
  Cells cells{4, {}};
  for (int i = 0; i < grid_->point_count(); ++i) {
    const Eigen::Vector2i corner = grid_->point(i);
    if (!grid_->has_cell(corner)) continue;
    const auto corners = grid_->cell_corners(corner);
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

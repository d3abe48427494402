#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "pd/cell_squares.hpp"
#include "pd/deformation.hpp"
#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

std::vector<std::uint8_t> LatticeRegion::broken_bonds(const std::vector<char>& intact) const {
  std::vector<std::uint8_t> broken(network()->bonds.size());
  for (std::size_t b = 0; b < broken.size(); ++b) broken[b] = intact[scene_bond(b)] ? 0 : 1;
  return broken;
}

FieldSize LatticeRegion::field_size(Field field) const {
  require(field != Field::traction && field != Field::element_stress, "region ", id(),
          " is peridynamic and has no tractions and no boundary elements; ask a BEM region");
  const std::int64_t count = field == Field::bond_stretch ? static_cast<std::int64_t>(bonds_.listed) : point_count();
  return {count, components_of(field)};
}

FieldValues LatticeRegion::field(Field field, const Solution& solution) const {
  switch (field) {
    case Field::position: {
      FieldValues positions{{}, 2};
      for (int i = 0; i < point_count(); ++i) {
        const Point p = position(i);
        positions.values.insert(positions.values.end(), {p.x(), p.y()});
      }
      return positions;
    }
    case Field::displacement: {
      const Eigen::VectorXd values = gather(solution.displacement);
      return {{values.data(), values.data() + values.size()}, 2};
    }
    case Field::damage:
      return damage(solution.intact);
    case Field::stress:
      return stress(solution);
    case Field::bond_stretch:
      return bond_stretch(solution);
    case Field::traction:
    case Field::element_stress:
      break;  // refused by field_size()
    case Field::stress_order:
      break;  // a matter of the whole scene
  }
  return {};
}

FieldValues LatticeRegion::damage(const std::vector<char>& intact) const {
  std::vector<int> all(points_.size() + bonds_.far_points.size(), 0), left(all.size(), 0);
  for (std::size_t b = 0; b < network()->bonds.size(); ++b) {
    for (int point : {network()->bonds[b].first, network()->bonds[b].second}) {
      ++all[point];
      left[point] += intact[scene_bond(b)];
    }
  }
  FieldValues field{std::vector<double>(points_.size(), 0.0), 1};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (all[i] > 0) field.values[i] = 1 - static_cast<double>(left[i]) / all[i];
  }
  return field;
}

pd::BondStates LatticeRegion::bond_states(const Solution& solution) const {
  const coupling::Terms& terms = solution.bonds;
  pd::BondStates states;
  for (std::size_t b = 0; b < network()->bonds.size(); ++b) {
    const std::size_t term = scene_bond(b);
    const double share = !solution.intact[term] ? 0
                         : solution.stages      ? terms.law_of(term).stiffness_share((*solution.stages)[term])
                                                : 1;
    states.share.push_back(share);
    if (!terms.have_offsets()) continue;
    const double rest = terms.rest(term, 0) + solution.load_factor * terms.rest(term, 1);
    const double force = terms.constant(term, 0) + solution.load_factor * terms.constant(term, 1);
    const double pushed = share > 0 ? force / (share * terms.stiffness[term]) : 0;
    states.rest_stretch.push_back((rest - pushed) / terms.length[term]);
  }
  return states;
}

FieldValues LatticeRegion::stress(const Solution& solution) const {
  const int own = point_count(), count = own + static_cast<int>(bonds_.far_nodes.size());
  Eigen::VectorXd displacement(2 * count);
  displacement.head(2 * own) = gather(solution.displacement);
  for (int i = own; i < count; ++i)
    displacement.segment<2>(2 * i) = solution.displacement.segment<2>(2 * bonds_.far_nodes[i - own]);
  displacement /= spacing();
  const pd::BondStates states = bond_states(solution);
  auto strains = pd::bond_strains(count, *network(), states, displacement);
  strains.resize(own);  // at the others some bonds are missing
  std::vector<Eigen::Vector3d> stresses;
  for (const Eigen::Vector3d& strain : strains) stresses.push_back(pd::stress_of(strain, elasticity()));
  if (!bonds_.squares.empty()) correct_at_losses(solution, strains, states, stresses);
  FieldValues field{{}, 3};
  for (const Eigen::Vector3d& stress : stresses)
    field.values.insert(field.values.end(), {stress[0], stress[1], stress[2]});
  return field;
}

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

FieldValues LatticeRegion::bond_stretch(const Solution& solution) const {
  FieldValues field{{}, 1};
  for (std::size_t b = bonds_.first; b < bonds_.first + bonds_.listed; ++b)
    field.values.push_back(solution.bonds.elastic_elongation(b, solution.displacement.data(), solution.load_factor) /
                           solution.bonds.length[b]);
  return field;
}

Cells LatticeRegion::cells() const {
  Cells cells{4, {}};
  for (int i = 0; i < grid_->point_count(); ++i) {
    const Eigen::Vector2i corner = grid_->point(i);
    if (!grid_->has_cell(corner)) continue;
    const auto corners = grid_->cell_corners(corner);
    // From rows to counter-clockwise order.
    cells.nodes.insert(cells.nodes.end(), {corners[0], corners[1], corners[3], corners[2]});
  }
  return cells;
}

SnapshotBlock LatticeRegion::snapshot_block() const {
  return {"lattice",
          0,
          output::VtuCell::quad,
          {{"displacement", Field::displacement}, {"damage", Field::damage}, {"stress", Field::stress}}};
}

// Bilinear interpolation in a cell of the grid.
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
    // On a boundary the cell may lie on the other side of a lattice line.
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

#include "regions/lattice/grid_squares.hpp"

#include <algorithm>

#include "pd/cell_squares.hpp"

namespace bempd::regions {

void GridSquares::set_rests(const std::vector<Eigen::RowVector2d>& strains, coupling::Terms& terms) const {
  if (bonds_.squares.empty()) return;
  const std::vector<pd::CellSquare> squares = pd::cell_squares(elasticity_);
  for (int i = 0; i < grid_.point_count(); ++i) {
    int term = bonds_.squares[i];
    if (term < 0) continue;
    Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
    for (const int corner : grid_.cell_corners(grid_.point(i))) mean += 0.25 * strains[corner];
    for (const pd::CellSquare& square : squares) {
      const Eigen::RowVector2d rest = points_.spacing() * pd::unit_stress(square).head<2>().sum() * mean;
      if (!rest.isZero(0)) terms.set_rest_elongation(term, rest[0], rest[1]);
      ++term;
    }
  }
}

Eigen::Vector3d GridSquares::stress(const Solution& solution, int first_square) const {
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  auto term = static_cast<std::size_t>(first_square);
  for (const pd::CellSquare& square : pd::cell_squares(elasticity_)) {
    const double force = solution.bonds.tension(term, solution.bonds.stiffness[term], solution.displacement.data(),
                                                solution.load_factor);
    stress += force / (points_.spacing() * elasticity_.thickness) * pd::unit_stress(square);
    ++term;
  }
  return stress;
}

void GridSquares::correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                                    const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const {
  if (bonds_.squares.empty()) return;
  std::vector<char> lost(static_cast<std::size_t>(points_.point_count()) + bonds_.far_points.size(), 0);
  for (std::size_t b = 0; b < states.share.size(); ++b) {
    if (states.share[b] < 1) lost[bonds_.all()[b].first] = lost[bonds_.all()[b].second] = 1;
  }
  const auto each_cell = [&](const auto& visit) {
    for (int i = 0; i < grid_.point_count(); ++i) {
      const int square = bonds_.squares[i];
      if (square >= 0) visit(square, solution.intact[square] != 0, grid_.cell_corners(grid_.point(i)));
    }
  };
  each_cell([&](int, bool intact, const std::array<int, 4>& corners) {
    for (const int corner : corners) lost[corner] = lost[corner] || !intact;
  });
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    if (lost[i]) stresses[i] = pd::bond_stress(strains[i], elasticity_);
  }
  each_cell([&](int square, bool intact, const std::array<int, 4>& corners) {
    const bool counts = intact && std::any_of(corners.begin(), corners.end(), [&](int corner) { return lost[corner]; });
    if (!counts) return;
    const Eigen::Vector3d stress = this->stress(solution, square);
    for (const int corner : corners) {
      if (lost[corner]) stresses[corner] += stress / grid_.cells_around(corner);
    }
  });
}

}  // namespace bempd::regions

#include "pd/cell_squares.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::pd {

namespace {

using Eigen::Vector2d;

constexpr double largest_ratio_difference = 1e-6;

constexpr std::array<std::array<int, 2>, 6> own_bonds{{{0, 1}, {2, 3}, {0, 2}, {1, 3}, {0, 3}, {1, 2}}};

}  // namespace

bool is_bond_based(const PlaneElasticity& elasticity) {
  return std::abs(elasticity.poisson_ratio - bond_based_poisson_ratio(elasticity.state)) <= largest_ratio_difference;
}

double bond_modulus(const PlaneElasticity& elasticity) {
  const double lambda = elasticity.c12(), mu = elasticity.shear_modulus();
  return std::min(mu, 0.5 * (lambda + mu));
}

double bond_c1111(const PlaneElasticity& elasticity) {
  return is_bond_based(elasticity) ? elasticity.c11() : 3 * bond_modulus(elasticity);
}

Eigen::Vector3d bond_stress(const Eigen::Vector3d& strain, const PlaneElasticity& elasticity) {
  const double beta = bond_modulus(elasticity), pressure = beta * (strain.x() + strain.y());
  return {pressure + 2 * beta * strain.x(), pressure + 2 * beta * strain.y(), 2 * beta * strain.z()};
}

Eigen::Vector3d unit_stress(const CellSquare& square) {
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < 4; ++k) moment += square.pull[k] * Vector2d(k % 2, k / 2).transpose();
  return {moment(0, 0), moment(1, 1), 0.5 * (moment(0, 1) + moment(1, 0))};
}

std::vector<CellSquare> cell_squares(const PlaneElasticity& elasticity) {
  const double lambda = elasticity.c12(), mu = elasticity.shear_modulus(), h = elasticity.thickness;
  const double r = std::sqrt(0.5);
  if (is_bond_based(elasticity)) return {};
  if (lambda > mu)
    return {{{Vector2d(-r, -r), Vector2d(r, -r), Vector2d(-r, r), Vector2d(r, r)}, h * (lambda - mu) / 2}};
  const double m = (mu - lambda) / 2;
  return {{{Vector2d(-r, -r), Vector2d(-r, r), Vector2d(r, -r), Vector2d(r, r)}, h * m / 2},
          {{Vector2d(-1, 1), Vector2d(1, 1), Vector2d(-1, -1), Vector2d(1, -1)}, h * m / 4}};
}

std::vector<Cell> cells_with_bonds(const CellLattice& lattice, const std::vector<Bond>& bonds) {
  const auto by_ends = [](const Bond& bond, const std::array<int, 2>& ends) {
    return bond.first != ends[0] ? bond.first < ends[0] : bond.second < ends[1];
  };
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(lattice.cell_count()));
  for (int i = 0; i < lattice.point_count(); ++i) {
    if (!lattice.has_cell(lattice.point(i))) continue;
    Cell& cell = cells.emplace_back(Cell{lattice.point(i), lattice.cell_corners(lattice.point(i)), {}});
    for (const auto& [from, to] : own_bonds) {
      const std::array<int, 2> ends{std::min(cell.corners[from], cell.corners[to]),
                                    std::max(cell.corners[from], cell.corners[to])};
      const auto found = std::lower_bound(bonds.begin(), bonds.end(), ends, by_ends);
      if (found != bonds.end() && found->first == ends[0] && found->second == ends[1])
        cell.bonds.push_back(static_cast<int>(found - bonds.begin()));
    }
  }
  return cells;
}

}  // namespace bempd::pd

#include "regions/lattice/lattice_swelling.hpp"

#include <algorithm>

#include "pd/cell_squares.hpp"
#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

void LatticeSwelling::add(const BondedRegion& region, const Swelling& strain) {
  const auto is_same = [&](const Body& body) { return body.first->shares_bonds_with(region); };
  auto body = std::find_if(bodies_.begin(), bodies_.end(), is_same);
  if (body == bodies_.end()) {
    const auto nodes = static_cast<Eigen::Index>(positions_.size());
    body = bodies_.insert(body, {&region, coupling::Affine::Zero(nodes, 2), std::vector<int>(positions_.size(), 0)});
  }
  for (const int node : region.nodes()) {
    body->sum.row(node) += strain(positions_[static_cast<std::size_t>(node)]).transpose();
    ++body->count[static_cast<std::size_t>(node)];
  }
}

const LatticeSwelling::Body& LatticeSwelling::body_of(const BondedRegion& region) const {
  return *std::find_if(bodies_.begin(), bodies_.end(),
                       [&](const Body& body) { return body.first->shares_bonds_with(region); });
}

Eigen::RowVector2d LatticeSwelling::at(const BondedRegion& region, int node) const {
  const Body& body = body_of(region);
  return body.sum.row(node) / body.count[static_cast<std::size_t>(node)];
}

void BondedRegion::swell(const Swelling& strain, LatticeSwelling& lattices) {
  lattices.add(*this, strain);
  is_swollen_ = true;
  free_swelling_ = FreeSwelling::through(positions(), strain);
}

std::vector<Eigen::RowVector2d> BondedRegion::strains_of_points(const LatticeSwelling& lattices) const {
  std::vector<Eigen::RowVector2d> strains;
  for (const int node : nodes_) strains.push_back(lattices.at(*this, node));
  for (const int node : bonds_.far_nodes) strains.push_back(lattices.at(*this, node));
  return strains;
}

// Sets rest elongations for swelling: a bond takes the mean strain of its ends, a square that of its corners. A linear
// strain, which the body follows without stress, then causes no force in any of them.
void BondedRegion::set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const {
  const std::vector<Eigen::RowVector2d> strains = strains_of_points(lattices);
  for (std::size_t b = 0; b < network()->bonds.size(); ++b) {
    const pd::Bond& bond = network()->bonds[b];
    const auto term = scene_bond(b);
    const Eigen::RowVector2d rest = 0.5 * terms.length[term] * (strains[bond.first] + strains[bond.second]);
    if (!rest.isZero(0)) terms.set_rest_elongation(static_cast<int>(term), rest[0], rest[1]);
  }
}

void LatticeRegion::set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const {
  BondedRegion::set_rests(lattices, terms);
  if (bonds_.squares.empty()) return;
  const std::vector<Eigen::RowVector2d> strains = strains_of_points(lattices);
  const std::vector<pd::CellSquare> squares = pd::cell_squares(elasticity());
  for (int i = 0; i < grid_->point_count(); ++i) {
    int term = bonds_.squares[i];
    if (term < 0) continue;
    Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
    for (const int corner : grid_->cell_corners(grid_->point(i))) mean += 0.25 * strains[corner];
    for (const pd::CellSquare& square : squares) {
      const Eigen::RowVector2d rest = spacing() * pd::unit_stress(square).head<2>().sum() * mean;
      if (!rest.isZero(0)) terms.set_rest_elongation(term, rest[0], rest[1]);
      ++term;
    }
  }
}

bool LatticeRegion::shares_bonds_with(const BondedRegion& other) const {
  if (this == &other) return true;  // also where none acts as one with another, as in scheme paper
  const auto* lattice = dynamic_cast<const LatticeRegion*>(&other);
  return lattice && acts_as_one_with(*lattice);
}

std::optional<Eigen::Matrix2d> BondedRegion::free_displacement(const Point& place) const {
  if (!is_swollen_) return Eigen::Matrix2d::Zero();
  if (!free_swelling_) return std::nullopt;
  return free_swelling_->displacement(place);
}

}  // namespace bempd::regions

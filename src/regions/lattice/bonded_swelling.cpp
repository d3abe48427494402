#include "regions/lattice/bonded_swelling.hpp"

#include "regions/lattice/bonded_region.hpp"

namespace bempd::regions {

void BondedSwelling::swell(const Swelling& strain, LatticeSwelling& lattices) {
  lattices.add(region_, strain);
  is_swollen_ = true;
  free_swelling_ = FreeSwelling::through(region_.positions(), strain);
}

std::vector<Eigen::RowVector2d> BondedSwelling::strains_of_points(const LatticeSwelling& lattices) const {
  std::vector<Eigen::RowVector2d> strains;
  for (const int node : region_.nodes()) strains.push_back(lattices.at(region_, node));
  for (const int node : bonds_.far_nodes) strains.push_back(lattices.at(region_, node));
  return strains;
}

// Sets rest elongations for swelling: a bond takes the mean strain of its two ends, a cell square the mean strain of
// its corners. A strain that is linear in the place, which the body follows without stress, then causes no force in
// bonds and cell squares.
void BondedSwelling::set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const {
  const std::vector<Eigen::RowVector2d> strains = strains_of_points(lattices);
  for (std::size_t b = 0; b < bonds_.all().size(); ++b) {
    const pd::Bond& bond = bonds_.all()[b];
    const auto term = bonds_.number(b);
    const Eigen::RowVector2d rest = 0.5 * terms.length[term] * (strains[bond.first] + strains[bond.second]);
    if (!rest.isZero(0)) terms.set_rest_elongation(static_cast<int>(term), rest[0], rest[1]);
  }
  if (const RegionSquares* squares = region_.squares()) squares->set_rests(strains, terms);
}

std::optional<Eigen::Matrix2d> BondedSwelling::free_displacement(const Point& place) const {
  if (!is_swollen_) return Eigen::Matrix2d::Zero();
  if (!free_swelling_) return std::nullopt;
  return free_swelling_->displacement(place);
}

}  // namespace bempd::regions

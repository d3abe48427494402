#include "regions/lattice/lattice_swelling.hpp"

#include <algorithm>

#include "regions/lattice/bonded_region.hpp"

namespace bempd::regions {

void LatticeSwelling::add(const BondedRegion& region, const Swelling& strain) {
  const auto is_same = [&](const Body& body) { return body.first->shares_bonds_with(region); };
  auto body = std::find_if(bodies_.begin(), bodies_.end(), is_same);
  if (body == bodies_.end()) {
    const auto nodes = static_cast<Eigen::Index>(positions_.size());
    body =
        bodies_.insert(body, {&region, coupling::Affine::Zero(nodes, 2), std::vector<double>(positions_.size(), 0.0)});
  }
  const std::vector<double> shares = region.cell_shares();
  for (std::size_t i = 0; i < region.nodes().size(); ++i) {
    const int node = region.nodes()[i];
    const double share = i < shares.size() ? shares[i] : 1;
    body->sum.row(node) += share * strain(positions_[static_cast<std::size_t>(node)]).transpose();
    body->weight[static_cast<std::size_t>(node)] += share;
  }
}

const LatticeSwelling::Body& LatticeSwelling::body_of(const BondedRegion& region) const {
  return *std::find_if(bodies_.begin(), bodies_.end(),
                       [&](const Body& body) { return body.first->shares_bonds_with(region); });
}

Eigen::RowVector2d LatticeSwelling::at(const BondedRegion& region, int node) const {
  const Body& body = body_of(region);
  return body.sum.row(node) / body.weight[static_cast<std::size_t>(node)];
}

}  // namespace bempd::regions

#include "paper/uncorrected_lattice.hpp"

#include "paper/uncorrected_network.hpp"
#include "paper/volume_damage.hpp"

namespace bempd::paper {

using namespace regions;

// Flags of the points shared with another region. Points beside boundary elements whose lengths the host chose are
// shared as well, because this scheme has no tied nodes.
std::vector<char> UncorrectedLattice::shared_points(const Preparation& preparation) const {
  std::vector<char> shared(points_.size(), 0);
  for (const Contact& contact : preparation.arrangement.contacts) {
    if (contact.region != id() - 1) continue;
    const Edge edge = preparation.scene.region(id()).edge(contact.edge + 1);
    for (int point : points_along(edge.at(contact.from), edge.at(contact.to))) shared[point] = 1;
  }
  return shared;
}

pd::Network UncorrectedLattice::make_network(const pd::CellLattice&, int) const {
  std::vector<std::array<Point, 2>> faces;
  const Point shift = (outline().origin - origin()) / spacing();
  for (const auto& loop : outline().loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      faces.push_back({loop[k].cast<double>() + shift, loop[(k + 1) % loop.size()].cast<double>() + shift});
    }
  }
  return build_uncorrected_network(points_, volumes(), faces, horizon_ratio(), elasticity());
}

FieldValues UncorrectedLattice::damage(const std::vector<char>& intact) const {
  return {volume_damage(*network(), volumes(), horizon_ratio(), bonds_.broken(intact)), 1};
}

}  // namespace bempd::paper

#pragma once

#include <vector>

#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

// Group of lattice regions (its members) that touch and form one lattice: bonds are made for the union of their cells.
class LatticeGroup {
 public:
  explicit LatticeGroup(std::vector<LatticeRegion*> members) : members_(std::move(members)) {}

  const std::vector<LatticeRegion*>& members() const { return members_; }  // ordered by id

  // Adds the bonds of the group, once all members have numbered their nodes. In the scene the bonds between points of
  // each member come first, member by member, then the bonds between points of different members. Returns false and
  // changes nothing if no network exists for the union of all cells.
  bool add_bonds(const Preparation& preparation, const Contributions& contributions) const;

 private:
  std::vector<LatticeRegion*> members_;
};

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

// The region and those with which it acts as one, directly or through others, by id.
std::vector<LatticeRegion*> regions_acting_as_one(LatticeRegion& region, const Preparation& preparation);

// Regions that act as one: their bonds are those of the body that all their cells make together.
class LatticeGroup {
 public:
  explicit LatticeGroup(std::vector<LatticeRegion*> members) : members_(std::move(members)) {}

  const std::vector<LatticeRegion*>& members() const { return members_; }  // by id

  // Adds the bonds, once all members have numbered their nodes. The scene's bonds come in the order of the regions that
  // list them, then those that no region lists. Returns false without a change if there is no network for all cells
  // together.
  bool add_bonds(const Preparation& preparation, const Contributions& contributions) const;

 private:
  std::vector<LatticeRegion*> members_;
};

}  // namespace bempd::regions

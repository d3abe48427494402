#pragma once

#include <vector>

#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

// The region and those it acts as one with, directly or through others, by id.
std::vector<LatticeRegion*> regions_acting_as_one(LatticeRegion& region, const Preparation& preparation);

// Regions that act as one: their bonds are those of the body that all their cells make together.
class LatticeGroup {
 public:
  explicit LatticeGroup(std::vector<LatticeRegion*> members) : members_(std::move(members)) {}

  const std::vector<LatticeRegion*>& members() const { return members_; }  // by id

  // Once all members have numbered their nodes. The scene's bonds come in the order of the regions that list them, then
  // those that nobody lists. False without a change if there is no network for all cells together.
  bool add_bonds(const Preparation& preparation, const Contributions& contributions) const;

 private:
  std::vector<LatticeRegion*> members_;
};

}  // namespace bempd::regions

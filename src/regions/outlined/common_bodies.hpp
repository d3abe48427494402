#pragma once

#include <vector>

#include "regions/preparation.hpp"

namespace bempd::regions {

class OutlinedRegion;

// Regions that are one body with `region` (they have one lattice, and bonds cross their common edges): those that touch
// the region, directly or through other such regions, and the region itself; by ascending id. If a support or a load
// acts along a common edge of these regions, only `region` is returned, because one body has no material points along
// edges inside it.
std::vector<OutlinedRegion*> regions_acting_as_one(OutlinedRegion& region, const Preparation& preparation);

// Ids (ascending) of regions whose outlines follow lattice rows, and which get material points on their outlines
// instead, because they are one body with a region whose outline follows no lattice rows.
std::vector<int> regions_leaving_rows(const Preparation& preparation);

// Exception: regions, of which some were to get material points on their outlines (regions_leaving_rows()), cannot be
// one body. discretize() catches it and keeps the lattice rows of these regions.
struct CannotLeaveRows {
  std::vector<int> regions;  // ids, ascending
};

}  // namespace bempd::regions

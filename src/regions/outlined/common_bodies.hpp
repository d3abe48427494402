#pragma once

#include <vector>

#include "regions/preparation.hpp"

namespace bempd::regions {

class OutlinedRegion;

// Regions that form one lattice with a region, touching it directly or through others, itself included; by ascending
// id. It is alone if a support or a load acts along a common edge of them: only the outline of a body has points.
std::vector<OutlinedRegion*> regions_acting_as_one(OutlinedRegion& region, const Preparation& preparation);

// Ids (ascending) of the regions that have to leave their lattice rows to be one body with a region of another outline.
std::vector<int> regions_leaving_rows(const Preparation& preparation);

// Exception: regions that were to leave their lattice rows have no network of bonds together with their neighbours.
struct CannotLeaveRows {};

}  // namespace bempd::regions

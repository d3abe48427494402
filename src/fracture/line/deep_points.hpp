#pragma once

#include <vector>

#include "coupling/terms.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Whether two laws are those of one kind of lattice.
bool are_alike(const pd::TipLaw& one, const pd::TipLaw& other);

// Points deep inside the lattices of each law, which stand for an endless lattice of that kind: by law, ascending. All
// regions of a kind count together, so that neither their order nor the number of regions matters.
std::vector<std::vector<int>> deep_points(const coupling::Terms& terms, const pd::TipLaws& laws);

}  // namespace bempd::fracture

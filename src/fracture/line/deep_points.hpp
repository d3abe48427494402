#pragma once

#include <vector>

#include "coupling/terms.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Whether two tip laws belong to lattices of one kind: with equal spacing, horizon, thickness and modulus.
bool are_alike(const pd::TipLaw& one, const pd::TipLaw& other);

// Material points deep inside the lattices of each tip law, which represent an infinite lattice: an ascending list for
// each law. Laws whose lattices are of one kind (are_alike()) share their points, so that neither the order nor the
// number of regions matters.
std::vector<std::vector<int>> deep_points(const coupling::Terms& terms, const pd::TipLaws& laws);

}  // namespace bempd::fracture

#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::regions {

// Bonds (of the whole scene) cut by the scene's cracks, ascending. Throws Error (argument) for a crack that leaves the
// peridynamic regions. One that passes through material points is an error too, but for cell-centred points, which a
// crack at 45 degrees cannot miss: there the points stay bonded to both faces, with a warning.
std::vector<int> bonds_cut_by_cracks(const scene::Scene& scene, const Discretization& discretization,
                                     std::vector<std::string>& warnings);

}  // namespace bempd::regions

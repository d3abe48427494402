#pragma once

#include <vector>

#include "model/discretization.hpp"

namespace bempd::model {

// Bonds (of the whole scene) cut by the scene's cracks, ascending. Throws Error (argument) for a crack that leaves the
// peridynamic regions or passes through material points.
std::vector<int> bonds_cut_by_cracks(const Scene& scene, const Discretization& discretization);

}  // namespace bempd::model

#pragma once

#include "coupling/support_dofs.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

// Degrees of freedom of supports, and how the force on one that several of them hold is divided. At a node of boundary
// elements each edge has the force that its own tractions make there, so that reactions converge as the tractions do.
// Points have none of it. At a material point, and where parts of edges overlap, the first support has all.
coupling::SupportDofs dofs_of_supports(const scene::Scene& scene, const Discretization& discretization,
                                       const DofConditions& conditions);

}  // namespace bempd::regions

#pragma once

#include "coupling/support_dofs.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

// Degrees of freedom of supports. If several supports hold one degree of freedom, its reaction is divided among them.
// At a node of boundary elements, a support on an edge gets the force that the tractions on this edge make at the node,
// so that reactions converge as the tractions do; a support at a single point gets nothing. At a material point, and
// where parts of edges overlap, the first support gets the whole reaction.
coupling::SupportDofs dofs_of_supports(const scene::Scene& scene, const Discretization& discretization,
                                       const DofConditions& conditions);

}  // namespace bempd::regions

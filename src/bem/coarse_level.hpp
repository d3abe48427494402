#pragma once

#include "bem/crack_tips.hpp"

namespace bempd::bem {

// State of a body under the same forces on elements twice as long, for an estimate of the discretization error by the
// difference of results. Neighbours of one panel, or of one straight piece of a crack, are merged in pairs, except
// elements at tips. The coarse functions lie in the space of the fine ones, so no integral is needed.
CrackedState coarse_state(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

#pragma once

#include "bem/crack_tips.hpp"

namespace bempd::bem {

// State of a cracked body under the same forces on elements twice as long. The difference between its results and those
// of the given `state` estimates the discretization error. Neighbouring elements of one panel, or of one straight piece
// of a crack, are merged in pairs, except elements at tips. The coarse shape functions are combinations of the fine
// ones, so that no integral is computed again.
CrackedState coarse_state(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

#pragma once

#include "bem/crack_tips.hpp"

namespace bempd::bem {

// State of a cracked body under the same forces on elements twice as long; the difference of results between the two
// estimates the discretization error. Neighbouring elements of one panel, or of one straight piece of a crack, are
// merged in pairs, except those at tips. Coarse functions are combinations of the fine ones, so that nothing is
// integrated anew.
CrackedState coarse_state(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

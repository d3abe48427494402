#pragma once

#include "bem/crack_tips.hpp"

namespace bempd::bem {

// The state of a body under the same forces on elements twice as long: neighbours of one panel, or of one straight
// piece of a crack, are merged by twos, but for those at tips. What they represent the elements represent as well, so
// that no integral is needed. The difference of results tells how far off they are.
CrackedState coarse_state(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

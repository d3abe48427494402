#pragma once

#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

void add(Resistance& resistance, const Event& event, const Outcome& outcome);

// True if events have left less than a share of the largest force that was borne, and of the stiffness: a small load
// alone is no loss.
bool is_lost(const Resistance& resistance, double share);

// True if a lost connection still holds by some bonds.
bool hangs(const Resistance& resistance);

}  // namespace bempd::fracture

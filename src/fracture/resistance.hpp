#pragma once

#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Force that a body bore just before an event: out of equilibrium bonds bear less than they are stretched for. If the
// body was separated before the event, its remainder may bear more than the body did, but the peak stays.
double borne_before(const Event& event, const Outcome& outcome);

void add(Resistance& resistance, const Event& event, const Outcome& outcome, bool separated_before);

// Whether events have left less than a share of the largest force that was borne, and of the stiffness: a small load
// alone is no loss.
bool is_lost(const Resistance& resistance, double share);

// Whether a lost connection still holds by some bonds.
bool hangs(const Resistance& resistance);

}  // namespace bempd::fracture

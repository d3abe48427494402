#pragma once

#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Force that a body carried just before an event. Out of equilibrium it is divided by the stretch ratio, because bonds
// carry no more than their critical stretch. If the body was separated before the event, the peak of its resistance
// stays.
double borne_before(const Event& event, const Outcome& outcome);

void add(Resistance& resistance, const Event& event, const Outcome& outcome, bool separated_before);

// Whether events have left less than a share both of the largest force carried and of the stiffness: a small load alone
// is no loss of resistance.
bool is_lost(const Resistance& resistance, double share);

// Whether a connection that counts as lost is still held by some bonds.
bool still_bears_force(const Resistance& resistance);

}  // namespace bempd::fracture

#pragma once

#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Force that a body carried just before an event [N]. A force out of equilibrium is divided by the stretch ratio of the
// event, because bonds carry no more than their critical stretch.
double borne_before(const Event& event, const Outcome& outcome);

// Adds an event to the resistance of a run. The peak does not change if the body was separated before the event.
void add(Resistance& resistance, const Event& event, const Outcome& outcome, bool separated_before);

// Whether events have left no more than `share` both of the largest force carried and of the stiffness. A small force
// alone is no loss of resistance, because the load may be small.
bool is_lost(const Resistance& resistance, double share);

// Whether the body still carries a force: some bonds, like a hinge, hold a connection that counts as lost.
bool still_bears_force(const Resistance& resistance);

}  // namespace bempd::fracture

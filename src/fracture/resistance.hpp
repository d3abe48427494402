#pragma once

#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Force that a body carried in equilibrium before an event [N]. If the event is out of equilibrium, the force just
// before is divided by the stretch ratio (stretch over critical stretch), because bonds carry no more than their
// critical stretch.
double borne_before(const Event& event, const Outcome& outcome);

// Adds an event to the resistance of a run: force, share of stiffness left, and peak force. The peak does not change if
// the body was separated before the event.
void add(Resistance& resistance, const Event& event, const Outcome& outcome, bool separated_before);

// Whether the body has lost its resistance: the force that it carries is at most `share` of the largest force carried,
// and the stiffness that is left is at most `share` of the original one. A small force alone is no loss, because the
// load may be small.
bool is_lost(const Resistance& resistance, double share);

// Whether the body carries more than rounding of its largest force, as by a hinge of a few bonds after is_lost().
bool still_bears_force(const Resistance& resistance);

}  // namespace bempd::fracture

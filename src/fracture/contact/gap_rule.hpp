#pragma once

#include "coupling/contacts.hpp"

namespace bempd::fracture {

// Distance of a gap on the wrong side of zero: an opening at a closed place, or an overlap at an open one. The place
// switches if that is more than rounding. The rule is the same in whole bodies and in windows.
inline double passed_zero(bool closed, double gap) { return closed ? gap : -gap; }

// Energy that a place releases when it opens, or takes up (negative) when it closes, from its gaps before and after the
// event. The potential energy is a quadratic function that is least in equilibrium: if a stiffness k is lost while the
// gap goes from g to g', it falls by k g g' / 2.
inline double released_by_switch(const coupling::Contact& place, bool was_closed, double gap_before, double gap_after) {
  const double lost = (was_closed ? 1 : -1) * place.stiffness;
  return 0.5 * lost * gap_before * gap_after;
}

}  // namespace bempd::fracture

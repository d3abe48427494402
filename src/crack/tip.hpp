#pragma once

#include <compare>

namespace bempd::crack {

// End of a crack. Cracks that the host described have the ids that it received for them; cracks that begin in a run
// have the next ids, in the order in which they begin.
struct TipId {
  int crack = 0;  // id
  int end = 0;    // 0: at the first point of the crack, 1: at its last point

  auto operator<=>(const TipId&) const = default;
};

// State of an end of a crack.
enum class TipState {
  grows = 0,         // it is a tip, and grows where its toughness is reached
  at_edge = 1,       // it has reached the outer boundary of the body
  at_hole = 2,       // it has reached a hole
  at_crack = 3,      // it has reached a crack
  at_interface = 4,  // it has stopped at another material, or where its region ends
  separated = 5      // what lay ahead of it has come apart
};

constexpr bool has_ended(TipState state) { return state != TipState::grows; }

}  // namespace bempd::crack

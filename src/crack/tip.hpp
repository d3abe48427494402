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
  grows = 0,         // a tip, which grows when it reaches its toughness
  at_edge = 1,       // ended at the outer boundary of the body
  at_hole = 2,       // ended at a hole
  at_crack = 3,      // ended at another crack
  at_interface = 4,  // stopped at another material, or at the border of its region
  separated = 5,     // no ligament is left ahead of it
  carried_on = 6     // its crack goes on in another carrier, where it has its tip; no extension ends so
};

// What the load factors of a tip's growth come from: its stress intensity factors; Williams' series fitted to the
// stress ahead of it in a lattice; or the energy of a trial step there.
enum class LoadRule { unknown = 0, factors = 1, fit = 2, energy = 3 };

constexpr bool has_ended(TipState state) { return state != TipState::grows; }

}  // namespace bempd::crack

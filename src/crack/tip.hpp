#pragma once

#include <algorithm>
#include <compare>

namespace bempd::crack {

// End of a crack. Cracks that the host described have the ids that it received for them; cracks that begin in a run
// have the next ids, in the order in which they begin.
struct TipId {
  int crack = 0;  // id of the crack
  int end = 0;    // 0: at the first point of the crack, 1: at its last point

  auto operator<=>(const TipId&) const = default;
};

// Entry of a list of tips with this id(); null if the tip is not in the list.
template <class Tips>
const typename Tips::value_type* tip_in(const Tips& tips, const TipId& id) {
  const auto found = std::find_if(tips.begin(), tips.end(), [&](const auto& tip) { return tip.id() == id; });
  return found == tips.end() ? nullptr : &*found;
}

// State of an end of a crack.
enum class TipState {
  grows = 0,         // a tip, which grows when it reaches its toughness
  at_edge = 1,       // ended at the outer boundary of the body
  at_hole = 2,       // ended at a hole
  at_crack = 3,      // ended at another crack
  at_interface = 4,  // stopped before another material, or at the border of its region
  separated = 5,     // no ligament is left ahead of the tip
  carried_on = 6     // the crack continues in another carrier, which has the tip; no extension has this state
};

// Method by which the load factor of a tip's growth is found: from its stress intensity factors (`factors`), from
// Williams' series fitted to the stress ahead of a tip in a lattice (`fit`), or from the energy that a trial step in a
// lattice would release (`energy`).
enum class LoadRule { unknown = 0, factors = 1, fit = 2, energy = 3 };

constexpr bool has_ended(TipState state) { return state != TipState::grows; }

}  // namespace bempd::crack

#include "crack/laws/host_resistance.hpp"

#include <cmath>

#include "error.hpp"

namespace bempd::crack {

double HostResistance::energy(const TipCycle& held) const {
  const double found = function_(held);
  if (!(found > 0) || std::isinf(found))
    fail(Failure::argument, "the resistance function gives a fracture energy of ", found, " for crack ", held.tip.crack,
         "; it must be a finite number > 0");
  return found;
}

}  // namespace bempd::crack

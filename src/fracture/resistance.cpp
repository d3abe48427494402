#include "fracture/resistance.hpp"

#include <algorithm>

namespace bempd::fracture {

namespace {

// Forces below this share of the largest one may be rounding.
constexpr double rounding = 1e-9;

}  // namespace

void add(Resistance& r, const Event& event, const Outcome& outcome) {
  const double before = outcome.resistance_before;
  // Out of equilibrium bonds bear less than they are stretched for.
  r.peak = std::max(r.peak, before / std::max(1.0, event.ratio));
  if (before > rounding * r.peak) r.stiffness *= outcome.resistance / before;
  r.present = outcome.resistance;
}

bool is_lost(const Resistance& r, double share) {
  return r.peak > 0 && r.present <= share * r.peak && r.stiffness <= share;
}

bool hangs(const Resistance& r) { return r.present > rounding * r.peak; }

}  // namespace bempd::fracture

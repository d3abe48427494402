#include "fracture/resistance.hpp"

#include <algorithm>

namespace bempd::fracture {

namespace {

// Ratio of a force to the largest force that the body has carried, below which the force may be rounding.
constexpr double rounding_of_forces = 1e-9;

}  // namespace

double borne_before(const Event& event, const Outcome& outcome) {
  return outcome.resistance_before / std::max(1.0, event.ratio);
}

void add(Resistance& r, const Event& event, const Outcome& outcome, bool separated_before) {
  const double before = outcome.resistance_before;
  if (!separated_before) r.peak = std::max(r.peak, borne_before(event, outcome));
  if (before > rounding_of_forces * r.peak) r.stiffness *= outcome.resistance / before;
  r.present = outcome.resistance;
}

bool is_lost(const Resistance& r, double share) {
  return r.peak > 0 && r.present <= share * r.peak && r.stiffness <= share;
}

bool still_bears_force(const Resistance& r) { return r.present > rounding_of_forces * r.peak; }

}  // namespace bempd::fracture

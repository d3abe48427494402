#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/contact/face_forecast.hpp"
#include "fracture/window/outside_gaps.hpp"

namespace bempd::fracture {

struct ForecastEvent;

// The proof that constraints stay closed or open in the states that a window has computed, or the first event after
// which some switch. The window itself switches constraints whose points it follows; what it has computed counts as
// long as no other switches.
class FaceCertificate {
 public:
  // Watches these constraints in the states after 0, 1, ... of the events, the first at the load factor `from`.
  FaceCertificate(const std::vector<WatchedConstraint>& constraints, const std::vector<ForecastEvent>& events,
                  double from, bool proportional);

  // How many of the events come before constraints open or close, and before one that makes a constraint with points
  // that are neither kept nor prescribed.
  int events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                           const coupling::EquilibriumSystem& system, const OutsideGaps& outside) const;

 private:
  // Whether a constraint is in a state as it was at first, at the load factors from the event that led there to the one
  // that follows; the largest displacements of the state's parts are given.
  bool holds(const WatchedConstraint& one, int state, double gap, double rate,
             const std::array<double, 2>& largest) const;

  std::vector<WatchedConstraint> constraints_;
  std::vector<std::array<double, 2>> load_factors_;  // of every state
};

}  // namespace bempd::fracture

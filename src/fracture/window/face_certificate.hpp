#pragma once

#include <array>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/contact/face_forecast.hpp"
#include "fracture/window/outside_gaps.hpp"

namespace bempd::fracture {

struct ForecastEvent;

// Proof that contact constraints stay closed or open in the states that a window (region around crack tips or bonds
// close to breaking that is solved alone) has computed, or the first event after which a constraint switches. The
// window itself switches constraints only if it follows all of their points; its events are valid as long as no other
// one switches.
class FaceCertificate {
 public:
  // Watches the given constraints in the states after 0, 1, ... events. `from` is the load factor of state 0.
  FaceCertificate(const std::vector<WatchedConstraint>& constraints, const std::vector<ForecastEvent>& events,
                  double from, bool proportional);

  // Number of events, from the first on, before which no constraint opens or closes outside the window's own
  // computation, and which add no constraint with points that are neither in the window nor prescribed. `kept` are the
  // displacements of the window's degrees of freedom `dofs` in each state.
  int events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                           const coupling::EquilibriumSystem& system, const OutsideGaps& outside) const;

 private:
  // Whether a constraint keeps its status (closed or open) in a state, from the load factor of the event that led to
  // the state up to that of the next event. Its gap at the load factor f is gap + f * rate; `largest` has the largest
  // displacements of the constant and the proportional part.
  bool holds(const WatchedConstraint& one, int state, double gap, double rate,
             const std::array<double, 2>& largest) const;

  std::vector<WatchedConstraint> constraints_;
  std::vector<std::array<double, 2>> load_factors_;  // at which each state begins and ends
};

}  // namespace bempd::fracture

#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/contact/face_forecast.hpp"
#include "fracture/window/outside_gaps.hpp"

namespace bempd::fracture {

struct ForecastEvent;

// The proof that faces of cracks stay as they are in the states that a window has computed, or the first event after
// which some close or open. The window switches places whose points it follows; what it has computed counts as long as
// no other closes or opens.
class FaceCertificate {
 public:
  // Nothing to watch.
  FaceCertificate() = default;
  // Watches these places in the states after 0, 1, ... of the events, the first at the load factor `from`.
  FaceCertificate(const std::vector<WatchedPlace>& places, const std::vector<ForecastEvent>& events, double from,
                  bool proportional);

  bool is_idle() const { return places_.empty(); }

  // How many of the events come before places open or close, and before one that makes a place with points that are
  // neither kept nor prescribed.
  int events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                           const coupling::EquilibriumSystem& system, const OutsideGaps& outside) const;

 private:
  // Whether a place is in a state as it was at first, at the load factors from the event that led there to the one that
  // follows; the largest displacements of its parts are given.
  bool holds(const WatchedPlace& place, int state, double gap, double rate, const std::array<double, 2>& largest) const;
  // Whether an open face inside an operator overlaps in a state.
  bool overlaps(int state, double gap, double rate, const std::array<double, 2>& largest) const;

  std::vector<WatchedPlace> places_;
  std::vector<std::array<double, 2>> load_factors_;  // of every state
};

}  // namespace bempd::fracture

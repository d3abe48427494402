#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "fracture/loaded_body.hpp"
#include "fracture/window/computed_events.hpp"

namespace bempd::fracture {

// Displacements of the whole body in the last state that a window (region around crack tips or bonds close to breaking
// that is solved alone) has proven, and the balance of forces in that state. The balance is checked only after the last
// of the events computed together, for all of these events.
class ForecastBalance {
 public:
  explicit ForecastBalance(LoadedBody& body) : body_(body) {}

  const coupling::Affine& whole() const { return whole_; }
  void set_whole(coupling::Affine displacement) { whole_ = std::move(displacement); }

  // Begins a series of events that are computed together: no imbalance has been corrected yet.
  void begin() { unbalanced_ = 0; }
  // Notes an imbalance of nodal forces that was found in the window, as a share of the largest force.
  void note_unbalanced(double share) { unbalanced_ = std::max(unbalanced_, share); }
  // Largest internal nodal force [N] of the run up to the load factor of the first event, by which residuals are
  // divided.
  double largest_force_before(double load_factor, const BodyState& start) const;
  // Checks the balance of forces of the whole body after the last event. If the forces balance, `whole`, the
  // displacements after that event, replace the stored displacements before the first event. Returns false and keeps
  // the stored ones if the residual is too large.
  bool holds_after(ComputedEvents& events, coupling::Affine whole);
  // Residual of the whole body after the last event or, if that is larger, the largest imbalance corrected in the
  // window.
  double residual() const { return residual_; }

 private:
  Eigen::VectorXd internal_force_after(const std::vector<ForecastEvent>& events) const;

  LoadedBody& body_;
  coupling::Affine whole_;
  double unbalanced_ = 0, residual_ = 0;
};

}  // namespace bempd::fracture

// Proof that events computed in a window would happen in the whole body in the same way.
#include <algorithm>

#include "fracture/window/event_forecast.hpp"
#include "fracture/window/face_certificate.hpp"
#include "fracture/window/window_settings.hpp"
#include "phase.hpp"

namespace bempd::fracture {

using coupling::Affine;

// Keeps the computed events up to the last for which it is proven that the whole body would break in the same way.
void EventForecast::certify(double from) {
  const Phase phase("proof of events ahead");
  if (!events_.empty() && !lines_) keep_first(bonds_.proven_in_window(states_));
  if (events_.empty()) return;
  // Contact places of events that were not kept are not watched. In the system the bonds of the kept events count as
  // broken during this proof, although the run has not performed these events yet.
  face_forecast_->forget_after(events_.count());
  const FaceCertificate watch(face_forecast_->constraints(), events_.list(), from, proportional_);
  const int unchanged = watch.events_before_change(states_, condensation_->dofs(), system_, outside_gaps_);
  faces_move_ = unchanged < events_.count();
  keep_first(unchanged);
  if (events_.empty()) return;
  const int kept = lines_ ? lines_->steps_as_foreseen(events_.list(), states_)
                          : bonds_.proven(states_, events_.list(), balance_.whole());
  faces_move_ = faces_move_ && kept >= unchanged;
  keep_first(kept);
  if (events_.empty()) return;
  if (!balance_.holds_after(events_, whole_in(events_.count()))) keep_first(0);
}

void EventForecast::keep_first(int count) {
  if (count >= events_.count()) return;
  has_ended_ = true;
  needs_whole_body_ = false;
  most_events_ = std::max(WindowSettings::first_events, 2 * count);  // more events would not be proven either
  events_.keep_first(count);
  states_.resize(count + 1);
  bonds_.keep_first(count);
}

Affine EventForecast::whole_in(int state) const {
  return lines_ ? condensation_->displacement(states_[state]) : bonds_.displacement(state);
}

}  // namespace bempd::fracture

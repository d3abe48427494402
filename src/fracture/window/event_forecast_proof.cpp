// Proof that the events of a window would happen in the whole body in the same way.
#include <algorithm>
#include <optional>

#include "fracture/balance.hpp"
#include "fracture/window/event_forecast.hpp"
#include "fracture/window/face_certificate.hpp"
#include "fracture/window/window_settings.hpp"
#include "phase.hpp"

namespace bempd::fracture {

using coupling::Affine;
using coupling::evaluate;

// Adds the checks for an event: no bond outside the window may break before it, or tie with it.
void EventForecast::add_checks(double from, const Event& event) {
  const int state = static_cast<int>(events_.size());
  const double f = event.load_factor, limit = tie_limit(options_.tie_band) * event.ratio;
  if (proportional_) {
    checks_.push_back({state, 1, limit / f});
    return;
  }
  if (from != f && options_.control == Control::load) checks_.push_back({state, from, 1});
  checks_.push_back({state, f, limit});
}

// Keeps the computed events up to the first for which it is not proven that the whole body would do the same.
void EventForecast::certify(double from) {
  const Phase phase("proof of events ahead");
  if (!events_.empty() && !lines_) keep_first(window_->dropped().first_violation(states_, checks_));
  if (events_.empty()) return;
  // Bonds of all computed events count as broken in the system until they are taken back.
  face_forecast_->forget_after(static_cast<int>(events_.size()));
  const FaceCertificate watch(face_forecast_->constraints(), events_, from, proportional_);
  const int unchanged = watch.events_before_change(states_, condensation_->dofs(), system_, outside_gaps_);
  faces_move_ = unchanged < static_cast<int>(events_.size());
  keep_first(unchanged);
  if (events_.empty()) return;
  std::vector<int> breaks{0};
  for (const ForecastEvent& foreseen : events_) {
    breaks.push_back(breaks.back() + static_cast<int>(foreseen.event.changes.size()));
  }
  const int kept = lines_ ? steps_as_foreseen() : certificate_->first_violation(states_, breaks, checks_, whole_);
  faces_move_ = faces_move_ && kept >= unchanged;
  keep_first(kept);
  if (!events_.empty()) check_whole_body();
}

// Checks the balance of forces of the whole body after the last event; it is known before the first one. Discards all
// events if the residual is too large.
void EventForecast::check_whole_body() {
  const Affine before = std::move(whole_);  // in state 0
  whole_ = whole_in(static_cast<int>(events_.size()));
  ForecastEvent& last = events_.back();
  const Eigen::VectorXd force = internal_force_after_all(last.event.load_factor);
  last.largest_force = std::max(
      {last.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(system_, last.event.load_factor)});
  residual_ = std::max(unbalanced_, fracture::residual(system_, force, last.event.load_factor, last.largest_force));
  if (residual_ <= WindowSettings::acceptable_residual) return;
  keep_first(0);
  whole_ = before;
}

Eigen::VectorXd EventForecast::internal_force_after_all(double load_factor) {
  const auto last = std::find_if(events_.rbegin(), events_.rend(), [](const ForecastEvent& e) { return e.faces; });
  if (last == events_.rend()) return system_.internal_force(evaluate(whole_, load_factor));
  coupling::Constraints present = system_.constraints();
  system_.put_constraints(body_.faces().constraints_of(*last->faces));
  Eigen::VectorXd force = system_.internal_force(evaluate(whole_, load_factor));
  system_.put_constraints(std::move(present));
  return force;
}

void EventForecast::keep_first(int count) {
  if (count >= static_cast<int>(events_.size())) return;
  has_ended_ = true;
  needs_whole_body_ = false;
  most_events_ = std::max(WindowSettings::first_events, 2 * count);  // more would be in vain again
  take_back(count);
  events_.resize(count);
  states_.resize(count + 1);
  std::erase_if(checks_, [&](const OutsideCheck& check) { return check.state >= count; });
}

}  // namespace bempd::fracture

#include "fracture/window/event_forecast.hpp"

#include <algorithm>
#include <optional>

#include "cancellation.hpp"
#include "fracture/balance.hpp"
#include "fracture/window/window_body.hpp"
#include "fracture/window/window_settings.hpp"
#include "phase.hpp"
#include "stop_request.hpp"
#include "undo.hpp"

namespace bempd::fracture {

using coupling::Affine;
using coupling::evaluate;

EventForecast::EventForecast(LoadedBody& body)
    : body_(body),
      system_(body.system()),
      locator_(body.system(), body.response().ratios(), body.positions()),
      bonds_(body),
      functions_(body.system(), body.supports().dofs()),
      narrowing_(body.system(), locator_, body.positions()),
      most_events_(WindowSettings::first_events),
      events_(body.system()),
      balance_(body) {}

bool EventForecast::open(const BodyState& state, double load_factor, const Options& options) {
  close();
  options_ = options;
  if (!has_window_form(system_) || !choose_place(state, load_factor)) return false;
  open_here(state);
  return true;
}

bool EventForecast::choose_place(const BodyState& state, double load_factor) {
  return lines_ ? lines_->choose_place(locator_, options_, state, load_factor)
                : locator_.choose(load_factor, options_.tie_band, options_.ahead);
}

void EventForecast::open_again(const BodyState& state, const Options& options) {
  options_ = options;
  locator_.keep_location();
  open_here(state);
}

void EventForecast::open_here(const BodyState& state) {
  undone_on_failure([&] { build_window(state); }, [&] { close(); });
}

void EventForecast::remember(WindowLocation place, int most_events) {
  locator_.go_back_to(std::move(place));
  most_events_ = most_events;
}

void EventForecast::build_window(const BodyState& state) {
  const Phase phase("window around what breaks", 3);
  has_ended_ = needs_whole_body_ = faces_move_ = false;
  condensation_ = std::make_unique<coupling::Condensation>(system_);
  check_cancelled();
  phase.reach(1);
  window_ = std::make_unique<WindowSolver>(system_, *condensation_, body_.response().ratios(), state.displacement,
                                           functions_.list());
  check_cancelled();
  phase.reach(2);
  proportional_ = state.displacement.col(0).isZero(0) && state.load_factor >= 0;
  if (!lines_) bonds_.begin_window(*condensation_, *window_, proportional_);
  outside_gaps_ = OutsideGaps(system_, *condensation_);
  balance_.set_whole(state.displacement);
  any_displacement_ = state.total_displacement;
  events_.begin_window();
  narrowing_.restart();
  states_ = {window_->displacement()};
}

void EventForecast::close() noexcept {
  if (!condensation_) return;
  window_.reset();
  bonds_.end_window();
  if (lines_) lines_->end_window();
  condensation_.reset();
  events_.clear();
  states_.clear();
  if (events_.have_changed_terms()) system_.factor().forget();
  if (needs_whole_body_)
    system_.factor().keep_last({});  // the next event needs no window, but factorizes the whole body
}

void EventForecast::forget() {
  close();
  most_events_ = WindowSettings::first_events;
  locator_.return_to_expected();
}

Affine EventForecast::displacement(int position) const {
  const bool is_last = position + 1 == static_cast<int>(states_.size());
  return is_last ? balance_.whole() : condensation_->displacement(states_[position]);
}

void EventForecast::compute(const BodyState& state) {
  events_.clear();
  bonds_.begin();
  balanced_events_ = 0;
  if (lines_) lines_->begin(*condensation_, *window_, state.tips);
  balance_.begin();
  foreseen_ = {window_->state()};
  FaceForecast ahead(body_.faces(), state.faces);
  face_forecast_ = &ahead;
  const bool keeps_balance = forecast_events(state);
  most_events_ = std::min(WindowSettings::growth_of_events * most_events_, WindowSettings::most_events_at_once);
  states_ = window_->complete(foreseen_);
  if (!keeps_balance) keep_first(balanced_events_);
  certify(state.load_factor);
  events_.take_back(0);
  face_forecast_ = nullptr;
}

// Computes events until the window ends, the wanted number is reached, or the host asks for the end of the step.
// Returns false if rounding errors have grown too large since the last check of the balance of forces.
bool EventForecast::forecast_events(const BodyState& start) {
  const Phase phase("events ahead in a window", most_events_);
  double from = start.load_factor;
  while (!has_ended_ && events_.count() < most_events_) {
    check_cancelled();
    if (!events_.empty() && stop_is_requested()) break;
    phase.reach(events_.count());
    if (!forecast_next(from, start)) {
      has_ended_ = true;
      return true;  // no check: the window may have performed a part of the event
    }
    from = events_.last().event.load_factor;
    const auto since = events_.count() - balanced_events_;
    if (events_.count() == 1 || since >= WindowSettings::events_between_balances) {
      if (!is_balanced()) return false;
    }
  }
  return is_balanced();
}

void EventForecast::narrow(double load_factor) {
  if (lines_)
    narrowing_.narrow(*window_, condensation_->dofs(), lines_->reaches());
  else
    narrowing_.narrow(*window_, condensation_->dofs(), load_factor);
}

bool EventForecast::forecast_next(double from, const BodyState& start) {
  narrow(from);
  ForecastEvent foreseen;
  const std::optional<LineSteps::Choice> line =
      lines_ ? lines_->choose(from, options_.control, foreseen) : std::nullopt;
  if (lines_ ? !line.has_value() : !bonds_.choose(from, options_, foreseen)) return false;
  if (!locator_.is_far_from_rim(coupling::terms_of(foreseen.event.changes))) return false;
  foreseen.event.changes = system_.stages().with_followers(std::move(foreseen.event.changes));
  for (const coupling::StageChange& c : foreseen.event.changes) {
    if (window_->place_of(c.term) < 0) return false;  // a follower reaches out of the window
    foreseen.back.push_back({c.term, system_.stages().numbers()[c.term]});
  }
  foreseen.largest_force =
      events_.empty() ? balance_.largest_force_before(foreseen.event.load_factor, start) : events_.last().largest_force;
  if (!perform_in_window(foreseen)) {
    needs_whole_body_ = true;
    return false;
  }
  const double unit_energy = foreseen.outcome.unit_energy;
  has_ended_ = is_separated(system_, unit_energy, start.first_unit_energy);
  if (!has_ended_ && unit_energy < WindowSettings::doubtful_energy * start.first_unit_energy) {
    system_.stages().enter(foreseen.back);
    needs_whole_body_ = true;
    return false;
  }
  if (line) {
    lines_->complete_step(*line, foreseen);
  } else {
    bonds_.note(events_.count(), from, foreseen.event, options_);
  }
  events_.add(std::move(foreseen));
  foreseen_.push_back(window_->state());
  return true;
}

// Checks the balance of forces in windows with cell squares, which may be many times as stiff as bonds and then cause
// larger rounding errors, and corrects small imbalances. Returns false if the imbalance is too large.
bool EventForecast::is_balanced() {
  const auto count = events_.count();
  if (system_.terms().followers.empty() || count == balanced_events_) return true;
  const ForecastEvent& last = events_.last();
  const Affine force = window_->unbalanced();
  const double share = evaluate(force, last.event.load_factor).lpNorm<Eigen::Infinity>() / last.largest_force;
  if (!(share <= WindowSettings::acceptable_residual)) return false;
  balance_.note_unbalanced(share);
  balanced_events_ = count;
  if (share <= WindowSettings::negligible_residual) return true;
  window_->balance(force);
  if (lines_) lines_->note_displacement();
  narrowing_.stop();
  foreseen_.back() = window_->state();
  return true;
}

bool EventForecast::perform_in_window(ForecastEvent& foreseen) {
  const int state = events_.count() + 1;
  WindowBody body(body_, *window_, functions_, *face_forecast_, state, any_displacement_);
  foreseen.before = body.energy();
  std::optional<Outcome> outcome = perform_event(foreseen.event, body_, body);
  if (!outcome) return false;
  foreseen.outcome = std::move(*outcome);
  foreseen.faces = body.switched_faces();
  return true;
}

}  // namespace bempd::fracture

#include "fracture/window/event_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cancellation.hpp"
#include "fracture/balance.hpp"
#include "fracture/event_choice.hpp"
#include "fracture/window/window_body.hpp"
#include "fracture/window/window_settings.hpp"
#include "phase.hpp"
#include "stop_request.hpp"

namespace bempd::fracture {

using coupling::Affine;
using coupling::evaluate;

EventForecast::EventForecast(LoadedBody& body)
    : body_(body),
      system_(body.system()),
      locator_(body.system(), body.ratios(), body.positions()),
      functions_(body.system(), body.reaction_dofs()),
      narrowing_(body.system(), locator_, body.positions()),
      most_events_(WindowSettings::first_events) {}

bool EventForecast::open(const BodyState& state, double load_factor, const Options& options) {
  close();
  options_ = options;
  if (!has_window_form(system_) || !choose_place(state, load_factor)) return false;
  open_here(state);
  return true;
}

bool EventForecast::choose_place(const BodyState& state, double load_factor) {
  return lines_ ? choose_place_of_lines(state, load_factor)
                : locator_.choose(load_factor, options_.tie_band, options_.ahead);
}

void EventForecast::open_again(const BodyState& state, const Options& options) {
  options_ = options;
  locator_.stay();
  open_here(state);
}

void EventForecast::open_here(const BodyState& state) {
  try {
    build_window(state);
  } catch (...) {
    close();
    throw;
  }
}

void EventForecast::remember(WindowLocation place, int most_events) {
  locator_.go_back_to(std::move(place));
  most_events_ = most_events;
}

void EventForecast::build_window(const BodyState& state) {
  const Phase phase("window around what breaks", 3);
  has_ended_ = needs_whole_body_ = faces_move_ = system_has_changed_ = false;
  condensation_ = std::make_unique<coupling::Condensation>(system_);
  check_cancelled();
  phase.reach(1);
  window_ =
      std::make_unique<WindowSolver>(system_, *condensation_, body_.ratios(), state.displacement, functions_.list());
  check_cancelled();
  phase.reach(2);
  proportional_ = state.displacement.col(0).isZero(0) && state.load_factor >= 0;
  if (!lines_)
    certificate_ =
        std::make_unique<WindowCertificate>(system_, *condensation_, *window_, body_.ratios(), proportional_);
  tips_ = state.tips;
  outside_gaps_ = OutsideGaps(system_, *condensation_);
  whole_ = state.displacement;
  any_displacement_ = state.total_displacement;
  position_ = 0;
  narrowing_.restart();
  states_ = {window_->displacement()};
}

void EventForecast::close() noexcept {
  if (!condensation_) return;
  window_.reset();
  certificate_.reset();
  line_certificate_.reset();
  condensation_.reset();
  events_.clear();
  states_.clear();
  if (system_has_changed_) system_.forget_factor();
  if (needs_whole_body_) system_.keep_last({});  // what comes next factorizes, twice, and needs no window for it
}

void EventForecast::forget() {
  close();
  most_events_ = WindowSettings::first_events;
  locator_.return_to_expected();
}

const ForecastEvent* EventForecast::next() const {
  return position_ < static_cast<int>(events_.size()) ? &events_[position_] : nullptr;
}

void EventForecast::take() {
  system_.set_stages(events_[position_].event.changes);
  system_has_changed_ = true;
  ++position_;
}

void EventForecast::return_to(int position) noexcept {
  while (position_ > position) system_.set_stages(events_[--position_].back);
}

void EventForecast::take_back(int count) {
  for (auto e = static_cast<int>(events_.size()); e-- > count;) system_.set_stages(events_[e].back);
}

Affine EventForecast::displacement(int position) const {
  const bool is_last = position + 1 == static_cast<int>(states_.size());
  return is_last ? whole_ : condensation_->displacement(states_[position]);
}

std::vector<std::uint8_t> EventForecast::stages(int position) const {
  std::vector<std::uint8_t> result = system_.stages();
  for (int e = position_; e-- > position;) {
    for (const coupling::StageChange& c : events_[e].back) result[c.term] = static_cast<std::uint8_t>(c.stage);
  }
  return result;
}

void EventForecast::compute(const BodyState& state) {
  events_.clear();
  checks_.clear();
  position_ = balanced_events_ = 0;
  if (lines_) begin_steps(state);
  unbalanced_ = 0;
  foreseen_ = {window_->state()};
  FaceForecast ahead(body_.faces(), state.faces);
  face_forecast_ = &ahead;
  const bool keeps_balance = forecast_events(state);
  most_events_ = std::min(WindowSettings::growth_of_events * most_events_, WindowSettings::most_events_at_once);
  states_ = window_->complete(foreseen_);
  if (!keeps_balance) keep_first(balanced_events_);
  certify(state.load_factor);
  take_back(0);
  face_forecast_ = nullptr;
}

// Computes events until the window ends or their number is reached. Returns false if rounding errors have grown too
// large since the last check of the balance of forces. A host that asks for the end of the step gets the events so far.
bool EventForecast::forecast_events(const BodyState& start) {
  const Phase phase("events ahead in a window", most_events_);
  double from = start.load_factor;
  while (!has_ended_ && static_cast<int>(events_.size()) < most_events_) {
    check_cancelled();
    if (!events_.empty() && stop_is_requested()) break;
    phase.reach(static_cast<double>(events_.size()));
    if (!forecast_next(from, start)) {
      has_ended_ = true;
      return true;  // in the window the event may be half done
    }
    from = events_.back().event.load_factor;
    const auto since = static_cast<int>(events_.size()) - balanced_events_;
    if (events_.size() == 1 || since >= WindowSettings::events_between_balances) {
      if (!is_balanced()) return false;
    }
  }
  return is_balanced();
}

bool EventForecast::choose_breaks(double from, ForecastEvent& foreseen) const {
  const BondList bonds{window_->ratios(), window_->intact(), &window_->bonds(), proportional_};
  const std::optional<double> next = next_critical(bonds, {from, true, options_.control});
  if (!next) return false;
  const std::vector<int> chosen = most_critical(bonds, *next, options_.tie_band, options_.max_breaks_per_solve);
  const auto is_known = [&](int place) { return window_->ratio_is_known(place); };
  if (!std::all_of(chosen.begin(), chosen.end(), is_known)) return false;
  foreseen.event = break_of(bonds, chosen, *next, system_);
  return true;
}

bool EventForecast::forecast_next(double from, const BodyState& start) {
  narrow(from);
  ForecastEvent foreseen;
  const std::optional<LineSteps::Choice> line = lines_ ? choose_step(from, foreseen) : std::nullopt;
  if (lines_ ? !line.has_value() : !choose_breaks(from, foreseen)) return false;
  if (!locator_.is_far_from_rim(coupling::terms_of(foreseen.event.changes))) return false;
  foreseen.event.changes = system_.with_followers(std::move(foreseen.event.changes));
  for (const coupling::StageChange& c : foreseen.event.changes) {
    if (window_->place_of(c.term) < 0) return false;  // a follower that reaches out of the window
    foreseen.back.push_back({c.term, system_.stages()[c.term]});
  }
  foreseen.largest_force =
      events_.empty() ? largest_force_before(foreseen.event.load_factor, start) : events_.back().largest_force;
  if (!perform_in_window(foreseen)) {
    needs_whole_body_ = true;
    return false;
  }
  const double unit_energy = foreseen.outcome.unit_energy;
  has_ended_ = is_separated(system_, unit_energy, start.first_unit_energy);
  if (!has_ended_ && unit_energy < WindowSettings::doubtful_energy * start.first_unit_energy) {
    system_.set_stages(foreseen.back);
    needs_whole_body_ = true;
    return false;
  }
  if (line) {
    take_step(*line, foreseen);
  } else {
    add_checks(from, foreseen.event);
  }
  events_.push_back(std::move(foreseen));
  foreseen_.push_back(window_->state());
  return true;
}

// Checks the balance of forces in windows with squares of cells, and corrects it. Squares may be many times as stiff as
// bonds and then have larger rounding errors. Returns false if the errors are too large.
bool EventForecast::is_balanced() {
  const auto count = static_cast<int>(events_.size());
  if (system_.terms().followers.empty() || count == balanced_events_) return true;
  const ForecastEvent& last = events_.back();
  const Affine force = window_->unbalanced();
  const double share = evaluate(force, last.event.load_factor).lpNorm<Eigen::Infinity>() / last.largest_force;
  if (!(share <= WindowSettings::acceptable_residual)) return false;
  unbalanced_ = std::max(unbalanced_, share);
  balanced_events_ = count;
  if (share <= WindowSettings::negligible_residual) return true;
  window_->balance(force);
  if (lines_) near_tips_ = displacement_near(last_tips());
  narrowing_.stop();
  foreseen_.back() = window_->state();
  return true;
}

// Scale of nodal forces just before the first of the events computed together.
double EventForecast::largest_force_before(double load_factor, const BodyState& start) const {
  const Eigen::VectorXd force = system_.internal_force(evaluate(whole_, load_factor));
  return std::max({start.largest_force, force.lpNorm<Eigen::Infinity>(), least_force_scale(system_, load_factor)});
}

bool EventForecast::perform_in_window(ForecastEvent& foreseen) {
  const int state = static_cast<int>(events_.size()) + 1;
  WindowBody body(body_, *window_, functions_, *face_forecast_, state, any_displacement_);
  foreseen.before = body.energy();
  std::optional<Outcome> outcome = perform_event(foreseen.event, system_, body);
  if (!outcome) return false;
  foreseen.outcome = std::move(*outcome);
  foreseen.faces = body.switched_faces();
  return true;
}

}  // namespace bempd::fracture

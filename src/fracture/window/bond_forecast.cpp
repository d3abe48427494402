#include "fracture/window/bond_forecast.hpp"

#include <algorithm>
#include <optional>

#include "fracture/event_choice.hpp"

namespace bempd::fracture {

void BondForecast::begin_window(const coupling::Condensation& condensation, const WindowSolver& window,
                                bool proportional) {
  window_ = &window, proportional_ = proportional;
  certificate_ = std::make_unique<WindowCertificate>(body_.system(), condensation, window, body_.response().ratios(),
                                                     proportional);
}

bool BondForecast::choose(double from, const WindowOptions& options, ForecastEvent& foreseen) const {
  const BondList bonds{window_->ratios(), window_->intact(), &window_->bonds(), proportional_};
  const std::optional<double> next = next_critical(bonds, {from, true, options.control});
  if (!next) return false;
  const std::vector<int> chosen = most_critical(bonds, *next, options.tie_band, options.max_breaks_per_solve);
  const auto is_known = [&](int place) { return window_->ratio_is_known(place); };
  if (!std::all_of(chosen.begin(), chosen.end(), is_known)) return false;
  foreseen.event = break_of(bonds, chosen, *next, body_.system());
  return true;
}

void BondForecast::note(int state, double from, const Event& event, const WindowOptions& options) {
  const double f = event.load_factor, limit = tie_limit(options.tie_band) * event.ratio;
  if (proportional_) {
    checks_.push_back({state, 1, limit / f});
    return;
  }
  if (from != f && options.control == Control::load) checks_.push_back({state, from, 1});
  checks_.push_back({state, f, limit});
}

void BondForecast::keep_first(int count) {
  std::erase_if(checks_, [&](const OutsideCheck& check) { return check.state >= count; });
}

int BondForecast::proven_in_window(const std::vector<coupling::Affine>& states) const {
  return window_->dropped().first_violation(states, checks_);
}

int BondForecast::proven(const std::vector<coupling::Affine>& states, const std::vector<ForecastEvent>& events,
                         const coupling::Affine& whole) {
  std::vector<int> breaks{0};
  for (const ForecastEvent& foreseen : events)
    breaks.push_back(breaks.back() + static_cast<int>(foreseen.event.changes.size()));
  return certificate_->first_violation(states, breaks, checks_, whole);
}

}  // namespace bempd::fracture

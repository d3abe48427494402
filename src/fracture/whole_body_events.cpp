#include "fracture/whole_body_events.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/whole_body.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// Distance from the end of an increment, as a share of the increment's size, within which a load factor counts as at
// the end.
constexpr double increment_rounding = 1e-9;

}  // namespace

const Event* WholeBodyEvents::next(double target, const SteppingOptions& options) {
  const std::optional<double> load_factor = next_load_factor(target, options);
  if (!load_factor) return nullptr;
  event_ = {};
  event_.load_factor = event_.critical_load_factor = *load_factor;
  const bool upwards = target >= body_.state().load_factor;
  if (upwards ? *load_factor <= target : *load_factor >= target) choose_terms(options);
  return &event_;
}

std::optional<double> WholeBodyEvents::next_load_factor(double target, const SteppingOptions& options) {
  const LoadWay way = body_.response().load_path_to(target, options.control);
  const std::optional<double> next = body_.response().next_critical(way);
  if (!next || way.control == Control::path || options.mode == SteppingMode::events) return next;
  const Stopwatch watch(body_.response().seconds_search());
  if (const std::optional<double> increment = next_increment(target, options.increment)) return increment;
  // No bond breaks up to the target; the next break lies beyond it.
  return way.end();
}

std::optional<double> WholeBodyEvents::next_increment(double target, double increment) const {
  // Increments end at multiples of their size and at the target.
  const double present = body_.state().load_factor, direction = target >= present ? 1 : -1;
  const auto number = [&](double load_factor) { return load_factor * direction / increment; };
  const double first = std::floor(number(present) + increment_rounding) + 1;
  double from = present;
  for (;;) {
    const std::optional<double> next = body_.response().ratios().next_break(system_.stages().intact(), from, target);
    if (!next || (target - from) * direction <= 0) return std::nullopt;
    const double end = std::max(first, std::ceil(number(*next) - increment_rounding)) * increment;
    const double load_factor = direction * std::min(end, target * direction);
    if (!body_.response().ratios().overstretched(system_.stages().intact(), load_factor).empty()) return load_factor;
    from = load_factor;  // bonds critical before this load factor are relieved here
  }
}

void WholeBodyEvents::choose_terms(const SteppingOptions& options) {
  const Stopwatch watch(body_.response().seconds_search());
  const double f = event_.load_factor;
  const BondList bonds = body_.response().bonds();
  const std::vector<int> chosen = options.mode == SteppingMode::increments
                                      ? body_.response().ratios().overstretched(system_.stages().intact(), f)
                                      : most_critical(bonds, f, options.tie_band, options.max_breaks_per_solve);
  event_ = break_of(bonds, chosen, f, system_);
  event_.changes = system_.stages().with_followers(std::move(event_.changes));
}

Outcome WholeBodyEvents::perform(Event event) {
  event_ = std::move(event);
  return perform();
}

Outcome WholeBodyEvents::perform() {
  const double work_before = body_.response().move_to(event_.load_factor);
  WholeBody whole(body_);
  Outcome outcome = *perform_event(event_, body_, whole);
  outcome.work_before = work_before;
  outcome.residual = body_.response().residual();
  return outcome;
}

}  // namespace bempd::fracture

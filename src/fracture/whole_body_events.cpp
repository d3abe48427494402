#include "fracture/whole_body_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/free_motions.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// A bond that lengthens by this factor when it breaks was the last resistance to some motion.
constexpr double runaway_elongation = 1e8;

// An increment that has begun by less than this share of its size has not begun.
constexpr double increment_rounding = 1e-9;

}  // namespace

using coupling::evaluate;

const Event* WholeBodyEvents::next(double target, const SteppingOptions& options) {
  const std::optional<double> load_factor = next_load_factor(target, options);
  if (!load_factor) return nullptr;
  event_ = {*load_factor, 0, {}};
  const bool upwards = target >= body_.state().load_factor;
  if (upwards ? *load_factor <= target : *load_factor >= target) choose_bonds(options);
  return &event_;
}

std::optional<double> WholeBodyEvents::next_load_factor(double target, const SteppingOptions& options) {
  const std::optional<double> next = body_.next_break(target);
  if (!next || options.mode == SteppingMode::events) return next;
  const Stopwatch watch(body_.seconds_search());
  if (const std::optional<double> increment = next_increment(target, options.increment)) return increment;
  // Without a break up to the target there is one beyond it.
  const double infinity = std::numeric_limits<double>::infinity();
  return target >= body_.state().load_factor ? infinity : -infinity;
}

std::optional<double> WholeBodyEvents::next_increment(double target, double increment) const {
  // Increments end at multiples of their size and at the target.
  const double present = body_.state().load_factor, direction = target >= present ? 1 : -1;
  const auto number = [&](double load_factor) { return load_factor * direction / increment; };
  const double first = std::floor(number(present) + increment_rounding) + 1;
  double from = present;
  for (;;) {
    const std::optional<double> next = body_.ratios().next_break(system_.intact(), from, target);
    if (!next || (target - from) * direction <= 0) return std::nullopt;
    const double end = std::max(first, std::ceil(number(*next) - increment_rounding)) * increment;
    const double load_factor = direction * std::min(end, target * direction);
    if (!body_.ratios().overstretched(system_.intact(), load_factor).empty()) return load_factor;
    from = load_factor;  // what exceeded its critical stretch here has been relieved by then
  }
}

void WholeBodyEvents::choose_bonds(const SteppingOptions& options) {
  const Stopwatch watch(body_.seconds_search());
  const double f = event_.load_factor;
  const StretchRatios& ratios = body_.ratios();
  event_.breaking = options.mode == SteppingMode::increments
                        ? ratios.overstretched(system_.intact(), f)
                        : ratios.most_stretched(system_.intact(), f, options.tie_band, options.max_breaks_per_solve);
  for (int b : event_.breaking) event_.ratio = std::max(event_.ratio, ratios.at(b, f));
}

bool WholeBodyEvents::runs_away(const std::vector<double>& elongation) {
  const Eigen::VectorXd after = evaluate(body_.state().displacement, body_.state().load_factor);
  for (std::size_t i = 0; i < elongation.size(); ++i) {
    const double now = std::abs(system_.bonds().elongation(event_.breaking[i], after.data()));
    if (!(now < runaway_elongation * std::abs(elongation[i]))) return true;
  }
  return false;
}

// Potential energy lost: k e^2 / (2 gamma) for a single bond, whose elongation grows from e to e / gamma.
double WholeBodyEvents::released_energy(const std::vector<double>& elongation) const {
  const coupling::BondSet& bonds = system_.bonds();
  double sum = 0;
  for (std::size_t i = 0; i < elongation.size(); ++i) {
    const double after = bonds.elongation(event_.breaking[i], body_.state().total_displacement.data());
    sum += 0.5 * bonds.stiffness[event_.breaking[i]] * elongation[i] * after;
  }
  return sum;
}

Outcome WholeBodyEvents::perform() {
  Outcome outcome;
  BodyState& state = body_.state();
  outcome.work_before = body_.move_to(event_.load_factor);
  const std::vector<int>& breaking = event_.breaking;
  const Eigen::VectorXd before = state.total_displacement;
  std::vector<double> elongation;
  FreedParts freed;
  {
    const Stopwatch watch(body_.seconds_search());
    for (int b : breaking) elongation.push_back(system_.bonds().elongation(b, before.data()));
    system_.mark_broken(breaking);
    freed = body_.freed_parts().after_break(breaking, before);
  }
  const double stored_before = body_.stored_energy();
  system_.commit_break(breaking, freed.springs);
  outcome.fragments = freed.fragments;
  if (!freed.nodes_with_lost_loads.empty()) body_.drop_loads(freed.nodes_with_lost_loads);
  const HeldMotions held = solve_and_hold(body_, breaking, before, [&] { return runs_away(elongation); });
  outcome.fragments += held.fragments;
  const bool loads_lost = held.loads_lost || !freed.nodes_with_lost_loads.empty();
  body_.update_ratios();
  outcome.work = body_.absorb(event_.load_factor);
  outcome.stored_energy = body_.stored_energy();
  // Lost loads take their part along with the piece.
  outcome.released_energy =
      loads_lost ? outcome.work + stored_before - outcome.stored_energy : released_energy(elongation);
  state.intact = system_.intact();
  state.springs = system_.springs();
  outcome.unit_energy = body_.unit_energy();
  outcome.residual = body_.residual();
  outcome.energy_scale = energy_scale_of_supports(system_, event_.load_factor);
  outcome.reactions = body_.reactions();
  return outcome;
}

}  // namespace bempd::fracture

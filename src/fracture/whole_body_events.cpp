#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "fracture/crack_evolution.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// A bond that lengthens by this factor when it breaks was the last resistance to some motion.
constexpr double runaway_elongation = 1e8;

constexpr int most_holds_per_event = 16;

// Resistance, relative to the stiffest direction, below which a motion is free up to rounding.
constexpr double free_motion_resistance = 1e-13;

// An increment that has begun by less than this share of its size has not begun.
constexpr double increment_rounding = 1e-9;

// Nodes that a free motion moves by less than this share of its largest displacement stay where they are.
constexpr double moved_share = 1e-6;

}  // namespace

using coupling::evaluate;

std::optional<double> CrackEvolution::next_event(double target, const SteppingOptions& options) {
  const Stopwatch watch(seconds_search_);
  const double infinity = std::numeric_limits<double>::infinity();
  const std::optional<double> next =
      ratios_.next_break(system_.intact(), state_.load_factor, target >= state_.load_factor ? infinity : -infinity);
  if (!next || options.mode == SteppingMode::events) return next;
  const std::optional<double> increment = next_increment(target, options.increment);
  // Without a break up to the target there is one beyond it.
  return increment ? increment : target >= state_.load_factor ? infinity : -infinity;
}

std::optional<double> CrackEvolution::next_increment(double target, double increment) const {
  // Increments end at multiples of their size and at the target.
  const double direction = target >= state_.load_factor ? 1 : -1;
  const auto number = [&](double load_factor) { return load_factor * direction / increment; };
  const double first = std::floor(number(state_.load_factor) + increment_rounding) + 1;
  double from = state_.load_factor;
  for (;;) {
    const std::optional<double> next = ratios_.next_break(system_.intact(), from, target);
    if (!next || (target - from) * direction <= 0) return std::nullopt;
    const double end = std::max(first, std::ceil(number(*next) - increment_rounding)) * increment;
    const double load_factor = direction * std::min(end, target * direction);
    if (!ratios_.overstretched(system_.intact(), load_factor).empty()) return load_factor;
    from = load_factor;  // what exceeded its critical stretch here has been relieved by then
  }
}

bool CrackEvolution::drop_loads_that_push(const Eigen::VectorXd& motion) {
  std::vector<char> moves(system_.node_count(), 0);
  const auto is_moved = [&](int node) { return motion.segment<2>(2 * node).norm() > moved_share; };
  for (int node = 0; node < system_.node_count(); ++node) moves[node] = is_moved(node) ? 1 : 0;
  // A body that cannot break moves as a whole.
  for (const std::vector<int>& body : system_.dense_bodies()) {
    if (std::none_of(body.begin(), body.end(), is_moved)) continue;
    for (int node : body) moves[node] = 1;
  }
  std::vector<int> loaded;
  for (int node = 0; node < system_.node_count(); ++node) {
    if (moves[node] && !system_.force().middleRows<2>(2 * node).isZero(0)) loaded.push_back(node);
  }
  if (loaded.empty()) return false;
  drop_loads(loaded);
  ++state_.fragments;
  return true;
}

bool CrackEvolution::solve_after_break(const std::vector<int>& bonds, const std::vector<double>& elongation,
                                       const Eigen::VectorXd& before) {
  bool loads_lost = false;
  for (int hold = 0;; ++hold) {
    bool free_motion = false;
    try {
      state_.displacement = system_.solve();
      const Eigen::VectorXd after = evaluate(state_.displacement, state_.load_factor);
      for (std::size_t i = 0; i < bonds.size(); ++i) {
        const double now = std::abs(system_.bonds().elongation(bonds[i], after.data()));
        free_motion = free_motion || !(now < runaway_elongation * std::abs(elongation[i]));
      }
    } catch (const Error& error) {
      if (error.failure() != Failure::unsolvable || hold == most_holds_per_event) throw;
      free_motion = true;
    }
    if (!free_motion && system_.resists_all_motions(bonds)) return loads_lost;
    const coupling::SoftMotion soft = system_.softest_motion();
    if (!free_motion && soft.resistance > free_motion_resistance) return loads_lost;
    if (hold == most_holds_per_event) fail(Failure::unsolvable, "bonds broke so that parts move freely");
    const coupling::HoldingSpring spring = freed_parts_.against(soft.motion, before);
    system_.commit_break({}, {&spring, 1});
    system_.forget_factor();
    loads_lost = drop_loads_that_push(soft.motion) || loads_lost;
  }
}

void CrackEvolution::perform_event(double load_factor, const SteppingOptions& options) {
  whole_body_events_ = std::max(0, whole_body_events_ - 1);
  move_to(load_factor);
  const coupling::BondSet& bonds = system_.bonds();
  const Eigen::VectorXd before = state_.total_displacement;
  std::vector<int> chosen;
  std::vector<double> elongation;
  FreedParts freed;
  double ratio = 0;
  {
    const Stopwatch watch(seconds_search_);
    chosen =
        options.mode == SteppingMode::increments
            ? ratios_.overstretched(system_.intact(), load_factor)
            : ratios_.most_stretched(system_.intact(), load_factor, options.tie_band, options.max_breaks_per_solve);
    for (int b : chosen) {
      ratio = std::max(ratio, ratios_.at(b, load_factor));
      elongation.push_back(bonds.elongation(b, before.data()));
    }
    system_.mark_broken(chosen);
    freed = freed_parts_.after_break(chosen, before);
  }
  const double stored_before = stored_energy();
  system_.commit_break(chosen, freed.springs);
  if (!freed.nodes_with_lost_loads.empty()) drop_loads(freed.nodes_with_lost_loads);
  const bool loads_lost = solve_after_break(chosen, elongation, before) || !freed.nodes_with_lost_loads.empty();
  {
    const Stopwatch watch(seconds_search_);
    ratios_.update(state_.displacement);
  }
  const double work = absorb(load_factor);
  state_.work += work;
  if (!loads_lost) {
    // Potential energy lost: k e^2 / (2 gamma) for a single bond, whose elongation grows from e to e / gamma.
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const double after = bonds.elongation(chosen[i], state_.total_displacement.data());
      state_.released_energy += 0.5 * bonds.stiffness[chosen[i]] * elongation[i] * after;
    }
  } else {
    state_.released_energy += work + stored_before - stored_energy();  // goes with the piece and its loads
  }
  ++state_.events;
  state_.broken_bonds += static_cast<std::int64_t>(chosen.size());
  state_.fragments += freed.fragments;
  state_.intact = system_.intact();
  state_.springs = system_.springs();
  note_separation();
  record(state_.events, ratio);
}

}  // namespace bempd::fracture

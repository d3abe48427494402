#include "fracture/crack_evolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

using coupling::Affine;
using coupling::evaluate;

// Elastic energy of the proportional load relative to the undamaged scene at which nothing resists it any more.
constexpr double separated_energy_ratio = 1e-10;

// A bond that lengthens by this factor when it breaks was the last resistance to some motion.
constexpr double runaway_elongation = 1e8;
constexpr int most_holds_per_event = 16;

// Events in the whole body after which a window is tried again at the latest.
constexpr int most_patience = 64;

// Resistance, relative to the stiffest direction, below which a motion is free up to rounding.
constexpr double free_motion_resistance = 1e-13;

// An increment that has begun by less than this share of its size has not begun.
constexpr double increment_rounding = 1e-9;

// Nodes that a free motion moves by less than this share of its largest displacement stay where they are.
constexpr double moved_share = 1e-6;

}  // namespace

CrackEvolution::CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                               std::vector<double> critical_stretch, const std::vector<int>& cut,
                               std::vector<std::vector<int>> reaction_dofs)
    : system_(system),
      freed_parts_(system, positions),
      ratios_(system.bonds(), std::move(critical_stretch)),
      reaction_dofs_(std::move(reaction_dofs)),
      lookahead_(system, freed_parts_, ratios_, positions, reaction_dofs_) {
  const Eigen::Index dofs = 2 * system.node_count();
  force_ = prescribed_ = state_.displacement = Affine::Zero(dofs, 2);
  state_.total_displacement = state_.total_force = Eigen::VectorXd::Zero(dofs);
  state_.unloaded.assign(system.node_count(), 0);
  system_.place_nodes(positions);
  system_.mark_broken(cut);
  system_.commit_break(cut, {});
  state_.intact = system_.intact();
  state_.springs = system_.springs();
  lookahead_.expect_cracks(cut);
}

void CrackEvolution::set_load(const Affine& force, const Affine& prescribed) {
  close_window();
  force_ = force;
  prescribed_ = prescribed;
  state_.in_equilibrium = false;
  state_.first_unit_energy = -1;
  apply_load();
}

void CrackEvolution::apply_load() {
  Affine force = force_;
  for (int node = 0; node < system_.node_count(); ++node) {
    if (state_.unloaded[node]) force.middleRows<2>(2 * node).setZero();
  }
  system_.set_load(std::move(force), prescribed_);
}

void CrackEvolution::drop_loads(const std::vector<int>& nodes) {
  for (int node : nodes) state_.unloaded[node] = 1;
  apply_load();
}

void CrackEvolution::find_equilibrium() {
  if (state_.in_equilibrium) return;
  EvolutionState start = without_history();
  try {
    hold_free_parts();
    state_.displacement = system_.solve();
    {
      const Stopwatch watch(seconds_search_);
      ratios_.update(state_.displacement);
    }
    state_.work += absorb(state_.load_factor);
    if (state_.first_unit_energy < 0) state_.first_unit_energy = unit_energy();
    state_.in_equilibrium = true;
  } catch (...) {
    start.history = std::move(state_.history);
    start.reactions = std::move(state_.reactions);
    restore(std::move(start));
    throw;
  }
}

void CrackEvolution::hold_free_parts() {
  const FreedParts freed = freed_parts_.all_pieces(state_.total_displacement);
  system_.commit_break({}, freed.springs);
  if (!freed.nodes_with_lost_loads.empty()) drop_loads(freed.nodes_with_lost_loads);
  state_.fragments += freed.fragments;
  state_.springs = system_.springs();
}

double CrackEvolution::absorb(double load_factor) {
  const Eigen::VectorXd displacement = evaluate(state_.displacement, load_factor);
  const Eigen::VectorXd force = system_.internal_force(displacement);
  // On the straight way between two states the trapezoid rule is exact. In equilibrium internal forces equal the loads.
  const double work = 0.5 * (state_.total_force + force).dot(displacement - state_.total_displacement);
  state_.total_displacement = displacement;
  state_.total_force = force;
  state_.largest_force = std::max(state_.largest_force, force.cwiseAbs().maxCoeff());
  state_.load_factor = load_factor;
  return work;
}

void CrackEvolution::move_to(double load_factor) {
  if (load_factor != state_.load_factor) state_.work += absorb(load_factor);
}

double CrackEvolution::stored_energy() const { return 0.5 * state_.total_displacement.dot(state_.total_force); }

bool CrackEvolution::energies_are_lost() const {
  const double displacement = state_.total_displacement.lpNorm<Eigen::Infinity>();
  const double force = state_.total_force.lpNorm<Eigen::Infinity>();
  return displacement > 0 && force > 0 && !std::isnormal(displacement * force);
}

double CrackEvolution::unit_energy() const {
  const Eigen::VectorXd unit = state_.displacement.col(1);
  return 0.5 * unit.dot(system_.internal_force(unit));
}

double CrackEvolution::residual() const {
  double unbalanced = 0;
  const Eigen::VectorXd load = evaluate(system_.force(), state_.load_factor);
  for (Eigen::Index dof = 0; dof < load.size(); ++dof) {
    if (system_.is_prescribed(static_cast<int>(dof))) continue;
    unbalanced = std::max(unbalanced, std::abs(state_.total_force[dof] - load[dof]));
  }
  return state_.largest_force > 0 ? unbalanced / state_.largest_force : unbalanced;
}

void CrackEvolution::record(std::int64_t event, double stretch_ratio) {
  append_history(event, stretch_ratio, stored_energy(), residual());
  for (std::size_t s = 0; s < reaction_dofs_.size(); ++s) {
    const Eigen::Vector2d force = present_reaction(s);
    state_.reactions.push_back(force.x());
    state_.reactions.push_back(force.y());
  }
}

void CrackEvolution::append_history(std::int64_t event, double stretch_ratio, double stored, double residual) {
  state_.largest_work = std::max(state_.largest_work, std::abs(state_.work));
  const double difference = std::abs(state_.work - stored - state_.released_energy);
  const double error = state_.largest_work > 0 ? difference / state_.largest_work : difference;
  state_.worst_energy_balance_error = std::max(state_.worst_energy_balance_error, error);
  state_.residual = residual;
  state_.history.push_back({event, state_.broken_bonds, state_.load_factor, stretch_ratio, stored,
                            state_.released_energy, state_.work, error, state_.residual});
}

Eigen::Vector2d CrackEvolution::present_reaction(std::size_t support) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int dof : reaction_dofs_[support]) {
    const double load = system_.force()(dof, 0) + state_.load_factor * system_.force()(dof, 1);
    sum[dof % 2] += state_.total_force[dof] - load;
  }
  return sum;
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

void CrackEvolution::note_separation() {
  if (unit_energy() < separated_energy_ratio * state_.first_unit_energy) state_.separated = true;
}

EvolutionState CrackEvolution::without_history() {
  // The history only grows; copying it at every step would cost more and more.
  std::vector<HistoryEntry> history;
  std::vector<double> reactions;
  history.swap(state_.history);
  reactions.swap(state_.reactions);
  EvolutionState copy = state_;
  history.swap(state_.history);
  reactions.swap(state_.reactions);
  return copy;
}

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

void CrackEvolution::mark_start(std::optional<Start>& start) {
  if (start) return;
  start.emplace(Start{{}, state_.history.size(), state_.reactions.size(), -1});
  if (!lookahead_.is_open()) {
    start->state = without_history();
    return;
  }
  // What depends on the position among the foreseen events is asked for only if it is needed.
  EvolutionState large;
  const auto set_aside = [&] {
    large.displacement.swap(state_.displacement);
    large.total_displacement.swap(state_.total_displacement);
    large.total_force.swap(state_.total_force);
    large.intact.swap(state_.intact);
  };
  set_aside();
  start->state = without_history();
  set_aside();
  start->foreseen_position = lookahead_.position();
}

void CrackEvolution::complete(Start& start) {
  if (start.foreseen_position < 0) return;
  const int now = lookahead_.position();
  lookahead_.return_to(start.foreseen_position);
  start.state.displacement = lookahead_.displacement(start.foreseen_position);
  start.state.total_displacement = evaluate(start.state.displacement, start.state.load_factor);
  start.state.total_force = system_.internal_force(start.state.total_displacement);
  start.state.intact = system_.intact();
  start.foreseen_position = -1;
  while (lookahead_.position() < now) lookahead_.take();
}

void CrackEvolution::return_to(Start start) {
  start.state.history = std::move(state_.history);
  start.state.reactions = std::move(state_.reactions);
  start.state.history.resize(start.history_size);
  start.state.reactions.resize(start.reactions_size);
  if (start.foreseen_position < 0) {
    restore(std::move(start.state));
    return;
  }
  lookahead_.return_to(start.foreseen_position);
  start.state.displacement = std::move(state_.displacement);
  start.state.total_displacement = std::move(state_.total_displacement);
  start.state.total_force = std::move(state_.total_force);
  start.state.intact = system_.intact();
  state_ = std::move(start.state);
  fields_are_behind_ = true;
}

void CrackEvolution::catch_up() {
  if (!fields_are_behind_) return;
  state_.displacement = lookahead_.displacement(lookahead_.position());
  {
    const Stopwatch watch(seconds_search_);
    ratios_.update(state_.displacement);
  }
  state_.total_displacement = evaluate(state_.displacement, state_.load_factor);
  state_.total_force = system_.internal_force(state_.total_displacement);
  state_.largest_force = std::max(state_.largest_force, state_.total_force.cwiseAbs().maxCoeff());
  fields_are_behind_ = false;
}

void CrackEvolution::close_window() {
  catch_up();
  lookahead_.close();
}

void CrackEvolution::synchronize() {
  catch_up();
  lookahead_.forget();
  whole_body_events_ = 0;
  patience_ = 1;
  system_.forget_factor();
}

void CrackEvolution::open_window(double target, const SteppingOptions& options) {
  if (state_.separated || whole_body_events_ > 0) return;
  const std::optional<double> next = next_event(target, options);
  if (!next || *next > target) return;
  const Lookahead::Options wanted{options.tie_band, options.max_breaks_per_solve, options.window_ahead,
                                  separated_energy_ratio * state_.first_unit_energy};
  events_at_opening_ = state_.events;
  if (!lookahead_.open(state_, *next, wanted)) whole_body_events_ = patience_;
}

const ForeseenEvent* CrackEvolution::foreseen_event(double target, const SteppingOptions& options,
                                                    std::optional<Start>& start) {
  const bool possible = options.window && options.mode == SteppingMode::events && target >= state_.load_factor;
  const Lookahead::Options& present = lookahead_.options();
  const bool others = options.tie_band != present.tie_band || options.window_ahead != present.ahead ||
                      options.max_breaks_per_solve != present.max_breaks_per_solve;
  const auto leave = [&] {
    if (start && lookahead_.is_open()) complete(*start);
    close_window();
  };
  if (!possible || (lookahead_.is_open() && others)) leave();
  if (!possible) return nullptr;
  for (;;) {
    if (!lookahead_.is_open()) open_window(target, options);
    if (!lookahead_.is_open()) return nullptr;
    const auto keep_start = [&] {
      mark_start(start);
      complete(*start);
    };
    if (const ForeseenEvent* event = lookahead_.next(state_.load_factor, keep_start)) return event;
    // A window that found nothing to do is not tried again at once.
    const bool was_useful = state_.events > events_at_opening_;
    patience_ = was_useful ? 1 : std::min(2 * patience_, most_patience);
    if (!was_useful) whole_body_events_ = patience_;
    if (lookahead_.needs_whole_body()) whole_body_events_ = std::max(whole_body_events_, 1);
    leave();
  }
}

void CrackEvolution::perform_foreseen(const ForeseenEvent& event) {
  lookahead_.take();
  fields_are_behind_ = true;
  state_.work += event.before.at(event.load_factor) - event.before.at(state_.load_factor) + event.work;
  state_.load_factor = event.load_factor;
  state_.released_energy += event.released;
  ++state_.events;
  state_.broken_bonds += static_cast<std::int64_t>(event.bonds.size());
  for (int b : event.bonds) state_.intact[b] = 0;
  if (0.5 * event.after.proportional < separated_energy_ratio * state_.first_unit_energy) state_.separated = true;
  append_history(state_.events, event.ratio, event.after.at(event.load_factor), lookahead_.residual_bound());
  state_.reactions.insert(state_.reactions.end(), event.reactions.begin(), event.reactions.end());
}

StopReason CrackEvolution::advance(double target, Goal goal, const SteppingOptions& options,
                                   const std::function<void(const EvolutionState&)>& on_event) {
  std::optional<Start> start;
  const std::int64_t events_before = state_.events;
  try {
    if (!state_.in_equilibrium) {
      mark_start(start);
      find_equilibrium();
    }
    for (;;) {
      if (goal == Goal::separation && state_.separated) return StopReason::separated;
      const ForeseenEvent* foreseen = foreseen_event(target, options, start);
      const std::optional<double> next = foreseen ? foreseen->load_factor : next_event(target, options);
      const bool beyond = next && (target >= state_.load_factor ? *next > target : *next < target);
      if (!next && goal != Goal::load_factor) {
        record(0, 0);
        return StopReason::no_further_event;
      }
      if (!next || beyond) break;
      if (state_.events - events_before >= options.max_events) {
        fail(Failure::convergence, options.max_events,
             " events happened in this step, as many as the option stepping.max_events allows; raise it to go on");
      }
      mark_start(start);
      if (foreseen) {
        perform_foreseen(*foreseen);
      } else {
        perform_event(*next, options);
      }
      if (on_event) on_event(state_);
      if (goal == Goal::next_event) return state_.separated ? StopReason::separated : StopReason::event;
    }
    catch_up();
    move_to(target);
    record(0, 0);
    return state_.separated ? StopReason::separated : StopReason::load_factor;
  } catch (...) {
    if (start) return_to(std::move(*start));
    throw;
  }
}

void CrackEvolution::restore(EvolutionState state) {
  lookahead_.forget();
  fields_are_behind_ = false;
  whole_body_events_ = 0;
  patience_ = 1;
  state_ = std::move(state);
  system_.restore(state_.intact, state_.springs);
  apply_load();
  ratios_.update(state_.displacement);
}

}  // namespace bempd::fracture

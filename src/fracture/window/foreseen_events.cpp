#include <algorithm>

#include "error.hpp"
#include "fracture/crack_evolution.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// Events in the whole body after which a window is tried again at the latest.
constexpr int most_patience = 64;

// Adds the time of its scope to a sum of seconds, but for what the system counts on its own.
class WindowWatch {
 public:
  WindowWatch(double& seconds, const coupling::SolverCounters& counters)
      : seconds_(seconds), counters_(counters), counted_(counted()) {
    watch_.emplace(elapsed_);
  }
  ~WindowWatch() {
    watch_.reset();
    seconds_ += elapsed_ - (counted() - counted_);
  }
  WindowWatch(const WindowWatch&) = delete;
  WindowWatch& operator=(const WindowWatch&) = delete;

 private:
  double counted() const {
    return counters_.seconds_assembly + counters_.seconds_factorization + counters_.seconds_solve +
           counters_.seconds_update;
  }

  double& seconds_;
  const coupling::SolverCounters& counters_;
  double counted_, elapsed_ = 0;
  std::optional<Stopwatch> watch_;
};

}  // namespace

using coupling::evaluate;

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
  bool opened = false;
  try {
    const WindowWatch watch(seconds_search_, system_.counters());
    opened = lookahead_.open(state_, *next, wanted);
  } catch (const Error& error) {
    // Next to a mechanism a fresh factorization may fail: the next break is then found, and held, in the whole body.
    if (error.failure() != Failure::unsolvable) throw;
  }
  if (!opened) look_at_whole_body();
}

// A window that finds nothing to do is not tried again at once, and each time later.
void CrackEvolution::look_at_whole_body() {
  patience_ = std::min(2 * patience_, most_patience);
  whole_body_events_ = patience_;
}

const ForeseenEvent* CrackEvolution::foreseen_event(double target, const SteppingOptions& options,
                                                    std::optional<Start>& start) {
  const bool possible =
      options.window && options.mode == SteppingMode::events && system_.is_symmetric() && target >= state_.load_factor;
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
    {
      const WindowWatch watch(seconds_search_, system_.counters());
      if (const ForeseenEvent* event = lookahead_.next(state_.load_factor, keep_start)) return event;
    }
    if (state_.events > events_at_opening_) {
      patience_ = 1;
      if (lookahead_.needs_whole_body()) whole_body_events_ = 1;
    } else {
      look_at_whole_body();
    }
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
  append_history(state_.events, event.ratio, event.after.at(event.load_factor), lookahead_.residual());
  state_.reactions.insert(state_.reactions.end(), event.reactions.begin(), event.reactions.end());
}

}  // namespace bempd::fracture

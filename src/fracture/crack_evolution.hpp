#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/freed_parts.hpp"
#include "fracture/window/lookahead.hpp"

namespace bempd::fracture {

// How bonds break on the way of the load factor.
enum class SteppingMode {
  // The most stretched bonds first, at the load factor at which they reach their critical stretch, until none exceeds
  // it.
  events,
  // Fixed increments with one solution each: every bond that exceeds its critical stretch at the end of an increment
  // breaks, and what that overloads has to wait for the next one (Yang and Liu 2021, fig. 6).
  increments
};

struct SteppingOptions {
  SteppingMode mode = SteppingMode::events;
  double increment = 1;  // of the load factor
  double tie_band = 1e-3;
  int max_breaks_per_solve = 0;  // 0: no limit
  std::int64_t max_events = 10'000'000;
  bool window = true;       // compute events ahead in a window around what breaks, where that is possible
  double window_ahead = 0;  // of a crack tip, in lattice spacings; 0: chosen
};

enum class Goal { load_factor, next_event, separation };
enum class StopReason { load_factor, event, separated, no_further_event };

// Quasi-static growth of cracks. Between two breaks the response is linear in the load factor, so the next break is
// found in closed form; a break is a low-rank change of the system. An event is one batch of bonds broken at one load
// factor; events follow each other at the same load factor until no bond exceeds its critical stretch.
class CrackEvolution {
 public:
  // `reaction_dofs[s]` are the degrees of freedom of support s. Bonds in `cut` are gone from the start.
  CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                 std::vector<double> critical_stretch, const std::vector<int>& cut,
                 std::vector<std::vector<int>> reaction_dofs);

  void set_load(const coupling::Affine& force, const coupling::Affine& prescribed);

  // Calls `on_event` after every event; what it throws, and any other failure, takes the run back to where it was.
  StopReason advance(double target, Goal goal, const SteppingOptions& options,
                     const std::function<void(const EvolutionState&)>& on_event);

  // Makes the state consistent with the present loads, at the present load factor.
  void find_equilibrium();

  // Displacements and forces are brought up to date first.
  const EvolutionState& state() {
    catch_up();
    return state_;
  }
  // The same without: numbers, bonds and history are right, displacements and forces may be those of an earlier event.
  const EvolutionState& progress() const { return state_; }
  void restore(EvolutionState state);
  // From here on the run is the same, bit for bit, as one restored from a copy of the present state.
  void synchronize();

  double stretch(std::size_t bond) {
    catch_up();
    return ratios_.stretch(bond, state_.load_factor);
  }
  Eigen::Vector2d reaction(std::size_t support) {
    catch_up();
    return present_reaction(support);
  }
  double seconds_search() const { return seconds_search_; }

  // Whether displacements and forces have products beyond the range of numbers.
  bool energies_are_lost() const;

 private:
  // Elastic energy of the proportional load relative to the undamaged scene at which nothing resists it any more.
  static constexpr double separated_energy_ratio = 1e-10;

  // Where a call began, to return to if it fails.
  struct Start {
    EvolutionState state;  // without history
    std::size_t history_size, reactions_size;
    int foreseen_position;  // < 0: displacements, forces and bonds are in `state`
  };

  void hold_free_parts();  // those that initial cracks cut off, and those that new loads push
  EvolutionState without_history();
  void mark_start(std::optional<Start>& start);
  void complete(Start& start);
  void return_to(Start start);

  // Events computed ahead: null where the next event has to be looked for in the whole body.
  const ForeseenEvent* foreseen_event(double target, const SteppingOptions& options, std::optional<Start>& start);
  void perform_foreseen(const ForeseenEvent& event);
  void open_window(double target, const SteppingOptions& options);
  void look_at_whole_body();
  void close_window();
  void catch_up();
  void move_to(double load_factor);
  // Load factor of the next event on the way to the target, empty if none is left in that direction. It may lie beyond
  // the target.
  std::optional<double> next_event(double target, const SteppingOptions& options);
  // End of the first increment, not beyond the target, at which a bond exceeds its critical stretch.
  std::optional<double> next_increment(double target, double increment) const;
  void perform_event(double load_factor, const SteppingOptions& options);
  // Loads on the nodes that a free motion moves: nothing balances them any more, the part counts as a fragment.
  bool drop_loads_that_push(const Eigen::VectorXd& motion);
  // Returns whether loads were lost with a part that came free.
  bool solve_after_break(const std::vector<int>& bonds, const std::vector<double>& elongation,
                         const Eigen::VectorXd& before);
  void drop_loads(const std::vector<int>& nodes);
  void apply_load();
  double absorb(double load_factor);  // takes over the displacement at a load factor; returns the work done
  double stored_energy() const;
  double unit_energy() const;
  void note_separation();
  void record(std::int64_t event, double stretch_ratio);
  void append_history(std::int64_t event, double stretch_ratio, double stored_energy, double residual);
  double residual() const;
  Eigen::Vector2d present_reaction(std::size_t support) const;

  coupling::EquilibriumSystem& system_;
  FreedPartFinder freed_parts_;
  StretchRatios ratios_;
  std::vector<std::vector<int>> reaction_dofs_;
  coupling::Affine force_, prescribed_;  // as the host gave them
  EvolutionState state_;
  double seconds_search_ = 0;
  Lookahead lookahead_;
  bool fields_are_behind_ = false;
  std::int64_t events_at_opening_ = 0;
  int whole_body_events_ = 0;  // before the next window is tried
  int patience_ = 1;           // how many, doubled where a window finds nothing to do
};

}  // namespace bempd::fracture

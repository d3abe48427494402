#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_sources.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// An event at which tips with elements have grown.
struct Growth {
  double ratio = 1;                 // largest equivalent stress intensity factor over the toughness, before it
  double critical_load_factor = 0;  // at which that tip just reached its toughness
  double surface_energy = 0;        // fracture energy times new area [J]
  double beyond_path = 0;           // of the energy released, as released_beyond_path() has it [J]
  std::vector<CrackExtension> extensions;
  int ties = 0;  // tips that would have grown as soon
};

// A bond that breaks by itself: at which load factor, and its stretch over the critical one at present.
struct NextBond {
  int term;
  double load_factor, ratio;
};

enum class Goal { load_factor, next_event, separation };
enum class StopReason {
  load_factor,
  event,
  separated,
  no_further_event,
  no_admissible_load,
  no_equilibrium,
  requested,
  crack_stopped,
  growth  // a tip with elements grows next, at the load factor that was reached; no step of a host ends so
};

// Quasi-static growth of cracks. Between two breaks the response is linear in the load factor, so the next break is
// found in closed form; a break is a low-rank change of the system. An event is one batch of bonds broken at one load
// factor; events follow each other at the same load factor until no bond exceeds its critical stretch.
//
// The sources say which event comes next and perform it; the books are kept here: work and energies, history, and the
// state to return to when a call fails.
class CrackEvolution {
 public:
  // `reaction_dofs[s]` are the degrees of freedom of support s. Bonds in `cut` are broken from the start.
  CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                 std::vector<double> critical_stretch, const std::vector<int>& cut,
                 std::vector<std::vector<int>> reaction_dofs, ContactPlan contact = {});

  // Makes cracks grow as lines from these tips, by the laws that they name; called before the first step.
  void grow_lines(pd::TipLaws laws, std::vector<GrowingTip> tips);

  // Adds the fluid by which pressures in cracks among bonds act; called before the first loads.
  void add_crack_fluid(CrackFluid fluid) { body_.add_crack_fluid(std::move(fluid)); }

  // `work_within`: what loads do beside the work of the nodal forces, half of (1, f) within (1, f) at the load factor
  // f. It is stored in the body as soon as it is done.
  void set_load(const coupling::Affine& force, const coupling::Affine& prescribed,
                const Eigen::Matrix2d& work_within = Eigen::Matrix2d::Zero(), const CrackPressures& pressures = {});

  // Replaces the loads by others that equal the present ones at this load factor: nothing moves.
  void take_over(const coupling::Affine& force, const coupling::Affine& prescribed, const Eigen::Matrix2d& work_within,
                 const CrackPressures& pressures = {});

  // What set_load() replaces, to come back to.
  struct Loads {
    ActingLoads acting;
    Eigen::Matrix2d work_within;
    Continuation way_on;
  };
  Loads loads() {
    sources_.refresh();
    return {body_.acting_loads(), work_within_, sources_.continuation()};
  }
  void restore_loads(Loads loads) noexcept;

  // Other rests of terms and operators, as heat makes them. What they do to the stored energy where nothing moves is
  // work; after that the body has to find equilibrium. Returns what restore_rest_lengths() takes to undo it.
  struct Heat {
    coupling::Rests rests;
    Eigen::VectorXd total_force;
    double work;
  };
  Heat heat(coupling::Rests rests);
  void restore_rest_lengths(Heat heat) noexcept;

  // What loads inside operators make of the gaps of faces there. What new ones do to the stored energy where nothing
  // moves is work, as with heat; set_load() or take_over() has to follow. Returns what unload_faces() takes to undo it.
  struct FaceLoads {
    coupling::Affine offsets;
    double work;
  };
  FaceLoads load_faces(coupling::Affine offsets);
  void unload_faces(FaceLoads loads) noexcept;

  // Calls `on_event` after every event and `on_end` at the end; what they throw, and any other failure, takes the run
  // back to where it was.
  StopReason advance(double target, Goal goal, const SteppingOptions& options,
                     const std::function<void(const EvolutionState&)>& on_event, const std::function<void()>& on_end);

  // Makes the state consistent with the present loads, at the present load factor.
  void find_equilibrium();

  // The tip that grows next after StopReason::growth, and how many others would grow as soon.
  struct Due {
    crack::TipId tip;
    int ties = 0;
  };
  const Due& due() const { return due_; }

  // Puts the run back to where it was before the advance() that ended with StopReason::growth; called next after it.
  void take_back() noexcept;

  // A tip of a line goes no further: it has come to an interface, or its crack goes on in another carrier.
  void stop_line(const crack::TipId& tip, crack::TipState state = crack::TipState::at_interface);

  // Ends the step after StopReason::growth, because these tips cannot grow: they have stopped.
  void end_with_stopped(const std::vector<crack::TipId>& tips, const std::function<void()>& on_end);

  // Goes on with the run of another body whose cracks have grown since, at its load factor. `node_before` has of each
  // node the one that was there before, or one close by. book() has to follow.
  void go_on_after_growth(CrackEvolution& before, const std::vector<int>& node_before,
                          const std::vector<crack::TipId>& entering);
  // Energy that this released, at constant loads, and what that is beyond the one on the path of equilibrium, along
  // which the load factor goes to another one [J].
  double released_by_growth() const { return growth_.released_energy; }
  double released_beyond_path(const CrackEvolution& before, double load_factor) const;
  // Writes it down as an event.
  void book(const Growth& growth);

  // Nodes of parts that the last equilibrium under new loads found to move freely; they are held from there on.
  std::vector<int> take_held() { return std::exchange(held_, {}); }

  // Displacements and forces are brought up to date first; nothing else depends on whether they are asked for.
  const EvolutionState& state() {
    look();
    return state_;
  }
  // What a restored run needs beside it to go on with the same digits.
  Continuation continuation() {
    look();
    return sources_.continuation();
  }
  // The state without its solution: numbers, bonds and history are right, displacements and forces may be those of an
  // earlier event.
  const EvolutionState& progress() const { return state_; }
  void restore(EvolutionState state, std::optional<Continuation> continuation = std::nullopt) noexcept;
  // The system's terms are in their present stages, also after a failure or another state.
  void bring_terms_up_to_date() { sources_.refresh(); }
  // Makes the run go on bit for bit as one that is restored from a copy of the present state alone.
  void synchronize();

  Eigen::Vector2d reaction(std::size_t support) {
    look();
    return body_.reaction(support);
  }
  double reaction_moment(std::size_t support, const Point& about) {
    look();
    return body_.reaction_moment(support, about);
  }
  double reaction_at(int dof) {
    look();
    return body_.reaction_at(dof);
  }
  // The places where crack faces meet come first for initial cracks, from this number on for grown ones; can_have()
  // says whether a bond and normal make a grown one.
  std::size_t first_grown_constraint() const { return body_.faces().first_grown(); }
  bool can_have(const GrownFace& face) const { return body_.faces().can_have(face); }
  double seconds_search() { return body_.seconds_search(); }

  // Whether cracks among bonds grow as lines, and what their tips do next under the present loads.
  bool grows_lines() { return sources_.lines() != nullptr; }
  std::vector<crack::Tip> tips_of_lines() {
    look();
    return sources_.lines() ? sources_.lines()->tips() : std::vector<crack::Tip>();
  }

  // The load factors at which nothing breaks, in the present state of the bonds and under the present loads.
  LoadInterval admissible_load_factors() {
    look();
    return body_.admissible();
  }
  // The bond that breaks next by itself, away from tips of lines, on the way of the load factor; null if none does.
  std::optional<NextBond> next_bond(bool upwards, Control control);
  double work() const;  // of loads and supports so far [J]

  // Whether displacements and forces have products beyond the range of numbers.
  bool energies_are_lost() const;

 private:
  void look() {
    sources_.refresh();
    sources_.show();
  }

  // The books as they were when a call began.
  struct Start {
    Sums sums;
    std::size_t history_size, extensions_size;
  };

  Start start() const { return {state_, state_.history.size(), state_.extensions.size()}; }
  StopReason run(double target, Goal goal, const SteppingOptions& options,
                 const std::function<void(const EvolutionState&)>& on_event);
  std::optional<StopReason> why_there_is_none(Goal goal, const SteppingOptions& options);
  bool has_come_apart(const Event* next, double target, const SteppingOptions& options);
  bool perform(const Event& event, const SteppingOptions& options, bool keep_what_was_reached);
  StopReason go_to_growth(const Event& growth);
  double potential_at(double load_factor) const;
  LoadedBody::FirstEquilibrium find_equilibrium_of_pieces();
  void take_over_faces(const CrackFaces& before, const FaceState& old);
  void take_over_lattices(const BodyState& old, const std::vector<crack::TipId>& entering);
  void take_over_body(const BodyState& old, const std::vector<int>& node_before,
                      const std::vector<crack::TipId>& entering);
  void forget_lines(const Start& start) noexcept;  // of the history, and what was added to the sums
  void return_to(const Start& start) noexcept;
  double within(double load_factor) const;
  // The least energy by which those within are measured: where both parts of the loads cancel, they are known to a
  // share of the energies of the parts only.
  double least_scale_within(double load_factor) const;
  double work_that_moves(const Event& event, const Outcome& outcome, const SteppingOptions& options);
  void book(const Event& event, const Outcome& outcome, const SteppingOptions& options);
  void book_lines(const Outcome& outcome, double released_energy);
  void pass(const Outcome& outcome);
  void find_lost_work(double stored_energy);
  void note_separation(const Outcome& outcome);
  void end_step();
  // Throws Error (unsolvable) for a line whose forces or energies do not balance.
  void measure_work();
  void write_line(const HistoryEntry& line, double energy_scale, const std::vector<double>& reactions_before,
                  const std::vector<double>& reactions);

  coupling::EquilibriumSystem& system_;
  EvolutionState state_;
  LoadedBody body_;
  EventSources sources_;
  std::vector<double> lengths_;  // of the cracks that the host described
  std::vector<int> held_;
  std::optional<Start> start_;  // of an advance() that ended where other tips grow
  Due due_;
  Outcome growth_;  // of the growth that is to be booked
  Eigen::Matrix2d work_within_ = Eigen::Matrix2d::Zero();
};

}  // namespace bempd::fracture

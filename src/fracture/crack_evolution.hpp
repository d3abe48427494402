#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_sources.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/line_carrier.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// Event at which tips with boundary elements have grown.
struct Growth {
  double ratio = 1;                 // largest equivalent stress intensity factor over the toughness, before it
  double critical_load_factor = 0;  // at which that tip just reached its toughness
  double surface_energy = 0;        // fracture energy times new area [J]
  double beyond_path = 0;           // of the energy released, as released_beyond_path() has it [J]
  std::vector<CrackExtension> extensions;
  int ties = 0;  // tips that would have grown as soon
};

// Bond that breaks next by itself, with the load factor of that and its present ratio of stretch to critical stretch.
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
  crack_stopped
};

// Quasi-static growth of cracks. Between two breaks the response is linear in the load factor, so the next break is
// found in closed form; a break is a low-rank change of the system. An event is one batch of bonds that break at one
// load factor; events follow each other at that load factor until no bond exceeds its critical stretch.
//
// Event sources find and perform the next event. This class keeps the records: work and energies, history, and the
// state to return to when a call fails.
class CrackEvolution {
 public:
  // `reaction_dofs[s]` are the degrees of freedom of support s. The bonds `cut` are broken from the start.
  CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                 std::vector<double> critical_stretch, const std::vector<int>& cut,
                 std::vector<std::vector<int>> reaction_dofs, ContactPlan contact = {});

  // Lets cracks grow as lines from these tips, by the laws that they refer to; called before the first step. `openings`
  // finds the openings of cracks in lattices, `factors` the stress intensity factors of tips from the field around
  // them.
  void grow_lines(pd::TipLaws laws, std::vector<GrowingTip> tips, LineCarrier::Openings openings,
                  FactorsAround factors);

  // Adds the fluid that carries pressures into cracks among bonds; called before the first loads.
  void add_crack_fluid(CrackFluid fluid) { body_.add_crack_fluid(std::move(fluid)); }

  // Sets new loads and prescribed displacements. `work_within` is the quadratic form W of the work that nodal forces do
  // not include: (1, f) W (1, f)^T / 2 at the load factor f. This work is stored in the body at once.
  void set_load(const coupling::Affine& force, const coupling::Affine& prescribed,
                const Eigen::Matrix2d& work_within = Eigen::Matrix2d::Zero(), const CrackPressures& pressures = {});

  // Replaces the loads by others that are equal at the present load factor, so that nothing moves.
  void take_over(const coupling::Affine& force, const coupling::Affine& prescribed, const Eigen::Matrix2d& work_within,
                 const CrackPressures& pressures = {});

  // Loads that set_load() replaces, for restore_loads().
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

  // Changes the rest lengths of terms and operators by heating. The change of stored energy at unchanged displacements
  // is work; the body then has to find equilibrium. Returns what restore_rest_lengths() needs to undo it.
  struct Heat {
    coupling::Rests rests;
    Eigen::VectorXd total_force;
    double work;
  };
  Heat heat(coupling::Rests rests);
  void restore_rest_lengths(Heat heat) noexcept;

  // Changes the gaps of contact constraints due to loads inside operators (body forces, tractions on cracks). The
  // change of stored energy at unchanged displacements is work; set_load() or take_over() has to follow. Returns what
  // unload_faces() needs to undo it.
  struct FaceLoads {
    coupling::Affine offsets;
    double work;
  };
  FaceLoads load_faces(coupling::Affine offsets);
  void unload_faces(FaceLoads loads) noexcept;

  // Runs to a target or goal (event_loop.hpp). `on_event` is called after every event, `on_end` at the end. If they
  // throw, or after any other failure, the run returns to where it was.
  StopReason advance(double target, Goal goal, const SteppingOptions& options,
                     const std::function<void(const EvolutionState&)>& on_event, const std::function<void()>& on_end);

  // Finds the equilibrium under the present loads at the present load factor.
  void find_equilibrium();

  // Stops a tip of a crack line: it has come to an interface, or its crack continues in boundary elements.
  void stop_line(const crack::TipId& tip, crack::TipState state = crack::TipState::at_interface);

  // Stops tips with boundary elements that cannot grow.
  void stop(const std::vector<crack::TipId>& tips);

  // Continues the run of another body (`before`) whose cracks have grown since, at its load factor. `node_before` maps
  // each node to the one at the same place before, or a close one. `entering` are tips that have entered a lattice.
  // book() has to follow.
  void go_on_after_growth(CrackEvolution& before, const std::vector<int>& node_before,
                          const std::vector<crack::TipId>& entering);
  // Energy released by the growth at constant loads; and the part of it that exceeds the release along the equilibrium
  // path, on which the load factor changes to `load_factor` [J].
  double released_by_growth() const { return growth_.released_energy; }
  double released_beyond_path(const CrackEvolution& before, double load_factor) const;
  // Enters a growth in the history as an event.
  void book(const Growth& growth);

  // Nodes of parts that could move freely in the last equilibrium under new loads and are held since; the list is
  // cleared.
  std::vector<int> take_held() { return std::exchange(held_, {}); }

  // State with its displacements and forces brought up to date. Reading it does not affect the run.
  const EvolutionState& state() {
    look();
    return state_;
  }
  // What a restored run needs beside the state to continue with the same digits.
  Continuation continuation() {
    look();
    return sources_.continuation();
  }
  // Brings displacements and forces up to date for the run itself.
  void bring_up_to_date() { sources_.bring_up_to_date(); }
  // State without an up-to-date solution: numbers, bonds and history are right, displacements and forces may be those
  // of an earlier event.
  const EvolutionState& progress() const { return state_; }
  void restore(EvolutionState state, std::optional<Continuation> continuation = std::nullopt) noexcept;
  // Brings the stages of the system's terms up to date, also after a failure or a return to another state.
  void bring_terms_up_to_date() { sources_.refresh(); }
  // Lets the run continue bit for bit like one that is restored from a copy of the present state alone.
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
  // Calls `visit` in the state in which faces are as soon as the load factor moves, if some open or close at once, and
  // returns to the present state. Returns whether it did.
  bool look_past_switch(bool upwards, const std::function<void()>& visit);
  // Number of the first contact place that growth has added (places on initial cracks come first); and whether a bond
  // and normal can make such a place.
  std::size_t first_grown_constraint() const { return body_.faces().first_grown(); }
  bool can_have(const GrownFace& face) const { return body_.faces().can_have(face); }
  double seconds_search() { return body_.seconds_search(); }

  // Carrier of the crack lines; null if cracks in lattices grow bond by bond.
  LineCarrier* lines() { return lines_ ? &*lines_ : nullptr; }

  // Range of load factors in which nothing breaks, for the present bonds and loads.
  LoadInterval admissible_load_factors() {
    look();
    return body_.admissible();
  }
  // Bond that breaks next by itself, away from tips of lines, as the load factor rises or falls; empty if there is
  // none.
  std::optional<NextBond> next_bond(bool upwards, Control control);
  double work() const;  // of loads and supports so far [J]

  // Whether products of displacements and forces exceed the range of numbers, so that energies are unknown.
  bool energies_are_lost() const;

 private:
  friend class EventLoop;
  friend class LineCarrier;

  // Lets the tip of a crack line grow by a step at the present load factor, whatever its load, as an event, if a bond
  // lies ahead of it; in a direction, or by its criterion. After a failure the caller restores an earlier state.
  void extend_line(const crack::TipId& tip, const std::optional<Point>& direction);
  void look() {
    sources_.refresh();
    sources_.show();
  }

  // Sums and sizes of lists at the start of a call, to return to.
  struct Start {
    Sums sums;
    std::size_t history_size, extensions_size;
  };

  Start start() const { return {state_, state_.history.size(), state_.extensions.size()}; }
  LineEvents& looked_at_lines() {
    look();
    return *sources_.lines();
  }
  void begin_call(const SteppingOptions& options);
  const Event* next(double target, const SteppingOptions& options);
  void move_to(double load_factor);
  void perform_and_book(const Event& event);
  bool perform_if_possible(const Event& event);
  double potential_at(double load_factor) const;
  LoadedBody::FirstEquilibrium find_equilibrium_of_pieces();
  void take_over_faces(const CrackFaces& before, const FaceState& old);
  void take_over_lattices(const BodyState& old, const std::vector<crack::TipId>& entering);
  void take_over_body(const BodyState& old, const std::vector<int>& node_before,
                      const std::vector<crack::TipId>& entering);
  void forget_lines(const Start& start) noexcept;  // of the history, and what was added to the sums
  void return_to(const Start& start) noexcept;
  // Body before an event that may be given up; empty while events come from a window, which are short.
  struct BeforeEvent {
    BodyState body;
    Start start;
  };
  std::optional<BeforeEvent> before_event();
  void give_up_event(BeforeEvent before);
  double within(double load_factor) const;
  // Least scale of the energies that within() returns: where the parts of the loads cancel, these are known only up to
  // a share of the energies of the parts.
  double least_scale_within(double load_factor) const;
  double work_that_moves(const Event& event, const Outcome& outcome);
  void book(const Event& event, const Outcome& outcome);
  void book_lines(const Outcome& outcome, double released_energy);
  void pass(const Outcome& outcome);
  void find_lost_work(double stored_energy);
  void note_separation(const Outcome& outcome);
  void end_step();
  // Updates the largest work so far, by which energy errors are measured.
  void measure_work();
  // Adds a line to the history. Throws Error (unsolvable) if its forces or energies do not balance.
  void write_line(const HistoryEntry& line, double energy_scale, const std::vector<double>& reactions_before,
                  const std::vector<double>& reactions);

  coupling::EquilibriumSystem& system_;
  EvolutionState state_;
  LoadedBody body_;
  EventSources sources_;
  std::vector<pd::CrackLength> lengths_;  // of the cracks that the host described
  std::vector<int> held_;
  std::optional<LineCarrier> lines_;
  const Event* next_ = nullptr;               // in the present run
  SteppingMode mode_ = SteppingMode::events;  // likewise
  Outcome growth_;                            // of the growth that is to be booked
  Eigen::Matrix2d work_within_ = Eigen::Matrix2d::Zero();
};

}  // namespace bempd::fracture

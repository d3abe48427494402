#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/body_growth.hpp"
#include "fracture/event_sources.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/inner_work.hpp"
#include "fracture/line_carrier.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/run_events.hpp"
#include "fracture/run_loads.hpp"
#include "fracture/run_records.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// Bond that breaks next by itself (not by the step of a crack line): the load factor of the break, and the present
// ratio of stretch to critical stretch.
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

// Quasi-static growth of cracks in a body. Between two breaks the response is linear in the load factor, so the next
// break is found in closed form; a break is a low-rank change of the system. An event is one batch of bonds that break
// at one load factor; events follow each other at that load factor until no bond exceeds its critical stretch.
//
// This class owns the state of the run, saves and restores it, and owns the parts of the run: the body, the sources of
// events, the loads, the events, the records, and the growth from another body.
class CrackEvolution {
 public:
  // The bonds `cut` are broken from the start.
  CrackEvolution(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                 std::vector<double> critical_stretch, const std::vector<int>& cut, coupling::SupportDofs supports,
                 ContactPlan contact = {});

  // Lets cracks in lattices grow as crack lines (by steps of one lattice spacing) from the given tips, by their tip
  // laws; called before the first step. `openings` finds the openings of cracks in lattices, `factors` the stress
  // intensity factors of tips by path-independent sums around them.
  void grow_lines(pd::TipLaws laws, std::vector<GrowingTip> tips, LineCarrier::Openings openings,
                  FactorsAround factors);
  // Carrier of the crack lines; null if cracks in lattices grow bond by bond.
  LineCarrier* lines() { return lines_ ? &*lines_ : nullptr; }

  // Adds the fluid that carries pressures into cracks among bonds; called before the first loads.
  void add_crack_fluid(CrackFluid fluid) { body_.loads().add_fluid(std::move(fluid)); }

  RunLoads& loads() { return loads_; }
  RunEvents& events() { return events_; }
  RunRecords& records() { return records_; }
  BodyGrowth& growth() { return growth_; }
  EventSources& sources() { return sources_; }

  // Runs to a target or goal (event_loop.hpp). `on_event` is called after every event, `on_end` at the end. If a
  // callback throws, or after any other failure, the run returns to its state before the call.
  StopReason advance(double target, Goal goal, const SteppingOptions& options,
                     const std::function<void(const EvolutionState&)>& on_event, const std::function<void()>& on_end);

  // State with its displacements and forces brought up to date. Reading it does not affect the run.
  const EvolutionState& state() {
    sources_.update_for_reader();
    return state_;
  }
  // State without an up-to-date solution: numbers, bonds and history are right, displacements and forces may be those
  // of an earlier event.
  const EvolutionState& progress() const { return state_; }
  // Data that a restored run needs beside the state to continue with the same digits.
  Continuation continuation() {
    sources_.update_for_reader();
    return sources_.resumption().present();
  }
  void restore(EvolutionState state, std::optional<Continuation> continuation = std::nullopt) noexcept;
  // Makes the run continue bit for bit like a run that is restored from a copy of the present state alone.
  void synchronize();

  // Body with its displacements and forces brought up to date. Reading it does not affect the run.
  const LoadedBody& body() {
    sources_.update_for_reader();
    return body_;
  }
  // Places where faces of cracks can close. They do not depend on displacements.
  const CrackFaces& faces() const { return std::as_const(body_).faces(); }
  double seconds_search() const { return body_.response().seconds_search(); }

  // If crack faces open or close as soon as the load factor moves upwards or downwards, calls `visit` in the contact
  // state after that switch, and returns to the present state. Returns whether `visit` was called.
  bool look_past_switch(bool upwards, const std::function<void()>& visit);
  // Bond that breaks next by itself, away from the tips of crack lines, as the load factor rises or falls; empty if
  // there is none.
  std::optional<NextBond> next_bond(bool upwards, Control control);

  // Whether products of displacements and forces exceed the range of numbers, so that energies are unknown.
  bool energies_are_lost() const;

 private:
  coupling::EquilibriumSystem& system_;
  EvolutionState state_;
  LoadedBody body_;
  EventSources sources_;
  InnerWork inner_work_;
  RunRecords records_;
  RunLoads loads_;
  RunEvents events_;
  BodyGrowth growth_;
  std::optional<LineCarrier> lines_;
};

}  // namespace bempd::fracture

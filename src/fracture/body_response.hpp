#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/event_choice.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Response of the whole body to the loads of its system: displacements as affine functions of the load factor, and
// forces, energies and stretch ratios (stretch over critical stretch of each bond) at the present load factor. The
// displacements stay the same functions of the load factor from one break to the next.
class BodyResponse {
 public:
  // `state` belongs to the caller, who saves and restores it.
  BodyResponse(coupling::EquilibriumSystem& system, std::vector<double> critical_stretch, BodyState& state)
      : system_(system), state_(state), ratios_(system.terms(), std::move(critical_stretch)) {}

  void solve();  // finds the displacements of the present system
  // Gives the damage stages of the system's terms to the stretch ratios, whose values change with the next
  // update_ratios().
  void enter_stages() { ratios_.enter(system_.stages().numbers()); }
  void update_ratios();  // computes the ratios for the present stages and displacements
  const StretchRatios& ratios() const { return ratios_; }

  // Moves the state to a load factor along the present solution. Returns the work [J] of the loads, including the work
  // of rest elongations that change with the load factor (swelling).
  double move_to(double load_factor);
  // Brings the state to the present solution at a load factor, also where only the displacements have changed; returns
  // the work as move_to() does.
  double absorb(double load_factor);
  // Sets displacements and forces of the state to those of a solution at the present load factor, whose work is already
  // recorded.
  void set_solution(coupling::Affine displacement);

  // Load path from the present load factor to a target.
  LoadWay load_path_to(double target, Control control) const {
    return {state_.load_factor, target >= state_.load_factor, control};
  }
  BondList bonds() const { return {ratios_, system_.stages().intact()}; }
  // Load factor at which the first bond becomes critical on a load path; empty if none does.
  std::optional<double> next_critical(const LoadWay& way);
  // Range of load factors in which no intact bond exceeds its critical stretch.
  LoadInterval admissible() const { return ratios_.admissible(system_.stages().intact()); }

  // Energy that rest elongations of terms (bonds and cell squares) store at zero displacements [J]; it counts as work
  // done before the run.
  double energy_at_rest() const;
  double stored_energy() const;
  double stored_energy_at(double load_factor) const;  // for the present stages of the terms
  double unit_energy() const;                         // energy of the proportional load alone, at the load factor 1
  double potential_of_loads() const;  // potential that the loads have lost: forces times displacements [J]
  double residual() const;
  // Whether the present solution is in equilibrium at the state's load factor. The forces of the state may still be
  // those of another solution.
  bool is_balanced() const;

  double& seconds_search() { return seconds_search_; }
  double seconds_search() const { return seconds_search_; }

 private:
  coupling::EquilibriumSystem& system_;
  BodyState& state_;
  StretchRatios ratios_;
  double seconds_search_ = 0;
};

}  // namespace bempd::fracture

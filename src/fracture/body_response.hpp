#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/event_choice.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Response of the whole body to the loads of its system: displacements as functions of the load factor, and forces,
// energies and stretch ratios at the present one. Between two breaks the response is linear in the load factor.
class BodyResponse {
 public:
  // `state` belongs to the caller, who saves and restores it.
  BodyResponse(coupling::EquilibriumSystem& system, std::vector<double> critical_stretch, BodyState& state)
      : system_(system), state_(state), ratios_(system.terms(), std::move(critical_stretch)) {}

  void solve();  // the displacements of the present system
  // Stretch ratios for the system's stages of terms; their values follow with the next update.
  void enter_stages() { ratios_.enter(system_.stages().numbers()); }
  void update_ratios();  // to the stages and displacements
  const StretchRatios& ratios() const { return ratios_; }

  double move_to(double load_factor);  // returns the work of the loads, and of what swells with them
  double absorb(double load_factor);   // the same, also where only the displacements have changed
  // Sets displacements and forces to those of a solution at the present load factor whose energies are already
  // recorded.
  void set_solution(coupling::Affine displacement);

  // Load path from the present load factor to a target.
  LoadWay load_path_to(double target, Control control) const {
    return {state_.load_factor, target >= state_.load_factor, control};
  }
  BondList bonds() const { return {ratios_, system_.stages().intact()}; }
  // Load factor at which the first bond becomes critical on a path; empty if none does.
  std::optional<double> next_critical(const LoadWay& way);
  LoadInterval admissible() const { return ratios_.admissible(system_.stages().intact()); }

  // Energy stored at zero displacements by rest lengths, which counts as work done before.
  double energy_at_rest() const;
  double stored_energy() const;
  double stored_energy_at(double load_factor) const;  // in the same state of the bonds
  double unit_energy() const;                         // of the proportional load alone
  double potential_of_loads() const;  // what the loads lose of it on the way to the present displacements
  double residual() const;
  bool is_balanced() const;  // the displacements, at the present load factor, which nothing else may know of yet

  double& seconds_search() { return seconds_search_; }
  double seconds_search() const { return seconds_search_; }

 private:
  coupling::EquilibriumSystem& system_;
  BodyState& state_;
  StretchRatios ratios_;
  double seconds_search_ = 0;
};

}  // namespace bempd::fracture

#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/contact/crack_faces.hpp"
#include "fracture/contact/held_parts.hpp"
#include "fracture/crack_fluid.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/event_choice.hpp"
#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/freed_parts.hpp"

namespace bempd::fracture {

// Loads as the host has given them, and whether the body is in equilibrium under them.
struct ActingLoads {
  coupling::Affine force, prescribed;
  CrackPressures pressures;
  std::vector<int> loaded_nodes;
  bool in_equilibrium = false;
  double first_unit_energy = -1;
};

// Whole body under its loads: displacements as functions of the load factor, forces and energies at the present one.
// Between two breaks the response is linear in the load factor.
class LoadedBody {
 public:
  // `reaction_dofs[s]` are the degrees of freedom of support s. The bonds `cut` are broken from the start. `state`
  // belongs to the caller, who saves and restores it.
  LoadedBody(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
             std::vector<double> critical_stretch, const std::vector<int>& cut,
             std::vector<std::vector<int>> reaction_dofs, ContactPlan contact, BodyState& state);
  LoadedBody(const LoadedBody&) = delete;
  LoadedBody& operator=(const LoadedBody&) = delete;

  coupling::EquilibriumSystem& system() { return system_; }
  const StretchRatios& ratios() const { return ratios_; }
  CrackFaces& faces() { return faces_; }
  const CrackFaces& faces() const { return faces_; }
  const FreedPartFinder& freed_parts() const { return freed_parts_; }
  const std::vector<Point>& positions() const { return positions_; }
  const std::vector<std::vector<int>>& reaction_dofs() const { return reaction_dofs_; }
  BodyState& state() { return state_; }
  double& seconds_search() { return seconds_search_; }

  // Adds the fluid in cracks; called before the first loads.
  void add_crack_fluid(CrackFluid fluid) { fluid_ = std::move(fluid); }
  bool has_fluid() const { return !fluid_.empty(); }
  // Pressure that the host has given for a crack, constant and proportional part [Pa]; 0 if none.
  Eigen::RowVector2d pressure_in(int crack) const;
  // Lets the fluid enter the terms that have broken; returns the nodal forces [N] that this adds at the present load
  // factor.
  Eigen::VectorXd let_flow();

  void set_load(const coupling::Affine& force, const coupling::Affine& prescribed, const CrackPressures& pressures);
  // Replaces the loads by others that are equal at the present load factor; the body stays in equilibrium.
  void take_over(const coupling::Affine& force, const coupling::Affine& prescribed, const CrackPressures& pressures);
  ActingLoads acting_loads() const;
  void restore_loads(ActingLoads loads) noexcept;  // restore() has to follow
  void drop_loads(const std::vector<int>& nodes);  // for good
  void keep_held_parts_dry();
  bool unload_pushed_parts();

  struct FirstEquilibrium {
    double work;
    std::int64_t fragments;  // cut off by initial cracks, or pushed by new loads
    std::vector<int> held;   // nodes of parts that could move freely
    std::int64_t switches;   // places of faces that have closed or opened
    LostBalance lost_balance;
  };
  // Finds the equilibrium under new loads at the present load factor.
  FirstEquilibrium find_equilibrium();

  void solve();          // the displacements of the present system
  void update_ratios();  // to these displacements
  // Opens and closes constraints, with a solution after each round, until all agree with their gaps at the present load
  // factor. Where a gap is zero, its sign just ahead in `direction` decides. Parts that only closed faces held are held
  // by springs when these open.
  struct Settled {
    std::int64_t switched = 0, fragments = 0;  // constraints; parts that loads push
    std::vector<int> held;                     // nodes of parts that could move freely
  };
  Settled settle_constraints(double direction);
  // Load factor up to which constraints are settled in a direction: the present one, or one a little farther if they
  // could only be settled for that.
  double settled_until(double direction) const;
  // Whether constraints open or close as soon as the load factor moves in a direction.
  bool switches_at_once(double direction) const;
  // Settles constraints for a look at what is ahead. The caller restores the state.
  void look_ahead(double direction);
  // Adds the contact places of terms that have broken since the last update, at the state's displacements.
  void update_faces() { faces_.update(state_.total_displacement, state_.faces); }
  // Adds contact places as update_faces() does, and bars those on parts that only springs hold from closing.
  void refresh_faces() {
    update_faces();
    bar_constraints_of_held_parts();
  }
  void restore();  // system and ratios to the state, which the caller has changed
  std::size_t changes_that_bar() const { return changes_that_bar_; }
  void bar_constraints(std::vector<char> barred, std::size_t changes);

  // Energy stored at zero displacements by rest lengths, which counts as work done before.
  double energy_at_rest() const;

  double move_to(double load_factor);  // returns the work of the loads, and of what swells with them
  double absorb(double load_factor);   // the same, also where only the displacements have changed
  // Sets displacements and forces to those of a solution at the present load factor whose energies are already
  // recorded.
  void show(coupling::Affine displacement);

  // Load path from the present load factor to a target.
  LoadWay way_to(double target, Control control) const {
    return {state_.load_factor, target >= state_.load_factor, control};
  }
  BondList bonds() const { return {ratios_, system_.intact()}; }
  // Load factor at which the first bond becomes critical on a path; empty if none does.
  std::optional<double> next_critical(const LoadWay& way);
  LoadInterval admissible() const { return ratios_.admissible(system_.intact()); }

  double stored_energy() const;
  double stored_energy_at(double load_factor) const;  // in the same state of the bonds
  double unit_energy() const;
  double potential_of_loads() const;  // what the loads lose of it on the way to the present displacements
  double residual() const;
  bool is_balanced() const;  // the displacements, at the present load factor, which nothing else may know of yet
  Eigen::Vector2d reaction(std::size_t support) const;
  double reaction_moment(std::size_t support, const Point& about) const;  // [N m]
  std::vector<double> reactions() const;
  // Prescribed displacement at the present load factor, x and y of each support: the mean over its nodes, NaN for a
  // component that is not prescribed.
  std::vector<double> support_displacements() const;
  Point load_on(int node, double load_factor) const;  // [N]
  // Force that the body carries at a load factor: half the sum of the magnitudes of these reactions and of the nodal
  // loads.
  double resistance(const std::vector<double>& reactions, double load_factor) const;
  double resistance(const std::vector<double>& reactions) const { return resistance(reactions, state_.load_factor); }
  // Imbalance of the loads at the present load factor, which supports have to bear: the sum of the loads, or their
  // moment over the radius of gyration of their places, over half the sum of their magnitudes. 0 if they balance.
  double unbalanced_share() const;
  double reaction_at(int dof) const;  // of one that is held [N]

 private:
  void apply_load();
  void bar_constraints_of_held_parts();
  double farther_on(double share, double direction) const;
  HeldParts held_parts() const;
  std::vector<char> nodes_of_held_parts() const;
  coupling::Affine without_lost_loads(coupling::Affine force) const;
  // Loads less those that nodes have lost, plus the forces of the fluid.
  coupling::Affine carried(coupling::Affine force, const CrackPressures& pressures) const;

  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  FreedPartFinder freed_parts_;
  StretchRatios ratios_;
  CrackFaces faces_;
  std::vector<std::vector<int>> reaction_dofs_;
  coupling::Affine force_, prescribed_;  // as the host gave them
  CrackPressures pressures_;             // likewise
  CrackFluid fluid_;
  std::vector<int> loaded_nodes_;
  BodyState& state_;
  double seconds_search_ = 0;
  double settled_at_ = 0, settled_farther_on_ = 0;  // load factors; the same where places are right at the first
  std::size_t changes_that_bar_ = 0;                // springs and broken terms when constraints were barred
};

}  // namespace bempd::fracture

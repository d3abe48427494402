#pragma once

#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/crack_fluid.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Loads as the host has given them, and whether the body is in equilibrium under them.
struct ActingLoads {
  coupling::Affine force, prescribed;
  CrackPressures pressures;
  std::vector<int> loaded_nodes;
  bool in_equilibrium = false;
  double first_unit_energy = -1;
};

// Loads of a body: nodal forces and prescribed displacements that the host gives, and the fluid in cracks. The
// equilibrium system gets all of these loads except those on parts that have come free.
class BodyLoads {
 public:
  BodyLoads(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, BodyState& state);

  // Adds the fluid in cracks; called before the first loads.
  void add_fluid(CrackFluid fluid) { fluid_ = std::move(fluid); }
  bool has_fluid() const { return !fluid_.empty(); }
  // Pressure that the host has given for a crack, constant and proportional part [Pa]; 0 if none.
  Eigen::RowVector2d pressure_in(int crack) const;
  // Lets the fluid in cracks spread to terms (bonds and cell squares) that have broken; returns the nodal forces [N] by
  // which the loads change at the present load factor.
  Eigen::VectorXd spread_fluid();

  void set(const coupling::Affine& force, const coupling::Affine& prescribed, const CrackPressures& pressures);
  ActingLoads acting() const;
  void restore(ActingLoads loads) noexcept;  // the caller calls apply() next
  void drop(const std::vector<int>& nodes);  // removes the loads of these nodes for good
  void apply();                              // gives the present loads to the system

  const coupling::Affine& prescribed() const { return prescribed_; }
  const std::vector<int>& loaded_nodes() const { return loaded_nodes_; }
  Point on(int node, double load_factor) const;  // load on a node [N]
  // Imbalance of the loads at the present load factor, which supports have to bear, as a share of the loads [-]; 0 if
  // the loads balance each other. It is the resultant force, or the resultant moment over the radius of gyration of the
  // loaded nodes if that is larger, divided by half the sum of the magnitudes of the loads.
  double unbalanced_share() const;

 private:
  coupling::Affine without_lost_loads(coupling::Affine force) const;
  // Nodal forces on the body: `force` without the loads that nodes have lost, plus the forces of the fluid.
  coupling::Affine carried(coupling::Affine force, const CrackPressures& pressures) const;

  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  BodyState& state_;
  coupling::Affine force_, prescribed_;  // loads as the host gave them
  CrackPressures pressures_;             // pressures as the host gave them
  CrackFluid fluid_;
  std::vector<int> loaded_nodes_;
};

}  // namespace bempd::fracture

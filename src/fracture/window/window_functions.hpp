#pragma once

#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Energy of the displacement u0 + f u1 at the load factor f.
struct EnergyForm {
  double constant = 0, mixed = 0, proportional = 0;
  double at(double f) const { return 0.5 * (constant + 2 * f * mixed + f * f * proportional); }
  double unit() const { return 0.5 * proportional; }  // of the proportional load alone
};

// The sums over the whole body that a window carries along, as functions of its displacements: the loads' work, the
// energy in moving supports, the reactions.
class WindowFunctions {
 public:
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  WindowFunctions(const coupling::EquilibriumSystem& system, const std::vector<std::vector<int>>& reaction_dofs)
      : system_(system), reaction_dofs_(reaction_dofs) {}

  std::vector<WindowSolver::Function> list() const;

  // The stored energy, from the values of these functions.
  static EnergyForm energy(const Values& values);
  // Work of the loads where displacements jump at a load factor.
  static double work(const Values& before, const Values& after, double load_factor);
  std::vector<double> reactions(const Values& values, double load_factor) const;  // x and y of every support

 private:
  const coupling::EquilibriumSystem& system_;
  const std::vector<std::vector<int>>& reaction_dofs_;
};

}  // namespace bempd::fracture

#pragma once

#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "coupling/support_dofs.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Energy of the displacements u0 + f u1 as a quadratic function of the load factor f: half of constant + 2 f mixed +
// f^2 proportional.
struct EnergyForm {
  double constant = 0, mixed = 0, proportional = 0;
  double at(double f) const { return 0.5 * (constant + 2 * f * mixed + f * f * proportional); }
  double unit() const { return 0.5 * proportional; }  // energy of the proportional load alone
};

// Functions over the whole body that a window (region around crack tips or bonds close to breaking that is solved
// alone) keeps up to date from its own displacements: work of the loads, energy due to moving supports, and reactions.
class WindowFunctions {
 public:
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  WindowFunctions(const coupling::EquilibriumSystem& system, const coupling::SupportDofs& supports)
      : system_(system), supports_(supports) {}

  std::vector<WindowSolver::Function> list() const;

  // Stored energy of the whole body, from the values of the functions of list().
  static EnergyForm energy(const Values& values);
  // Work of the loads when an event changes the displacements at a constant load factor, from the values of the
  // functions of list() before and after the event.
  static double work(const Values& before, const Values& after, double load_factor);
  std::vector<double> reactions(const Values& values, double load_factor) const;  // x and y of every support [N]

 private:
  const coupling::EquilibriumSystem& system_;
  const coupling::SupportDofs& supports_;
};

}  // namespace bempd::fracture

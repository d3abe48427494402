#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/linear_forms.hpp"
#include "fracture/window/outside_stiffness.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Balance of forces on the degrees of freedom of a window (region around crack tips or bonds close to breaking that is
// solved alone). It is computed from stiffnesses and elongations, because the flexibility accumulates rounding errors
// from change to change.
class WindowBalance {
 public:
  WindowBalance() = default;
  // Notes the loads in the state in which the window is opened; `rows` are the displacements of the window in that
  // state.
  WindowBalance(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                const WindowTerms& terms, const coupling::Affine& rows);

  // Notes a loss of stiffness by a contact constraint, which is no term of the system; `pull` gives its gap as a linear
  // form of the window's displacements.
  void note_loss(const LinearForms& pull, double stiffness);

  // Imbalance of forces: loads less internal forces for the displacements `rows` of the window, with the terms in their
  // present damage stages. `part` is 0 for the constant, 1 for the proportional part of the load.
  Eigen::VectorXd unbalanced(const Eigen::VectorXd& rows, int part, const OutsideStiffness& outside) const;

 private:
  const coupling::EquilibriumSystem* system_ = nullptr;
  std::vector<int> numbers_;  // numbers of the terms in the system
  LinearForms pulls_, lost_pulls_;
  std::vector<double> lost_;
  coupling::Affine load_;
};

}  // namespace bempd::fracture

#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/linear_forms.hpp"
#include "fracture/window/outside_stiffness.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// The balance of forces on the kept degrees of freedom, from stiffnesses and elongations and not from the flexibility,
// whose rounding adds up from change to change.
class WindowBalance {
 public:
  WindowBalance() = default;
  // When the window is opened.
  WindowBalance(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                const WindowTerms& terms, const coupling::Affine& rows);

  // Notes the stiffness that a place of faces loses, which has no number among the terms; a form of kept degrees of
  // freedom.
  void note_loss(const LinearForms& pull, double stiffness);

  // Loads less what resists at these displacements, kept and prescribed ones in their rows of the window, with the
  // system's terms in their stages; `part`: of the load.
  Eigen::VectorXd unbalanced(const Eigen::VectorXd& rows, int part, const OutsideStiffness& outside) const;

 private:
  const coupling::EquilibriumSystem* system_ = nullptr;
  std::vector<int> numbers_;  // of the terms in the system
  LinearForms pulls_, lost_pulls_;
  std::vector<double> lost_;
  coupling::Affine load_;
};

}  // namespace bempd::fracture

#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"

namespace bempd::fracture {

// Gaps of all constraints that have points outside a window, as linear functions of the kept displacements. Their
// weights come from half a solution (one triangular solve) for each constraint. Exact constraints are included: all of
// them are open while a window is open.
class OutsideGaps {
 public:
  OutsideGaps() = default;
  OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);

  const std::vector<std::size_t>& constraints() const { return constraints_; }  // by their numbers in the system
  // Gaps in states of the kept displacements: one row for each constraint, one column for each state. `part`: 0 for the
  // constant, 1 for the proportional part of the load.
  Eigen::MatrixXd at(std::span<const coupling::Affine> kept, int part) const;

 private:
  std::vector<std::size_t> constraints_;
  Eigen::MatrixXd weights_;    // of kept displacements, one column a constraint
  coupling::Affine constant_;  // one row a constraint
};

}  // namespace bempd::fracture

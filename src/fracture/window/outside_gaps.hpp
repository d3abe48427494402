#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"

namespace bempd::fracture {

// Gaps of all contact constraints that have points outside a window (region around crack tips or bonds close to
// breaking that is solved alone), as linear functions of the displacements kept in the window. The weights of each
// function cost one triangular solve (half a solution). Exact constraints are included, because all of them are open
// while a window is open.
class OutsideGaps {
 public:
  OutsideGaps() = default;
  OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);

  const std::vector<std::size_t>& constraints() const { return constraints_; }  // numbers in the system
  // Gaps for the displacements `kept` of some states: one row for each constraint, one column for each state. `part` is
  // 0 for the constant, 1 for the proportional part of the load.
  Eigen::MatrixXd at(std::span<const coupling::Affine> kept, int part) const;

 private:
  std::vector<std::size_t> constraints_;
  Eigen::MatrixXd weights_;    // weights of kept displacements, one column for each constraint
  coupling::Affine constant_;  // one row for each constraint
};

}  // namespace bempd::fracture

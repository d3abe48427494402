#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"

namespace bempd::fracture {

// Gaps of all constraints that have points outside of a window, as functions of the displacements kept; each takes the
// part of half a solution that its points reach. Exact ones are among them, all of which are open where windows are.
class OutsideGaps {
 public:
  OutsideGaps() = default;
  OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);

  const std::vector<std::size_t>& constraints() const { return constraints_; }  // by their numbers in the system
  // One row a constraint, one column a state; `part`: of the load.
  Eigen::MatrixXd at(std::span<const coupling::Affine> kept, int part) const;

 private:
  std::vector<std::size_t> constraints_;
  Eigen::MatrixXd weights_;    // of kept displacements, one column a constraint
  coupling::Affine constant_;  // one row a constraint
};

}  // namespace bempd::fracture

#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Stiffness of everything outside the terms of a window, on the kept degrees of freedom that it touches.
struct OutsideStiffness {
  std::vector<int> dofs;  // places among the kept ones
  Eigen::MatrixXd matrix;
};

OutsideStiffness outside_stiffness(const coupling::EquilibriumSystem& system,
                                   const coupling::Condensation& condensation, const WindowTerms& terms);

}  // namespace bempd::fracture

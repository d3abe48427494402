#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Stiffness of everything but the terms of a window (region around crack tips or bonds close to breaking that is solved
// alone), on those degrees of freedom of the window that something outside acts on.
struct OutsideStiffness {
  std::vector<int> dofs;  // places among the kept degrees of freedom
  Eigen::MatrixXd matrix;
};

OutsideStiffness outside_stiffness(const coupling::EquilibriumSystem& system,
                                   const coupling::Condensation& condensation, const WindowTerms& terms);

}  // namespace bempd::fracture

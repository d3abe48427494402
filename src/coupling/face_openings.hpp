#pragma once

#include <Eigen/Core>

namespace bempd::coupling {

// Gaps of crack faces inside a dense operator at some places; no gap may be negative. With the displacements u of its
// nodes (2 * node of its list + component, less those at rest) and contact forces q,
//   gaps = of_displacements u + of_forces q + gaps due to loads inside the body.
// A closed place has the gap zero and q >= 0, an open one has q = 0. The operator's stiffness is that of open faces.
struct FaceOpenings {
  Eigen::MatrixXd of_displacements, of_forces;
};

}  // namespace bempd::coupling

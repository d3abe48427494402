#pragma once

#include <Eigen/Core>

namespace bempd::coupling {

// How far the faces of cracks inside a dense operator are open at some places, of which none may be negative: with the
// displacements u of its nodes (2 * node of its list + component, without what they are at rest) and forces q with
// which faces press on each other there,
//   gaps = of_displacements u + of_forces q + what loads inside the body make of them.
// Where a place is closed its gap is zero and q >= 0, elsewhere q is 0. The operator's stiffness is that of open faces.
struct FaceOpenings {
  Eigen::MatrixXd of_displacements, of_forces;
};

}  // namespace bempd::coupling

#pragma once

#include "physics/bem_bodies.hpp"

// What the tests of the collocation operator share beyond the bodies: its stiffness is not symmetric.
namespace bempd::bem_test {

// |K - K^T| / |K|, Frobenius.
inline double asymmetry(const Eigen::MatrixXd& k) { return (k - k.transpose()).norm() / k.norm(); }

}  // namespace bempd::bem_test

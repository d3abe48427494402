#pragma once

#include <Eigen/Core>

namespace bempd::coupling {

// Vectors that depend on the load factor. Column 0 is the constant part; column 1 is the proportional part, which is
// multiplied by the load factor.
using Affine = Eigen::Matrix<double, Eigen::Dynamic, 2>;

inline Eigen::VectorXd evaluate(const Affine& values, double load_factor) {
  return values.col(0) + load_factor * values.col(1);
}

}  // namespace bempd::coupling

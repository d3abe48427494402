#include "linalg/least_squares.hpp"

#include <Eigen/QR>

namespace bempd::linalg {

struct LeastSquares::Decomposition {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> of;
};

LeastSquares::LeastSquares(const Eigen::MatrixXd& equations) : own_(std::make_unique<Decomposition>()) {
  own_->of.compute(equations);
}

LeastSquares::LeastSquares(const Eigen::MatrixXd& equations, double threshold)
    : own_(std::make_unique<Decomposition>()) {
  own_->of.setThreshold(threshold);
  own_->of.compute(equations);
}

LeastSquares::~LeastSquares() = default;

Eigen::MatrixXd LeastSquares::solve(const Eigen::MatrixXd& wanted) const { return own_->of.solve(wanted); }

}  // namespace bempd::linalg

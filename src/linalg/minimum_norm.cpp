#include "linalg/minimum_norm.hpp"

#include <algorithm>
#include <limits>

#include "cancellation.hpp"

namespace bempd::linalg {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// Sparse matrices are assigned rather than constructed in this file, because Eigen's constructors leak memory if a part
// of it cannot be allocated.
void SparseMinimumNorm::factorize(const Sparse& b) {
  constexpr double largest_shift = 1e-12;
  b_ = b;
  bt_ = b.transpose();
  Sparse normal;
  normal = b_ * bt_;
  const double largest = normal.rows() == 0 ? 0 : VectorXd(normal.diagonal()).maxCoeff();
  Sparse identity(normal.rows(), normal.cols());
  identity.setIdentity();
  for (;; shift_ *= 10) {
    Sparse shifted;
    shifted = normal + shift_ * (largest > 0 ? largest : 1) * identity;
    const Sparse lower = shifted.triangularView<Eigen::Lower>();
    if (order_.empty()) {
      std::vector<int> order = minimum_degree(lower);
      check_cancelled();
      factor_.analyse(upper_in_order(lower, order));
      order_.swap(order);
    }
    const bool positive = factor_.factorize(upper_in_order(lower, order_)) && (factor_.pivots().array() > 0).all();
    if (positive || shift_ >= largest_shift) return;
  }
}

SparseMinimumNorm::Step SparseMinimumNorm::solve(VectorXd r, double least_residual) const {
  Step s{VectorXd::Zero(b_.rows()), VectorXd::Zero(b_.cols())};
  VectorXd z = precondition(r), p = z;
  double rz = r.dot(z);
  // The goal for the residual of a round is rough, because the next round starts from a residual that is recomputed
  // from the values.
  const double goal = std::max(1e-5 * r.lpNorm<Eigen::Infinity>(), 0.5 * least_residual);
  for (int step = 0; step < 100 && rz > 0; ++step) {
    check_cancelled();
    const VectorXd q = bt_ * p;
    const double square = q.squaredNorm();
    if (!(square > 0) || rz / std::numeric_limits<double>::max() >= square) break;
    const double alpha = rz / square;
    s.lambda += alpha * p;
    s.change += alpha * q;
    r -= alpha * (b_ * q);
    if (r.lpNorm<Eigen::Infinity>() <= goal) break;
    z = precondition(r);
    const double next = r.dot(z);
    p = z + next / rz * p;
    rz = next;
  }
  return s;
}

VectorXd SparseMinimumNorm::precondition(const VectorXd& r) const {
  const VectorXd pulled = bt_ * apply_inverse(r);
  return apply_inverse(b_ * pulled);
}

VectorXd SparseMinimumNorm::apply_inverse(const VectorXd& r) const {
  Eigen::MatrixXd ordered = r(order_);
  factor_.solve_forward(ordered);
  ordered = factor_.pivots().cwiseInverse().asDiagonal() * ordered;
  factor_.solve_backward(ordered);
  VectorXd x(r.size());
  x(order_) = ordered.col(0);
  return x;
}

}  // namespace bempd::linalg

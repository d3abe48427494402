#include "linalg/least_change.hpp"

#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "cancellation.hpp"

namespace bempd::linalg {

namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// Residual that no further round can improve, for values and equations of order one.
constexpr double rounding = 5e-16;

// Shortest x = B^T lambda with B x = r, for a consistent right-hand side.
class MinimumNormSolver {
 public:
  struct Step {
    VectorXd lambda, change;  // change = B^T lambda
  };
  virtual ~MinimumNormSolver() = default;
  virtual Step solve(VectorXd r) const = 0;
};

// Complete orthogonal decomposition, for a few equations that may be close to dependent.
class DenseSolver final : public MinimumNormSolver {
 public:
  explicit DenseSolver(const Sparse& b) {
    rows_.setThreshold(1e-13);
    columns_.setThreshold(1e-13);
    rows_.compute(Eigen::MatrixXd(b));
    columns_.compute(Eigen::MatrixXd(b.transpose()));
  }
  Step solve(VectorXd r) const override {
    const VectorXd change = rows_.solve(r);
    return {columns_.solve(change), change};
  }

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> rows_, columns_;
};

// Conjugate gradients on N lambda = r, N = B B^T. N is singular, so the Cholesky factor F of the slightly shifted
// matrix serves as preconditioner, in the form F^-1 N F^-1: F^-1 alone would amplify the kernel's share of the rounding
// in r by the inverse of the shift and drown the rest.
class SparseSolver final : public MinimumNormSolver {
 public:
  // Assigned, here and below: Eigen's constructors keep a part of their memory where the rest is missing.
  explicit SparseSolver(const Sparse& b) {
    b_ = b;
    bt_ = b.transpose();
    Sparse normal;
    normal = b_ * bt_;
    double largest = 0;
    for (int i = 0; i < normal.rows(); ++i) largest = std::max(largest, normal.coeff(i, i));
    Sparse identity(normal.rows(), normal.cols());
    identity.setIdentity();
    normal += 1e-12 * (largest > 0 ? largest : 1) * identity;
    factor_.compute(normal);
  }

  Step solve(VectorXd r) const override {
    Step s{VectorXd::Zero(b_.rows()), VectorXd::Zero(b_.cols())};
    VectorXd z = precondition(r), p = z;
    double rz = r.dot(z);
    // One round need not be exact: the next one starts from the residual recomputed from the values. Nor can it be
    // more exact than that is.
    const double goal = std::max(1e-5 * r.lpNorm<Eigen::Infinity>(), 0.5 * rounding);
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

 private:
  VectorXd precondition(const VectorXd& r) const {
    const VectorXd pulled = bt_ * VectorXd(factor_.solve(r));
    return factor_.solve(VectorXd(b_ * pulled));
  }

  Sparse b_, bt_;
  Eigen::SimplicialLDLT<Sparse> factor_;
};

double largest(const VectorXd& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

struct Candidate {
  VectorXd values, lambda;
  double residual = 0;
};

// Least change with some of the values held at the bound.
Candidate solve_with_held(const LeastChange& problem, const std::vector<char>& held) {
  Candidate c{problem.start, VectorXd::Zero(problem.target.size()), 0};
  VectorXd free_scale = problem.scale;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) continue;
    c.values[i] = problem.lower * problem.scale[i];
    free_scale[i] = 0;
  }
  Sparse scaled;
  scaled = problem.constraints * free_scale.asDiagonal();
  std::unique_ptr<MinimumNormSolver> solver;
  if (scaled.rows() <= 80) {
    solver = std::make_unique<DenseSolver>(scaled);
  } else {
    solver = std::make_unique<SparseSolver>(scaled);
  }
  VectorXd missing = problem.target - problem.constraints * c.values;
  c.residual = largest(missing);
  for (int round = 0; round < 30 && c.residual > rounding; ++round) {
    const MinimumNormSolver::Step step = solver->solve(missing);
    const VectorXd next = c.values + free_scale.cwiseProduct(step.change);
    missing = problem.target - problem.constraints * next;
    const double residual = largest(missing), before = c.residual;
    if (!(residual < before)) break;
    c.values = next;
    c.lambda += step.lambda;
    c.residual = residual;
    if (residual > 0.5 * before) break;
  }
  return c;
}

}  // namespace

// Primal-dual active sets (Hintermueller, Ito, Kunisch 2002): a semismooth Newton method for the dual problem, in which
// x = max(lower * scale, start + scale^2 A^T lambda).
LeastChangeResult solve_least_change(const LeastChange& problem) {
  assert(problem.constraints.cols() == problem.start.size() && problem.start.size() == problem.scale.size());
  LeastChangeResult result;
  std::vector<char> held(problem.start.size(), 0);
  const bool bounded = std::isfinite(problem.lower);
  for (int round = 0; round < 30; ++round) {
    check_cancelled();
    const Candidate c = solve_with_held(problem, held);
    result.values = c.values;
    result.residual = c.residual;
    const VectorXd pull = problem.constraints.transpose() * c.lambda;
    std::vector<char> next(held.size(), 0);
    for (std::size_t i = 0; i < held.size(); ++i) {
      const double wanted = problem.start[i] + problem.scale[i] * problem.scale[i] * pull[i];
      // A margin keeps rounding from letting a value change sides for ever.
      const double margin = held[i] ? 1e-12 : -1e-12;
      next[i] = bounded && wanted < (problem.lower + margin) * problem.scale[i];
    }
    if (next == held) break;
    held = next;
  }
  return result;
}

}  // namespace bempd::linalg

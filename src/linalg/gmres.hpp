#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "cancellation.hpp"
#include "linalg/krylov.hpp"

namespace bempd::linalg {

struct GmresOptions {
  double tolerance = 1e-14;  // on |b - A x|_inf / |b|_inf
  int max_iterations = 1000;
  int restart = 50;  // steps of a cycle, each of which keeps two vectors
};

namespace detail {

// The least-squares problem min |beta e_1 - H y| of GMRES, its Hessenberg matrix brought to triangular form by one
// Givens rotation a column.
class HessenbergLeastSquares {
 public:
  HessenbergLeastSquares(double beta, int max_columns)
      : triangle_(Eigen::MatrixXd::Zero(max_columns, max_columns)), rhs_(Eigen::VectorXd::Zero(max_columns + 1)) {
    rhs_[0] = beta;
  }

  // Takes the entries h_0j ... h_(j+1)j of the next column; false (and unchanged) if it depends on those before.
  bool append(Eigen::VectorXd h) {
    const int j = columns();
    for (int i = 0; i < j; ++i) h.segment<2>(i) = rotated(h.segment<2>(i), cosine_[i], sine_[i]);
    const double length = std::hypot(h[j], h[j + 1]);
    if (!(length > 0 && std::isfinite(length))) return false;
    cosine_.push_back(h[j] / length);
    sine_.push_back(h[j + 1] / length);
    h[j] = length;
    triangle_.col(j).head(j + 1) = h.head(j + 1);
    rhs_.segment<2>(j) = rotated(rhs_.segment<2>(j), cosine_[j], sine_[j]);
    return true;
  }

  int columns() const { return static_cast<int>(cosine_.size()); }
  double residual_norm() const { return std::abs(rhs_[columns()]); }

  Eigen::VectorXd solution() const {
    const int n = columns();
    return triangle_.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(rhs_.head(n));
  }

  // beta e_1 - H y: the residual in the basis.
  Eigen::VectorXd residual() const {
    const int n = columns();
    Eigen::VectorXd out = Eigen::VectorXd::Zero(n + 1);
    out[n] = rhs_[n];
    for (int i = n - 1; i >= 0; --i) out.segment<2>(i) = rotated(out.segment<2>(i), cosine_[i], -sine_[i]);
    return out;
  }

 private:
  static Eigen::Vector2d rotated(const Eigen::Vector2d& v, double c, double s) {
    return {c * v[0] + s * v[1], c * v[1] - s * v[0]};
  }

  Eigen::MatrixXd triangle_;
  Eigen::VectorXd rhs_;
  std::vector<double> cosine_, sine_;
};

inline Eigen::VectorXd combination(const std::vector<Eigen::VectorXd>& vectors, const Eigen::VectorXd& factors) {
  Eigen::VectorXd sum = factors[0] * vectors[0];
  for (Eigen::Index k = 1; k < factors.size(); ++k) sum += factors[k] * vectors[k];
  return sum;
}

// Removes from w its parts along the basis and returns them, followed by the length of what is left. Twice is enough to
// stay orthogonal to rounding when nearly nothing is left.
inline Eigen::VectorXd orthogonalize(const std::vector<Eigen::VectorXd>& basis, Eigen::VectorXd& w) {
  const int n = static_cast<int>(basis.size());
  Eigen::VectorXd h = Eigen::VectorXd::Zero(n + 1);
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < n; ++i) {
      const double part = basis[i].dot(w);
      w -= part * basis[i];
      h[i] += part;
    }
  }
  h[n] = w.norm();
  return h;
}

// One cycle of GMRES from (x, r = b - A x): ends when the residual is known to have at most the given inf-norm, or
// after `steps`.
template <class Apply, class Precondition>
SweepEnd gmres_cycle(const Apply& apply, const Precondition& precondition, double target, int steps, Eigen::VectorXd& x,
                     const Eigen::VectorXd& r, int& iterations) {
  const double beta = r.norm(), inf_to_two = std::sqrt(static_cast<double>(r.size()));
  if (!(beta > 0 && std::isfinite(beta))) return SweepEnd::breakdown;
  HessenbergLeastSquares problem(beta, steps);
  std::vector<Eigen::VectorXd> basis{r / beta}, directions;
  SweepEnd end = SweepEnd::finished;
  Eigen::VectorXd w(r.size());
  while (problem.columns() < steps) {
    check_cancelled();
    Eigen::VectorXd z = basis.back();
    precondition(z);
    ++iterations;
    apply(z, w);
    const Eigen::VectorXd h = orthogonalize(basis, w);
    if (!problem.append(h)) {
      end = SweepEnd::breakdown;
      break;
    }
    directions.push_back(std::move(z));
    if (problem.residual_norm() == 0) break;
    basis.push_back(w / h[h.size() - 1]);
    // The norm wanted is at least the one at hand over the root of n, so mostly it need not be computed.
    if (problem.residual_norm() > inf_to_two * target) continue;
    if (combination(basis, problem.residual()).lpNorm<Eigen::Infinity>() <= target) break;
  }
  if (!directions.empty()) x += combination(directions, problem.solution());
  return end;
}

}  // namespace detail

// Restarted GMRES (Saad and Schultz 1986) for A x = b, preconditioned from the right in the flexible form (Saad 1993):
// the preconditioned vectors are kept, so that an exact factor as preconditioner is applied once only. `apply(x, y)`
// sets y = A x; `precondition(r)` overwrites r by M^-1 r. `x` brings the initial guess and takes the best solution
// found, whatever the end.
template <class Apply, class Precondition>
KrylovResult gmres(const Apply& apply, const Precondition& precondition, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                   const GmresOptions& options = {}) {
  const auto sweep = [&](double target, int max_iterations, Eigen::VectorXd& trial, Eigen::VectorXd& r,
                         int& iterations) -> detail::Sweep {
    const int steps = std::min(options.restart, max_iterations), before = iterations;
    const detail::SweepEnd end = detail::gmres_cycle(apply, precondition, target, steps, trial, r, iterations);
    const bool spent = end == detail::SweepEnd::finished && iterations - before == max_iterations;
    return {spent ? detail::SweepEnd::iteration_limit : end};
  };
  return detail::iterate_with_refinement(apply, sweep, b, x, options.tolerance, options.max_iterations);
}

}  // namespace bempd::linalg

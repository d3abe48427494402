#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

enum class KrylovEnd {
  converged,
  stagnated,  // a restart gained less than a factor of two, mostly due to rounding
  iteration_limit,
  breakdown  // matrix or preconditioner is not what the method needs, or a number is not finite
};

struct KrylovResult {
  KrylovEnd end = KrylovEnd::converged;
  int iterations = 0;            // number of applications of the preconditioner
  double relative_residual = 0;  // |b - A x|_inf / |b|_inf of the returned x, computed from x itself
};

namespace detail {

enum class SweepEnd { finished, iteration_limit, breakdown };

struct Sweep {
  SweepEnd end;
  bool residual_is_true = false;  // whether the updated residual is as good as b - A x
};

// Solves A x = b by sweeps of an iteration. sweep(target, max_iterations, x, r, iterations) iterates from x with r = b
// - A x, until the largest entry of its updated residual is at most `target`, or until it has to restart.
//
// Updated residuals drift from the true residual b - A x, so only the true residual decides about convergence. If it is
// too large, the iteration restarts from the true residual, which refines the solution, until a restart gains less than
// a factor of two.
template <class Apply, class SweepFunction>
KrylovResult iterate_with_refinement(const Apply& apply, const SweepFunction& sweep, const Eigen::VectorXd& b,
                                     Eigen::VectorXd& x, double tolerance, int max_iterations) {
  const auto norm = [](const Eigen::VectorXd& v) { return v.size() == 0 ? 0 : v.template lpNorm<Eigen::Infinity>(); };
  const double scale = norm(b);
  if (scale == 0) {
    x.setZero(b.size());
    return {};
  }
  Eigen::VectorXd work(b.size()), r = b;
  if (!x.isZero(0)) {
    apply(x, work);
    r -= work;
  }
  KrylovResult result;
  result.relative_residual = norm(r) / scale;
  Eigen::VectorXd trial = x;
  while (!(result.relative_residual <= tolerance)) {
    const Sweep done = sweep(tolerance * scale, max_iterations - result.iterations, trial, r, result.iterations);
    if (!done.residual_is_true) {
      apply(trial, work);
      r = b - work;
    }
    const double residual = norm(r) / scale;
    const bool gained = residual < 0.5 * result.relative_residual;
    if (residual < result.relative_residual) {
      result.relative_residual = residual;
      x = trial;
    }
    if (result.relative_residual <= tolerance) break;
    if (done.end == SweepEnd::breakdown) result.end = KrylovEnd::breakdown;
    if (done.end == SweepEnd::iteration_limit) result.end = KrylovEnd::iteration_limit;
    if (done.end == SweepEnd::finished && !gained) result.end = KrylovEnd::stagnated;
    if (result.end != KrylovEnd::converged) break;
  }
  return result;
}

}  // namespace detail

}  // namespace bempd::linalg

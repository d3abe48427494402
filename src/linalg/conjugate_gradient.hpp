#pragma once

#include <Eigen/Core>

namespace bempd::linalg {

struct ConjugateGradientOptions {
  double tolerance = 1e-14;  // on |b - A x|_inf / |b|_inf
  int max_iterations = 1000;
};

enum class ConjugateGradientEnd {
  converged,
  stagnated,  // rounding allows no smaller residual
  iteration_limit,
  breakdown  // matrix or preconditioner is not positive definite, or a number is not finite
};

struct ConjugateGradientResult {
  ConjugateGradientEnd end = ConjugateGradientEnd::converged;
  int iterations = 0;            // = applications of the preconditioner
  double relative_residual = 0;  // |b - A x|_inf / |b|_inf of the returned x, computed from x itself
};

namespace detail {

enum class SweepEnd { converged, iteration_limit, breakdown };

// Conjugate gradients from (x, r = b - A x) until the updated residual has at most the given inf-norm.
template <class Apply, class Precondition>
SweepEnd conjugate_gradient_sweep(const Apply& apply, const Precondition& precondition, double target,
                                  int max_iterations, Eigen::VectorXd& x, Eigen::VectorXd& r, int& iterations) {
  Eigen::VectorXd z, p, q(r.size());
  double rho_before = 0;
  for (int k = 0; k < max_iterations; ++k) {
    z = r;
    precondition(z);
    ++iterations;
    const double rho = r.dot(z);
    if (k == 0)
      p = z;
    else
      p = z + rho / rho_before * p;
    apply(p, q);
    const double curvature = p.dot(q);
    if (!(rho > 0 && curvature > 0)) return SweepEnd::breakdown;
    const double alpha = rho / curvature;
    x += alpha * p;
    r -= alpha * q;
    rho_before = rho;
    if (r.lpNorm<Eigen::Infinity>() <= target) return SweepEnd::converged;
  }
  return SweepEnd::iteration_limit;
}

}  // namespace detail

// Preconditioned conjugate gradients (Hestenes and Stiefel 1952) for A x = b, A and the preconditioner symmetric
// positive definite. `apply(x, y)` sets y = A x; `precondition(r)` overwrites r by M^-1 r. `x` brings the initial guess
// and takes the best solution found, whatever the end.
//
// The residual updated along the way drifts from the true one, so convergence is only believed of b - A x. If that is
// still too large, the iteration starts anew from it, which refines the solution, until a start gains less than a
// factor of two.
template <class Apply, class Precondition>
ConjugateGradientResult conjugate_gradient(const Apply& apply, const Precondition& precondition,
                                           const Eigen::VectorXd& b, Eigen::VectorXd& x,
                                           const ConjugateGradientOptions& options = {}) {
  using detail::SweepEnd;
  const auto norm = [](const Eigen::VectorXd& v) { return v.size() == 0 ? 0 : v.template lpNorm<Eigen::Infinity>(); };
  const double scale = norm(b);
  if (scale == 0) {
    x.setZero(b.size());
    return {};
  }
  const double target = options.tolerance * scale;
  Eigen::VectorXd work(b.size()), r = b;
  if (!x.isZero(0)) {
    apply(x, work);
    r -= work;
  }
  ConjugateGradientResult result;
  result.relative_residual = norm(r) / scale;
  Eigen::VectorXd trial = x;
  while (!(result.relative_residual <= options.tolerance)) {
    const int before = result.iterations;
    const SweepEnd end = detail::conjugate_gradient_sweep(
        apply, precondition, target, options.max_iterations - result.iterations, trial, r, result.iterations);
    // After a single step the updated residual is the true one.
    if (result.iterations - before != 1 || end != SweepEnd::converged) {
      apply(trial, work);
      r = b - work;
    }
    const double residual = norm(r) / scale;
    const bool gained = residual < 0.5 * result.relative_residual;
    if (residual < result.relative_residual) {
      result.relative_residual = residual;
      x = trial;
    }
    if (result.relative_residual <= options.tolerance) break;
    if (end == SweepEnd::breakdown) result.end = ConjugateGradientEnd::breakdown;
    if (end == SweepEnd::iteration_limit) result.end = ConjugateGradientEnd::iteration_limit;
    if (end == SweepEnd::converged && !gained) result.end = ConjugateGradientEnd::stagnated;
    if (result.end != ConjugateGradientEnd::converged) break;
  }
  return result;
}

}  // namespace bempd::linalg

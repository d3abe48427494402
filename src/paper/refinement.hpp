#pragma once

#include "cancellation.hpp"
#include "linalg/krylov.hpp"

namespace bempd::paper {

// Iterative refinement x <- x + M^-1 (b - A x) by a factor M of A. It ends when the largest residual is `tolerance`
// times the largest entry of b, or when a step gains less than a factor of two. apply(x, y) sets y = A x; solve(r)
// overwrites r by M^-1 r. `x` holds the initial guess, then the best solution found.
//
// GMRES, preconditioned by a factor that has missed changes, is not used, because it costs more than a fresh factor. On
// the published centre crack it took 6.4 s instead of 4.8 s, event by event 15 s instead of 7.6 s. Eigen's GMRES, which
// applies the factor once more per right-hand side, took 8.3 s.
template <class Apply, class Solve>
linalg::KrylovResult refine(const Apply& apply, const Solve& solve, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                            double tolerance, int max_iterations) {
  const auto sweep = [&](double, int steps_left, Eigen::VectorXd& trial, Eigen::VectorXd& r, int& iterations) {
    if (steps_left <= 0) return linalg::detail::Sweep{linalg::detail::SweepEnd::iteration_limit};
    check_cancelled();
    solve(r);
    trial += r;
    ++iterations;
    return linalg::detail::Sweep{linalg::detail::SweepEnd::finished};
  };
  return linalg::detail::iterate_with_refinement(apply, sweep, b, x, tolerance, max_iterations);
}

}  // namespace bempd::paper

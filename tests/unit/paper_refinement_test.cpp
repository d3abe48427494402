#include <gtest/gtest.h>

#include <limits>

#include "paper/refinement.hpp"
#include "paper/sparse_lu.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::paper;
using namespace bempd::test;

// Counts what a solve costs.
struct Problem {
  explicit Problem(const SparseMatrix& a) : matrix(a) {}
  template <class Solve>
  KrylovResult solve_with(const Solve& solve, const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance = 1e-14,
                          int max_iterations = 40) {
    const auto apply = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
      ++products;
      out = matrix * in;
    };
    return refine(apply, solve, b, x, tolerance, max_iterations);
  }
  KrylovResult solve(const SparseFactorization& factor, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                     double tolerance = 1e-14, int max_iterations = 40) {
    return solve_with([&](Eigen::VectorXd& r) { factor.solve_in_place(r); }, b, x, tolerance, max_iterations);
  }
  double residual(const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    return (b - matrix * x).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
  }
  SparseMatrix matrix;
  int products = 0;
};

Eigen::VectorXd zeros(Eigen::Index n) { return Eigen::VectorXd::Zero(n); }

TEST(Refinement, an_exact_factor_needs_one_solve_and_at_most_one_more) {
  const SpringLattice lattice(20, 4, 1.0);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 100));
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(problem.matrix));
  const Eigen::VectorXd b = problem.matrix * waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto loose = problem.solve(*factor, b, x, 1e-12);
  EXPECT_EQ(loose.end, KrylovEnd::converged);
  EXPECT_EQ(loose.iterations, 1);
  EXPECT_EQ(problem.products, 1);
  EXPECT_EQ(loose.relative_residual, problem.residual(b, x));
  x.setZero();
  const auto tight = problem.solve(*factor, b, x);
  EXPECT_LE(tight.iterations, 2);
  EXPECT_LE(tight.relative_residual, 1e-14);
}

TEST(Refinement, a_step_that_gains_less_than_a_factor_of_two_is_the_last) {
  const SpringLattice lattice(10, 3, 1.0);
  Problem problem(lattice.stiffness(lattice.intact()));
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(problem.matrix));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  const auto scaled = [&](double share) {
    return [&factor, share](Eigen::VectorXd& r) {
      factor->solve_in_place(r);
      r *= share;
    };
  };
  Eigen::VectorXd x = zeros(b.size());
  const auto gains = problem.solve_with(scaled(0.9), b, x, 2e-12);
  EXPECT_EQ(gains.end, KrylovEnd::converged);
  EXPECT_EQ(gains.iterations, 12);
  EXPECT_LE(problem.residual(b, x), 2e-12);
  x.setZero();
  const auto slow = problem.solve_with(scaled(0.4), b, x, 1e-12);
  EXPECT_EQ(slow.end, KrylovEnd::stagnated);
  EXPECT_EQ(slow.iterations, 1);
  EXPECT_NEAR(problem.residual(b, x), 0.6, 1e-12);
  x.setZero();
  EXPECT_EQ(problem.solve_with(scaled(3), b, x).end, KrylovEnd::stagnated);
  EXPECT_EQ(x, zeros(b.size())) << "a step that goes too far is not taken";
}

TEST(Refinement, a_factor_that_has_missed_much_does_not_get_there_in_few_steps) {
  const SpringLattice lattice(40, 4, 1e-3);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(unsymmetric_lattice(lattice, broken, 100)));
  const std::vector<int> order = shuffled(static_cast<int>(lattice.springs.size()), 11);
  for (int k = 0; k < 300; ++k) broken[order[k]] = 1;
  Problem problem(unsymmetric_lattice(lattice, broken, 100));
  const Eigen::VectorXd b = problem.matrix * waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto stale = problem.solve(*factor, b, x, 1e-12, 4);
  EXPECT_NE(stale.end, KrylovEnd::converged);
  EXPECT_LE(stale.iterations, 4);
  EXPECT_GT(stale.relative_residual, 1e-12);
  EXPECT_EQ(stale.relative_residual, x.isZero(0) ? 1.0 : problem.residual(b, x));
}

TEST(Refinement, a_good_guess_is_used_and_a_solution_costs_one_product) {
  const SpringLattice lattice(10, 3, 1.0);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 20));
  const Eigen::VectorXd exact = waves(lattice.dof_count()), b = problem.matrix * exact;
  Eigen::VectorXd x = exact;
  const auto result = problem.solve_with([](Eigen::VectorXd&) {}, b, x);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(problem.products, 1);
  EXPECT_EQ(x, exact);
}

TEST(Refinement, an_unreachable_tolerance_ends_in_stagnation_at_rounding_level) {
  const SpringLattice lattice(20, 3, 1e-8);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 40));
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(problem.matrix));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve(*factor, b, x, 1e-30);
  EXPECT_EQ(result.end, KrylovEnd::stagnated);
  EXPECT_LE(result.iterations, 10);
  EXPECT_EQ(result.relative_residual, problem.residual(b, x));
  // Rounding of the product A x alone.
  const double limit = 20 * 1e-16 * (problem.matrix.cwiseAbs() * x.cwiseAbs()).maxCoeff();
  EXPECT_LE(result.relative_residual, limit / b.lpNorm<Eigen::Infinity>());
}

TEST(Refinement, the_iteration_limit_and_numbers_that_are_not_finite_end_cleanly) {
  const SpringLattice lattice(8, 3, 1.0);
  Problem problem(lattice.stiffness(lattice.intact()));
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(problem.matrix));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  for (const int limit : {0, 1, 3}) {
    Eigen::VectorXd x = zeros(b.size());
    const auto solve = [&](Eigen::VectorXd& r) {
      factor->solve_in_place(r);
      r *= 0.9;
    };
    const auto limited = problem.solve_with(solve, b, x, 1e-12, limit);
    EXPECT_EQ(limited.end, KrylovEnd::iteration_limit);
    EXPECT_EQ(limited.iterations, limit);
    EXPECT_EQ(limited.relative_residual, x.isZero(0) ? 1.0 : problem.residual(b, x));
  }
  Eigen::VectorXd x = zeros(b.size());
  const auto spoils = [](Eigen::VectorXd& r) { r[3] = std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_NE(problem.solve_with(spoils, b, x).end, KrylovEnd::converged);
  EXPECT_EQ(x, zeros(b.size()));
}

}  // namespace

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "linalg/conjugate_gradient.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::test;

// Counts what a solve costs.
struct Problem {
  explicit Problem(const SparseMatrix& a) : matrix(a) {}
  KrylovResult solve(const SparseCholesky& factor, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                     const ConjugateGradientOptions& options = {}) {
    return conjugate_gradient(
        [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
          ++products;
          out = matrix * in;
        },
        [&](Eigen::VectorXd& r) { factor.solve_in_place(r); }, b, x, options);
  }
  double residual(const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    return (b - matrix * x).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
  }
  SparseMatrix matrix;
  int products = 0;
};

Eigen::VectorXd zeros(Eigen::Index n) { return Eigen::VectorXd::Zero(n); }

TEST(ConjugateGradient, an_exact_factor_needs_one_solve_and_at_most_one_refinement) {
  const SpringLattice lattice(20, 4, 1.0);
  Problem problem(lattice.stiffness(lattice.intact()));
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(problem.matrix)));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto loose = problem.solve(*factor, b, x, {.tolerance = 1e-12});
  EXPECT_EQ(loose.end, KrylovEnd::converged);
  EXPECT_EQ(loose.iterations, 1);
  EXPECT_EQ(problem.products, 1);
  x.setZero();
  const auto tight = problem.solve(*factor, b, x);
  EXPECT_LE(tight.iterations, 2);
  EXPECT_LE(tight.relative_residual, 1e-14);
  EXPECT_EQ(tight.relative_residual, problem.residual(b, x));
}

TEST(ConjugateGradient, a_factor_stale_by_a_thousand_broken_bonds_still_solves_to_1e12) {
  const SpringLattice lattice(40, 4, 1e-3);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(lattice.stiffness(broken))));
  const std::vector<int> order = shuffled(static_cast<int>(lattice.springs.size()), 11);
  for (int k = 0; k < 1000; ++k) broken[order[k]] = 1;
  Problem problem(lattice.stiffness(broken));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve(*factor, b, x, {.tolerance = 1e-12});
  std::cout << "iterations " << result.iterations << ", residual " << result.relative_residual << '\n';
  EXPECT_EQ(result.end, KrylovEnd::converged);
  EXPECT_LE(problem.residual(b, x), 1e-12);
  EXPECT_LE(result.iterations, 100);
}

TEST(ConjugateGradient, after_a_thousand_single_removals_the_factor_is_exact_or_a_preconditioner) {
  const SpringLattice lattice(40, 4, 1e-3);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(lattice.stiffness(broken))));
  const std::vector<int> order = shuffled(static_cast<int>(lattice.springs.size()), 12);
  bool current = true;
  for (int k = 0; k < 1000; ++k) {
    broken[order[k]] = 1;
    current = factor->update(lattice.columns({order[k]}), Change::remove) && current;
  }
  Problem problem(lattice.stiffness(broken));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve(*factor, b, x, {.tolerance = 1e-12});
  std::cout << "iterations " << result.iterations << ", residual " << result.relative_residual << '\n';
  EXPECT_EQ(result.end, KrylovEnd::converged);
  EXPECT_LE(problem.residual(b, x), 1e-12);
  if (current) {
    EXPECT_LE(result.iterations, 2);
  }
}

TEST(ConjugateGradient, a_good_guess_is_used_and_a_solution_costs_one_product) {
  const SpringLattice lattice(10, 3, 1.0);
  Problem problem(lattice.stiffness(lattice.intact()));
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(problem.matrix)));
  const Eigen::VectorXd exact = waves(lattice.dof_count()), b = problem.matrix * exact;
  Eigen::VectorXd x = exact;
  const auto result = problem.solve(*factor, b, x);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(problem.products, 1);
  EXPECT_EQ(x, exact);
}

TEST(ConjugateGradient, a_zero_right_hand_side_gives_zero_without_work) {
  const SpringLattice lattice(4, 2, 1.0);
  Problem problem(lattice.stiffness(lattice.intact()));
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(problem.matrix)));
  Eigen::VectorXd x = waves(lattice.dof_count());
  EXPECT_EQ(problem.solve(*factor, zeros(x.size()), x).end, KrylovEnd::converged);
  EXPECT_EQ(x, zeros(x.size()));
  EXPECT_EQ(problem.products, 0);
  Eigen::VectorXd nothing;
  EXPECT_EQ(problem.solve(*factor, Eigen::VectorXd(), nothing).relative_residual, 0);
}

TEST(ConjugateGradient, an_unreachable_tolerance_ends_in_stagnation_at_rounding_level) {
  const SpringLattice lattice(20, 3, 1e-8);
  Problem problem(lattice.stiffness(lattice.intact()));
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(problem.matrix)));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve(*factor, b, x, {.tolerance = 1e-30});
  EXPECT_EQ(result.end, KrylovEnd::stagnated);
  EXPECT_LE(result.iterations, 20);
  EXPECT_EQ(result.relative_residual, problem.residual(b, x));
  // Rounding of the product A x alone.
  const double limit = 20 * 1e-16 * (problem.matrix.cwiseAbs() * x.cwiseAbs()).maxCoeff();
  EXPECT_LE(result.relative_residual, limit / b.lpNorm<Eigen::Infinity>());
}

TEST(ConjugateGradient, the_iteration_limit_and_an_indefinite_matrix_end_cleanly) {
  const SpringLattice lattice(20, 3, 1e-3);
  Problem problem(lattice.stiffness(lattice.intact()));
  SparseMatrix identity(problem.matrix.rows(), problem.matrix.cols());
  identity.setIdentity();
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(identity));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto limited = problem.solve(*factor, b, x, {.tolerance = 1e-12, .max_iterations = 5});
  EXPECT_EQ(limited.end, KrylovEnd::iteration_limit);
  EXPECT_EQ(limited.iterations, 5);
  EXPECT_EQ(limited.relative_residual, x.isZero(0) ? 1.0 : problem.residual(b, x));
  Problem indefinite(-problem.matrix);
  x.setZero();
  EXPECT_EQ(indefinite.solve(*factor, b, x).end, KrylovEnd::breakdown);
  EXPECT_EQ(x, zeros(b.size()));
}

}  // namespace

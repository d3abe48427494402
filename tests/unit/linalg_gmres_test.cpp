#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "linalg/gmres.hpp"
#include "linalg/sparse_lu.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::test;

// Counts what a solve costs.
struct Problem {
  explicit Problem(const SparseMatrix& a) : matrix(a) {}
  template <class Precondition>
  KrylovResult solve_with(const Precondition& precondition, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                          const GmresOptions& options = {}) {
    return gmres(
        [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) {
          ++products;
          out = matrix * in;
        },
        precondition, b, x, options);
  }
  KrylovResult solve(const SparseFactorization& factor, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                     const GmresOptions& options = {}) {
    return solve_with([&](Eigen::VectorXd& r) { factor.solve_in_place(r); }, b, x, options);
  }
  double residual(const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    return (b - matrix * x).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
  }
  SparseMatrix matrix;
  int products = 0;
};

const auto unpreconditioned = [](Eigen::VectorXd&) {};

Eigen::VectorXd zeros(Eigen::Index n) { return Eigen::VectorXd::Zero(n); }

// x_i of row i goes to row i + 1: GMRES without preconditioner gains nothing before the last of n steps.
SparseMatrix cyclic_shift(int n) {
  SparseMatrix out(n, n);
  for (int i = 0; i < n; ++i) out.insert((i + 1) % n, i) = 1;
  return out;
}

TEST(Gmres, an_exact_factor_needs_one_solve_and_at_most_one_refinement) {
  const SpringLattice lattice(20, 4, 1.0);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 100));
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(problem.matrix));
  const Eigen::VectorXd b = problem.matrix * waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto loose = problem.solve(*factor, b, x, {.tolerance = 1e-12});
  EXPECT_EQ(loose.end, KrylovEnd::converged);
  EXPECT_EQ(loose.iterations, 1);
  EXPECT_EQ(problem.products, 2);  // one in the cycle, one for the true residual
  EXPECT_EQ(loose.relative_residual, problem.residual(b, x));
  x.setZero();
  const auto tight = problem.solve(*factor, b, x);
  EXPECT_LE(tight.iterations, 2);
  EXPECT_LE(tight.relative_residual, 1e-14);
}

TEST(Gmres, a_factor_stale_by_hundreds_of_broken_bonds_still_solves_to_1e12) {
  const SpringLattice lattice(40, 4, 1e-3);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(unsymmetric_lattice(lattice, broken, 100)));
  const std::vector<int> order = shuffled(static_cast<int>(lattice.springs.size()), 11);
  for (int k = 0; k < 300; ++k) broken[order[k]] = 1;
  Problem problem(unsymmetric_lattice(lattice, broken, 100));
  const Eigen::VectorXd b = problem.matrix * waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve(*factor, b, x, {.tolerance = 1e-12});
  std::cout << "iterations " << result.iterations << ", residual " << result.relative_residual << '\n';
  EXPECT_EQ(result.end, KrylovEnd::converged);
  EXPECT_LE(problem.residual(b, x), 1e-12);
  EXPECT_LE(result.iterations, 60);
}

TEST(Gmres, the_minimum_is_found_after_as_many_steps_as_the_theory_says) {
  // n distinct eigenvalues on a circle: nothing is gained in n - 1 steps, all in the n-th.
  Problem shift(cyclic_shift(12));
  const Eigen::VectorXd b = Eigen::VectorXd::Unit(12, 0);
  Eigen::VectorXd x = zeros(12);
  const auto result = shift.solve_with(unpreconditioned, b, x);
  EXPECT_EQ(result.end, KrylovEnd::converged);
  EXPECT_EQ(result.iterations, 12);
  EXPECT_LT((x - Eigen::VectorXd::Unit(12, 11)).lpNorm<Eigen::Infinity>(), 1e-14);
  // Three distinct eigenvalues of a matrix that can be brought to diagonal form: three steps.
  SparseMatrix diagonal(30, 30);
  for (int i = 0; i < 30; ++i) diagonal.insert(i, i) = 1 + i % 3;
  Problem few(diagonal);
  x = zeros(30);
  const auto three = few.solve_with(unpreconditioned, waves(30), x, {.tolerance = 1e-13});
  EXPECT_EQ(three.end, KrylovEnd::converged);
  EXPECT_EQ(three.iterations, 3);
}

TEST(Gmres, a_restart_goes_on_from_the_solution_it_has) {
  const SpringLattice lattice(6, 2, 1.0);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 0));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve_with(unpreconditioned, b, x, {.tolerance = 1e-10, .restart = 5});
  EXPECT_EQ(result.end, KrylovEnd::converged);
  EXPECT_GT(result.iterations, 5);
  EXPECT_LE(problem.residual(b, x), 1e-10);
}

TEST(Gmres, a_memory_too_short_for_the_matrix_ends_in_stagnation_with_the_guess_kept) {
  Problem shift(cyclic_shift(12));
  Eigen::VectorXd x = zeros(12);
  const auto result = shift.solve_with(unpreconditioned, Eigen::VectorXd::Unit(12, 0), x, {.restart = 6});
  EXPECT_EQ(result.end, KrylovEnd::stagnated);
  EXPECT_EQ(result.iterations, 6);
  EXPECT_EQ(result.relative_residual, 1);
  EXPECT_EQ(x, zeros(12));
}

TEST(Gmres, a_good_guess_is_used_and_a_solution_costs_one_product) {
  const SpringLattice lattice(10, 3, 1.0);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 20));
  const Eigen::VectorXd exact = waves(lattice.dof_count()), b = problem.matrix * exact;
  Eigen::VectorXd x = exact;
  const auto result = problem.solve_with(unpreconditioned, b, x);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(problem.products, 1);
  EXPECT_EQ(x, exact);
}

TEST(Gmres, a_zero_right_hand_side_gives_zero_without_work) {
  const SpringLattice lattice(4, 2, 1.0);
  Problem problem(lattice.stiffness(lattice.intact()));
  Eigen::VectorXd x = waves(lattice.dof_count());
  EXPECT_EQ(problem.solve_with(unpreconditioned, zeros(x.size()), x).end, KrylovEnd::converged);
  EXPECT_EQ(x, zeros(x.size()));
  EXPECT_EQ(problem.products, 0);
  Eigen::VectorXd nothing;
  EXPECT_EQ(problem.solve_with(unpreconditioned, Eigen::VectorXd(), nothing).relative_residual, 0);
}

TEST(Gmres, an_unreachable_tolerance_ends_in_stagnation_at_rounding_level) {
  const SpringLattice lattice(20, 3, 1e-8);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 40));
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(problem.matrix));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  Eigen::VectorXd x = zeros(b.size());
  const auto result = problem.solve(*factor, b, x, {.tolerance = 1e-30, .restart = 10});
  EXPECT_EQ(result.end, KrylovEnd::stagnated);
  EXPECT_LE(result.iterations, 40);
  EXPECT_EQ(result.relative_residual, problem.residual(b, x));
  // Rounding of the product A x alone.
  const double limit = 20 * 1e-16 * (problem.matrix.cwiseAbs() * x.cwiseAbs()).maxCoeff();
  EXPECT_LE(result.relative_residual, limit / b.lpNorm<Eigen::Infinity>());
}

TEST(Gmres, the_iteration_limit_ends_cleanly) {
  const SpringLattice lattice(20, 3, 1.0);
  Problem problem(unsymmetric_lattice(lattice, lattice.intact(), 0));
  const Eigen::VectorXd b = waves(lattice.dof_count());
  for (const int limit : {0, 5, 12}) {
    Eigen::VectorXd x = zeros(b.size());
    const auto limited =
        problem.solve_with(unpreconditioned, b, x, {.tolerance = 1e-12, .max_iterations = limit, .restart = 8});
    EXPECT_EQ(limited.end, KrylovEnd::iteration_limit);
    EXPECT_EQ(limited.iterations, limit);
    EXPECT_EQ(limited.relative_residual, x.isZero(0) ? 1.0 : problem.residual(b, x));
  }
}

TEST(Gmres, matrices_that_map_to_nothing_and_numbers_that_are_not_finite_break_down) {
  Problem zero(SparseMatrix(8, 8));
  Eigen::VectorXd x = zeros(8);
  EXPECT_EQ(zero.solve_with(unpreconditioned, waves(8), x).end, KrylovEnd::breakdown);
  EXPECT_EQ(x, zeros(8));
  Problem good(cyclic_shift(8));
  const auto spoils = [](Eigen::VectorXd& r) { r[3] = std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_EQ(good.solve_with(spoils, waves(8), x).end, KrylovEnd::breakdown);
  EXPECT_EQ(x, zeros(8));
}

}  // namespace

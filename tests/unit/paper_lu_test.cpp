#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <string>
#include <thread>

#include "paper/sparse_lu.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::paper;
using namespace bempd::test;

// No structure at all: a third of the diagonal is missing, so pivots must be looked for.
SparseMatrix random_matrix(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  const std::vector<int> partner = shuffled(n, seed);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    if (i % 3 != 0) entries.emplace_back(i, i, 0.1 * value(random));
    entries.emplace_back(i, partner[i], 3.0);
    for (int k = 0; k < 3; ++k) entries.emplace_back(i, static_cast<int>(random() % n), 0.5 * value(random));
  }
  SparseMatrix out(n, n);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

// Masses in a chain that drift as well as pull: unsymmetric, and singular without a support.
SparseMatrix drifting_chain(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i + 1 < n; ++i) {
    entries.emplace_back(i, i, 1.2);
    entries.emplace_back(i + 1, i + 1, 0.8);
    entries.emplace_back(i, i + 1, -1.2);
    entries.emplace_back(i + 1, i, -0.8);
  }
  SparseMatrix out(n, n);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

// Largest residual of a row relative to the terms that it is the sum of.
double backward_error(const SparseMatrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& rhs) {
  const Eigen::VectorXd terms = matrix.cwiseAbs() * x.cwiseAbs() + rhs.cwiseAbs();
  return ((rhs - matrix * x).cwiseAbs().array() / terms.array()).maxCoeff();
}

TEST(SparseLU, random_matrices_of_all_small_sizes_solve_like_a_dense_factorization) {
  for (int n = 1; n <= 60; ++n) {
    const SparseMatrix matrix = random_matrix(n, static_cast<unsigned>(n));
    const Eigen::FullPivLU<Eigen::MatrixXd> dense{Eigen::MatrixXd(matrix)};
    const auto factor = make_sparse_lu();
    ASSERT_TRUE(factor->factorize(matrix)) << n;
    const Eigen::MatrixXd rhs = Eigen::Map<const Eigen::MatrixXd>(waves(3 * n).eval().data(), n, 3);
    Eigen::MatrixXd x = rhs;
    factor->solve_in_place(x);
    EXPECT_LT(relative_difference(x, dense.solve(rhs)), 1e-13 / dense.rcond()) << n;
  }
}

TEST(SparseLU, right_hand_sides_may_be_a_block_of_a_larger_array) {
  const SparseMatrix matrix = random_matrix(20, 1);
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(matrix));
  Eigen::MatrixXd array = Eigen::MatrixXd::Constant(30, 4, 7.0);
  array.block(5, 1, 20, 2).setOnes();
  factor->solve_in_place(array.block(5, 1, 20, 2));
  EXPECT_LT((matrix * array.block(5, 1, 20, 2) - Eigen::MatrixXd::Ones(20, 2)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(array.row(4), Eigen::RowVectorXd::Constant(4, 7.0));
  EXPECT_EQ(array.col(3), Eigen::VectorXd::Constant(30, 7.0));
}

TEST(SparseLU, an_empty_matrix_has_an_empty_solution) {
  const auto factor = make_sparse_lu();
  EXPECT_TRUE(factor->factorize(SparseMatrix(0, 0)));
  Eigen::VectorXd nothing(0);
  factor->solve_in_place(nothing);
  EXPECT_TRUE(factor->update(SparseMatrix(0, 0), Change::remove));
  EXPECT_EQ(factor->smallest_pivot_ratio(), 1);
  EXPECT_EQ(factor->factor_nonzeros(), 0);
}

TEST(SparseLU, rows_of_different_units_and_a_dense_block_do_not_cost_accuracy) {
  const SpringLattice lattice(20, 4, 1e-3);
  const SparseMatrix matrix = unsymmetric_lattice(lattice, lattice.intact(), 120);
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(matrix));
  const Eigen::VectorXd exact = waves(lattice.dof_count());
  EXPECT_LT(relative_difference(solve(*factor, matrix * exact), exact), 1e-11);
}

TEST(SparseLU, a_singular_matrix_is_refused) {
  const auto factor = make_sparse_lu();
  EXPECT_FALSE(factor->factorize(drifting_chain(500)));
  EXPECT_FALSE(factor->factorize(drifting_chain(500).transpose()));
  SparseMatrix with_empty_row(3, 3), with_zero_column(2, 2);
  with_empty_row.insert(0, 0) = 1;
  with_empty_row.insert(0, 1) = 1;
  with_empty_row.insert(2, 2) = 1;
  EXPECT_FALSE(factor->factorize(with_empty_row));
  with_zero_column.insert(0, 0) = 1;
  with_zero_column.insert(1, 0) = 1;
  with_zero_column.insert(0, 1) = 0;
  EXPECT_FALSE(factor->factorize(with_zero_column));
  const SpringLattice floating(8, 3, 0.0);
  EXPECT_FALSE(factor->factorize(floating.stiffness(floating.intact())));
}

TEST(SparseLU, an_indefinite_matrix_is_as_good_as_any) {
  const SpringLattice lattice(8, 3, 1e-2);
  const auto factor = make_sparse_lu();
  const SparseMatrix matrix = -lattice.stiffness(lattice.intact());
  ASSERT_TRUE(factor->factorize(matrix));
  EXPECT_LT(relative_difference(matrix * solve(*factor, waves(lattice.dof_count())), waves(lattice.dof_count())),
            1e-12);
}

TEST(SparseLU, numbers_that_are_not_finite_are_refused) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SparseMatrix matrix = random_matrix(30, 3);
    matrix.coeffRef(7, 7) = bad;
    EXPECT_FALSE(make_sparse_lu()->factorize(matrix)) << bad;
  }
}

TEST(SparseLU, a_refused_matrix_does_not_spoil_the_next) {
  const auto factor = make_sparse_lu();
  SparseMatrix matrix = drifting_chain(40);
  EXPECT_FALSE(factor->factorize(matrix));
  matrix.coeffRef(0, 0) += 1;
  ASSERT_TRUE(factor->factorize(matrix));
  EXPECT_LT(backward_error(matrix, solve(*factor, waves(40)), waves(40)), 1e-14);
}

TEST(SparseLU, pivot_ratio_and_solution_do_not_depend_on_the_units_of_rows) {
  const int n = 50;
  const SparseMatrix matrix = random_matrix(n, 4);
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(matrix));
  const double ratio = factor->smallest_pivot_ratio();
  const Eigen::VectorXd x = solve(*factor, waves(n));
  EXPECT_GT(ratio, 1e-3);
  const Eigen::VectorXd units = Eigen::VectorXd::NullaryExpr(
      n, [](Eigen::Index i) { return std::ldexp(1.0, static_cast<int>(i % 7) * 100 - 300); });
  ASSERT_TRUE(factor->factorize(units.asDiagonal() * matrix));
  EXPECT_NEAR(factor->smallest_pivot_ratio(), ratio, 1e-10 * ratio);
  EXPECT_LT(relative_difference(solve(*factor, units.cwiseProduct(waves(n))), x), 1e-12);
}

TEST(SparseLU, pivot_ratio_goes_to_zero_with_the_support_of_a_free_body) {
  const int n = 100;
  for (const double support : {1e-4, 1e-8}) {
    SparseMatrix matrix = drifting_chain(n);
    matrix.coeffRef(0, 0) += support;
    const auto factor = make_sparse_lu();
    ASSERT_TRUE(factor->factorize(matrix));
    EXPECT_LE(factor->smallest_pivot_ratio(), 10 * support) << support;
    EXPECT_GT(factor->smallest_pivot_ratio(), singular_pivot_ratio) << support;
  }
}

TEST(SparseLU, a_new_pattern_is_analysed_again_and_an_old_one_reused) {
  const auto factor = make_sparse_lu();
  for (const int n : {30, 30, 12, 45}) {
    const SparseMatrix matrix = random_matrix(n, static_cast<unsigned>(n));
    for (const double scale : {1.0, -3.0}) {
      ASSERT_TRUE(factor->factorize(scale * matrix));
      EXPECT_LT(relative_difference(scale * (matrix * solve(*factor, waves(n))), waves(n)), 1e-12);
    }
  }
}

TEST(SparseLU, a_change_leaves_the_factor_stale_until_it_is_made_anew) {
  const SpringLattice lattice(14, 4, 1e-2);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(unsymmetric_lattice(lattice, broken, 60)));
  const Eigen::VectorXd rhs = waves(lattice.dof_count()), before = solve(*factor, rhs);
  std::vector<int> which = shuffled(static_cast<int>(lattice.springs.size()), 5);
  which.resize(40);
  for (const int s : which) broken[s] = 1;
  EXPECT_FALSE(factor->update(lattice.columns(which), Change::remove));
  EXPECT_EQ(solve(*factor, rhs), before);
  // Broken springs stay in the pattern as zeros.
  const SparseMatrix matrix = unsymmetric_lattice(lattice, broken, 60);
  ASSERT_TRUE(factor->factorize(matrix));
  EXPECT_LT(backward_error(matrix, solve(*factor, rhs), rhs), 1e-12);
}

TEST(SparseLU, factor_entries_lie_between_the_matrix_and_a_full_factor) {
  const SpringLattice lattice(30, 4, 1e-2);
  const SparseMatrix matrix = lattice.stiffness(lattice.intact());
  const auto factor = make_sparse_lu();
  ASSERT_TRUE(factor->factorize(matrix));
  const std::int64_t n = matrix.rows();
  std::cout << "entries of the factor " << factor->factor_nonzeros() << ", of the matrix " << matrix.nonZeros() << '\n';
  EXPECT_GT(factor->factor_nonzeros(), matrix.nonZeros());
  EXPECT_LT(factor->factor_nonzeros(), n * n / 4);
}

TEST(SparseLU, objects_on_different_threads_do_not_disturb_each_other) {
  const SpringLattice lattice(20, 3, 1e-2);
  const SparseMatrix matrix = unsymmetric_lattice(lattice, lattice.intact(), 80);
  const auto run = [&](Eigen::VectorXd& out) {
    const auto factor = make_sparse_lu();
    for (int round = 0; round < 3; ++round) {
      if (!factor->factorize(matrix)) return;
      out = solve(*factor, waves(lattice.dof_count()));
    }
  };
  Eigen::VectorXd expected;
  run(expected);
  ASSERT_EQ(expected.size(), lattice.dof_count());
  std::vector<Eigen::VectorXd> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&] { run(result); });
  for (auto& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

}  // namespace

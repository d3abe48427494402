#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <string>
#include <thread>

#include "linalg/sparse_cholesky.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::test;

SparseMatrix random_positive_definite(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1.0);
    for (int k = 0; k < 4; ++k) entries.emplace_back(i, static_cast<int>(random() % n), value(random));
  }
  SparseMatrix root(n, n);
  root.setFromTriplets(entries.begin(), entries.end());
  SparseMatrix identity(n, n);
  identity.setIdentity();
  return SparseMatrix(root * root.transpose()) + identity;
}

// Free chain of n masses: singular, its kernel is the constant vector.
SparseMatrix free_chain(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i + 1 < n; ++i) {
    entries.emplace_back(i, i, 1.0);
    entries.emplace_back(i + 1, i + 1, 1.0);
    entries.emplace_back(i + 1, i, -1.0);
  }
  SparseMatrix lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

TEST(SparseCholesky, random_matrices_of_all_small_sizes_solve_like_a_dense_factorization) {
  for (int n = 1; n <= 60; ++n) {
    const SparseMatrix matrix = random_positive_definite(n, static_cast<unsigned>(n));
    const auto factor = make_sparse_cholesky();
    ASSERT_TRUE(factor->factorize(lower_triangle(matrix)));
    const Eigen::MatrixXd rhs = Eigen::Map<const Eigen::MatrixXd>(waves(3 * n).eval().data(), n, 3);
    Eigen::MatrixXd x = rhs;
    factor->solve_in_place(x);
    EXPECT_LT(relative_difference(x, Eigen::MatrixXd(matrix).llt().solve(rhs)), 1e-12) << n;
  }
}

TEST(SparseCholesky, right_hand_sides_may_be_a_block_of_a_larger_array) {
  const SparseMatrix matrix = random_positive_definite(20, 1);
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(matrix)));
  Eigen::MatrixXd array = Eigen::MatrixXd::Constant(30, 4, 7.0);
  array.block(5, 1, 20, 2).setOnes();
  factor->solve_in_place(array.block(5, 1, 20, 2));
  EXPECT_LT((matrix * array.block(5, 1, 20, 2) - Eigen::MatrixXd::Ones(20, 2)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(array.row(4), Eigen::RowVectorXd::Constant(4, 7.0));
  EXPECT_EQ(array.col(3), Eigen::VectorXd::Constant(30, 7.0));
}

TEST(SparseCholesky, an_empty_matrix_has_an_empty_solution) {
  const auto factor = make_sparse_cholesky();
  EXPECT_TRUE(factor->factorize(SparseMatrix(0, 0)));
  Eigen::VectorXd nothing(0);
  factor->solve_in_place(nothing);
  EXPECT_TRUE(factor->update(SparseMatrix(0, 0), Change::remove));
  EXPECT_EQ(factor->smallest_pivot_ratio(), 1);
  EXPECT_EQ(factor->factor_nonzeros(), 0);
}

TEST(SparseCholesky, a_matrix_that_is_not_positive_definite_is_refused) {
  const auto factor = make_sparse_cholesky();
  EXPECT_FALSE(factor->factorize(free_chain(500)));
  EXPECT_FALSE(factor->factorize(-free_chain(5)));
  SparseMatrix indefinite(2, 2);
  indefinite.insert(0, 0) = 1;
  indefinite.insert(1, 0) = 2;
  indefinite.insert(1, 1) = 1;
  EXPECT_FALSE(factor->factorize(indefinite));
  SparseMatrix without_diagonal(3, 3);
  without_diagonal.insert(0, 0) = 1;
  EXPECT_FALSE(factor->factorize(without_diagonal));
  const SpringLattice floating(8, 3, 0.0);
  EXPECT_FALSE(factor->factorize(lower_triangle(floating.stiffness(floating.intact()))));
}

TEST(SparseCholesky, numbers_that_are_not_finite_are_refused) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SparseMatrix lower = lower_triangle(random_positive_definite(30, 3));
    lower.coeffRef(7, 7) = bad;
    EXPECT_FALSE(make_sparse_cholesky()->factorize(lower)) << bad;
  }
}

TEST(SparseCholesky, a_refused_matrix_does_not_spoil_the_next) {
  const auto factor = make_sparse_cholesky();
  SparseMatrix lower = free_chain(40);
  EXPECT_FALSE(factor->factorize(lower));
  lower.coeffRef(0, 0) += 1;
  ASSERT_TRUE(factor->factorize(lower));
  const Eigen::VectorXd x = solve(*factor, Eigen::VectorXd::Unit(40, 39));
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(x[i], i + 1, 1e-11);
}

TEST(SparseCholesky, pivot_ratio_measures_the_weakest_support) {
  const int n = 100;
  for (const double support : {1.0, 1e-4, 1e-8}) {
    SparseMatrix lower = free_chain(n);
    lower.coeffRef(0, 0) += support;
    const auto factor = make_sparse_cholesky();
    ASSERT_TRUE(factor->factorize(lower));
    // Whatever the elimination order, pivots are at least 1 / (A^-1)_ii = 1 / (1 / support + i), the last one equal to
    // it; diagonal entries lie between 1 and 2.
    const double rounding = 1e-14 / support;
    EXPECT_GE(factor->smallest_pivot_ratio(), support / (1 + n * support) / 2 * (1 - rounding)) << support;
    EXPECT_LE(factor->smallest_pivot_ratio(), support * (1 + rounding)) << support;
  }
}

TEST(SparseCholesky, a_new_pattern_is_analysed_again_and_an_old_one_reused) {
  const auto factor = make_sparse_cholesky();
  for (const int n : {30, 30, 12, 45}) {
    const SparseMatrix matrix = random_positive_definite(n, static_cast<unsigned>(n));
    for (const double scale : {1.0, 3.0}) {
      ASSERT_TRUE(factor->factorize(lower_triangle(scale * matrix)));
      const Eigen::VectorXd x = solve(*factor, waves(n));
      EXPECT_LT(relative_difference(scale * (matrix * x), waves(n)), 1e-12);
    }
  }
}

TEST(SparseCholesky, changes_agree_with_a_fresh_factorization_or_are_reported_stale) {
  const SpringLattice lattice(14, 4, 1e-3);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(lattice.stiffness(broken))));
  const std::vector<int> order = shuffled(static_cast<int>(lattice.springs.size()), 5);
  double worst = 0;
  for (int batch = 0; batch < 12; ++batch) {
    const bool add = batch % 3 == 2;  // every third batch mends what the one before broke
    const int first = 20 * (add ? batch - 1 : batch);
    std::vector<int> which(order.begin() + first, order.begin() + first + 20);
    for (const int s : which) broken[s] = !add;
    const bool current = factor->update(lattice.columns(which), add ? Change::add : Change::remove);
    EXPECT_EQ(current, std::string(backend_name()) == "suitesparse");
    if (!current) continue;
    const auto fresh = make_sparse_cholesky();
    ASSERT_TRUE(fresh->factorize(lower_triangle(lattice.stiffness(broken))));
    const Eigen::VectorXd rhs = waves(lattice.dof_count());
    worst = std::max(worst, relative_difference(solve(*factor, rhs), solve(*fresh, rhs)));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-10);
}

TEST(SparseCholesky, a_factor_can_be_made_anew_after_changes) {
  const SpringLattice lattice(10, 3, 1e-2);
  std::vector<char> broken = lattice.intact();
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower_triangle(lattice.stiffness(broken))));
  const std::int64_t entries = factor->factor_nonzeros();
  for (int round = 0; round < 3; ++round) {
    const std::vector<int> which = {round, 50 + round};
    for (const int s : which) broken[s] = 1;
    factor->update(lattice.columns(which), Change::remove);
    const SparseMatrix matrix = lattice.stiffness(broken);
    ASSERT_TRUE(factor->factorize(lower_triangle(matrix)));
    EXPECT_EQ(factor->factor_nonzeros(), entries);
    const Eigen::VectorXd rhs = waves(lattice.dof_count());
    EXPECT_LT(relative_difference(matrix * solve(*factor, rhs), rhs), 1e-11);
  }
}

TEST(SparseCholesky, a_change_between_uncoupled_rows_grows_the_factor) {
  SparseMatrix matrix(50, 50);
  matrix.setIdentity();
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(matrix));
  SparseMatrix column(50, 1);
  column.insert(3, 0) = 2;
  column.insert(41, 0) = -1;
  if (!factor->update(column, Change::add)) GTEST_SKIP() << "this backend leaves the factor stale";
  matrix += column * SparseMatrix(column.transpose());
  EXPECT_LT(relative_difference(matrix * solve(*factor, waves(50)), waves(50)), 1e-13);
}

TEST(SparseCholesky, removing_the_last_support_shows_in_the_pivots_and_stays_finite) {
  SparseMatrix lower = free_chain(60);
  SparseMatrix support(60, 1);
  support.insert(0, 0) = 1;
  lower.coeffRef(0, 0) += 1;
  const auto factor = make_sparse_cholesky();
  ASSERT_TRUE(factor->factorize(lower));
  EXPECT_GT(factor->smallest_pivot_ratio(), 1e-3);
  if (!factor->update(support, Change::remove)) GTEST_SKIP() << "this backend leaves the factor stale";
  EXPECT_LT(std::abs(factor->smallest_pivot_ratio()), 1e-11);
  EXPECT_TRUE(solve(*factor, waves(60)).allFinite());
  ASSERT_TRUE(factor->update(support, Change::add));
  EXPECT_GT(factor->smallest_pivot_ratio(), 1e-3);
}

TEST(SparseCholesky, wide_indices_give_the_same_digits) {
  const SpringLattice lattice(12, 3, 0.1);
  const SparseMatrix lower = lower_triangle(lattice.stiffness(lattice.intact()));
  const auto n = static_cast<int>(lower.rows());
  const std::unique_ptr<SparseCholesky> narrow = own_cholesky(false), wide = own_cholesky(true);
  const Eigen::MatrixXd sides = Eigen::Map<const Eigen::MatrixXd>(waves(3 * n).eval().data(), n, 3);
  for (const int kept : {0, 7}) {
    std::vector<Eigen::MatrixXd> found[2];
    for (int k = 0; k < 2; ++k) {
      SparseCholesky& factor = k == 0 ? *narrow : *wide;
      factor.set_elimination_order(shuffled(n, 5), kept);
      ASSERT_TRUE(factor.factorize(lower));
      Eigen::MatrixXd whole = sides, halves = sides;
      factor.solve_in_place(whole);
      factor.solve_forward(halves);
      Eigen::MatrixXd backward = halves.transpose();
      factor.solve_backward(backward, kept);
      found[k] = {whole, halves, backward, factor.trailing_factor(kept), factor.inverse_block({3, 80, n - 1})};
      if (factor.update(lattice.columns({17, 60}), Change::remove)) {
        Eigen::MatrixXd changed = sides;
        factor.solve_in_place(changed);
        found[k].insert(found[k].end(), {changed, factor.inverse_block({3, 80, n - 1})});
      }
      found[k].push_back(Eigen::Vector2d(factor.smallest_pivot_ratio(), double(factor.factor_nonzeros())));
    }
    EXPECT_EQ(found[0], found[1]);
    EXPECT_EQ(narrow->elimination_order(), wide->elimination_order());
  }
}

TEST(SparseCholesky, objects_on_different_threads_do_not_disturb_each_other) {
  const SpringLattice lattice(20, 3, 1e-2);
  const SparseMatrix lower = lower_triangle(lattice.stiffness(lattice.intact()));
  const auto run = [&](Eigen::VectorXd& out) {
    const auto factor = make_sparse_cholesky();
    if (!factor->factorize(lower)) return;
    for (int s = 0; s < 40; ++s) factor->update(lattice.columns({s}), Change::remove);
    out = solve(*factor, waves(lattice.dof_count()));
  };
  Eigen::VectorXd expected;
  run(expected);
  std::vector<Eigen::VectorXd> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&] { run(result); });
  for (auto& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

}  // namespace

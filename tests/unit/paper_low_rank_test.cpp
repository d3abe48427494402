#include <gtest/gtest.h>

#include "paper/low_rank_update.hpp"
#include "paper/sparse_lu.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::paper;
using namespace bempd::test;

double error_against_fresh(const SpringLattice& lattice, const std::vector<char>& broken,
                           const SparseFactorization& updated) {
  const auto fresh = make_sparse_lu();
  EXPECT_TRUE(fresh->factorize(lattice.stiffness(broken)));
  Eigen::MatrixXd expected(lattice.dof_count(), 2);
  expected << waves(lattice.dof_count()), waves(lattice.dof_count()).reverse();
  Eigen::MatrixXd found = expected;
  fresh->solve_in_place(expected);
  updated.solve_in_place(found);
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

TEST(LowRankUpdates, equal_a_fresh_factor_after_removals_and_additions) {
  const SpringLattice lattice(9, 3, 0.01);
  std::vector<char> broken = lattice.intact();
  const auto factor = with_low_rank_updates(make_sparse_lu(), 40);
  ASSERT_TRUE(factor->factorize(lattice.stiffness(broken)));
  const std::vector<int> order = shuffled(static_cast<int>(lattice.springs.size()), 3);
  for (int batch = 0; batch < 8; ++batch) {
    const std::vector<int> which(order.begin() + 3 * batch, order.begin() + 3 * batch + 3);
    ASSERT_TRUE(factor->update(lattice.columns(which), Change::remove));
    for (int s : which) broken[s] = 1;
    EXPECT_LE(error_against_fresh(lattice, broken, *factor), 1e-12) << "batch " << batch;
  }
  const std::vector<int> back(order.begin(), order.begin() + 5);
  ASSERT_TRUE(factor->update(lattice.columns(back), Change::add));
  for (int s : back) broken[s] = 0;
  EXPECT_LE(error_against_fresh(lattice, broken, *factor), 1e-12);
  EXPECT_GT(factor->smallest_pivot_ratio(), 1e-6);
}

TEST(LowRankUpdates, leave_the_factor_stale_beyond_their_limit_until_it_is_made_anew) {
  const SpringLattice lattice(6, 2, 0.01);
  const auto factor = with_low_rank_updates(make_sparse_lu(), 4);
  ASSERT_TRUE(factor->factorize(lattice.stiffness(lattice.intact())));
  EXPECT_TRUE(factor->update(lattice.columns({0, 7, 20}), Change::remove));
  std::vector<char> broken = lattice.intact();
  for (int s : {0, 7, 20}) broken[s] = 1;
  EXPECT_FALSE(factor->update(lattice.columns({3, 9}), Change::remove));
  EXPECT_FALSE(factor->update(lattice.columns({11}), Change::remove)) << "it would fit, but one change is missing";
  EXPECT_LE(error_against_fresh(lattice, broken, *factor), 1e-12) << "the factor is that of the last change it took";
  for (int s : {3, 9, 11}) broken[s] = 1;
  ASSERT_TRUE(factor->factorize(lattice.stiffness(broken)));
  EXPECT_TRUE(factor->update(lattice.columns({15}), Change::remove));
  broken[15] = 1;
  EXPECT_LE(error_against_fresh(lattice, broken, *factor), 1e-12);
}

// A chain of four masses between two walls.
TEST(LowRankUpdates, pivots_show_a_removal_that_leaves_a_mechanism) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < 4; ++i) entries.emplace_back(i, i, 2.0);
  for (int i = 0; i + 1 < 4; ++i) entries.emplace_back(i, i + 1, -1.0), entries.emplace_back(i + 1, i, -1.0);
  SparseMatrix chain(4, 4);
  chain.setFromTriplets(entries.begin(), entries.end());
  const auto factor = with_low_rank_updates(make_sparse_lu(), 10);
  ASSERT_TRUE(factor->factorize(chain));
  const auto ground = [](int node) {
    SparseMatrix column(4, 1);
    column.insert(node, 0) = 1;
    return column;
  };
  ASSERT_TRUE(factor->update(ground(0), Change::remove));
  EXPECT_GT(factor->smallest_pivot_ratio(), 1e-3) << "the other end still holds";
  ASSERT_TRUE(factor->update(ground(3), Change::remove));
  EXPECT_LT(factor->smallest_pivot_ratio(), 1e-12);
}

}  // namespace

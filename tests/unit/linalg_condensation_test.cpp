#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "linalg/dense_inverse.hpp"
#include "linalg/nested_dissection.hpp"
#include "linalg/sparse_cholesky.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::test;

// Springs to the four neighbours on a lattice, and a weak one to the ground.
SparseMatrix lattice(int side) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int i = side * y + x;
      entries.emplace_back(i, i, 4.01);
      if (x + 1 < side) entries.emplace_back(i + 1, i, -1.0);
      if (y + 1 < side) entries.emplace_back(i + side, i, -1.0);
    }
  }
  SparseMatrix lower(side * side, side * side);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

NodeGraph lattice_graph(int side, double spacing = 1) {
  std::vector<Eigen::Vector2d> positions;
  std::vector<int> first, second;
  for (int i = 0; i < side * side; ++i) {
    positions.emplace_back(spacing * (i % side), spacing * (i / side));
    if (i % side + 1 < side) first.push_back(i), second.push_back(i + 1);
    if (i / side + 1 < side) first.push_back(i), second.push_back(i + side);
  }
  return {positions, first, second, {}};
}

TEST(DenseInverse, is_the_inverse_from_the_cholesky_factor_at_all_sizes_of_blocks) {
  for (const int n : {1, 2, 47, 48, 49, 97, 200}) {
    const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(
        n, n, [](Eigen::Index i, Eigen::Index j) { return std::sin(1.0 + static_cast<double>(3 * i + 7 * j * j)); });
    const Eigen::MatrixXd matrix = root * root.transpose() + n * Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd inverse = matrix.llt().matrixL();
    invert_from_cholesky(inverse);
    const Eigen::MatrixXd whole = inverse.selfadjointView<Eigen::Lower>();
    EXPECT_LT((whole * matrix - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-12) << n;
  }
}

TEST(NestedDissection, orders_every_member_once_and_no_other) {
  const int side = 17;
  std::vector<char> member(side * side, 1);
  for (int i = 0; i < side; ++i) member[18 * i % (side * side)] = 0;
  std::vector<int> order = nested_dissection(lattice_graph(side), member);
  std::sort(order.begin(), order.end());
  std::vector<int> expected;
  for (int i = 0; i < side * side; ++i) {
    if (member[i]) expected.push_back(i);
  }
  EXPECT_EQ(order, expected);
}

TEST(NestedDissection, fills_less_than_the_natural_order) {
  const int side = 120;
  const SparseMatrix matrix = lattice(side);
  const auto fill = [&](std::vector<int> order) {
    const auto factor = make_sparse_cholesky();
    factor->set_elimination_order(std::move(order), 0);
    EXPECT_TRUE(factor->factorize(matrix));
    return factor->factor_nonzeros();
  };
  std::vector<int> natural(side * side);
  std::iota(natural.begin(), natural.end(), 0);
  EXPECT_LT(2 * fill(nested_dissection(lattice_graph(side), std::vector<char>(side * side, 1))), fill(natural));
}

TEST(NestedDissection, is_the_same_in_every_unit_of_length) {
  const int side = 40;
  const std::vector<char> all(side * side, 1);
  const std::vector<int> expected = nested_dissection(lattice_graph(side), all);
  for (const double spacing : {1e-300, 1e-20, 1e-11, 1e-9, 1e-3, 1e3, 1e11, 1e300}) {
    EXPECT_EQ(nested_dissection(lattice_graph(side, spacing), all), expected) << spacing;
  }
}

TEST(NestedDissection, keeps_places_on_one_spot_and_groups_that_couple_all) {
  NodeGraph graph(std::vector<Eigen::Vector2d>(100, Eigen::Vector2d::Zero()), {0}, {1}, {});
  EXPECT_EQ(nested_dissection(graph, std::vector<char>(100, 1)).size(), 100u);
  NodeGraph clique = lattice_graph(12);
  clique.groups.emplace_back(144);
  std::iota(clique.groups[0].begin(), clique.groups[0].end(), 0);
  EXPECT_EQ(nested_dissection(clique, std::vector<char>(144, 1)).size(), 144u);
}

class KeptLast : public testing::Test {
 protected:
  KeptLast() {
    std::vector<int> order;
    for (int i = 0; i < n; ++i) {
      if (std::find(kept.begin(), kept.end(), i) == kept.end()) order.push_back(i);
    }
    order.insert(order.end(), kept.begin(), kept.end());
    factor->set_elimination_order(order, static_cast<int>(kept.size()));
    const bool done = factor->factorize(lower);
    EXPECT_TRUE(done);
  }
  static constexpr int side = 9, n = side * side;
  const SparseMatrix lower = lattice(side);
  const Eigen::MatrixXd matrix = Eigen::MatrixXd(SparseMatrix(lower.selfadjointView<Eigen::Lower>()));
  const std::vector<int> kept{40, 3, 41, 77, 12};
  const std::unique_ptr<SparseCholesky> factor = make_sparse_cholesky();
};

TEST_F(KeptLast, unknowns_come_last_and_leave_the_factor_of_their_schur_complement) {
  const std::vector<int>& order = factor->elimination_order();
  const std::vector<int> last(order.end() - static_cast<std::ptrdiff_t>(kept.size()), order.end());
  EXPECT_TRUE(std::is_permutation(last.begin(), last.end(), kept.begin(), kept.end()));
  const Eigen::MatrixXd inverse = matrix.inverse();
  const Eigen::MatrixXd schur = Eigen::MatrixXd(inverse(last, last)).inverse();
  const Eigen::MatrixXd trailing = factor->trailing_factor(static_cast<int>(kept.size()));
  EXPECT_LT(relative_difference(trailing * trailing.transpose(), schur), 1e-13);
}

TEST_F(KeptLast, both_halves_of_a_solution_make_the_whole) {
  const Eigen::MatrixXd rhs = Eigen::Map<const Eigen::MatrixXd>(waves(2 * n).eval().data(), n, 2);
  Eigen::MatrixXd whole = rhs, halves = rhs;
  factor->solve_in_place(whole);
  factor->solve_forward(halves);
  const Eigen::VectorXd eliminated = halves.col(0);
  EXPECT_NEAR(eliminated.squaredNorm(), rhs.col(0).dot(whole.col(0)), 1e-12 * eliminated.squaredNorm());
  const std::vector<int>& order = factor->elimination_order();
  const Eigen::MatrixXd expected = whole.transpose()(Eigen::all, order);
  for (const int known : {0, 5, 7, n}) {
    Eigen::MatrixXd unknowns = halves.transpose();
    unknowns.rightCols(known) = expected.rightCols(known);
    factor->solve_backward(unknowns, known);
    EXPECT_LT(relative_difference(unknowns, expected), 1e-13) << known;
  }
}

TEST_F(KeptLast, a_part_of_a_solution_is_that_of_the_whole) {
  const Eigen::MatrixXd halves = Eigen::Map<const Eigen::MatrixXd>(waves(n).eval().data(), 1, n);
  const int known = static_cast<int>(kept.size());
  Eigen::MatrixXd whole = halves;
  factor->solve_backward(whole, known);
  for (const std::vector<int>& places : {std::vector<int>{0}, std::vector<int>{7, 30, 52}, std::vector<int>{n - 1}}) {
    Eigen::MatrixXd part = halves;
    factor->solve_backward_at(places, part, known);
    for (const int place : places) EXPECT_EQ(part(0, place), whole(0, place)) << place;
    EXPECT_EQ(part.rightCols(known), halves.rightCols(known));
  }
}

}  // namespace

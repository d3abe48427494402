// Cholesky factors in panels of rows, and the order that keeps them short.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdlib>
#include <random>

#include "linalg/profile_cholesky.hpp"

namespace {

using bempd::linalg::close_order;
using bempd::linalg::ProfileCholesky;

constexpr int group = ProfileCholesky::group;

// Groups that are coupled to up to some before them, fewer here and there.
std::vector<int> some_profile(int count) {
  std::vector<int> first;
  first.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) first.push_back(std::max(0, i - 9 - (i % 5) * (i % 3)));
  return first;
}

// Entries of any size below the diagonal, and `diagonal` on it.
Eigen::MatrixXd fill(const std::vector<int>& first, double diagonal, ProfileCholesky& profile) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> entry(-1, 1);
  const auto count = static_cast<Eigen::Index>(first.size());
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(group * count, group * count);
  for (int i = 0; i < count; ++i) {
    for (int j = first[i]; j <= i; ++j) {
      Eigen::Matrix4d block = Eigen::Matrix4d::NullaryExpr([&] { return entry(random); });
      if (i == j) block = (0.5 * (block + block.transpose()) + diagonal * Eigen::Matrix4d::Identity()).eval();
      profile.at(i, j) += block;
      whole.block<group, group>(group * i, group * j) = block;
      whole.block<group, group>(group * j, group * i) = block.transpose();
    }
  }
  return whole;
}

TEST(ProfileCholesky, solves_what_it_has_factorized) {
  for (const int count : {1, 5, 6, 7, 40, 97}) {
    const std::vector<int> first = some_profile(count);
    ProfileCholesky profile(first);
    for (const double shift : {0.0, 2.5}) {
      profile.clear();
      Eigen::MatrixXd whole = fill(first, 90, profile);
      EXPECT_EQ(profile.largest_diagonal(), whole.diagonal().maxCoeff());
      whole.diagonal().array() += shift;
      ASSERT_TRUE(profile.factorize(shift));
      const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(group * count, -1, 2);
      Eigen::VectorXd solved = whole * exact;
      profile.solve_in_place(solved);
      EXPECT_LT((solved - exact).lpNorm<Eigen::Infinity>(), 1e-13);
    }
  }
}

TEST(ProfileCholesky, refuses_what_is_not_positive_definite) {
  const std::vector<int> first = some_profile(30);
  ProfileCholesky profile(first);
  fill(first, 0.1, profile);
  EXPECT_FALSE(profile.factorize(0));
}

// Nodes of two rings, each coupled to the two before and behind it, numbered at random.
TEST(CloseOrder, brings_coupled_nodes_together) {
  constexpr int ring = 50, reach = 2;
  std::vector<int> number(2 * ring);
  for (int i = 0; i < 2 * ring; ++i) number[i] = i;
  std::shuffle(number.begin(), number.end(), std::mt19937(1));
  std::vector<std::vector<int>> partners(2 * ring);
  for (int i = 0; i < 2 * ring; ++i)
    for (const int step : {-reach, -1, 1, reach})
      partners[number[i]].push_back(number[i / ring * ring + (i % ring + step + ring) % ring]);
  std::vector<int> start{0}, neighbours;
  for (const std::vector<int>& own : partners) {
    neighbours.insert(neighbours.end(), own.begin(), own.end());
    start.push_back(static_cast<int>(neighbours.size()));
  }
  const std::vector<int> order = close_order(start, neighbours);
  std::vector<int> place(order.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  ASSERT_EQ(order.size(), number.size());
  EXPECT_EQ(std::count(place.begin(), place.end(), -1), 0);
  for (int i = 0; i < 2 * ring; ++i)
    for (const int other : partners[i]) EXPECT_LE(std::abs(place[i] - place[other]), 3 * reach);
}

}  // namespace

// Least changes of values that meet linear equations, while floating-point traps are on.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "floating_point_traps.hpp"
#include "linalg/least_change.hpp"

namespace {

using namespace bempd;
using namespace bempd::linalg;

// The sum of each pair of neighbours among count + 1 values is given.
LeastChange sums_of_neighbours(int count, double sum, double lower) {
  LeastChange problem;
  problem.lower = lower;
  problem.start = Eigen::VectorXd::Ones(count + 1);
  problem.scale = Eigen::VectorXd::Ones(count + 1);
  problem.target = Eigen::VectorXd::Constant(count, sum);
  problem.constraints.resize(count, count + 1);
  for (int k = 0; k < count; ++k) problem.constraints.insert(k, k) = problem.constraints.insert(k, k + 1) = 1;
  return problem;
}

// Few equations are solved by another method than many.
class LeastChanges : public ::testing::TestWithParam<int> {
 protected:
  const test::FloatingPointTraps traps;
};
INSTANTIATE_TEST_SUITE_P(, LeastChanges, ::testing::Values(3, 200));

TEST_P(LeastChanges, without_a_bound_some_values_may_stay) {
  LeastChange problem = sums_of_neighbours(GetParam(), 3, -std::numeric_limits<double>::infinity());
  problem.scale[0] = 0;
  const LeastChangeResult result = solve_least_change(problem);
  EXPECT_EQ(result.values[0], 1);
  EXPECT_NEAR(result.values[1], 2, 1e-14);
  EXPECT_NEAR(result.values[2], 1, 1e-14);
  EXPECT_LE(result.residual, 1e-14);
}

TEST_P(LeastChanges, equations_that_nothing_can_meet_leave_their_residual) {
  LeastChange problem = sums_of_neighbours(GetParam(), 3, 0.1);
  problem.scale.setZero();
  const LeastChangeResult result = solve_least_change(problem);
  EXPECT_EQ(result.values, problem.start);
  EXPECT_EQ(result.residual, 1);
}

// Second differences around a ring of the sums of three values at each node: long waves resist next to nothing.
TEST(LongLeastChange, is_the_least_change) {
  const int count = 400;
  LeastChange problem;
  problem.lower = 0.7;
  problem.start = problem.scale = Eigen::VectorXd::Ones(3 * count);
  problem.constraints.resize(count, 3 * count);
  Eigen::VectorXd wanted = problem.start;
  for (int k = 0; k < count; ++k) {
    for (int copy = 0; copy < 3; ++copy) {
      for (const auto& [step, weight] : {std::pair{0, -2.0}, {1, 1.0}, {count - 1, 1.0}})
        problem.constraints.insert((k + step) % count, 3 * k + copy) = (1 + copy) * weight;
    }
    wanted[3 * k] += std::sin(2 * std::numbers::pi * k / count) + 0.5 * std::cos(k * k);
  }
  problem.target = problem.constraints * wanted;
  const LeastChangeResult slow = solve_least_change(problem), fast = solve_long_least_change(problem);
  EXPECT_LE(slow.residual, 1e-14);
  EXPECT_LE(fast.residual, 1e-14);
  EXPECT_GE(fast.values.minCoeff(), 0.7 - 1e-12);
  EXPECT_LE((fast.values - slow.values).lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_GT((fast.values.array() < 0.7 + 1e-12).count(), 0);
  EXPECT_LT((fast.values.array() < 0.7 + 1e-12).count(), count);
}

}  // namespace

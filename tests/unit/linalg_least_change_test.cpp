// Least changes of values that meet linear equations, while floating-point traps are on.

#include <gtest/gtest.h>

#include <limits>

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

}  // namespace

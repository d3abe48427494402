// Least changes of values that meet linear equations, while floating-point traps are on.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <thread>
#include <utility>

#include "cancellation.hpp"
#include "floating_point_traps.hpp"
#include "linalg/least_change.hpp"
#include "linalg/minimum_norm.hpp"

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

// Differences between neighbours of a cube of nodes, whose normal equations fill up: seconds of one factorization.
TEST(SparseMinimumNorms, hear_a_request_to_stop_in_the_midst) {
  constexpr int side = 30, nodes = side * side * side;
  std::vector<Eigen::Triplet<double>> entries;
  int columns = 0;
  for (int node = 0; node < nodes; ++node) {
    entries.emplace_back(node, columns++, 1);
    for (const auto& [step, place] :
         {std::pair{1, node % side}, {side, node / side % side}, {side * side, node / side / side}}) {
      if (place + 1 == side) continue;
      entries.emplace_back(node, columns, 1);
      entries.emplace_back(node + step, columns++, -1);
    }
  }
  Eigen::SparseMatrix<double> differences(nodes, columns);
  differences.setFromTriplets(entries.begin(), entries.end());
  std::atomic<bool> request{false};
  const CancellationScope scope(&request);
  const auto processor_time = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  std::atomic<double> asked{0};
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    asked = processor_time();
    request = true;
  });
  SparseMinimumNorm solver(1e-12);
  EXPECT_THROW(solver.factorize(differences), Error);
  const double delay = processor_time() - asked;
  other.join();
  std::printf("heard after %.4f s of processor time\n", delay);
  EXPECT_LT(delay, 0.2);
}

}  // namespace

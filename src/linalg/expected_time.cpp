#include "linalg/expected_time.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <vector>

#include "phase.hpp"

namespace bempd::linalg {

namespace {

// Number of operations (20 to 100 ms of work) above which the time of a factorization is estimated in advance.
constexpr double worth_foretelling = 1e9;

// Shortest time of three calls of work() [s].
template <class Work>
double least_seconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Clock::time_point start = Clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

bool is_worth_foretelling(double operations) { return operations >= worth_foretelling && Phase::is_heard(); }

}  // namespace

double expected_time_of_products(double operations) {
  if (!is_worth_foretelling(operations)) return 0;
  constexpr Eigen::Index size = 128;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(size, size, 0.5), b = Eigen::MatrixXd::Constant(size, size, 0.25);
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(size, size);
  const double seconds = least_seconds([&] { c.noalias() += a * b; });
  return operations * seconds / (2.0 * size * size * size);
}

double expected_time_of_entries(double operations) {
  if (!is_worth_foretelling(operations)) return 0;
  constexpr int size = 1 << 16;
  std::vector<int> place(size);
  for (int k = 0; k < size; ++k) place[k] = static_cast<int>((7919L * k) % size);
  std::vector<double> value(size, 0.5), target(size, 0.0);
  const double seconds = least_seconds([&] {
    for (int k = 0; k < size; ++k) target[place[k]] -= value[k] * 0.25;
  });
  return operations * seconds / size;
}

}  // namespace bempd::linalg

#include "linalg/machine_rates.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

namespace bempd::linalg {

namespace {

constexpr int repeats = 5;

// Of several, since anything else on the machine only makes it longer.
template <class Work>
double least_seconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Clock::time_point start = Clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return std::max(least, 1e-9);
}

// Chains that do not wait for each other: enough of them to keep the units busy, few enough to stay in registers.
constexpr int chains = 12, rounds = 2000;

template <int Lanes>
using Lane [[gnu::vector_size(Lanes * sizeof(double))]] = double;

template <int Lanes>
[[gnu::always_inline]] inline double run_chains(double factor, double term) {
  std::array<Lane<Lanes>, chains> sums{};
  for (int round = 0; round < rounds; ++round) {
    for (Lane<Lanes>& sum : sums) sum = sum * factor + term;
  }
  double total = 0;
  for (const Lane<Lanes>& sum : sums) total += sum[0];
  return total;
}

struct Chains {
  double (*run)(double factor, double term);
  int lanes;
};

double run_two(double factor, double term) { return run_chains<2>(factor, term); }

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] double run_four(double factor, double term) { return run_chains<4>(factor, term); }
[[gnu::target("avx512f")]] double run_eight(double factor, double term) { return run_chains<8>(factor, term); }

Chains widest() {
  if (__builtin_cpu_supports("avx512f")) return {run_eight, 8};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return {run_four, 4};
  return {run_two, 2};
}
#else
Chains widest() { return {run_two, 2}; }
#endif

double arithmetic_rate() {
  const Chains chosen = widest();
  volatile double factor = 0.5, term = 1, sink = 0;
  const double seconds = least_seconds([&] { sink = sink + chosen.run(factor, term); });
  return 2.0 * chosen.lanes * chains * rounds / seconds;
}

double matrix_product_rate() {
  constexpr Eigen::Index size = 192;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(size, size, 0.5);
  Eigen::MatrixXd product(size, size);
  const double seconds = least_seconds([&] { product.noalias() = a * a; });
  return 2.0 * size * size * size / seconds;
}

}  // namespace

const MachineRates& machine_rates() {
  static const MachineRates rates{arithmetic_rate(), matrix_product_rate()};
  return rates;
}

}  // namespace bempd::linalg

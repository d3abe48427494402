// The limits of boundary assembly on this machine, the kernels of a pair of points in the simplest loop that computes
// them with everything in the first cache, once with Eigen's logarithm and once with that of the library in whole
// vectors, and the integrals of pairs of elements, which also weigh them with the functions of six nodes. All are
// compiled for the same instruction sets. Items are pairs of points. Prints JSON with --benchmark_format=json.
// Functions that pass whole vectors are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "bem/lanes.hpp"
#include "bem/pair_integrals.hpp"

namespace {

using Values = Eigen::ArrayXd;

// ln r, the two trigonometric kernels and the four of the double layer, for one source and many field points.
#if defined(__x86_64__)
[[gnu::target_clones("default", "arch=x86-64-v3")]]
#endif
void add_kernels(const Values& x, const Values& y, Values& square, Values& sum) {
  const double normal_x = 0.6, normal_y = 0.8;
  square = x.square() + y.square();
  for (Eigen::Index p = 0; p < x.size(); ++p) {
    const double inverse = 1 / square[p];
    const double cosine = 0.5 * (x[p] * x[p] - y[p] * y[p]) * inverse, sine = x[p] * y[p] * inverse;
    const double along = (x[p] * normal_x + y[p] * normal_y) * inverse;
    const double across = (normal_x * y[p] - normal_y * x[p]) * inverse;
    sum[p] += cosine + sine + along + across + along * cosine + along * sine;
  }
  sum += 0.5 * square.log();
}

template <int lanes>
[[gnu::always_inline]] inline void add_in_lanes(const Values& x, const Values& y, Values& sum) {
  using namespace bempd::bem;
  using Vector = typename Lanes<lanes>::Values;
  const double normal_x = 0.6, normal_y = 0.8;
  for (Eigen::Index p = 0; p < x.size(); p += lanes) {
    const Vector rx = load<Vector>(&x[p]), ry = load<Vector>(&y[p]);
    const auto [logarithm, inverse] = half_logarithm_and_inverse<lanes>(rx * rx + ry * ry);
    const Vector unit_x = rx * inverse, unit_y = ry * inverse;
    const Vector cosine = 0.5 * (rx * unit_x - ry * unit_y), sine = rx * unit_y;
    const Vector along = normal_x * unit_x + normal_y * unit_y, across = normal_x * unit_y - normal_y * unit_x;
    const Vector all = logarithm + cosine + sine + along + across + along * cosine + along * sine;
    store(Vector(load<Vector>(&sum[p]) + all), &sum[p]);
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void add_in_four_lanes(const Values& x, const Values& y, Values& sum) {
  add_in_lanes<4>(x, y, sum);
}
#endif

void kernels_in_lanes(const Values& x, const Values& y, Values&, Values& sum) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return add_in_four_lanes(x, y, sum);
#endif
  add_in_lanes<2>(x, y, sum);
}

template <auto add>
void kernels(benchmark::State& state) {
  const Eigen::Index count = state.range(0);
  const Values x = Values::LinSpaced(count, 0, 1), y = 0.3 * x + 1;
  Values square(count), sum = Values::Zero(count);
  for (auto _ : state) {
    add(x, y, square, sum);
    benchmark::DoNotOptimize(sum.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * count);
}
BENCHMARK(kernels<add_kernels>)->Name("kernels")->Arg(256);
BENCHMARK(kernels<kernels_in_lanes>)->Name("kernels_in_lanes")->Arg(256);

// All pairs that do not touch among elements around a polygon.
void pair_integrals(benchmark::State& state) {
  using bempd::Point;
  const int count = static_cast<int>(state.range(0));
  const auto corner = [&](int i) {
    const double angle = 2 * EIGEN_PI * i / count;
    return Point(std::cos(angle), std::sin(angle));
  };
  std::vector<bempd::bem::ElementGeometry> elements;
  for (int i = 0; i < count; ++i) {
    const Point start = corner(i), end = corner(i + 1);
    elements.push_back(bempd::bem::element_through(start, 0.5 * (start + end), end, 0));
  }
  const bempd::bem::PairIntegrator integrator(elements, 1e-14);
  std::int64_t evaluations = 0;
  for (auto _ : state)
    for (int inner = 2; inner < count - 1; ++inner) {
      const auto moments = integrator.integrate(0, inner, bempd::bem::Contact::none, bempd::bem::PairPart::everything);
      evaluations += moments.evaluations;
      benchmark::DoNotOptimize(moments);
    }
  state.SetItemsProcessed(evaluations);
}
BENCHMARK(pair_integrals)->Arg(200);

}  // namespace

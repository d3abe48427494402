// Pairs of elements that lie along each other at a small distance: closed forms, agreement with the sum over pieces,
// and work that grows with the logarithm of length over distance.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "bem/pair_integrals.hpp"
#include "bem_moments.hpp"

namespace {

using namespace bempd;
using namespace bempd::bem;

// Integral of the kernel alone over inner and outer element: the first half of the double layer.
double double_layer_total(const PairMoments& m, int kernel) {
  double sum = 0;
  for (int b = 0; b < 3; ++b)
    for (const double value : m.double_layer[kernel][b]) sum += value;
  return sum;
}

// The part of an element between two parameters.
ElementGeometry piece(const ElementGeometry& whole, double from, double to) {
  const double sweep = 2 * whole.basis.half_angle();
  return element_through(whole.at(from), whole.at(0.5 * (from + to)), whole.at(to), 0.5 * sweep * (to - from));
}

TEST(ClosePairs, parallel_elements_agree_with_closed_forms) {
  std::int64_t evaluations = 0;
  for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    // The second runs backwards, as the other side of a strip does.
    const std::vector<ElementGeometry> elements{{{0.5, 0}, {0.5, 0}, {0, 0}}, {{0.5, gap}, {-0.5, 0}, {0, 0}}};
    const PairMoments m = PairIntegrator(elements, 1e-15).integrate(0, 1, Contact::none, PairPart::everything);
    const double square = gap * gap, angle = std::atan(1 / gap);
    const double logarithm = std::log1p(square) - 2 + 2 * gap * angle -
                             0.5 * ((1 + square) * std::log1p(square) - 1 - square * std::log(square));
    // The normal of the second points away from the first.
    const double along = 2 * angle - gap * std::log1p(1 / square);
    std::printf("gap %.0e: logarithm %.15g, off by %.1e; double layer %.15g, off by %.1e; %lld evaluations\n", gap,
                logarithm, total(m.mass[0]) - logarithm, along, double_layer_total(m, 0) - along,
                static_cast<long long>(m.evaluations));
    EXPECT_NEAR(total(m.mass[0]), logarithm, 1e-14);
    const double rounding = 1e-13 + 0.5 * std::numeric_limits<double>::epsilon() / gap;  // of places, over the distance
    EXPECT_NEAR(double_layer_total(m, 0), along, rounding);
    EXPECT_NEAR(double_layer_total(m, 1), 0, rounding);  // odd
    EXPECT_LT(m.evaluations, 2500 * std::pow(std::log(1 / gap), 2));
    EXPECT_GT(m.evaluations, evaluations);
    evaluations = m.evaluations;
  }
}

struct Couple {
  const char* name;
  ElementGeometry first, second;
};

ElementGeometry arc(const Point& centre, double radius, double from, double to) {
  const auto at = [&](double angle) -> Point { return centre + radius * Point(std::cos(angle), std::sin(angle)); };
  return element_through(at(from), at(0.5 * (from + to)), at(to), to - from);
}

std::vector<Couple> couples() {
  const double d = 0.004;
  const ElementGeometry straight{{0, 0}, {0.5, 0}, {0, 0}};
  std::vector<Couple> all;
  all.push_back({"concentric arcs", arc({0, 0}, 1, 0.2, 0.9), arc({0, 0}, 1 - d, 0.9, 0.2)});
  all.push_back({"shifted concentric arcs", arc({0, 0}, 1, 0.2, 0.9), arc({0, 0}, 1 - d, 1.2, 0.5)});
  all.push_back({"arcs side by side", arc({0, 0}, 1, -0.35, 0.35), arc({0.1 - d, 0}, 0.9, 0.35, -0.35)});
  all.push_back({"arc beside a straight element", straight, arc({0, -1 - d}, 1, 1.3, 1.9)});
  all.push_back(
      {"parabola beside a straight element", straight, element_through({0.6, 0.02}, {0, d}, {-0.4, 0.03}, 0)});
  all.push_back({"needle", straight, element_through({0.5, 0.006}, {0, 0.0035}, {-0.5, 0.001}, 0)});
  all.push_back({"short beside long", straight, element_through({0.23, d}, {0.18, d}, {0.13, d}, 0)});
  return all;
}

TEST(ClosePairs, totals_agree_with_the_sum_over_pieces) {
  constexpr int count = 96;
  for (const Couple& couple : couples()) {
    std::vector<ElementGeometry> elements{couple.first, couple.second};
    for (const ElementGeometry& whole : {couple.first, couple.second})
      for (int k = 0; k < count; ++k)
        elements.push_back(piece(whole, -1 + 2.0 * k / count, -1 + 2.0 * (k + 1) / count));
    const PairIntegrator integrator(elements, 1e-14);
    const PairMoments whole = integrator.integrate(0, 1, Contact::none, PairPart::everything);
    double logarithm = 0, along = 0, across = 0, size = 0;
    std::int64_t evaluations = 0;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        const PairMoments m = integrator.integrate(2 + i, 2 + count + j, Contact::none, PairPart::everything);
        logarithm += total(m.mass[0]);
        along += double_layer_total(m, 0);
        across += double_layer_total(m, 1);
        size += std::abs(double_layer_total(m, 1));
        evaluations += m.evaluations;
      }
    std::printf("%-36s off by %.1e, %.1e, %.1e; %lld evaluations for %lld\n", couple.name,
                total(whole.mass[0]) - logarithm, double_layer_total(whole, 0) - along,
                double_layer_total(whole, 1) - across, static_cast<long long>(whole.evaluations),
                static_cast<long long>(evaluations));
    EXPECT_NEAR(total(whole.mass[0]), logarithm, 1e-13) << couple.name;
    EXPECT_NEAR(double_layer_total(whole, 0), along, 1e-12) << couple.name;
    EXPECT_NEAR(double_layer_total(whole, 1), across, 1e-13 * size + 1e-13) << couple.name;
  }
}

}  // namespace

#include "bem/pair_integrals.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bem/smoothness.hpp"

namespace bempd::bem {

namespace {

constexpr int max_pairs = max_regular_points * max_regular_points;
using Row = ElementPoints::Values;

// Kernels integrated over the inner element only, at every outer point.
struct InnerIntegrals {
  std::array<std::array<Row, 3>, 4> double_layer;  // [kernel][inner node]
  std::array<std::array<Row, 3>, 3> mass;
  std::array<std::array<Row, 2>, 3> derivative;  // nodes 0 and 2; the derivatives of all three add to zero
};

template <typename Rows>
void clear(Rows& rows, int count) {
  for (auto& kernel : rows)
    for (Row& row : kernel) std::fill_n(row.begin(), count, 0.0);
}

// Kernels at all outer points for one inner point.
struct KernelRow {
  Row double_layer[4], cosine, sine;
};

void evaluate(const ElementPoints& outer, const ElementPoints& inner, int q, KernelRow& kernel, double* square) {
  const double yx = inner.x[q], yy = inner.y[q], nx = inner.normal_x[q], ny = inner.normal_y[q];
#pragma omp simd
  for (int p = 0; p < outer.count; ++p) {
    const double rx = yx - outer.x[p], ry = yy - outer.y[p];
    const double r2 = rx * rx + ry * ry, inverse = 1 / r2;
    const double cosine = 0.5 * (rx * rx - ry * ry) * inverse, sine = rx * ry * inverse;
    const double along = (rx * nx + ry * ny) * inverse;
    square[p] = r2;
    kernel.cosine[p] = cosine;
    kernel.sine[p] = sine;
    kernel.double_layer[0][p] = along;
    kernel.double_layer[1][p] = (nx * ry - ny * rx) * inverse;
    kernel.double_layer[2][p] = along * cosine;
    kernel.double_layer[3][p] = along * sine;
  }
}

void add_scaled(int count, double factor, const double* from, double* to) {
#pragma omp simd
  for (int p = 0; p < count; ++p) to[p] += factor * from[p];
}

double dot(int count, const Row& a, const Row& b) {
  double sum = 0;
  for (int p = 0; p < count; ++p) sum += a[p] * b[p];
  return sum;
}

void integrate_inner(const ElementPoints& outer, const ElementPoints& inner, bool weak, InnerIntegrals& integrals) {
  const int n = outer.count;
  alignas(64) double logs[max_pairs];
  alignas(64) KernelRow kernel;
  clear(integrals.double_layer, n);
  if (weak) {
    clear(integrals.mass, n);
    clear(integrals.derivative, n);
  }
  for (int q = 0; q < inner.count; ++q) {
    evaluate(outer, inner, q, kernel, logs + q * n);
    for (int k = 0; k < 3; ++k) {
      const double value = inner.shape[k][q];
      for (int c = 0; c < 4; ++c)
        add_scaled(n, value, kernel.double_layer[c].data(), integrals.double_layer[c][k].data());
    }
    if (!weak) continue;
    for (int k = 0; k < 3; ++k) {
      add_scaled(n, inner.mass[k][q], kernel.cosine.data(), integrals.mass[1][k].data());
      add_scaled(n, inner.mass[k][q], kernel.sine.data(), integrals.mass[2][k].data());
    }
    for (int k = 0; k < 2; ++k) {
      add_scaled(n, inner.derivative[2 * k][q], kernel.cosine.data(), integrals.derivative[1][k].data());
      add_scaled(n, inner.derivative[2 * k][q], kernel.sine.data(), integrals.derivative[2][k].data());
    }
  }
  if (!weak) return;
  Eigen::Map<Eigen::ArrayXd> ln(logs, n * inner.count);
  ln = 0.5 * ln.log();
  for (int q = 0; q < inner.count; ++q) {
    for (int k = 0; k < 3; ++k) add_scaled(n, inner.mass[k][q], logs + q * n, integrals.mass[0][k].data());
    for (int k = 0; k < 2; ++k)
      add_scaled(n, inner.derivative[2 * k][q], logs + q * n, integrals.derivative[0][k].data());
  }
}

void add_double_layer(const ElementPoints& outer, const InnerIntegrals& inner, PairMoments& moments) {
  const int n = outer.count;
  for (int c = 0; c < 4; ++c) {
    // The shape functions add to one, so the integrals over the nodes add to that of the bare kernel.
    Row total;
    for (int p = 0; p < n; ++p)
      total[p] = inner.double_layer[c][0][p] + inner.double_layer[c][1][p] + inner.double_layer[c][2][p];
    for (int a = 0; a < 3; ++a) {
      auto& row = moments.double_layer[c][a];
      for (int b = 0; b < 3; ++b) row[b] += dot(n, outer.mass[a], inner.double_layer[c][b]);
      Row weighted;
      for (int p = 0; p < n; ++p) weighted[p] = outer.mass[a][p] * total[p];
      for (int b = 0; b < 3; ++b) row[3 + b] -= dot(n, weighted, outer.shape[b]);
    }
  }
}

void add_weakly_singular(const ElementPoints& outer, const InnerIntegrals& inner, PairMoments& moments) {
  const int n = outer.count;
  for (int c = 0; c < 3; ++c) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) moments.mass[c][a][b] += dot(n, outer.mass[a], inner.mass[c][b]);
    double corner[2][2];
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) corner[a][b] = dot(n, outer.derivative[2 * a], inner.derivative[c][b]);
    auto& block = moments.derivative[c];
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) block[2 * a][2 * b] += corner[a][b];
      block[2 * a][1] -= corner[a][0] + corner[a][1];
      block[1][2 * a] -= corner[0][a] + corner[1][a];
    }
    block[1][1] += corner[0][0] + corner[0][1] + corner[1][0] + corner[1][1];
  }
}

// Analyticity of the kernels along one interval, seen from the other one: r vanishes at the complex parameter where
// the straight line through the interval meets the other point, whose distances to the ends of the interval are real
// distances in the plane.
double pair_ellipse(const ElementGeometry& element, const Interval& interval, const std::array<Point, 3>& self,
                    const std::array<Point, 3>& other) {
  if (!element.straight()) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Point& y : other) smallest = std::min(smallest, singularities_from(element, y).ellipse(interval));
    return smallest;
  }
  const double half = 0.5 * ((self[1] - self[0]).norm() + (self[2] - self[1]).norm());
  double closest = 1e300;
  for (const Point& y : other) closest = std::min(closest, (y - self[0]).norm() + (y - self[2]).norm());
  return ellipse_size(closest / half);
}

std::array<Point, 3> sample(const ElementGeometry& element, const Interval& i) {
  return {element.at(i.from), element.at(i.mid()), element.at(i.to)};
}

}  // namespace

PairIntegrator::PairIntegrator(const std::vector<ElementGeometry>& elements, double tolerance)
    : elements_(elements), tolerance_(tolerance), whole_(elements.size()) {
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t rule = 0; rule < regular_point_counts.size(); ++rule)
      fill_points(elements[e], {}, regular_point_counts[rule], whole_[e][rule]);
}

const ElementPoints& PairIntegrator::points(const Side& side, int rule, ElementPoints& scratch) const {
  if (side.interval.from == -1 && side.interval.to == 1) return whole_[side.element][rule];
  fill_points(elements_[side.element], side.interval, regular_point_counts[rule], scratch);
  return scratch;
}

void PairIntegrator::apart(const Side& outer, const Side& inner, PairPart part, int depth, PairMoments& moments) const {
  const ElementGeometry &a = elements_[outer.element], &b = elements_[inner.element];
  const auto outer_sample = sample(a, outer.interval), inner_sample = sample(b, inner.interval);
  const double outer_ellipse = pair_ellipse(a, outer.interval, outer_sample, inner_sample);
  const double inner_ellipse = pair_ellipse(b, inner.interval, inner_sample, outer_sample);
  const int outer_rule = regular_rule(
      std::max(gauss_points_needed(outer_ellipse, tolerance_), shape_points_needed(a, outer.interval, tolerance_)));
  const int inner_rule = regular_rule(
      std::max(gauss_points_needed(inner_ellipse, tolerance_), shape_points_needed(b, inner.interval, tolerance_)));

  constexpr int largest = static_cast<int>(regular_point_counts.size()) - 1, max_depth = 60;
  if ((outer_rule > largest || inner_rule > largest) && depth < max_depth) {
    const bool halve_outer = outer_ellipse < inner_ellipse;
    const Side& longer = halve_outer ? outer : inner;
    const double mid = longer.interval.mid();
    const Side first{longer.element, {longer.interval.from, mid}}, second{longer.element, {mid, longer.interval.to}};
    for (const Side& half : {first, second})
      halve_outer ? apart(half, inner, part, depth + 1, moments) : apart(outer, half, part, depth + 1, moments);
    return;
  }

  ElementPoints outer_scratch, inner_scratch;
  const ElementPoints& x = points(outer, std::min(outer_rule, largest), outer_scratch);
  const ElementPoints& y = points(inner, std::min(inner_rule, largest), inner_scratch);
  InnerIntegrals integrals;
  const bool weak = part == PairPart::everything;
  integrate_inner(x, y, weak, integrals);
  add_double_layer(x, integrals, moments);
  if (weak) add_weakly_singular(x, integrals, moments);
  moments.evaluations += static_cast<std::int64_t>(x.count) * y.count;
}

PairMoments PairIntegrator::integrate(int outer, int inner, Contact contact, PairPart part) const {
  PairMoments moments;
  switch (contact) {
    case Contact::same:
      same(outer, moments);
      break;
    case Contact::end_to_start:
      touching({outer, {1, -1}}, {inner, {-1, 1}}, part, moments);
      break;
    case Contact::start_to_end:
      touching({outer, {-1, 1}}, {inner, {1, -1}}, part, moments);
      break;
    case Contact::both_ends:
      // Two elements that form a loop: halves with the same sign are apart, opposite ones touch.
      touching({outer, {1, 0}}, {inner, {-1, 0}}, part, moments);
      touching({outer, {-1, 0}}, {inner, {1, 0}}, part, moments);
      apart({outer, {0, 1}}, {inner, {0, 1}}, part, 0, moments);
      apart({outer, {-1, 0}}, {inner, {-1, 0}}, part, 0, moments);
      break;
    case Contact::none:
      apart({outer, {}}, {inner, {}}, part, 0, moments);
      break;
  }
  return moments;
}

}  // namespace bempd::bem

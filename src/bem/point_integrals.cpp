#include "bem/point_integrals.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>

namespace bempd::bem {

namespace {

using Complex = std::complex<double>;
constexpr int max_depth = 60;

Complex as_complex(const Point& p) { return {p.x(), p.y()}; }

// Complex parameters at which an integrand is not analytic: where |x(xi) - x|^2 vanishes, which are the roots of
// c0 - x + c1 xi + c2 xi^2 read as complex numbers and their conjugates, and where the Jacobian does.
struct Singularities {
  std::array<Complex, 3> at;
  int count = 0;

  void add(Complex xi) { at[count++] = xi; }

  // Size of the ellipse around the interval in which the integrand is analytic.
  double ellipse(const Interval& interval) const {
    double closest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i)
      closest = std::min(closest, std::abs(at[i] - interval.from) + std::abs(at[i] - interval.to));
    return ellipse_size(2 * closest / std::abs(interval.to - interval.from));
  }
};

Singularities singularities_from(const ElementGeometry& element, const Point& x) {
  const Complex c0 = as_complex(element.c0 - x), c1 = as_complex(element.c1), c2 = as_complex(element.c2);
  Singularities s;
  if (element.straight()) {
    s.add(-c0 / c1);
    return s;
  }
  const Complex root = std::sqrt(c1 * c1 - 4.0 * c2 * c0);
  const Complex larger = std::abs(c1 + root) > std::abs(c1 - root) ? c1 + root : c1 - root;
  s.add(-larger / (2.0 * c2));
  if (larger != 0.0) s.add(-2.0 * c0 / larger);
  s.add(-c1 / (2.0 * c2));
  return s;
}

// Those that are left when r is divided by xi - xi0.
Singularities singularities_of_chord(const ElementGeometry& element, double xi0) {
  Singularities s;
  if (element.straight()) return s;
  const Complex ratio = as_complex(element.c1) / as_complex(element.c2);
  s.add(-ratio - xi0);
  s.add(-0.5 * ratio);
  return s;
}

void add_apart(const ElementPoints& y, const Point& x, PointMoments& moments) {
  ElementPoints::Values ln, cosine, sine, along, across;
  for (int p = 0; p < y.count; ++p) {
    const double rx = y.x[p] - x.x(), ry = y.y[p] - x.y(), r2 = rx * rx + ry * ry, inverse = 1 / r2;
    ln[p] = 0.5 * std::log(r2);
    cosine[p] = 0.5 * (rx * rx - ry * ry) * inverse;
    sine[p] = rx * ry * inverse;
    along[p] = (rx * y.normal_x[p] + ry * y.normal_y[p]) * inverse;
    across[p] = (y.normal_x[p] * ry - y.normal_y[p] * rx) * inverse;
  }
  for (int b = 0; b < 3; ++b)
    for (int p = 0; p < y.count; ++p) {
      const double mass = y.mass[b][p], normal = y.shape[b][p] * along[p];
      moments.mass[0][b] += mass * ln[p];
      moments.mass[1][b] += mass * cosine[p];
      moments.mass[2][b] += mass * sine[p];
      moments.double_layer[0][b] += normal;
      moments.double_layer[1][b] += y.shape[b][p] * across[p];
      moments.double_layer[2][b] += normal * cosine[p];
      moments.double_layer[3][b] += normal * sine[p];
    }
  moments.evaluations += y.count;
}

// Integrals over the part of one element on one side of its point xi0.
class OwnElement {
 public:
  OwnElement(const ElementGeometry& element, double xi0, double tolerance, PointMoments& moments)
      : element_(element),
        xi0_(xi0),
        tolerance_(tolerance),
        chord_(singularities_of_chord(element, xi0)),
        moments_(moments) {}

  // `part.from` is xi0. Product rules are exact to half the degree of Gauss's rule.
  void add_singular(const Interval& part, int depth = 0) {
    constexpr int polynomial_degree = 2;
    const int needed = gauss_points_needed(std::sqrt(chord_.ellipse(part)), tolerance_) + polynomial_degree;
    if (needed > max_gauss_points && depth < max_depth) {
      add_singular({part.from, part.mid()}, depth + 1);
      add_regular({part.mid(), part.to}, depth + 1);
      return;
    }
    const double length = std::abs(part.to - part.from), log_length = std::log(length);
    const GaussRule& rule = gauss_rule(std::min(needed, max_gauss_points));
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double weight = length * rule.weights[i];
      add_point(part.at(rule.points[i]), weight, length * rule.log_weights[i] + weight * log_length);
    }
  }

 private:
  void add_regular(const Interval& part, int depth) {
    Singularities all = chord_;
    all.add(xi0_);
    const int needed = gauss_points_needed(all.ellipse(part), tolerance_) + 1;
    if (needed > max_gauss_points && depth < max_depth) {
      add_regular({part.from, part.mid()}, depth + 1);
      add_regular({part.mid(), part.to}, depth + 1);
      return;
    }
    const double length = std::abs(part.to - part.from);
    const GaussRule& rule = gauss_rule(std::min(needed, max_gauss_points));
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double xi = part.at(rule.points[i]), weight = length * rule.weights[i];
      add_point(xi, weight, weight * std::log(std::abs(xi - xi0_)));
    }
  }

  // `log_weight` integrates ln|xi - xi0|.
  void add_point(double xi, double weight, double log_weight) {
    const Point chord = element_.difference_quotient(xi, xi0_), dx = element_.derivative(xi);
    const Point normal = scaled_normal(dx);
    const double square = chord.squaredNorm(), inverse = 1 / square, jacobian = dx.norm();
    const double cosine = 0.5 * (chord.x() * chord.x() - chord.y() * chord.y()) * inverse;
    const double sine = chord.x() * chord.y() * inverse;
    const double along = chord.dot(normal) * inverse, across = cross(normal, chord) * inverse;
    const auto value = shape(xi), difference = shape_difference_quotient(xi, xi0_);
    const double weak[3] = {log_weight + weight * 0.5 * std::log(square), weight * cosine, weight * sine};
    const double strong[4] = {along, across, along * cosine, along * sine};
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 3; ++c) moments_.mass[c][b] += weak[c] * jacobian * value[b];
      for (int c = 0; c < 4; ++c) moments_.double_layer[c][b] += strong[c] * weight * difference[b];
    }
    ++moments_.evaluations;
  }

  const ElementGeometry& element_;
  double xi0_, tolerance_;
  Singularities chord_;
  PointMoments& moments_;
};

}  // namespace

PointIntegrator::PointIntegrator(const std::vector<ElementGeometry>& elements, double tolerance)
    : elements_(elements), tolerance_(tolerance), whole_(elements.size()) {
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t rule = 0; rule < regular_point_counts.size(); ++rule)
      fill_points(elements[e], {}, regular_point_counts[rule], whole_[e][rule]);
}

PointMoments PointIntegrator::apart(int element, const Point& x) const {
  PointMoments moments;
  const Singularities singularities = singularities_from(elements_[element], x);
  constexpr int largest = static_cast<int>(regular_point_counts.size()) - 1;
  const auto add = [&](const auto& self, const Interval& interval, int depth) -> void {
    const int rule = regular_rule(gauss_points_needed(singularities.ellipse(interval), tolerance_) + 1);
    if (rule > largest && depth < max_depth) {
      self(self, {interval.from, interval.mid()}, depth + 1);
      self(self, {interval.mid(), interval.to}, depth + 1);
    } else if (depth == 0) {
      add_apart(whole_[element][rule], x, moments);
    } else {
      ElementPoints points;
      fill_points(elements_[element], interval, regular_point_counts[std::min(rule, largest)], points);
      add_apart(points, x, moments);
    }
  };
  add(add, {}, 0);
  return moments;
}

PointMoments PointIntegrator::containing(int element, double xi0) const {
  assert(-1 <= xi0 && xi0 <= 1);
  PointMoments moments;
  OwnElement own(elements_[element], xi0, tolerance_, moments);
  for (const double end : {-1.0, 1.0})
    if (xi0 != end) own.add_singular({xi0, end});
  return moments;
}

}  // namespace bempd::bem

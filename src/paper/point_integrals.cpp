#include "paper/point_integrals.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bem/smoothness.hpp"

namespace bempd::paper {

using namespace bem;

namespace {

constexpr int max_depth = 60;

void add_off_element(const ElementPoints& y, const Point& x, PointMoments& moments) {
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

// Integrals over the part of an element on one side of the element's own point xi0.
class OwnElement {
 public:
  OwnElement(const ElementGeometry& element, double xi0, double tolerance, PointMoments& moments)
      : element_(element),
        xi0_(xi0),
        tolerance_(tolerance),
        chord_(singularities_of_chord(element, xi0)),
        moments_(moments) {}

  // Adds the integrals over `part`, which begins at xi0. Product rules are exact to half the degree of the Gauss rule
  // with as many points.
  void add_singular(const Interval& part, int depth = 0) {
    constexpr int polynomial_degree = 2;
    const int needed = std::max(gauss_points_needed(std::sqrt(chord_.ellipse(part)), tolerance_) + polynomial_degree,
                                2 * shape_points_needed(element_, part, tolerance_));
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
    const int needed = std::max(gauss_points_needed(all.ellipse(part), tolerance_) + 1,
                                shape_points_needed(element_, part, tolerance_));
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

  // Adds the values at one point of the element; `weight` is its weight for smooth integrands, `log_weight` that for
  // integrands with the factor ln|xi - xi0|.
  void add_point(double xi, double weight, double log_weight) {
    const Point chord = element_.quotients(xi, xi0_).place, dx = element_.derivative(xi);
    const Point normal = scaled_normal(dx);
    const double square = chord.squaredNorm(), inverse = 1 / square, jacobian = dx.norm();
    const double cosine = 0.5 * (chord.x() * chord.x() - chord.y() * chord.y()) * inverse;
    const double sine = chord.x() * chord.y() * inverse;
    const double along = chord.dot(normal) * inverse, across = cross(normal, chord) * inverse;
    const auto value = element_.shape(xi), difference = element_.quotients(xi, xi0_).shape;
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

PointMoments PointIntegrator::off_element(int element, const Point& x) const {
  PointMoments moments;
  const Singularities singularities = singularities_from(elements_[element], x);
  constexpr int largest = static_cast<int>(regular_point_counts.size()) - 1;
  const auto add = [&](const auto& self, const Interval& interval, int depth) -> void {
    const int rule = regular_rule(std::max(gauss_points_needed(singularities.ellipse(interval), tolerance_) + 1,
                                           shape_points_needed(elements_[element], interval, tolerance_)));
    if (rule > largest && depth < max_depth) {
      self(self, {interval.from, interval.mid()}, depth + 1);
      self(self, {interval.mid(), interval.to}, depth + 1);
    } else if (depth == 0) {
      add_off_element(whole_[element][rule], x, moments);
    } else {
      ElementPoints points;
      fill_points(elements_[element], interval, regular_point_counts[std::min(rule, largest)], points);
      add_off_element(points, x, moments);
    }
  };
  add(add, {}, 0);
  return moments;
}

PointMoments PointIntegrator::on_element(int element, double xi0) const {
  assert(-1 <= xi0 && xi0 <= 1);
  PointMoments moments;
  OwnElement own(elements_[element], xi0, tolerance_, moments);
  for (const double end : {-1.0, 1.0})
    if (xi0 != end) own.add_singular({xi0, end});
  return moments;
}

}  // namespace bempd::paper

// Pairs of elements that share a point, or are the same. Coordinates are chosen in which r = radius * chord, where the
// chord is smooth and does not vanish: Duffy's coordinates around a common end, the distance of the parameters
// inside one element. What is left of ln r is the smooth ln|chord| and ln(radius), which a product rule integrates;
// the 1 / r of the double layer cancels against N(y) - N(x), which vanishes with the radius.

#include <cmath>
#include <complex>
#include <numbers>

#include "bem/pair_integrals.hpp"

namespace bempd::bem {

namespace {

// Pair of parameters with everything the kernels need there.
struct PointPair {
  ElementGeometry::Values outer, inner;
  Point chord{};                       // r / radius
  double weight = 0, log_weight = 0;   // log_weight integrates ln(radius)
  std::array<double, 6> difference{};  // (N_b(y) - N_b(x)) / radius, inner nodes then outer nodes
};

void add_weakly_singular(const PointPair& p, double cosine, double sine, bool mass, PairMoments& moments) {
  const double jacobians = p.outer.derivative.norm() * p.inner.derivative.norm();
  const double kernels[3] = {p.log_weight + p.weight * 0.5 * std::log(p.chord.squaredNorm()), p.weight * cosine,
                             p.weight * sine};
  for (int c = 0; c < 3; ++c)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        if (mass) moments.mass[c][b][a] += kernels[c] * jacobians * p.outer.shape[a] * p.inner.shape[b];
        moments.derivative[c][b][a] += kernels[c] * p.outer.shape_derivative[a] * p.inner.shape_derivative[b];
      }
}

void add_point(const PointPair& p, PairPart part, PairMoments& moments) {
  ++moments.evaluations;
  const double inverse = 1 / p.chord.squaredNorm();
  const double cosine = 0.5 * (p.chord.x() * p.chord.x() - p.chord.y() * p.chord.y()) * inverse;
  const double sine = p.chord.x() * p.chord.y() * inverse;
  if (part != PairPart::double_layer_only) add_weakly_singular(p, cosine, sine, part == PairPart::everything, moments);
  if (part == PairPart::derivative_only) return;

  const Point normal = scaled_normal(p.inner.derivative);
  const double along = p.chord.dot(normal) * inverse, across = cross(normal, p.chord) * inverse;
  const double kernels[4] = {along, across, along * cosine, along * sine};
  const double weight = p.weight * p.outer.derivative.norm();
  for (int c = 0; c < 4; ++c)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 6; ++b)
        moments.double_layer[c][b][a] += weight * kernels[c] * p.outer.shape[a] * p.difference[b];
}

// (N_b(y) - N_b(x)) / radius at a pair of parameters around a common end. N_b is one and the same there, so its value
// drops out of the difference.
std::array<double, 6> common_node_difference(const std::array<double, 3>& inner, double inner_way,
                                             const std::array<double, 3>& outer, double outer_way) {
  std::array<double, 6> difference;
  for (int k = 0; k < 3; ++k) {
    difference[k] = inner_way * inner[k];
    difference[3 + k] = -outer_way * outer[k];
  }
  return difference;
}

// The same where each element has its own node.
std::array<double, 6> separate_node_difference(const PointPair& p, double radius) {
  const auto &inner = p.inner.shape, &outer = p.outer.shape;
  return {inner[0] / radius,  inner[1] / radius,  inner[2] / radius,
          -outer[0] / radius, -outer[1] / radius, -outer[2] / radius};
}

// Polynomials of straight elements reach degree five in the radius and two along an element; curved ones need more,
// having sines or Jacobians that are roots, the fewer the looser they may be.
struct PointCounts {
  int radial = 6, along = 3, extra_angular = 1;

  PointCounts(bool straight, double tolerance) {
    constexpr double loose = 1e-8;
    if (straight) return;
    const bool few = tolerance >= loose;
    radial = few ? 10 : 18, along = few ? 7 : 12, extra_angular = few ? 2 : 5;
  }
};

// Angular variable w on [0, 1]: the chord vanishes at one complex w, so intervals shrink towards it.
struct AngularRule {
  std::vector<double> points, weights;

  AngularRule(std::complex<double> zero, double tolerance, int extra_points) {
    add({0, 1}, zero, tolerance, extra_points, 0);
  }

 private:
  void add(const Interval& interval, std::complex<double> zero, double tolerance, int extra_points, int depth) {
    constexpr int max_points = 20, max_depth = 50;
    const double length = interval.to - interval.from;
    const double ellipse =
        ellipse_size((std::abs(zero - interval.from) + std::abs(zero - interval.to)) / (0.5 * length));
    const int needed = gauss_points_needed(ellipse, tolerance) + extra_points;
    if (needed > max_points && depth < max_depth) {
      add({interval.from, interval.mid()}, zero, tolerance, extra_points, depth + 1);
      add({interval.mid(), interval.to}, zero, tolerance, extra_points, depth + 1);
      return;
    }
    const GaussRule& rule = gauss_rule(std::min(needed, max_points));
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      points.push_back(interval.at(rule.points[i]));
      weights.push_back(rule.weights[i] * length);
    }
  }
};

}  // namespace

// The intervals start at the common point: parameters from + s (to - from), with s = radius, t = radius * w in one
// triangle of the unit square and s = radius * w, t = radius in the other (M. G. Duffy, SIAM J. Numer. Anal. 19, 1982).
void PairIntegrator::touching(const Side& outer, const Side& inner, bool common_node, PairPart part,
                              PairMoments& moments) const {
  const ElementGeometry &a = elements_[outer.element], &b = elements_[inner.element];
  const double a0 = outer.interval.from, a_length = outer.interval.to - a0;
  const double b0 = inner.interval.from, b_length = inner.interval.to - b0;
  const bool straight = a.straight() && b.straight();
  const PointCounts counts(straight, tolerance_);
  const GaussRule& radial = gauss_rule(counts.radial);
  const Point a_tangent = a_length * a.derivative(a0), b_tangent = b_length * b.derivative(b0);
  const std::complex<double> ratio =
      std::complex<double>(a_tangent.x(), a_tangent.y()) / std::complex<double>(b_tangent.x(), b_tangent.y());

  for (const bool inner_is_nearer : {true, false}) {
    const AngularRule angular(inner_is_nearer ? ratio : 1.0 / ratio, tolerance_, counts.extra_angular);
    for (std::size_t j = 0; j < angular.points.size(); ++j) {
      const double s_over_radius = inner_is_nearer ? 1 : angular.points[j];
      const double t_over_radius = inner_is_nearer ? angular.points[j] : 1;
      for (std::size_t i = 0; i < radial.points.size(); ++i) {
        const double radius = radial.points[i];
        const double outer_way = a_length * s_over_radius, inner_way = b_length * t_over_radius;
        const double outer_xi = a0 + outer_way * radius, inner_xi = b0 + inner_way * radius;
        PointPair p{a.values(outer_xi), b.values(inner_xi)};
        const ElementGeometry::Quotients from_a = a.quotients(outer_xi, a0), from_b = b.quotients(inner_xi, b0);
        p.chord = inner_way * from_b.place - outer_way * from_a.place;
        const double area = angular.weights[j] * radius * std::abs(a_length * b_length);
        p.weight = radial.weights[i] * area;
        p.log_weight = radial.log_weights[i] * area;
        p.difference = common_node ? common_node_difference(from_b.shape, inner_way, from_a.shape, outer_way)
                                   : separate_node_difference(p, radius);
        add_point(p, part, moments);
      }
    }
  }
}

// The radius is half the distance of the parameters, 2 s = |eta - xi|; the lower one runs over -1 .. 1 - 2 s.
void PairIntegrator::same(int element, PairMoments& moments) const {
  const ElementGeometry& geometry = elements_[element];
  if (geometry.tip != TipEnd::none) return same_tip(element, moments);
  const PointCounts counts(geometry.straight(), tolerance_);
  const GaussRule &radial = gauss_rule(counts.radial), &along = gauss_rule(counts.along);
  const double log_two = std::log(2.0);
  for (std::size_t i = 0; i < radial.points.size(); ++i)
    for (std::size_t j = 0; j < along.points.size(); ++j) {
      const double s = radial.points[i];
      const double lower = -1 + 2 * along.points[j] * (1 - s), upper = lower + 2 * s;
      const double area = 4 * (1 - s) * along.weights[j];
      const ElementGeometry::Values at_lower = geometry.values(lower), at_upper = geometry.values(upper);
      const ElementGeometry::Quotients quotients = geometry.quotients(upper, lower);
      for (const bool outer_is_lower : {true, false}) {
        PointPair p{outer_is_lower ? at_lower : at_upper, outer_is_lower ? at_upper : at_lower};
        // Signed radius eta - xi: even kernels do not see the sign, in the double layer it cancels.
        p.chord = quotients.place;
        p.weight = radial.weights[i] * area;
        p.log_weight = radial.log_weights[i] * area + p.weight * log_two;
        for (int k = 0; k < 3; ++k) {
          p.difference[k] = quotients.shape[k];
          p.difference[3 + k] = 0;
        }
        add_point(p, PairPart::everything, moments);
      }
    }
}

// Derivatives only: cracks have no traction unknowns. With the ways sigma and tau from the tip,
// r = length |sigma^2 - tau^2|, and the derivatives have the powers 0 and 2 of sigma and tau: all integrals in closed
// form, from those of  sigma^a tau^b ln|sigma^2 - tau^2|  over the unit square.
void PairIntegrator::same_tip(int element, PairMoments& moments) const {
  const ElementGeometry& geometry = elements_[element];
  const Point along = 2 * geometry.c1, unit = along.normalized();
  constexpr double ln2 = std::numbers::ln2;
  constexpr double with_1 = 2 * ln2 - 2, with_square = 2 * ln2 / 3 - 8.0 / 9;  // of ln(1 - w^2), over 0 .. 1
  constexpr double logarithm[2][2] = {{with_1 - 1, 0.25 * (with_1 + with_square) - 1.0 / 6},
                                      {0.25 * (with_1 + with_square) - 1.0 / 6, with_square / 3 - 1.0 / 27}};
  // Of the functions of tip, mid node and far end.
  constexpr double slope[3][2] = {{-7.0 / 3, 4}, {8.0 / 3, -8}, {-1.0 / 3, 4}}, difference[3] = {-1, 0, 1};
  const double cosine = 0.5 * (unit.x() * unit.x() - unit.y() * unit.y()), sine = unit.x() * unit.y();
  const auto position = [&](int k) { return geometry.tip == TipEnd::start ? k : 2 - k; };
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double both = difference[a] * difference[b];
      double sum = both * std::log(along.norm());
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) sum += slope[a][i] * slope[b][j] * logarithm[i][j];
      moments.derivative[0][position(b)][position(a)] += sum;
      moments.derivative[1][position(b)][position(a)] += both * cosine;
      moments.derivative[2][position(b)][position(a)] += both * sine;
    }
}

}  // namespace bempd::bem

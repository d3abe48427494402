// Integrals over pairs of elements that share a point, or of an element with itself. Coordinates are chosen in which
// the distance is r = radius * chord, where the chord is smooth and does not vanish: Duffy's coordinates around a
// common end, or the difference of two parameters on one element. The logarithm ln r is then the smooth ln|chord| plus
// ln(radius), which a product rule integrates. The factor 1 / r of the double layer cancels against N(y) - N(x), the
// difference of the shape functions at both points, which vanishes with the radius.

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "bem/kernel_sums.hpp"
#include "bem/pair_integrals.hpp"

namespace bempd::bem {

namespace {

// Writes entry `p` of `side`: an element's normal, shape functions N and their derivatives at a point, from `values`,
// and the element's part `scale * difference` of the quotient (N(y) - N(x)) / radius.
void set(const ElementGeometry::Values& values, const std::array<double, 3>& difference, double scale, std::size_t p,
         SingularPoints::Side& side) {
  const Point normal = scaled_normal(values.derivative);
  const double jacobian = values.derivative.norm();
  side.normal_x[p] = normal.x(), side.normal_y[p] = normal.y();
  for (int k = 0; k < 3; ++k) {
    side.mass[k][p] = values.shape[k] * jacobian;
    side.derivative[k][p] = values.shape_derivative[k];
    side.difference[k][p] = scale * difference[k];
  }
}

void set(const Point& chord, double weight, double log_weight, std::size_t p, SingularPoints::Pair& pair) {
  pair.chord_x[p] = chord.x(), pair.chord_y[p] = chord.y();
  pair.weight[p] = weight, pair.log_weight[p] = log_weight;
}

// Pads the arrays of `side` with zeros up to a whole vector, because whole vectors are read behind the last radius.
void fill_up(std::size_t radii, SingularPoints::Side& side) {
  const ElementGeometry::Values nothing{Point(0, 0), {}, {}};
  for (std::size_t p = radii; p % 4 != 0; ++p) set(nothing, {}, 0, p, side);
}

void fill_up(std::size_t radii, SingularPoints::Pair& pair) {
  for (std::size_t p = radii; p % 4 != 0; ++p) set(Point(1, 0), 0, 0, p, pair);
}

// Numbers of quadrature points. On straight elements integrands are polynomials, of degree five in the radius and two
// along the element. On curved elements integrands have sines, or Jacobians with square roots, and need more points,
// fewer of them for a loose tolerance.
struct PointCounts {
  int radial = 6, along = 3, extra_angular = 1;

  PointCounts(bool straight, double tolerance) {
    constexpr double loose = 1e-8;
    if (straight) return;
    const bool few = tolerance >= loose;
    radial = few ? 10 : 18, along = few ? 7 : 12, extra_angular = few ? 2 : 5;
  }
};

// Rule for the angular variable w on [0, 1]. The chord vanishes at the complex value `zero` of w; intervals are halved
// towards this value.
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

// Element with parameters that start at one of its ends: sets quadrature points by their distance from this end.
class FromEnd {
 public:
  FromEnd(const ElementGeometry& element, const Interval& interval)
      : element_(element), from_(interval.from), length_(interval.to - from_), half_(element.basis.half(from_)) {}

  // Sets point `p` at the distance radius * times_radius from the end, in lengths of the interval. N are the shape
  // functions; the element's part of the quotient (N(y) - N(x)) / radius is, with a common node, N less its value at
  // the end (these values cancel), over the radius; without a common node it is N over the radius. `sign` is the sign
  // of this part.
  void set_at(double radius, double times_radius, bool common_node, double sign, std::size_t p, Point& chord,
              SingularPoints::Side& side) const {
    const double way = length_ * times_radius;
    const auto [values, quotients] =
        element_.values_and_quotients(from_, way * radius, half_, element_.basis.half(way * radius));
    chord = way * quotients.place;
    if (common_node)
      set(values, quotients.shape, sign * way, p, side);
    else
      set(values, values.shape, sign / radius, p, side);
  }
  Point tangent() const { return length_ * element_.derivative(from_); }
  double length() const { return length_; }

 private:
  const ElementGeometry& element_;
  double from_, length_;
  ElementBasis::HalfAngle half_;
};

}  // namespace

// Integrates over two elements that touch; intervals start at the common point. With the parameters from + s (to -
// from) on one element and from + t (to - from) on the other, s = radius and t = radius * w in one triangle of the unit
// square, s = radius * w and t = radius in the other (M. G. Duffy, SIAM J. Numer. Anal. 19, 1982).
void PairIntegrator::integrate_touching(const Side& outer, const Side& inner, bool common_node, PairPart part,
                                        PairMoments& moments) const {
  const ElementGeometry &a = elements_[outer.element], &b = elements_[inner.element];
  const FromEnd from_a(a, outer.interval), from_b(b, inner.interval);
  const PointCounts counts(a.straight() && b.straight(), tolerance_);
  const GaussRule& radial = gauss_rule(counts.radial);
  const Point a_tangent = from_a.tangent(), b_tangent = from_b.tangent();
  const std::complex<double> ratio =
      std::complex<double>(a_tangent.x(), a_tangent.y()) / std::complex<double>(b_tangent.x(), b_tangent.y());
  const double square = std::abs(from_a.length() * from_b.length());

  SingularPoints points;
  points.radii = counts.radial;
  for (const bool inner_is_nearer : {true, false}) {
    const AngularRule angular(inner_is_nearer ? ratio : 1.0 / ratio, tolerance_, counts.extra_angular);
    points.outer_ignores_angle = inner_is_nearer, points.inner_ignores_angle = !inner_is_nearer;
    const FromEnd &nearer = inner_is_nearer ? from_b : from_a, &farther = inner_is_nearer ? from_a : from_b;
    auto &nearer_sides = inner_is_nearer ? points.inner : points.outer,
         &farther_sides = inner_is_nearer ? points.outer : points.inner;
    const double sign = inner_is_nearer ? 1 : -1;
    std::array<Point, SingularPoints::most_radii> farther_chord;
    for (std::size_t i = 0; i < radial.points.size(); ++i)
      farther.set_at(radial.points[i], 1, common_node, -sign, i, farther_chord[i], farther_sides[0]);
    fill_up(radial.points.size(), farther_sides[0]);
    for (std::size_t j = 0; j < angular.points.size(); ++j) {
      const auto q = static_cast<std::size_t>(points.angles++);
      for (std::size_t i = 0; i < radial.points.size(); ++i) {
        Point chord;
        nearer.set_at(radial.points[i], angular.points[j], common_node, sign, i, chord, nearer_sides[q]);
        const double area = angular.weights[j] * radial.points[i] * square;
        set(sign * (chord - farther_chord[i]), radial.weights[i] * area, radial.log_weights[i] * area, i,
            points.pairs[q]);
      }
      fill_up(radial.points.size(), nearer_sides[q]);
      fill_up(radial.points.size(), points.pairs[q]);
      if (points.angles < SingularPoints::most_angles && j + 1 < angular.points.size()) continue;
      add_singular_sums(points, part, moments);
      points.angles = 0;
    }
  }
}

// Integrates over an element paired with itself. The radius s is half the difference of the parameters, 2 s = |eta -
// xi|; the lower parameter runs over -1 .. 1 - 2 s.
void PairIntegrator::integrate_with_itself(int element, PairPart part, PairMoments& moments) const {
  const ElementGeometry& geometry = elements_[element];
  if (geometry.tip != TipEnd::none) return integrate_tip_with_itself(element, moments);
  const PointCounts counts(geometry.straight(), tolerance_);
  const GaussRule &radial = gauss_rule(counts.radial), &along = gauss_rule(counts.along);
  SingularPoints points;
  points.has_outer_part = false;
  points.radii = counts.radial, points.angles = counts.along;
  for (std::size_t i = 0; i < radial.points.size(); ++i) {
    const double s = radial.points[i];
    const ElementBasis::HalfAngle half_way = geometry.basis.half(2 * s);
    for (std::size_t j = 0; j < along.points.size(); ++j) {
      const double lower = -1 + 2 * along.points[j] * (1 - s);
      const double area = 4 * (1 - s) * along.weights[j], weight = radial.weights[i] * area;
      const double log_weight = radial.log_weights[i] * area + weight * std::numbers::ln2;
      const ElementBasis::HalfAngle half_lower = geometry.basis.half(lower);
      const ElementGeometry::Values at_lower = geometry.values(lower, geometry.basis.at(lower, half_lower));
      const auto [at_upper, quotients] = geometry.values_and_quotients(lower, 2 * s, half_lower, half_way);
      // The radius is taken with the sign of eta - xi. Even kernels do not depend on this sign, and in the double layer
      // the sign cancels.
      set(quotients.place, weight, log_weight, i, points.pairs[j]);
      set(at_lower, quotients.shape, 1, i, points.outer[j]);
      set(at_upper, quotients.shape, 1, i, points.inner[j]);
    }
  }
  for (std::size_t j = 0; j < along.points.size(); ++j) {
    fill_up(radial.points.size(), points.outer[j]);
    fill_up(radial.points.size(), points.inner[j]);
    fill_up(radial.points.size(), points.pairs[j]);
  }
  add_singular_sums(points, part, moments);
  std::swap(points.outer, points.inner);
  add_singular_sums(points, part, moments);
}

// Integrates over a tip element paired with itself: derivatives only, because cracks have no traction unknowns. With
// the parameters sigma and tau from the tip, r = length |sigma^2 - tau^2|, and the derivatives have the powers 0 and 2
// of sigma and tau. All integrals follow from closed forms for  sigma^a tau^b ln|sigma^2 - tau^2|  over the unit
// square.
void PairIntegrator::integrate_tip_with_itself(int element, PairMoments& moments) const {
  const ElementGeometry& geometry = elements_[element];
  const Point along = 2 * geometry.c1, unit = along.normalized();
  constexpr double ln2 = std::numbers::ln2;
  constexpr double with_1 = 2 * ln2 - 2, with_square = 2 * ln2 / 3 - 8.0 / 9;  // of ln(1 - w^2) and w^2 ln(1 - w^2)
  constexpr double logarithm[2][2] = {{with_1 - 1, 0.25 * (with_1 + with_square) - 1.0 / 6},
                                      {0.25 * (with_1 + with_square) - 1.0 / 6, with_square / 3 - 1.0 / 27}};
  // Coefficients of the shape functions N_k of tip, mid node and far end, with sigma running from 0 at the tip to 1:
  // dN_k / dsigma = slope[k][0] + slope[k][1] sigma^2, and difference[k] is N_k at the far end less N_k at the tip.
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

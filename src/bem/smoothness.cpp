#include "bem/smoothness.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace bempd::bem {

namespace {

using Complex = std::complex<double>;

Complex as_complex(const Point& p) { return {p.x(), p.y()}; }

// Adds the two complex roots of the quadratic c0 + c1 xi + c2 xi^2.
void add_roots(const Complex& c0, const Complex& c1, const Complex& c2, Singularities& s) {
  const Complex root = std::sqrt(c1 * c1 - 4.0 * c2 * c0);
  const Complex larger = std::abs(c1 + root) > std::abs(c1 - root) ? c1 + root : c1 - root;
  s.add(-larger / (2.0 * c2));
  if (larger != 0.0) s.add(-2.0 * c0 / larger);
}

}  // namespace

double Singularities::sum_of_distances(const Interval& interval) const {
  double closest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count_; ++i)
    closest = std::min(closest, std::abs(at_[i] - interval.from) + std::abs(at_[i] - interval.to));
  return 2 * closest / std::abs(interval.to - interval.from);
}

// Solves for the length h of the interval. Let the singularity have the distance r from the start of the interval and
// the coordinate u along the interval. Its distance from the end is then sqrt(r^2 - 2 u h + h^2), and both distances
// add to sum h / 2 where h = 2 (k r - u) / (k^2 - 1) with k = sum / 2.
double Singularities::longest_interval(double from, double sum) const {
  const double k = 0.5 * sum;
  double longest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count_; ++i) {
    const Complex offset = at_[i] - from;
    longest = std::min(longest, 2 * (k * std::abs(offset) - offset.real()) / (k * k - 1));
  }
  return longest;
}

ArcParameters::ArcParameters(const ElementGeometry& arc) : alpha_(arc.basis.half_angle()) {
  const double root = std::sin(0.5 * alpha_);
  to_mid_ = -arc.c2 / (2 * root * root);
  centre_ = arc.c0 - to_mid_;
  radius_ = to_mid_.norm();
}

std::array<Complex, 2> ArcParameters::of(const Point& x) const {
  const Point place = x - centre_;
  const Complex xi(std::atan2(cross(to_mid_, place), to_mid_.dot(place)) / alpha_,
                   -std::log(place.norm() / radius_) / alpha_);
  return {xi, xi - std::copysign(2 * std::numbers::pi / std::abs(alpha_), xi.real())};
}

double ArcParameters::sum_of_distances(const Point& x, const Interval& interval) const {
  const auto [xi, next_turn] = of(x);
  const auto sum = [&](const Complex& at) {
    return std::sqrt(std::norm(at - interval.from)) + std::sqrt(std::norm(at - interval.to));
  };
  return 2 * std::min(sum(xi), sum(next_turn)) / std::abs(interval.to - interval.from);
}

// Bound by places as complex numbers: x has the parameter -i ln(z / m) / alpha on the arc, where z is x less the arc's
// centre, m the arc's mid node less its centre, and alpha half the arc's angle. The parameters of two places z and z'
// therefore differ by |ln(z' / z)| / |alpha| <= q / (1 - q) / |alpha|, where q = |z' - z| / |z|, and the
// parameter's distances from both ends of `interval` change by at most this.
double ArcParameters::largest_change(const std::array<Point, 3>& places, const Interval& interval) const {
  const double apart =
      std::sqrt(std::max((places[0] - places[1]).squaredNorm(), (places[2] - places[1]).squaredNorm()));
  const double room = (places[1] - centre_).norm() - apart;
  if (room <= 0) return std::numeric_limits<double>::infinity();
  return 4 * apart / (room * std::abs(alpha_ * (interval.to - interval.from)));
}

Singularities singularities_from(const ElementGeometry& element, const Point& x) {
  Singularities s;
  const Complex c0 = as_complex(element.c0 - x), c1 = as_complex(element.c1), c2 = as_complex(element.c2);
  if (element.straight()) {
    s.add(-c0 / c1);
  } else if (element.basis.powers()) {
    add_roots(c0, c1, c2, s);
  } else {
    for (const Complex& xi : ArcParameters(element).of(x)) s.add(xi);
  }
  return s;
}

std::vector<Singularities> singularities_of_integral(const ElementGeometry& outer, const ElementGeometry& inner,
                                                     const Interval& interval) {
  std::vector<Singularities> all{singularities_from(outer, inner.at(interval.from)),
                                 singularities_from(outer, inner.at(interval.to))};
  if (inner.straight()) return all;
  if (inner.basis.powers()) {
    const Complex c1 = as_complex(inner.c1), focus = as_complex(inner.c0) - c1 * c1 / (4.0 * as_complex(inner.c2));
    all.push_back(singularities_from(outer, Point(focus.real(), focus.imag())));
  } else {
    const double root = std::sin(0.5 * inner.basis.half_angle());
    all.push_back(singularities_from(outer, inner.c0 + inner.c2 / (2 * root * root)));
  }
  return all;
}

Singularities singularities_of_chord(const ElementGeometry& element, double xi0) {
  Singularities s;
  if (element.straight()) return s;
  if (element.basis.powers()) {
    s.add(-as_complex(element.c1) / as_complex(element.c2) - xi0);
    return s;
  }
  const double turn = 2 * std::numbers::pi / std::abs(element.basis.half_angle());
  s.add(xi0 - turn);
  s.add(xi0 + turn);
  return s;
}

int shape_points_needed(const ElementGeometry& element, const Interval& interval, double tolerance) {
  if (element.straight()) return 1;
  // Shape functions of elements at a tip are polynomials of the parameter.
  if (element.tip != TipEnd::none) return 2;
  if (element.basis.powers()) {
    // The Jacobian is singular where its square dx/dxi . dx/dxi vanishes, that is where c1 + 2 c2 xi = 0 with c1 and c2
    // read as complex numbers.
    Singularities s;
    s.add(-as_complex(element.c1) / (2.0 * as_complex(element.c2)));
    return gauss_points_needed(s.ellipse(interval), tolerance);
  }
  // Integrands have sines and cosines of up to four times the angle of the arc, so that the error of n Gauss points
  // falls like (e angle / (4 n))^(2 n), where e = 2.718...
  const double angle = 4 * std::abs(element.basis.half_angle()) * 0.5 * std::abs(interval.to - interval.from);
  int points = 1;
  while (points < max_gauss_points && std::pow(std::numbers::e * angle / (4 * points), 2 * points) > tolerance)
    ++points;
  return points;
}

}  // namespace bempd::bem

#include "bem/crack_field.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "bem/quadrature.hpp"
#include "geometry/turning.hpp"

namespace bempd::bem {

namespace {

using Complex = std::complex<double>;

// Cauchy integrals I(z) = integral of w(s) / (z - s) over s = 0 .. 1, for the two components of the opening w along an
// element, and their first two derivatives by the complex place z.
struct CauchyIntegrals {
  std::array<Complex, 2> value, first, second;
};

// Distance from an element, over its length, below which a point counts as lying on the element.
constexpr double on_crack = 1e-10;

// Cauchy integrals (CauchyIntegrals) of the polynomial w[0] + w[1] s + w[2] s^2 in closed form. The branch cut of the
// logarithm lies on the crack only.
CauchyIntegrals of_polynomial(const std::array<Point, 3>& w, const Complex& z) {
  const Complex log = std::log(z) - std::log(z - 1.0), log1 = 1.0 / z - 1.0 / (z - 1.0);
  const Complex log2 = 1.0 / ((z - 1.0) * (z - 1.0)) - 1.0 / (z * z);
  CauchyIntegrals result;
  for (int c = 0; c < 2; ++c) {
    const Complex p = w[0][c] + z * (w[1][c] + z * w[2][c]), p1 = w[1][c] + 2.0 * w[2][c] * z, p2 = 2.0 * w[2][c];
    result.value[c] = p * log - w[1][c] - w[2][c] * (z + 0.5);
    result.first[c] = p1 * log + p * log1 - w[2][c];
    result.second[c] = p2 * log + 2.0 * p1 * log1 + p * log2;
  }
  return result;
}

// Cauchy integrals (CauchyIntegrals) of w[0] s^(1/2) + w[1] s^(3/2), the opening of an element at a tip, in closed form
// with q = sqrt(z).
CauchyIntegrals of_tip(const std::array<Point, 3>& w, const Complex& z) {
  const Complex q = std::sqrt(z), log = std::log(q + 1.0) - std::log(q - 1.0);
  const Complex log1 = 1.0 / (q + 1.0) - 1.0 / (q - 1.0);
  const Complex log2 = 1.0 / ((q - 1.0) * (q - 1.0)) - 1.0 / ((q + 1.0) * (q + 1.0));
  CauchyIntegrals result;
  for (int c = 0; c < 2; ++c) {
    const double a = w[0][c], b = w[1][c];
    const Complex slope = a * (log + q * log1) + b * (q * (3.0 * q * log + q * q * log1 - 4.0));
    const Complex curvature = a * (2.0 * log1 + q * log2) + b * (6.0 * q * log + q * q * (6.0 * log1 + q * log2) - 4.0);
    result.value[c] = a * (q * log - 2.0) + b * (q * q * (q * log - 2.0) - 2.0 / 3);
    result.first[c] = slope / (2.0 * q);
    result.second[c] = (curvature - slope / q) / (4.0 * z);
  }
  return result;
}

// Cauchy integrals (CauchyIntegrals) by quadrature, for distant points, where the closed forms would be small
// differences of large numbers.
CauchyIntegrals by_quadrature(const std::array<Point, 3>& w, bool tip, const Complex& z) {
  const GaussRule& rule = gauss_rule(max_regular_points);
  CauchyIntegrals result{};
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q], s = tip ? t * t : t, weight = rule.weights[q] * (tip ? 2 * t : 1);
    const Point opening = tip ? Point(t * (w[0] + s * w[1])) : Point(w[0] + s * (w[1] + s * w[2]));
    const Complex inverse = 1.0 / (z - s);
    for (int c = 0; c < 2; ++c) {
      const Complex value = weight * opening[c] * inverse;
      result.value[c] += value;
      result.first[c] -= value * inverse;
      result.second[c] += 2.0 * value * inverse * inverse;
    }
  }
  return result;
}

}  // namespace

CrackField::CrackField(const ScaledBoundary& boundary, const CrackMesh& cracks, double nu,
                       const Eigen::VectorXd& openings)
    : nu_(nu) {
  for (const CrackElement& e : cracks.elements) {
    Point start = boundary.scaled(cracks.nodes[e.nodes[0]]), end = boundary.scaled(cracks.nodes[e.nodes[2]]);
    std::array<Point, 3> nodal;
    for (int k = 0; k < 3; ++k) nodal[k] = openings.segment<2>(2 * e.nodes[k]) / boundary.length;
    if (e.tip == TipEnd::end) {
      // An element whose tip is at its end is turned round, so that it starts at the tip: its left face becomes the
      // right one.
      std::swap(start, end);
      nodal = {-nodal[2], -nodal[1], -nodal[0]};
    }
    const Point axis = (end - start).normalized(), left = left_of(axis);
    for (Point& w : nodal) w = Point(w.dot(axis), w.dot(left));
    Piece piece{start, axis, (end - start).norm(), e.tip != TipEnd::none, e.tip == TipEnd::end, {}};
    if (piece.tip) {
      piece.terms[0] = (8 * nodal[1] - nodal[2]) / 3;
      piece.terms[1] = nodal[2] - piece.terms[0];
      piece.terms[2].setZero();
    } else {
      piece.terms = {nodal[0], 4 * nodal[1] - 3 * nodal[0] - nodal[2], 2 * (nodal[0] + nodal[2]) - 4 * nodal[1]};
    }
    pieces_.push_back(piece);
  }
}

// Adds the displacement and stress due to one crack element. They follow from derivatives of the integrals g = 1 / (4
// pi (1 - nu)) integral of w ln r over the element, for both components of the opening w, where r is the distance from
// x (Crouch and Starfield, Boundary Element Methods in Solid Mechanics, 1983, section 5.2, with the opposite sign of
// the discontinuity).
void CrackField::add(const Piece& piece, const Point& x, Value& value) const {
  const Point left = left_of(piece.axis), r = x - piece.start;
  Complex z(r.dot(piece.axis) / piece.length, r.dot(left) / piece.length);
  // A point at the tip is moved just ahead of it: the displacement would otherwise contain infinite terms times 0.
  constexpr double at_tip = 1e-24;
  if (piece.tip && std::abs(z) < at_tip) z = -at_tip;
  // The sign of zero chooses the face of the crack. A reversed element has the crack's left face on its own right.
  if (std::abs(z.imag()) <= on_crack && z.real() >= 0 && z.real() <= 1)
    z.imag(piece.reversed != right_face_ ? -0.0 : 0.0);
  constexpr double far = 3;
  const CauchyIntegrals i = std::abs(z) + std::abs(z - 1.0) > far ? by_quadrature(piece.terms, piece.tip, z)
                            : piece.tip                           ? of_tip(piece.terms, z)
                                                                  : of_polynomial(piece.terms, z);
  const double c = 1 / (4 * std::numbers::pi * (1 - nu_)), y = z.imag();
  const auto real = [&](const Complex& f) { return c * f.real(); };
  const auto minus_imaginary = [&](const Complex& f) { return -c * f.imag(); };
  // First, second and third derivatives of the potentials of the shearing component (s) and the opening component (o).
  const double sx = real(i.value[0]), sy = minus_imaginary(i.value[0]);
  const double ox = real(i.value[1]), oy = minus_imaginary(i.value[1]);
  const double sxx = real(i.first[0]), sxy = minus_imaginary(i.first[0]);
  const double oxx = real(i.first[1]), oxy = minus_imaginary(i.first[1]);
  const double sxxx = real(i.second[0]), sxxy = minus_imaginary(i.second[0]);
  const double oxxx = real(i.second[1]), oxxy = minus_imaginary(i.second[1]);
  const double along = 2 * (1 - nu_) * sy - y * sxx - (1 - 2 * nu_) * ox - y * oxy;
  const double across = (1 - 2 * nu_) * sx - y * sxy + 2 * (1 - nu_) * oy + y * oxx;
  value.displacement += along * piece.axis + across * left;

  const double factor = 2 / piece.length;
  const double xx = factor * (2 * sxy - y * sxxx - oxx - y * oxxy);
  const double yy = factor * (y * sxxx - oxx + y * oxxy);
  const double xy = factor * (-sxx - y * sxxy + y * oxxx);
  const double cos = piece.axis.x(), sin = piece.axis.y();
  value.stress += Eigen::Vector3d(cos * cos * xx + sin * sin * yy - 2 * sin * cos * xy,
                                  sin * sin * xx + cos * cos * yy + 2 * sin * cos * xy,
                                  sin * cos * (xx - yy) + (cos * cos - sin * sin) * xy);
}

CrackField::Value CrackField::at(const Point& x, int skipped) const {
  Value value;
  for (int e = 0; e < static_cast<int>(pieces_.size()); ++e)
    if (e != skipped) add(pieces_[e], x, value);
  return value;
}

CrackField::Value CrackField::anywhere(const Point& x) const {
  constexpr double at_end = 1e-6, right_beside = 1e-7, inside = 0.02;
  Value sum;
  int met = 0;
  for (const Piece& piece : pieces_) {
    for (const double end : {0.0, 1.0}) {
      if ((piece.tip && end == 0) || (piece.start + end * piece.length * piece.axis - x).norm() > at_end * piece.length)
        continue;
      const Point inwards = (1 - 2 * end) * piece.length * piece.axis;
      sum.displacement += at(x + right_beside * inwards).displacement;
      sum.stress += at(x + inside * inwards).stress;
      ++met;
    }
  }
  if (met == 0) return at(x);
  sum.displacement /= met;
  sum.stress /= met;
  return sum;
}

double CrackField::nearness_of_tip(const Point& x) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_)
    if (piece.tip) nearest = std::min(nearest, (x - piece.start).norm() / piece.length);
  return nearest;
}

}  // namespace bempd::bem

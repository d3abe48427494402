#include "linalg/analytic_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bempd::linalg {

namespace {

using Complex = std::complex<double>;

struct Box {
  double left, right, low, high;

  Complex middle() const { return {0.5 * (left + right), 0.5 * (low + high)}; }
};

// Value of a function at a place, and the magnitude of (slope / value) there. A root at the distance d adds about 1 / d
// to this magnitude, which thus shows how near roots are.
struct Sample {
  Complex place, value;
  double slope;

  Sample(const AnalyticFunction& f, const Complex& at) : place(at), value(f(at)) {
    constexpr double step = 1e-7;
    slope = std::abs((f(at + step) - value) / (step * value));
  }
};

// Change of the argument (angle) of the complex function value along the straight line between two places. The line is
// halved until no root can lie so close to it that a turn of the value is missed.
double argument_change(const AnalyticFunction& f, const Sample& from, const Sample& to, int depth) {
  constexpr double small = 0.8;
  constexpr int most_halvings = 40;
  const double change = std::arg(to.value / from.value), way = std::abs(to.place - from.place);
  if (way * std::max(from.slope, to.slope) < small || depth == most_halvings) return std::isfinite(change) ? change : 0;
  const Sample middle(f, 0.5 * (from.place + to.place));
  return argument_change(f, from, middle, depth + 1) + argument_change(f, middle, to, depth + 1);
}

// Number of roots in a box: the number of turns of the function's value around zero along the sides of the box.
int count_roots(const AnalyticFunction& f, const Box& box) {
  const std::array<Sample, 4> corners{Sample(f, {box.left, box.low}), Sample(f, {box.right, box.low}),
                                      Sample(f, {box.right, box.high}), Sample(f, {box.left, box.high})};
  double sum = 0;
  for (std::size_t side = 0; side < 4; ++side) sum += argument_change(f, corners[side], corners[(side + 1) % 4], 0);
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

// Root with the smaller real part of two roots that are close together or equal, near `start`. They are the roots of
// the parabola through three values of the function.
Complex left_of_two(const AnalyticFunction& f, const Complex& start, double reach) {
  Complex z = start;
  for (const double step : {reach, 0.3 * reach, 0.1 * reach, 0.1 * reach}) {
    const Complex value = f(z), up = f(z + step), down = f(z - step);
    const Complex slope = (up - down) / (2 * step), curvature = (up - 2.0 * value + down) / (step * step);
    const Complex root = std::sqrt(slope * slope - 2.0 * value * curvature);
    const Complex a = z + (-slope + root) / curvature, b = z + (-slope - root) / curvature;
    const Complex next = a.real() < b.real() ? a : b;
    if (!(std::abs(next - start) < 20 * reach)) return z;
    z = next;
  }
  return z;
}

// Root near `start` by Newton's method with difference quotients; `start` itself if the iteration goes farther than
// `reach`.
Complex refined(const AnalyticFunction& f, const Complex& start, double reach) {
  Complex z = start;
  for (int iteration = 0; iteration < 60; ++iteration) {
    constexpr double step = 1e-6;
    const Complex value = f(z), slope = (f(z + step) - f(z - step)) / (2 * step);
    if (slope == 0.0 || value == 0.0) break;
    const Complex change = value / slope;
    z -= change;
    if (!(std::abs(z - start) < reach)) return start;
    if (std::abs(change) < 1e-15) break;
  }
  return z;
}

}  // namespace

std::optional<Complex> leftmost_root(const AnalyticFunction& f, RealRange range, double most_imaginary) {
  // Boxes are divided at an uneven ratio, because roots often lie at half of the range, and no side of a box may go
  // through a root.
  constexpr double share = 0.4871, precise = 1e-4;
  Box box{range.from, range.to, -0.9713 * most_imaginary, most_imaginary};
  if (count_roots(f, box) <= 0) return std::nullopt;
  while (box.right - box.left > precise) {
    Box first = box;
    first.right = box.left + share * (box.right - box.left);
    if (count_roots(f, first) > 0)
      box = first;
    else
      box.left = first.right;
  }
  // The upper part of the box is taken if it has a root, so that the upper root of two conjugate roots is found.
  Box upper = box;
  upper.low = -0.37 * precise;
  if (count_roots(f, upper) > 0) box = upper;
  while (box.high - box.low > precise) {
    Box first = box;
    first.low = box.low + share * (box.high - box.low);
    if (count_roots(f, first) > 0)
      box = first;
    else
      box.high = first.low;
  }
  Complex root =
      count_roots(f, box) > 1 ? left_of_two(f, box.middle(), precise) : refined(f, box.middle(), 20 * precise);
  constexpr double imaginary_by_rounding = 1e-7;
  if (std::abs(root.imag()) < imaginary_by_rounding) root.imag(0);
  return Complex(root.real(), std::abs(root.imag()));
}

}  // namespace bempd::linalg

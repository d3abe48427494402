#include "fracture/line/williams_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elasticity/kinked_tip.hpp"
#include "linalg/least_squares.hpp"

namespace bempd::fracture {

namespace {

// Limits on the energy release rate behind a kink, over its first spacings, relative to the rate at the beginning of
// the kink.
constexpr double least_shape = 0.25, largest_shape = 4;

constexpr int most_amplitudes = 2 * WilliamsFit::most_terms;

// Stresses (xx, yy, xy) of the terms of Williams' series for unit amplitudes, at the distance r and the angle t: two
// columns for each term, modes I and II.
Eigen::Matrix<double, 3, most_amplitudes> williams_stress(double r, double t) {
  Eigen::Matrix<double, 3, most_amplitudes> stress;
  for (int n = 1; n <= WilliamsFit::most_terms; ++n) {
    const double h = n / 2.0, sign = n % 2 == 0 ? 1 : -1, scale = h * std::pow(r, h - 1);
    const double c1 = std::cos((h - 1) * t), c3 = std::cos((h - 3) * t);
    const double s1 = std::sin((h - 1) * t), s3 = std::sin((h - 3) * t);
    stress.col(2 * n - 2) << (2 + h + sign) * c1 - (h - 1) * c3, (2 - h - sign) * c1 + (h - 1) * c3,
        (h - 1) * s3 - (h + sign) * s1;
    stress.col(2 * n - 1) << (h - 1) * s3 - (2 + h - sign) * s1, (-2 + h - sign) * s1 - (h - 1) * s3,
        (h - 1) * c3 - (h - sign) * c1;
    stress.middleCols<2>(2 * n - 2) *= scale;
  }
  return stress;
}

}  // namespace

void WilliamsFit::add(double distance, double angle, const Stress& stress) {
  Eigen::Matrix<double, 3, amplitudes> terms = williams_stress(distance, angle);
  terms.rightCols(amplitudes - 2 * terms_).setZero();
  normal_ += distance * terms.transpose() * terms;
  right_ += distance * terms.transpose() * stress;
  squares_ += distance * stress.transpose() * stress;
  reach_ = std::max(reach_, distance);
}

// Amplitudes of the first terms of Williams' series by least squares. The equations of terms that are not fitted, and
// of mode II of the second term (which has no stress), are empty; the solution with the shortest vector gives such
// terms the amplitude 0.
WilliamsFit::Parts WilliamsFit::solution(int terms) const {
  if (terms >= terms_) return linalg::LeastSquares(normal_).solve(right_);
  Eigen::Matrix<double, amplitudes, amplitudes> normal = normal_;
  Parts right = right_;
  normal.rightCols(amplitudes - 2 * terms).setZero();
  normal.bottomRows(amplitudes - 2 * terms).setZero();
  right.bottomRows(amplitudes - 2 * terms).setZero();
  return linalg::LeastSquares(normal).solve(right);
}

AffineIntensity WilliamsFit::factors(double horizon, int terms) const {
  const Parts amplitudes_found = solution(terms);
  const double root = std::sqrt(2 * std::numbers::pi * horizon);
  return {amplitudes_found.row(0) * root, -amplitudes_found.row(1) * root};
}

double WilliamsFit::residual(double load_factor) const {
  const Eigen::Vector2d at(1, load_factor);
  const Eigen::Matrix2d left = squares_ - right_.transpose() * solution(terms_);
  const double all = at.dot(squares_ * at);
  return all > 0 ? std::sqrt(std::max(at.dot(left * at), 0.0) / all) : 0;
}

KinkShape::Factors KinkShape::of_kink(double load_factor) const {
  const Eigen::Vector2d at(1, load_factor);
  return {kinked_factors({factors_.one.dot(at), factors_.two.dot(at)}, angle_),
          t_stress_.dot(at) * kink_growth(angle_)};
}

double KinkShape::mean(double length, double load_factor) const {
  const auto [first, growing] = of_kink(load_factor);
  const double all = first.squaredNorm();
  const double grown = 4.0 / 3 * first.dot(growing) * std::sqrt(length) + growing.squaredNorm() * length / 2;
  return all > 0 ? std::clamp(1 + grown / all, least_shape, largest_shape) : 1;
}

double KinkShape::at(double length, double load_factor) const {
  const auto [first, growing] = of_kink(load_factor);
  const double all = first.squaredNorm();
  return all > 0 ? std::clamp((first + std::sqrt(length) * growing).squaredNorm() / all, least_shape, largest_shape)
                 : 1;
}

}  // namespace bempd::fracture

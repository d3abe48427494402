#pragma once

#include <Eigen/Core>

namespace bempd::fracture {

// Stress intensity factors, each with a constant part and one that is proportional to the load factor [Pa m^(1/2)].
struct AffineIntensity {
  Eigen::RowVector2d one{0, 0}, two{0, 0};
};

// Least-squares fit of Williams' series (J. Appl. Mech. 24, 1957) to stresses around a tip: the terms r^(-1/2), 1,
// r^(1/2) and so on of both modes. Stresses have a constant and a proportional part.
class WilliamsFit {
 public:
  static constexpr int most_terms = 5;
  using Stress = Eigen::Matrix<double, 3, 2>;  // xx, yy, xy along the tip's direction

  explicit WilliamsFit(int terms) : terms_(terms) {}

  // Adds the stress of a point at a distance, in horizons, and an angle from the tip's direction.
  void add(double distance, double angle, const Stress& stress);

  // Factors from the first so many terms, at most those that were fitted.
  AffineIntensity factors(double horizon, int terms = most_terms) const;

  // What the fitted terms leave of the stress, as a share of it, at a load factor: little where the field is that of
  // the tip alone.
  double residual(double load_factor) const;

 private:
  static constexpr int amplitudes = 2 * most_terms;
  using Parts = Eigen::Matrix<double, amplitudes, 2>;
  Parts solution(int terms) const;

  int terms_;
  Eigen::Matrix<double, amplitudes, amplitudes> normal_ = Eigen::Matrix<double, amplitudes, amplitudes>::Zero();
  Parts right_ = Parts::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();  // of the stress
};

}  // namespace bempd::fracture

#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"

namespace bempd::fracture {

// Stress intensity factors K_I (`one`) and K_II (`two`), each with a constant part and a part proportional to the load
// factor [Pa m^(1/2)].
struct AffineIntensity {
  Eigen::RowVector2d one{0, 0}, two{0, 0};
};

// Least-squares fit of Williams' series (J. Appl. Mech. 24, 1957) to stresses around a tip: terms r^(-1/2), 1, r^(1/2)
// and so on of both modes, with the distance r from the tip. Stresses have a constant and a proportional part.
class WilliamsFit {
 public:
  static constexpr int most_terms = 5;
  using Stress = Eigen::Matrix<double, 3, 2>;  // xx, yy, xy along the tip's direction

  explicit WilliamsFit(int terms) : terms_(terms) {}

  // Adds the stress of a point at a distance (in horizons) from the tip and an angle from the tip's direction.
  void add(double distance, double angle, const Stress& stress);

  // Stress intensity factors from the first `terms` terms of the series, or from all fitted terms if these are fewer.
  AffineIntensity factors(double horizon, int terms = most_terms) const;

  // T-stress: the part of the stress along the tip's direction that is independent of the distance; constant and
  // proportional part.
  Eigen::RowVector2d t_stress() const { return 4 * solution(terms_).row(2); }

  // Distance from the tip to the farthest point of the fit [horizons].
  double reach() const { return reach_; }

  // Residual at a load factor: the part of the stress that the fitted terms do not describe, as a share of the stress.
  // The residual is small if the stress field is that of the tip alone.
  double residual(double load_factor) const;

 private:
  static constexpr int amplitudes = 2 * most_terms;
  using Parts = Eigen::Matrix<double, amplitudes, 2>;
  Parts solution(int terms) const;

  int terms_;
  double reach_ = 0;
  Eigen::Matrix<double, amplitudes, amplitudes> normal_ = Eigen::Matrix<double, amplitudes, amplitudes>::Zero();
  Parts right_ = Parts::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();  // sums of squares of the stress
};

// Change of the energy release rate over the first spacings of a kink, as the square of stress intensity factors that
// change with the square root of the kink's length. The rate is constant without a kink, or if nothing is known of the
// tip.
class KinkShape {
 public:
  KinkShape() = default;
  // Shape of a kink by which a tip turns by `angle`. `factors` (stress intensity) and `t_stress` belong to the tip
  // before the turn.
  KinkShape(const AffineIntensity& factors, const Eigen::RowVector2d& t_stress, double angle)
      : factors_(factors), t_stress_(t_stress), angle_(angle) {}

  // Ratio of the energy release rate, as the mean over a length of a kink, to the rate of a kink of zero length.
  double mean(double length, double load_factor) const;
  // Ratio of the energy release rate at the end of a length of a kink to the rate of a kink of zero length.
  double at(double length, double load_factor) const;

 private:
  struct Factors {
    Point first, growing;  // at zero length, and increase with the square root of the length
  };
  Factors of_kink(double load_factor) const;

  AffineIntensity factors_;
  Eigen::RowVector2d t_stress_{0, 0};
  double angle_ = 0;
};

}  // namespace bempd::fracture

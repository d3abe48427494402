#pragma once

#include <Eigen/Core>

#include "geometry/point.hpp"

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

  // Stress along the tip's direction that does not fall with the distance, its constant and proportional part.
  Eigen::RowVector2d t_stress() const { return 4 * solution(terms_).row(2); }

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

// How the energy release rate of a kink changes over its first spacings: like the square of factors that grow with the
// root of its length. Without a kink, or where nothing is known of the tip, it does not.
class KinkShape {
 public:
  KinkShape() = default;
  // `factors` and `t_stress` of the tip before it turns by `angle`; `is_hoop`: whether the hoop stress says when it
  // does.
  KinkShape(const AffineIntensity& factors, const Eigen::RowVector2d& t_stress, double angle, bool is_hoop)
      : factors_(factors), t_stress_(t_stress), angle_(angle), is_hoop_(is_hoop) {}

  // Rates over that of a kink of no length: their mean over a length, and at its end.
  double mean(double length, double load_factor) const;
  double at(double length, double load_factor) const;
  // Equivalent factor of the criterion over the one that belongs to the energy release rate.
  double of_criterion(double load_factor) const;

 private:
  struct Factors {
    Point first, growing;  // at no length, and what comes with the root of the length
  };
  Factors of_kink(double load_factor) const;

  AffineIntensity factors_;
  Eigen::RowVector2d t_stress_{0, 0};
  double angle_ = 0;
  bool is_hoop_ = false;
};

}  // namespace bempd::fracture

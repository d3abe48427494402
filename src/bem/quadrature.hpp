#pragma once

#include <array>
#include <vector>

namespace bempd::bem {

// Gauss-Legendre rule on [0, 1]. `log_weights` belong to the same points and integrate f(s) ln(s), exactly when f is a
// polynomial of a degree below the number of points.
struct GaussRule {
  std::vector<double> points, weights, log_weights;
};

inline constexpr int max_gauss_points = 32;

// Gauss rule with this many points; it is built once, and the reference stays valid.
const GaussRule& gauss_rule(int point_count);

// Size rho (sum of the semi-axes) of the largest ellipse with foci +-1 in which an integrand on [-1, 1] is analytic.
// `sum_of_distances` is the sum of the distances of the integrand's nearest singularity from -1 and 1.
double ellipse_size(double sum_of_distances);

// Number n of points that a Gauss rule needs for the relative error `tolerance`. The error falls like rho^(-2 n), where
// rho is the size `ellipse` (ellipse_size()).
int gauss_points_needed(double ellipse, double tolerance);

// Numbers of points of the Gauss rules for smooth integrals; only a few, so that they can be tabulated for every
// element.
inline constexpr std::array<int, 8> regular_point_counts{4, 5, 6, 7, 8, 10, 12, 16};
inline constexpr int max_regular_points = 16;

// Index in `regular_point_counts` of the smallest number of points that is enough; the length of that list if none is
// enough.
int regular_rule(int points_needed);

// Choice of a Gauss rule, with the same result as gauss_points_needed() and regular_rule(), but by tabulated limits
// instead of a logarithm.
class RegularRules {
 public:
  explicit RegularRules(double tolerance);
  // Smallest sum of a singularity's distances from the ends for which the rule with most points is enough.
  double least_sum() const { return least_sum_.back(); }
  // Index of the rule for a singularity with this sum of distances from the ends (as in ellipse_size()).
  int rule(double sum_of_distances) const {
    int index = 0;
    while (index < static_cast<int>(least_sum_.size()) && sum_of_distances < least_sum_[index]) ++index;
    return index;
  }

 private:
  std::array<double, regular_point_counts.size()> least_sum_;
};

}  // namespace bempd::bem

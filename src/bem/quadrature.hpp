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

// Rule with this many points; it is built once, and the reference stays valid.
const GaussRule& gauss_rule(int point_count);

// Size rho of the largest ellipse with foci +-1 in which an integrand on [-1, 1] is analytic, from the sum of the
// distances of its nearest singularity from both ends (in units where the interval has the length 2).
double ellipse_size(double sum_of_distances);

// Number of points that Gauss's rule needs for the relative error `tolerance`: its error falls like rho^(-2 n).
int gauss_points_needed(double ellipse, double tolerance);

// Numbers of points used for smooth integrals; they are few, so that they can be tabulated for every element.
inline constexpr std::array<int, 8> regular_point_counts{4, 5, 6, 7, 8, 10, 12, 16};
inline constexpr int max_regular_points = 16;

// Index into `regular_point_counts`; `regular_point_counts.size()` when even the largest is too small.
int regular_rule(int points_needed);

// Rule for the number of points that gauss_points_needed() returns, without a logarithm for every integral.
class RegularRules {
 public:
  explicit RegularRules(double tolerance);
  // Sum of distances for which the largest rule is just enough.
  double least_sum() const { return least_sum_.back(); }
  // Index of the rule for the argument of ellipse_size().
  int rule(double sum_of_distances) const {
    int index = 0;
    while (index < static_cast<int>(least_sum_.size()) && sum_of_distances < least_sum_[index]) ++index;
    return index;
  }

 private:
  std::array<double, regular_point_counts.size()> least_sum_;
};

}  // namespace bempd::bem

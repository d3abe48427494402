#pragma once

#include <array>
#include <complex>
#include <vector>

#include "bem/element_geometry.hpp"
#include "bem/quadrature.hpp"

namespace bempd::bem {

// Complex parameters at which an integrand over an element is not analytic.
class Singularities {
 public:
  void add(std::complex<double> xi) { at_[count_++] = xi; }

  // Sum of the distances of the nearest singularity from both ends of the interval, where the interval has the length
  // 2; infinite without singularities.
  double sum_of_distances(const Interval& interval) const;
  // Longest interval from `from` upwards for which sum_of_distances() is at least `sum` > 2.
  double longest_interval(double from, double sum) const;
  // Size of the ellipse around the interval in which the integrand is analytic.
  double ellipse(const Interval& interval) const { return ellipse_size(sum_of_distances(interval)); }

 private:
  std::array<std::complex<double>, 4> at_;
  int count_ = 0;
};

// Parameters on a circular arc, x = centre + (mid - centre) exp(i alpha xi): as a function of a complex parameter it
// passes through every place of the plane but its centre.
class ArcParameters {
 public:
  explicit ArcParameters(const ElementGeometry& arc);

  // Parameters at which the distance from the place vanishes: the one within half a turn of the arc's middle, and the
  // one a turn from there.
  std::array<std::complex<double>, 2> of(const Point& x) const;
  // Sum of distances as in Singularities, of the nearer parameter.
  double sum_of_distances(const Point& x, const Interval& interval) const;
  // Largest change of sum_of_distances() from the middle one of the places to any of them.
  double largest_change(const std::array<Point, 3>& places, const Interval& interval) const;

 private:
  Point centre_, to_mid_;
  double alpha_, radius_;
};

// Parameters at which the distance from the point x vanishes.
Singularities singularities_from(const ElementGeometry& element, const Point& x);

// Singularities of an integral over the interval of `inner` with kernels of the distance, as a function of the place x
// on `outer`. They lie where the path of integration ends, and where the parameter of `inner` is not analytic in the
// place (at the centre of an arc, the focus of a parabola). The rest of the path can be moved out of the way.
std::vector<Singularities> singularities_of_integral(const ElementGeometry& outer, const ElementGeometry& inner,
                                                     const Interval& interval);

// Singularities that remain when the distance from the element's own point xi0 is divided by |xi - xi0|.
Singularities singularities_of_chord(const ElementGeometry& element, double xi0);

// Number of points that Gauss's rule needs for the element's own functions: Jacobian and products of shape functions.
int shape_points_needed(const ElementGeometry& element, const Interval& interval, double tolerance);

}  // namespace bempd::bem

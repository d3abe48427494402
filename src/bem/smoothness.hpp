#pragma once

#include <array>
#include <complex>
#include <vector>

#include "bem/element_geometry.hpp"
#include "bem/quadrature.hpp"

namespace bempd::bem {

// Singularities of an integrand over an element: complex parameters at which the integrand is not analytic.
class Singularities {
 public:
  void add(std::complex<double> xi) { at_[count_++] = xi; }

  // Least sum of the distances of a singularity from both ends of the interval, in units of half the interval's length;
  // infinite without singularities.
  double sum_of_distances(const Interval& interval) const;
  // Longest interval that begins at `from` and whose sum_of_distances() is at least `sum`. `sum` must be larger than 2,
  // the value for a singularity on the interval itself.
  double longest_interval(double from, double sum) const;
  // Size of the ellipse around the interval in which the integrand is analytic (ellipse_size()).
  double ellipse(const Interval& interval) const { return ellipse_size(sum_of_distances(interval)); }

 private:
  std::array<std::complex<double>, 4> at_;
  int count_ = 0;
};

// Complex parameters on a circular arc, x = centre + (mid - centre) exp(i alpha xi), where alpha is half the arc's
// angle. With complex xi this reaches every place of the plane but the centre.
class ArcParameters {
 public:
  explicit ArcParameters(const ElementGeometry& arc);

  // Complex parameters at which the distance from x vanishes: the parameter within half a turn of the arc's middle, and
  // the next parameter, a full turn away.
  std::array<std::complex<double>, 2> of(const Point& x) const;
  // Sum of the distances from the complex parameter of the place x to both ends of the interval, in units of half the
  // interval's length. Of the two parameters that of() finds for x, the nearer one counts.
  double sum_of_distances(const Point& x, const Interval& interval) const;
  // Upper bound on the change of sum_of_distances() between places[1] and either of the other two places; infinite if
  // the arc's centre is too near.
  double largest_change(const std::array<Point, 3>& places, const Interval& interval) const;

 private:
  Point centre_, to_mid_;
  double alpha_, radius_;
};

// Singularities of kernels of the distance from the point x to the element: parameters at which this distance vanishes.
Singularities singularities_from(const ElementGeometry& element, const Point& x);

// Singularities of an integral over an interval of `inner`, with kernels of the distance, as a function of the place on
// `outer`. They lie where the path of integration ends, and where the parameter of `inner` is not an analytic function
// of the place (at the centre of an arc, the focus of a parabola). The path between its ends causes no singularity,
// because it can be deformed away from the place.
std::vector<Singularities> singularities_of_integral(const ElementGeometry& outer, const ElementGeometry& inner,
                                                     const Interval& interval);

// Singularities that remain when the distance from the element's own point xi0 is divided by |xi - xi0|.
Singularities singularities_of_chord(const ElementGeometry& element, double xi0);

// Number of points that a Gauss rule needs for the element's own functions: Jacobian and products of shape functions.
int shape_points_needed(const ElementGeometry& element, const Interval& interval, double tolerance);

}  // namespace bempd::bem

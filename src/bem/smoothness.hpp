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

  // Distances of the nearest one from the ends of the interval, added, where the interval has the length 2; infinite
  // without singularities.
  double sum_of_distances(const Interval& interval) const;
  // The longest interval from `from` upwards for which sum_of_distances() is at least `sum` > 2.
  double longest_interval(double from, double sum) const;
  // Size of the ellipse around the interval in which the integrand is analytic.
  double ellipse(const Interval& interval) const { return ellipse_size(sum_of_distances(interval)); }

 private:
  std::array<std::complex<double>, 4> at_;
  int count_ = 0;
};

// A circular arc is x = centre + (mid - centre) exp(i alpha xi); read as complex numbers it passes through every place
// of the plane but its centre.
class ArcParameters {
 public:
  explicit ArcParameters(const ElementGeometry& arc);

  // Where the distance from the place vanishes: within half a turn of the arc's middle, and a turn from there.
  std::array<std::complex<double>, 2> of(const Point& x) const;
  // As Singularities has it, of the nearer one.
  double sum_of_distances(const Point& x, const Interval& interval) const;
  // By how much more or less that may be seen from places in the plane than from the middle one of them.
  double largest_change(const std::array<Point, 3>& places, const Interval& interval) const;

 private:
  Point centre_, to_mid_;
  double alpha_, radius_;
};

// Where the distance from the point x vanishes.
Singularities singularities_from(const ElementGeometry& element, const Point& x);

// Where a function of the place x on `outer` that is an integral over the interval of `inner`, with kernels of the
// distance, is not analytic: where the path of integration ends, and where the parameter of `inner` is not analytic in
// the place (at the centre of an arc, the focus of a parabola). The rest of the path can be moved out of the way.
std::vector<Singularities> singularities_of_integral(const ElementGeometry& outer, const ElementGeometry& inner,
                                                     const Interval& interval);

// Those that are left when the distance from the element's own point xi0 is divided by |xi - xi0|.
Singularities singularities_of_chord(const ElementGeometry& element, double xi0);

// Points that Gauss's rule needs on account of the element's own functions: Jacobian, and products of shape functions.
int shape_points_needed(const ElementGeometry& element, const Interval& interval, double tolerance);

}  // namespace bempd::bem

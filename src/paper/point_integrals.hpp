#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bem/boundary_elements.hpp"

namespace bempd::paper {

// Integrals over one element with points y, as seen from a point x, with r = y - x. The collocation blocks of the
// displacement kernel U and the traction kernel T follow from them. With e = r / |r| and the normal n at y the kernels
// are
//   weakly singular:  ln r,  (e_x^2 - e_y^2) / 2,  e_x e_y   (the last two: e e^T without its trace part),
//   double layer:     (e . n) / r,  (n x e) / r,  and (e . n) / r times the last two weakly singular kernels.
struct PointMoments {
  using Row = std::array<double, 3>;  // [node]
  std::array<Row, 3> mass{};          // times N_b(y)
  std::array<Row, 4> double_layer{};  // times N_b(y), or times N_b(y) - N_b(x) when x lies on the element
  std::int64_t evaluations = 0;       // points at which kernels were evaluated
};

// Integrates over elements, each with the relative error `tolerance`. If x is off the element, Gauss rules are used; an
// element that is too long for its distance from x is halved. If x lies on the element, r = (xi - xi0) chord, where the
// chord is smooth and does not vanish. The logarithm ln r is then the smooth ln|chord| plus ln|xi - xi0|, which a
// product rule integrates. The factor 1 / r of the double layer cancels against the difference N(y) - N(x) of shape
// functions, so that no principal value is needed.
class PointIntegrator {
 public:
  PointIntegrator(const std::vector<bem::ElementGeometry>& elements, double tolerance);

  PointMoments off_element(int element, const Point& x) const;
  // Integrals for a point x on the element, at the parameter xi0, -1 <= xi0 <= 1.
  PointMoments on_element(int element, double xi0) const;

 private:
  std::vector<bem::ElementGeometry> elements_;
  double tolerance_;
  std::vector<std::array<bem::ElementPoints, bem::regular_point_counts.size()>> whole_;  // tables for whole elements
};

}  // namespace bempd::paper

// A cantilever under a parabolic end shear in plane stress. Reference: S. P. Timoshenko and J. N. Goodier, Theory of
// Elasticity, 3rd ed., art. 21.
#pragma once

#include "host.hpp"

namespace host::cantilever {

constexpr double young = 100e9, poisson = 1.0 / 3, length = 1, height = 0.2, end_shear = 1e5;

// Art. 21, with the end load at x = length and the axis at mid height.
inline Vector exact_at_ratio(double x, double y_from_bottom, double ratio) {
  const double c = height / 2, y = y_from_bottom - c, inertia = 2 * c * c * c / 3;
  const double f = end_shear / (6 * young * inertia);
  return {-f * y * ((6 * length - 3 * x) * x + (2 + ratio) * (y * y - c * c)),
          f * (3 * ratio * y * y * (length - x) + (4 + 5 * ratio) * c * c * x + (3 * length - x) * x * x)};
}

inline Vector exact(double x, double y_from_bottom) { return exact_at_ratio(x, y_from_bottom, poisson); }

inline Vector end_traction(double, double y_from_bottom) {
  const double c = height / 2, y = y_from_bottom - c, inertia = 2 * c * c * c / 3;
  return {0, end_shear / (2 * inertia) * (c * c - y * y)};
}

struct Errors {
  double everywhere, interface;  // relative to the largest displacement
};

inline Errors errors(Model& model, const std::vector<int32_t>& regions, double interface_at) {
  double scale = 0, everywhere = 0, interface = 0;
  for (int32_t region : regions) {
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector e = exact(x[i][0], x[i][1]);
      const double error = std::hypot(u[i][0] - e[0], u[i][1] - e[1]);
      scale = largest({scale, std::hypot(e[0], e[1])});
      everywhere = largest({everywhere, error});
      if (std::abs(x[i][0] - interface_at) < 1e-9) interface = largest({interface, error});
    }
  }
  return {everywhere / scale, interface / scale};
}

}  // namespace host::cantilever

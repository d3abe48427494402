// A cantilever under a parabolic end shear, left half BEM, right half peridynamics, against the exact plane-stress
// field. Reference: S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed., art. 21; errors of an
// independent prototype of the same discretisation: 1.8e-4, at the interface 1.6e-5 for dx = H / 20.
#include <gtest/gtest.h>

#include "host.hpp"

namespace {

using namespace host;
constexpr double young = 100e9, poisson = 1.0 / 3, length = 1, height = 0.2, end_shear = 1e5;

// Art. 21, with the end load at x = length and the axis at mid height.
Vector exact(double x, double y_from_bottom) {
  const double c = height / 2, y = y_from_bottom - c, inertia = 2 * c * c * c / 3;
  const double f = end_shear / (6 * young * inertia);
  return {-f * y * ((6 * length - 3 * x) * x + (2 + poisson) * (y * y - c * c)),
          f * (3 * poisson * y * y * (length - x) + (4 + 5 * poisson) * c * c * x + (3 * length - x) * x * x)};
}

Vector end_traction(double, double y_from_bottom) {
  const double c = height / 2, y = y_from_bottom - c, inertia = 2 * c * c * c / 3;
  return {0, end_shear / (2 * inertia) * (c * c - y * y)};
}

struct Errors {
  double everywhere, interface;
};

Errors solve(int cells_over_height) {
  const double dx = height / cells_over_height;
  Model model;
  const int32_t id = model.add(material(young, poisson));
  const int32_t left = model.bem(id, rectangle(0, 0, length / 2, height), dx);
  const int32_t right = model.pd(id, rectangle(length / 2, 0, length, height), dx, 4);
  model.prescribe(left, 4, 0, 1, exact);
  model.traction(right, 2, end_traction);
  model.step(1);
  double scale = 0, everywhere = 0, interface = 0;
  for (int32_t region : {left, right}) {
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector e = exact(x[i][0], x[i][1]);
      const double error = std::hypot(u[i][0] - e[0], u[i][1] - e[1]);
      scale = largest({scale, std::hypot(e[0], e[1])});
      everywhere = largest({everywhere, error});
      if (std::abs(x[i][0] - length / 2) < 1e-9) interface = largest({interface, error});
    }
  }
  return {everywhere / scale, interface / scale};
}

TEST(Cantilever, boundary_elements_and_peridynamics_converge_at_second_order) {
  std::vector<double> errors;
  for (int cells : {10, 20, 40}) {
    const Errors e = solve(cells);
    std::printf("dx = H/%d: ", cells);
    report("error, anywhere", e.everywhere, cells == 20 ? 1.8e-4 : 0, "closed form; prototype at H/20");
    std::printf("dx = H/%d: ", cells);
    report("error, interface", e.interface, cells == 20 ? 1.6e-5 : 0, "closed form; prototype at H/20");
    if (!errors.empty()) {
      EXPECT_GE(report("order", std::log2(errors.back() / e.everywhere), 2, "theory of the network"), 1.9 - 2);
    }
    errors.push_back(e.everywhere);
  }
  EXPECT_LE(errors[1], 2e-4);
}

}  // namespace

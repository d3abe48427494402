// Stress at material points, from their bond forces: second order in the spacing where all bonds of a point are there,
// first order next to faces. Reference: a cantilever with a parabolic end shear, S. P. Timoshenko and J. N. Goodier,
// Theory of Elasticity, 3rd ed., art. 21: its stress is quadratic.
#include <gtest/gtest.h>

#include "cantilever.hpp"

namespace {

using namespace host;
using namespace host::cantilever;

constexpr int horizon_ratio = 4;

std::array<double, 3> exact_stress(double x, double y_from_bottom) {
  const double c = height / 2, y = y_from_bottom - c, inertia = 2 * c * c * c / 3;
  return {-end_shear * (length - x) * y / inertia, 0, end_shear / (2 * inertia) * (c * c - y * y)};
}

// Largest errors over the largest stress, by whether a point has all the bonds of the bulk.
struct StressErrors {
  double inside = 0, at_faces = 0;
};

StressErrors stress_errors(Model& model, int32_t region, double from, double dx) {
  const auto x = model.vectors(region, BEMPD_POSITION);
  const auto stress = model.field(region, BEMPD_STRESS);
  StressErrors errors;
  double scale = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto exact = exact_stress(x[i][0], x[i][1]);
    const double depth = std::min({x[i][0] - from, length - x[i][0], x[i][1], height - x[i][1]});
    // Where weights differ from the bulk's they do so near corners, within some horizons.
    double& error = depth > (horizon_ratio - 0.5) * dx ? errors.inside : errors.at_faces;
    for (std::size_t k = 0; k < 3; ++k) {
      error = largest({error, stress[3 * i + k] - exact[k]});
      scale = largest({scale, exact[k]});
    }
  }
  return {errors.inside / scale, errors.at_faces / scale};
}

StressErrors solve(int cells_over_height, bool coupled) {
  const double dx = height / cells_over_height, from = coupled ? length / 2 : 0;
  Model model;
  const int32_t id = model.add(material(young, poisson));
  const int32_t left = coupled ? model.bem(id, rectangle(0, 0, from, height), dx) : 0;
  const int32_t right = model.pd(id, rectangle(from, 0, length, height), dx, horizon_ratio);
  model.prescribe(coupled ? left : right, 4, 0, 1, exact);
  model.traction(right, 2, end_traction);
  model.step(1);
  return stress_errors(model, right, from, dx);
}

class LatticeStress : public testing::TestWithParam<bool> {};

TEST_P(LatticeStress, converges) {
  StressErrors previous;
  for (int cells : {10, 20, 40}) {
    const StressErrors errors = solve(cells, GetParam());
    std::printf("dx = H/%d: ", cells);
    report("stress error, inside", errors.inside, 0, "closed form");
    std::printf("dx = H/%d: ", cells);
    report("stress error, next to faces", errors.at_faces, 0, "closed form");
    if (cells > 10) {
      report("order, inside", std::log2(previous.inside / errors.inside), 2, "central symmetry of the bonds");
      report("order, next to faces", std::log2(previous.at_faces / errors.at_faces), 1, "one-sided bonds");
    }
    previous = errors;
  }
}

INSTANTIATE_TEST_SUITE_P(Cantilever, LatticeStress, testing::Bool(),
                         [](const auto& test) { return test.param ? "coupled" : "pd_only"; });

}  // namespace

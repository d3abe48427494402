// A plate 1.0 x 0.2 m clamped at its left end. Both clamped corners are singular, so the meshes are graded towards
// them. References: mid point of the right end, Richardson values of finite elements (P2) and boundary elements, which
// agree to 2e-6: 5.23431e-5 m under 1050 kN of tension, -5.13570e-4 m under 100 kN of uniform end shear.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "host.hpp"

namespace coupled_clamped_plate_test {
namespace {

using namespace host;
constexpr double tension = 1050e3 / 0.2, shear = 100e3 / 0.2;
constexpr double tension_reference = 5.23431e-5, shear_reference = -5.13570e-4;
constexpr const char* source = "FEM and BEM, Richardson";

struct Tip {
  double pulled, bent;
};

// The displacement of the tip under either load, one after the other on one prepared model.
Tip solve(Model& model, int32_t right) {
  const int32_t pull = model.traction(right, 2, 0, 1, BEMPD_X, 0, tension);
  const int32_t bend = model.traction(right, 2, 0, 1, BEMPD_Y, 0, 0);
  const double none = 0, down = -shear;
  model.step(1);
  Tip tip{};
  tip.pulled = model.evaluate({1, 0.1}).displacement[0];
  model.check(bempd_set_load_values(model.get(), pull, 1, nullptr, &none));
  model.check(bempd_set_load_values(model.get(), bend, 1, nullptr, &down));
  model.step(1);
  tip.bent = model.evaluate({1, 0.1}).displacement[1];
  return tip;
}

void expect_references(Tip tip) {
  EXPECT_LE(std::abs(report("tip under tension", tip.pulled, tension_reference, source)),
            claims::clamped_plate * tension_reference);
  EXPECT_LE(std::abs(report("tip under shear", tip.bent, shear_reference, source)),
            claims::clamped_plate * -shear_reference);
}

int32_t plate(Model& model, double end, double grading) {
  const int32_t region = model.bem(model.add(material(100e9, 1.0 / 3)), rectangle(0, 0, end, 0.2), 0.05);
  model.mesh(region, 1, end / 32, grading);
  model.mesh(region, 3, end / 32, grading);
  model.mesh(region, 4, 0.2 / 32, grading);
  model.fix(region, 4, BEMPD_BOTH);
  return region;
}

TEST(ClampedPlate, boundary_elements_reach_the_reference) {
  Model model;
  const int32_t region = plate(model, 1, 1.2);
  expect_references(solve(model, region));
}

TEST(ClampedPlate, boundary_elements_and_peridynamics_reach_the_reference) {
  Model model;
  plate(model, 0.5, 1.2);
  const int32_t right = model.pd(1, rectangle(0.5, 0, 1, 0.2), 0.005, 4);
  expect_references(solve(model, right));
}

// A support that acts on the whole end must carry the whole load.
TEST(ClampedPlate, the_clamp_carries_the_load) {
  Model model;
  const int32_t region = model.bem(model.add(material(100e9, 1.0 / 3)), rectangle(0, 0, 1, 0.2), 0.05);
  const int32_t clamp = model.fix(region, 4, BEMPD_BOTH);
  model.traction(region, 2, 0, 1, BEMPD_X, 0, tension);
  model.traction(region, 2, 0, 1, BEMPD_Y, 0, -shear);
  model.step(1);
  const Vector force = model.reaction(clamp);
  EXPECT_LE(std::abs(report("reaction in x", force[0], -1050e3, "equilibrium")), 1e-9 * 1050e3);
  EXPECT_LE(std::abs(report("reaction in y", force[1], 100e3, "equilibrium")), 1e-9 * 1050e3);
}

}  // namespace
}  // namespace coupled_clamped_plate_test

// Strength of a plate without a crack, pulled along x: a bond along x breaks when the strain is the critical stretch,
// so the strength is E' s_c = sqrt(64 pi / 105) sqrt(E' G0 / horizon), with s_c from the energy of the bonds across a
// plane (S. A. Silling, E. Askari, Comput. Struct. 83, 2005) and E' = E in plane stress, E / (1 - nu^2) in plane
// strain.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "host.hpp"

namespace strength_test {
namespace {

using namespace host;

constexpr double young = 7, fracture_energy = 0.3, pi = 3.14159265358979323846;

// Load at the first break over sqrt(E' G0 / horizon).
double strength(int32_t plane, double poisson, double spacing, int horizon_ratio) {
  Model model;
  bempd_material solid = material(young, poisson, plane, 2);
  solid.fracture_energy = fracture_energy;
  const int32_t plate = model.pd(model.add(solid), rectangle(0, 0, 20 * spacing, 16 * spacing), spacing, horizon_ratio);
  model.fix(plate, 4, BEMPD_X);
  model.fix_point({0, 0}, BEMPD_Y);
  model.traction(plate, 2, 0, 1, BEMPD_X, 0, 1);
  const bempd_step_report report = model.next_event(1e6);
  EXPECT_GT(report.broken_bonds, 0);
  const double modulus = plane == BEMPD_PLANE_STRESS ? young : young / (1 - poisson * poisson);
  return model.load_factor() / std::sqrt(modulus * fracture_energy / (horizon_ratio * spacing));
}

TEST(Strength, of_a_plate_without_a_crack) {
  const double reference = std::sqrt(64 * pi / 105);
  for (const int horizon_ratio : {3, 4, 6})
    for (const double spacing : {1.0, 0.01})
      for (const int32_t plane : {BEMPD_PLANE_STRESS, BEMPD_PLANE_STRAIN}) {
        const double value = strength(plane, bond_poisson(plane), spacing, horizon_ratio);
        EXPECT_LE(std::abs(report(plane == BEMPD_PLANE_STRESS ? "strength, plane stress" : "strength, plane strain",
                                  value, reference, "bonds across a plane")),
                  1e-9);
        EXPECT_TRUE(claims::strength.holds(value)) << value;
      }
}

// Bonds are softer below the ratio of bonds alone, and their critical stretch is larger.
TEST(Strength, at_other_ratios_of_poisson) {
  for (const double poisson : {-0.1, 0.2, 0.3, 0.4, 0.45})
    for (const int32_t plane : {BEMPD_PLANE_STRESS, BEMPD_PLANE_STRAIN}) {
      const double in_plane = plane == BEMPD_PLANE_STRESS ? poisson : poisson / (1 - poisson);
      const double more = std::sqrt(std::max(1.0, 1.5 * (1 - in_plane)));
      const double value = strength(plane, poisson, 1, 4);
      EXPECT_LE(std::abs(report(plane == BEMPD_PLANE_STRESS ? "strength, plane stress" : "strength, plane strain",
                                value, more * std::sqrt(64 * pi / 105), "bonds across a plane")),
                1e-9)
          << poisson;
    }
}

}  // namespace
}  // namespace strength_test

// A plate 1.0 x 0.2 m with a hole of radius 0.05 m at its centre, clamped at its left end (singular corners) and pulled
// at the other one by 1050 kN. Reference: mid point of the right end, Richardson values of finite elements and boundary
// elements. Boundary elements place and size themselves here, but for one length.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "host.hpp"

namespace curved_plate_test {
namespace {

using namespace host;

struct Solution {
  double tip;
  int64_t unknowns;
};

Solution solve(bool with_hole, double element_length, const char* grading) {
  Model model;
  model.set_text("bem.grading", grading);
  const int32_t region = model.bem(model.add(material(100e9, 1.0 / 3)), rectangle(0, 0, 1, 0.2), element_length);
  if (with_hole) model.circular_hole(region, {0.5, 0.1}, 0.05);
  model.fix(region, 4, BEMPD_BOTH);
  model.traction(region, 2, 0, 1, BEMPD_X, 0, 1050e3 / 0.2);
  model.step(1);
  return {model.evaluate({1, 0.1}).displacement[0], 2 * model.statistics().boundary_nodes};
}

double relative_error(bool with_hole, double element_length, const char* grading, int64_t limit) {
  const Solution s = solve(with_hole, element_length, grading);
  const double reference = with_hole ? 6.07911e-5 : 5.23431e-5;
  std::printf("grading %s, %d unknowns: ", grading, static_cast<int>(s.unknowns));
  EXPECT_LE(s.unknowns, limit);
  return std::abs(report(with_hole ? "plate with hole" : "plate", s.tip, reference, "FEM and BEM, Richardson")) /
         reference;
}

TEST(ClampedPlate, with_hole_reaches_the_reference_with_few_unknowns) {
  EXPECT_LE(relative_error(true, 0.025, "auto", 600), claims::plate_with_hole);
  EXPECT_PRED1([](int64_t unknowns) { return claims::plate_with_hole_unknowns.holds(static_cast<double>(unknowns)); },
               solve(true, 0.025, "auto").unknowns);
}

// The reference is known to six digits.
TEST(ClampedPlate, graded_elements_remove_the_error_of_the_singular_corners) {
  EXPECT_LE(relative_error(false, 0.1, "auto", 200), 5e-6);
  EXPECT_GE(relative_error(false, 0.1, "none", 200), 1e-4);
}

}  // namespace
}  // namespace curved_plate_test

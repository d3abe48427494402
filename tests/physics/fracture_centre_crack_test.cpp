// When the centre-cracked plate first breaks. Reference: an independent prototype of the same discretisation, load
// factor 278.607 (278.614 and 278.600 with wider lattice strips); the published example has its first damage at
// increment 278.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "fracture_scenes.hpp"

namespace fracture_centre_crack_test {
namespace {

using namespace host;

double first_break(const CentreCrack& scene) {
  BondModel model;
  build(model, scene);
  const bempd_step_report report = model.next_event(1000);
  EXPECT_EQ(report.stop_reason, BEMPD_STOP_EVENT);
  EXPECT_GT(report.broken_bonds, 0);
  return report.load_factor;
}

TEST(CentreCrack, the_initial_crack_cuts_the_bonds_that_meet_the_closed_line) {
  BondModel model;
  build(model, {});
  model.prepare();
  report("cut bonds", static_cast<double>(model.statistics().cut_bonds), 730, "independent prototype");
  EXPECT_EQ(model.statistics().cut_bonds, 730);
}

TEST(CentreCrack, first_break_is_where_the_prototype_has_it) {
  const double value = first_break({});
  EXPECT_LE(std::abs(report("first break", value, 278.607, "independent prototype")), 1e-5 * 278.607);
  EXPECT_PRED1([](double load) { return claims::first_break.holds(load); }, value);
}

TEST(CentreCrack, first_break_does_not_depend_on_the_width_of_the_lattice_strip) {
  const double reference = first_break({});
  const double prototype[2] = {278.614, 278.600};
  for (int k = 0; k < 2; ++k) {
    CentreCrack scene;
    scene.strip = k == 0 ? 10.5 : 20.5;
    const double value = first_break(scene);
    report("first break, wider strip", value, prototype[k], "independent prototype");
    EXPECT_LE(std::abs(report("first break, wider strip", value, reference, "strip of 8.5 mm")), 1e-4 * reference);
  }
}

TEST(CentreCrack, first_break_does_not_depend_on_the_outer_elements) {
  const double reference = first_break({});
  CentreCrack scene;
  scene.element_length = 2.5;
  const double value = first_break(scene);
  EXPECT_LE(std::abs(report("first break, halved elements", value, reference, "elements of 5 mm")), 1e-4 * reference);
}

// The proportional load of n increments as a constant one brings the break n increments forward.
TEST(CentreCrack, a_constant_load_brings_the_first_break_forward) {
  const CentreCrack plain = CentreCrack::small();
  const double reference = first_break(plain);
  CentreCrack shifted = plain;
  shifted.constant_openings = std::floor(0.4 * reference);
  const double value = first_break(shifted) + shifted.constant_openings;
  EXPECT_LE(std::abs(report("first break", value, reference, "linear response")), 1e-12 * reference);
}

}  // namespace
}  // namespace fracture_centre_crack_test

// Loads that a host changes while a body breaks, and what they push that can no longer resist. References: statics.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace fracture_new_loads_test {
namespace {

using namespace host;

int32_t breakable(Model& model) { return model.add(material(30e9, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3)); }

void set_load(Model& model, int32_t load, double constant, double proportional) {
  model.check(bempd_set_load_values(model.get(), load, 1, &constant, &proportional));
}

TEST(NewLoads, a_load_given_later_to_a_fragment_has_no_equilibrium_and_is_dropped) {
  Model model;
  const int32_t plate = model.pd(breakable(model), rectangle(0, 0, 10, 8), 1, 3);
  model.crack({{4.5, 0}, {4.5, 8}});
  model.fix(plate, 4, BEMPD_BOTH);
  const int32_t load = model.traction(plate, 2, 0, 1, BEMPD_X, 0, 0);
  EXPECT_EQ(model.step(1).fragments, 1);
  set_load(model, load, 0, 1e6);
  const bempd_step_report after = model.step(1);
  EXPECT_EQ(after.fragments, 1);
  EXPECT_LE(report("unbalanced force", after.residual, 0, "statics"), 1e-12);
  EXPECT_EQ(report("stored energy", after.stored_energy, 0, "no load is left"), 0);
}

TEST(NewLoads, a_point_on_rollers_that_lost_its_bonds_loses_its_load) {
  Model model;
  const int32_t block = model.pd(breakable(model), rectangle(0, 0, 8, 8), 1, 2);
  model.crack({{0, 3.5}, {0.4, 3.5}, {0.4, 4.5}, {0, 4.5}});
  model.fix(block, 1, BEMPD_Y);
  model.fix(block, 4, BEMPD_X);
  model.point_force({0, 4}, BEMPD_Y, 0, 1e3);
  model.traction(block, 3, 0, 1, BEMPD_Y, 0, 1e6);
  EXPECT_LE(report("unbalanced force", model.step(1).residual, 0, "statics"), 1e-12);
}

TEST(NewLoads, a_smaller_proportional_part_is_no_separation) {
  const CentreCrack scene = CentreCrack::small();
  Model model;
  const CentreCrackIds ids = build(model, scene);
  const double first = model.next_event(1e4).load_factor;
  const double opening = scene.opening * scene.unit, constant = 1.01 * first * opening;
  for (const auto& [support, sign] : {std::pair{ids.left_end, -1.0}, {ids.right_end, 1.0}}) {
    const double dead = sign * constant, live = sign * 1e-7 * opening;
    model.check(bempd_set_support_values(model.get(), support, 1, &dead, &live));
  }
  const bempd_step_report next = model.next_event(1e4);
  EXPECT_EQ(next.stop_reason, BEMPD_STOP_EVENT);
  EXPECT_EQ(next.separated, 0);
}

TEST(NewLoads, a_step_that_is_cancelled_while_it_prepares_the_model_stops) {
  Model model;
  const int32_t plate = model.pd(breakable(model), rectangle(0, 0, 10, 8), 1, 3);
  model.fix(plate, 4, BEMPD_BOTH);
  model.prescribe(plate, 2, 0, 1, [&](double, double) {
    bempd_request_cancel(model.get());
    return Vector{1, 0};
  });
  EXPECT_EQ(bempd_step(model.get(), 1, nullptr), BEMPD_ERROR_CANCELLED);
  EXPECT_EQ(model.load_factor(), 0);
}

}  // namespace
}  // namespace fracture_new_loads_test

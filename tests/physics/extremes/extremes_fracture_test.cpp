// Long runs, load reversal, fragments and mechanisms. References: balance of forces and energy, and elasticity.
#include <gtest/gtest.h>

#include "../fracture_scenes.hpp"

namespace extremes_fracture_test {
namespace {

using namespace host;

// A tall strip of peridynamics between two thin blocks, pulled apart with a crack at its lower end.
bempd_step_report tear_tall_strip(Model& model, int rows, double tie_band) {
  const double height = rows;
  const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
  model.bem(id, rectangle(0, 0, 4, height), 4);
  model.pd(id, rectangle(4, 0, 13, height), 1, 4);
  model.bem(id, rectangle(13, 0, 17, height), 4);
  model.crack({{8.5, 0}, {8.5, 6.5}});
  model.fix(1, 4, BEMPD_BOTH);
  model.prescribe(3, 2, BEMPD_X, 0, 1e-3);
  model.set("crack.tie_share", tie_band);
  model.set("stepping.separation_share", 0);  // to the last bond
  return model.run(1e6);
}

TEST(LongRuns, ten_thousand_breaks_keep_forces_and_energy_in_balance) {
  BondModel model;
  const bempd_step_report end = tear_tall_strip(model, 300, 0.05);
  std::printf("%lld bonds in %lld events\n", static_cast<long long>(end.total_broken_bonds),
              static_cast<long long>(end.total_events));
  EXPECT_GE(end.total_broken_bonds, 10000);
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_LE(report("residual", end.residual, 0, "equilibrium"), 1e-9);
  EXPECT_LE(report("energy balance", end.energy_balance_error, 0, "conservation of energy"), 1e-9);
}

TEST(LoadReversal, unloading_is_elastic_and_reloading_finds_the_same_state) {
  CentreCrack scene = CentreCrack::small();
  BondModel model;
  model.set_text("contact", "none");  // faces that press are no linear body
  build(model, scene);
  const double first = model.next_event(1e4).load_factor;
  const bempd_step_report loaded = model.step(1.02 * first);
  ASSERT_GT(loaded.total_broken_bonds, 0);
  const std::vector<double> u = model.displacements();

  const bempd_step_report unloaded = model.step(0);
  EXPECT_EQ(unloaded.broken_bonds, 0);
  EXPECT_LE(report("displacement without load", largest(model.displacements()) / largest(u), 0, "elasticity"), 1e-12);
  EXPECT_LE(report("stored energy without load", unloaded.stored_energy / loaded.stored_energy, 0, "elasticity"),
            1e-12);

  // Pushed together by half as much, where no bond reaches its critical stretch.
  const bempd_step_report pushed = model.step(-0.5 * first);
  EXPECT_EQ(pushed.broken_bonds, 0);
  EXPECT_LE(
      report("reversed displacement",
             largest_difference(model.displacements(), u, -0.5 * first / (1.02 * first)) / largest(u), 0, "linearity"),
      1e-12);

  const bempd_step_report again = model.step(1.02 * first);
  EXPECT_EQ(again.broken_bonds, 0);
  EXPECT_LE(report("displacement after reloading", largest_difference(model.displacements(), u) / largest(u), 0,
                   "elasticity"),
            1e-12);
  EXPECT_LE(report("energy balance", again.energy_balance_error, 0, "conservation of energy"), 1e-12);
}

// Two cracks across a strip that is pulled apart: the piece between them comes free of all supports and is held.
TEST(Fragments, a_piece_that_comes_free_is_held_and_reported) {
  BondModel model;
  const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
  model.pd(id, rectangle(0, 0, 24, 8), 1, 3);
  model.crack({{8.5, 0}, {8.5, 7.5}});
  model.crack({{15.5, 0}, {15.5, 7.5}});
  model.fix(1, 4, BEMPD_BOTH);
  model.prescribe(1, 2, BEMPD_X, 0, 1e-2);
  const bempd_step_report end = model.run(1e6);
  std::printf("%lld fragments\n", static_cast<long long>(end.fragments));
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_LE(report("residual", end.residual, 0, "equilibrium"), 1e-9);
  EXPECT_TRUE(std::isfinite(largest(model.displacements())));
}

TEST(Mechanisms, are_refused_and_the_free_motion_is_named) {
  BondModel model;
  const int32_t id = model.add(material(1, 1.0 / 3));
  model.bem(id, rectangle(0, 0, 1, 1), 0.5);
  model.pd(id, rectangle(1, 0, 2, 1), 0.125, 3);
  model.fix(1, 4, BEMPD_X);
  EXPECT_EQ(bempd_step(model.get(), 1, nullptr), BEMPD_ERROR_UNSOLVABLE);
  const std::string message = bempd_last_error(model.get());
  EXPECT_NE(message.find("translate in y"), std::string::npos) << message;
  EXPECT_NE(message.find("bempd_fix_point"), std::string::npos) << message;
}

}  // namespace
}  // namespace extremes_fracture_test

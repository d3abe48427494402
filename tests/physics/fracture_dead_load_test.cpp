// Bodies that dead loads tear off their supports. While the load is carried every event must be an equilibrium; when it
// no longer is, also because what is left of a ligament is a hinge, the run must end as separated. References: statics.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace fracture_dead_load_test {
namespace {

using namespace host;

void expect_clean_separation(Model& model, int32_t region, const bempd_step_report& end) {
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_EQ(end.separated, 1);
  EXPECT_TRUE(std::isfinite(end.work) && std::isfinite(end.stored_energy) && std::isfinite(end.released_energy));
  for (int32_t field : {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_BOND_STRETCH, BEMPD_DAMAGE})
    EXPECT_TRUE(all_finite(model.field(region, field))) << "field " << field;
  double residual = 0;
  int64_t first_unbalanced = 0;
  for (const bempd_history_entry& line : model.history()) {
    if (first_unbalanced == 0 && !(line.residual <= 1e-8)) first_unbalanced = line.event;
    residual = largest({residual, line.residual});
  }
  // A ligament about to become a hinge lets the bar swing by many times its length: that much rounding is in the
  // forces.
  EXPECT_LE(report("residual, worst event", residual, 0, "equilibrium"), 1e-8) << "first at event " << first_unbalanced;
  EXPECT_LE(report("energy balance", worst_energy_balance(model), 0, "first law"), 1e-8);
}

struct Bar {
  int horizon_ratio, length, height;
  double notch;
};

class DeadLoad : public testing::TestWithParam<Bar> {
 protected:
  // A bar held at its left end and notched from below at mid length.
  Model model;
  const Bar& bar = GetParam();
  const int32_t lattice = model.pd(model.add(material(30e9, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3)),
                                   rectangle(0, 0, bar.length, bar.height), 1, bar.horizon_ratio);
  int32_t left = 0;

  void SetUp() override {
    const double x = bar.length / 2 + 0.5;
    if (bar.notch > 0) model.crack({{x, 0}, {x, bar.notch}});
    left = model.fix(lattice, 4, BEMPD_BOTH);
  }
};

TEST_P(DeadLoad, a_pulled_bar_separates_cleanly) {
  model.traction(lattice, 2, 0, 1, BEMPD_X, 0, 1e6);
  const double load = model.next_event(1e4).load_factor * 1e6 * bar.height;
  EXPECT_LE(std::abs(report("reaction at the first event", model.reaction(left)[0], -load, "equilibrium")),
            1e-10 * load);
  expect_clean_separation(model, lattice, model.run(1e4));
}

TEST_P(DeadLoad, a_bent_bar_separates_cleanly) {
  model.point_force({static_cast<double>(bar.length), 0}, BEMPD_Y, 0, 1e6);
  expect_clean_separation(model, lattice, model.run(1e4));
}

INSTANTIATE_TEST_SUITE_P(Bars, DeadLoad,
                         testing::Values(Bar{4, 31, 12, 3.5}, Bar{3, 16, 12, 2.5}, Bar{3, 9, 6, 1.5}, Bar{4, 18, 7, 0}),
                         [](const auto& test) {
                           return std::to_string(test.param.length) + "_by_" + std::to_string(test.param.height) +
                                  "_m" + std::to_string(test.param.horizon_ratio);
                         });

// A tab on the free edge of a block is torn off by the load it carries.
// What is left of the energies is rounding of what the loads have done before.
TEST(CancellingLoads, leave_a_body_in_balance) {
  for (const double length : {10.0, 17.0, 31.0}) {
    Model model;
    const int32_t bar =
        model.bem(model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 0)), rectangle(0, 0, length, 10), 2);
    model.fix(bar, 4, BEMPD_X);
    model.fix_point({0, 0}, BEMPD_Y);
    model.traction(bar, 2, 0, 1, BEMPD_X, 3e-4, -1e-3);
    const bempd_step_report report = model.step(0.3);
    EXPECT_LE(report.energy_balance_error, 1e-9) << length;
    EXPECT_LE(std::abs(report.stored_energy), 1e-20) << length;
  }
}

TEST(DeadLoadOnTab, a_torn_off_tab_separates_cleanly) {
  Model model;
  const int32_t id = model.add(material(30e9, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
  const int32_t block = model.pd(id, {{0, 0}, {21, 0}, {21, 8}, {13, 8}, {13, 14}, {8, 14}, {8, 8}, {0, 8}}, 1, 3);
  model.fix(block, 1, BEMPD_BOTH);
  model.traction(block, 5, 0, 1, BEMPD_Y, 0, 1e6);
  const bempd_step_report end = model.run(1e4);
  EXPECT_GT(end.broken_bonds, 0);
  EXPECT_GE(end.fragments, 1);
  expect_clean_separation(model, block, end);
}

}  // namespace
}  // namespace fracture_dead_load_test

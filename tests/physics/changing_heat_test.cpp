// Temperatures of lattices that take new values. References: a bar held at both ends bears the stress -E alpha T; runs
// whose temperature goes with the load factor; and the first law for a cycle without a break.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace changing_heat_test {
namespace {

using namespace host;

constexpr double young = 1000, expansion = 1e-4, critical = 1e-3;

int32_t warm(Model& model, int32_t region, double constant, double proportional) {
  int32_t load = 0;
  model.check(bempd_add_temperature(model.get(), region, constant, proportional, &load));
  return load;
}

void set(Model& model, int32_t load, double constant) {
  model.check(bempd_set_load_values(model.get(), load, 1, &constant, nullptr));
}

bempd_step_report go(Model& model, double time) {
  bempd_step_report report;
  bempd_step_report_init(&report, sizeof report);
  model.check(bempd_step_to_values(model.get(), time, BEMPD_UNTIL_VALUES, &report));
  return report;
}

// A bar of two lattices that act as one, or of boundary elements and a lattice, 20 by 6, held along itself at its ends.
struct Bar {
  Model model;
  int32_t lower = 0, upper = 0, left = 0, heat[2] = {0, 0};

  explicit Bar(double proportional, double limit = critical, double poisson = 1.0 / 3, bool elements = false) {
    bempd_material solid = material(young, poisson, BEMPD_PLANE_STRESS, 1, limit);
    solid.thermal_expansion = expansion;
    const int32_t id = model.add(solid);
    lower = elements ? model.bem(id, rectangle(0, 0, 20, 3), 1) : model.pd(id, rectangle(0, 0, 20, 3), 1, 3);
    upper = model.pd(id, rectangle(0, 3, 20, 6), 1, 3);
    left = model.fix(lower, 4, BEMPD_X);
    for (const int32_t region : {upper, lower}) model.fix(region, 2, BEMPD_X);
    model.fix(upper, 4, BEMPD_X);
    model.fix_point({0, 0}, BEMPD_Y);
    heat[0] = warm(model, lower, 0, proportional);
    heat[1] = warm(model, upper, 0, proportional);
  }
  double pull() {  // of both supports at the left [N]
    double sum[2] = {0, 0}, moment = 0;
    double all = 0;
    for (const int32_t region : {lower, upper}) {
      model.check(bempd_edge_reaction(model.get(), region, 4, 0, 0, sum, &moment));
      all += sum[0];
    }
    return -all;
  }
};

TEST(ChangingHeat, a_held_bar_bears_the_present_temperature) {
  for (const auto& [poisson, elements] : {std::pair(1.0 / 3, false), {0.2, false}, {0.2, true}}) {
    Bar bar(0, 1, poisson, elements);
    bar.model.step(0);
    for (const double temperature : {50.0, -30.0, 0.0, 80.0}) {
      for (const int32_t load : bar.heat) set(bar.model, load, temperature);
      const bempd_step_report step = bar.model.step(0);
      EXPECT_LE(std::abs(report("pull", bar.pull(), -young * expansion * temperature * 6, "-E alpha T A")), 1e-9);
      EXPECT_LE(step.energy_balance_error, 1e-10);
      const double energy = 0.5 * young * std::pow(expansion * temperature, 2) * 120;
      EXPECT_LE(std::abs(report("stored", step.stored_energy, energy, "E (alpha T)^2 V / 2")), 1e-9);
    }
  }
}

TEST(ChangingHeat, on_a_straight_line_breaks_what_the_load_factor_breaks) {
  Bar proportional(-1), valued(0);
  proportional.model.step(15);
  for (const double time : {4.0, 9.0, 12.0, 15.0}) {
    for (const int32_t load : valued.heat) set(valued.model, load, -time);
    EXPECT_LE(go(valued.model, time).energy_balance_error, 1e-9);
  }
  const auto expected = events(proportional.model), seen = events(valued.model);
  ASSERT_GT(expected.size(), 0u);
  ASSERT_EQ(expected.size(), seen.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    EXPECT_EQ(expected[k].broken, seen[k].broken);
    EXPECT_NEAR(expected[k].load_factor, seen[k].load_factor, 1e-9 * expected[k].load_factor);
  }
}

// Two halves are warmed and cooled by columns of their own: the work of a cycle is zero.
void expect_cycle(bool elements) {
  Bar bar(1, 1, 0.25, elements);
  const std::vector<double> times{1, 2, 3, 4}, factors{40, 0, 40, -20, 10, -20, 0, 0};
  const std::vector<int32_t> kinds{BEMPD_COLUMN_LOAD, BEMPD_COLUMN_LOAD}, ids{bar.heat[0], bar.heat[1]};
  const auto run = [&](int64_t rows) {
    bempd_step_report report;
    bempd_step_report_init(&report, sizeof report);
    bar.model.check(bempd_run_program(bar.model.get(), rows, times.data(), 2, kinds.data(), ids.data(), factors.data(),
                                      BEMPD_UNTIL_VALUES, &report));
    return report;
  };
  const bempd_step_report half = run(2), whole = run(4);
  EXPECT_GT(half.stored_energy, 0);
  EXPECT_LE(std::abs(half.work - half.stored_energy), 1e-10 * half.work);
  EXPECT_LE(std::abs(report("work of a cycle", whole.work, 0, "first law")), 1e-10 * half.work);
  EXPECT_LE(std::abs(bar.pull()), 1e-9);
}

TEST(ChangingHeat, a_cycle_without_a_break_returns_its_work) {
  for (const bool elements : {false, true}) expect_cycle(elements);
}

// Boundary elements that have taken a new temperature are those that have had it from the start, cracks among them:
// cooled they open, warmed they close.
TEST(ChangingHeat, boundary_elements_with_a_crack_forget_the_temperature_before) {
  const auto bar = [](double temperature, int32_t* load) {
    auto held = std::make_unique<Model>();
    bempd_material solid = material(young, 0.2, BEMPD_PLANE_STRESS, 1, critical);
    solid.thermal_expansion = expansion;
    const int32_t region = held->bem(held->add(solid), rectangle(0, 0, 20, 6), 1);
    const double crack[] = {8, 2, 11, 4.5};
    held->check(bempd_add_crack(held->get(), 2, crack, nullptr));
    held->fix(region, 2, BEMPD_BOTH), held->fix(region, 4, BEMPD_BOTH);
    *load = warm(*held, region, temperature, 0);
    held->step(0);
    return held;
  };
  const auto tip_of = [](Model& model) {
    bempd_crack_tip tip;
    bempd_crack_tip_init(&tip, sizeof tip);
    model.check(bempd_tip(model.get(), 0, &tip));
    return tip;
  };
  int32_t load = 0, other = 0;
  const auto changing = bar(5, &load);
  for (const double temperature : {-40.0, 60.0, -10.0}) {
    set(*changing, load, temperature);
    const bempd_step_report step = changing->step(0);
    const auto fresh = bar(temperature, &other);
    const bempd_step_report expected = fresh->step(0);
    const bempd_crack_tip a = tip_of(*changing), b = tip_of(*fresh);
    const double size = std::hypot(b.stress_intensity_1, b.stress_intensity_2);
    EXPECT_NEAR(a.stress_intensity_1, b.stress_intensity_1, 1e-9 * size);
    EXPECT_NEAR(a.stress_intensity_2, b.stress_intensity_2, 1e-9 * size);
    EXPECT_EQ(a.stress_intensity_1 == 0, temperature > 0);
    EXPECT_EQ(step.closed_places, expected.closed_places);
    EXPECT_NEAR(step.stored_energy, expected.stored_energy, 1e-9 * expected.stored_energy);
    EXPECT_LE(step.energy_balance_error, 1e-10);
  }
}

int32_t never(double, int64_t, int64_t, void*) { return 1; }

TEST(ChangingHeat, a_step_that_fails_leaves_the_temperature_before) {
  Bar bar(0);
  for (const int32_t load : bar.heat) set(bar.model, load, -6);
  const double stored = go(bar.model, 1).stored_energy, pull = bar.pull();
  bar.model.check(bempd_set_progress(bar.model.get(), never, nullptr));
  for (const int32_t load : bar.heat) set(bar.model, load, -20);
  EXPECT_EQ(bempd_step_to_values(bar.model.get(), 2, BEMPD_UNTIL_VALUES, nullptr), BEMPD_ERROR_CANCELLED);
  EXPECT_EQ(bempd_step(bar.model.get(), 1, nullptr), BEMPD_ERROR_CANCELLED);
  for (const int32_t load : bar.heat) set(bar.model, load, -6);
  bar.model.check(bempd_set_progress(bar.model.get(), nullptr, nullptr));
  const bempd_step_report step = bar.model.step(1);
  EXPECT_EQ(step.events, 0);
  EXPECT_NEAR(step.stored_energy, stored, 1e-10 * stored);
  EXPECT_NEAR(step.work, stored, 1e-10 * stored);
  EXPECT_NEAR(bar.pull(), pull, 1e-10 * pull);
}

TEST(ChangingHeat, a_state_on_the_way_goes_on_with_it) {
  Bar bar(0);
  for (const int32_t load : bar.heat) set(bar.model, load, -15);
  bempd_step_report step;
  bempd_step_report_init(&step, sizeof step);
  bar.model.check(bempd_step_to_values(bar.model.get(), 1, BEMPD_UNTIL_EVENT, &step));
  ASSERT_EQ(step.stop_reason, BEMPD_STOP_EVENT);
  const auto state = bar.model.save();
  const bempd_step_report first = go(bar.model, 1);
  bar.model.restore(state);
  const bempd_step_report again = go(bar.model, 1);
  EXPECT_EQ(first.total_broken_bonds, again.total_broken_bonds);
  EXPECT_EQ(first.released_energy, again.released_energy);
}

// What a temperature does to the energy counts from that of the state, whatever the last trial's was.
TEST(ChangingHeat, trials_from_a_state_do_the_work_of_their_own_temperature) {
  const auto to = [](Bar& bar, double temperature, double time) {
    for (const int32_t load : bar.heat) set(bar.model, load, temperature);
    return go(bar.model, time);
  };
  Bar bar(0, 1);
  to(bar, -3, 1);
  const auto state = bar.model.save();
  for (const double temperature : {-9.0, 20.0, -4.0}) {
    Bar direct(0, 1);
    to(direct, -3, 1);
    bar.model.restore(state);
    const bempd_step_report trial = to(bar, temperature, 2), once = to(direct, temperature, 2);
    EXPECT_EQ(trial.work, once.work);
    EXPECT_EQ(trial.stored_energy, once.stored_energy);
    EXPECT_LE(trial.energy_balance_error, 1e-10);
  }
}

}  // namespace
}  // namespace changing_heat_test

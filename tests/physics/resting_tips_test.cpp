// Tips that do not grow: frozen ones, those that have stopped at an interface, those whose load goes back; and what a
// host is told of energy and ties where others do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host.hpp"

namespace resting_tips_test {
namespace {

using namespace host;

constexpr double far = 1e6;

bempd_material brittle(double young = 1) {
  bempd_material result = material(young, 1.0 / 3);
  result.fracture_energy = 1;
  return result;
}

// A square of lattice or boundary elements with a crack in its middle, held below and pulled up above.
constexpr double side = 24;
void describe_square(Model& model, bool lattice = true, double constant = 0, double proportional = 1,
                     double spacing = 1) {
  const int32_t id = model.add(brittle());
  const Outline outline = rectangle(0, 0, side, side);
  const int32_t region = lattice ? model.pd(id, outline, spacing, 3) : model.bem(id, outline, 2);
  model.fix(region, 1, BEMPD_BOTH);
  model.prescribe(region, 3, BEMPD_X, 0, 0);
  model.prescribe(region, 3, BEMPD_Y, constant, proportional);
  model.crack({{8, 12.3}, {16, 12.3}});
}

double load_of_growth() {
  Model model;
  describe_square(model);
  EXPECT_EQ(model.next_event(far).stop_reason, BEMPD_STOP_EVENT);
  return model.load_factor();
}

std::vector<bempd_crack_extension> extensions(const Model& model) {
  int64_t count = 0;
  model.check(bempd_extension_count(model.get(), &count));
  std::vector<bempd_crack_extension> all(static_cast<std::size_t>(count));
  for (int64_t k = 0; k < count; ++k) {
    bempd_crack_extension_init(&all[static_cast<std::size_t>(k)], sizeof(bempd_crack_extension));
    model.check(bempd_extension(model.get(), k, &all[static_cast<std::size_t>(k)]));
  }
  return all;
}

void freeze(const Model& model, int32_t end, int32_t frozen = 1) {
  model.check(bempd_set_tip_frozen(model.get(), 1, end, frozen));
}

TEST(RestingTips, bonds_around_a_tip_relax_where_the_load_falls_back) {
  const double load = load_of_growth();
  Model model;
  describe_square(model);
  EXPECT_EQ(model.step(0.95 * load).events, 0);
  EXPECT_EQ(model.step(0.4 * load).events, 0);
  EXPECT_EQ(model.step(-0.2 * load).events, 0);
  EXPECT_EQ(model.next_event(far).stop_reason, BEMPD_STOP_EVENT);
  EXPECT_NEAR(model.load_factor(), load, 1e-9 * load);

  Model constant;
  describe_square(constant, true, 0.95 * load, -1);
  EXPECT_EQ(constant.step(0.5 * load).events, 0);
}

TEST(RestingTips, frozen_tips_of_lines_stay_where_they_are) {
  const double load = load_of_growth();
  for (const char* control : {"load", "path"}) {
    Model model;
    describe_square(model);
    model.set_text("stepping.control", control);
    freeze(model, BEMPD_CRACK_START), freeze(model, BEMPD_CRACK_END);
    EXPECT_EQ(model.step(1.2 * load).events, 0);
    bempd_crack_tip tip;
    bempd_crack_tip_init(&tip, sizeof tip);
    model.check(bempd_tip(model.get(), 0, &tip));
    EXPECT_NEAR(tip.critical_load_factor, load, 1e-9 * load);
    freeze(model, BEMPD_CRACK_END, 0);
    model.run(far);
    std::vector<bempd_crack_extension> grown = extensions(model);
    std::erase_if(grown, [](const bempd_crack_extension& e) { return e.crack != 1; });  // cracks that began far away
    ASSERT_GT(grown.size(), 4u);
    for (const bempd_crack_extension& e : grown) EXPECT_EQ(e.end, BEMPD_CRACK_END);
    EXPECT_EQ(grown.back().state, BEMPD_TIP_AT_EDGE);
  }
}

TEST(RestingTips, states_say_which_tips_of_lines_are_frozen) {
  const double load = load_of_growth();
  Model model, other;
  describe_square(model), describe_square(other);
  freeze(model, BEMPD_CRACK_START), freeze(model, BEMPD_CRACK_END);
  model.step(0.5 * load);
  bempd_state* state = nullptr;
  model.check(bempd_state_save_with(model.get(), BEMPD_STATE_BODY_AND_VALUES, &state));
  const SavedState saved(state);
  other.restore(saved);
  EXPECT_EQ(other.step(1.2 * load).events, 0);
}

// A plate of two regions, side by side, with a crack from its left edge.
void describe_pair(Model& model, bool lattice_first, double second_modulus, double lattice_angle) {
  if (lattice_angle != 0) model.lattice_angle = lattice_angle;
  const int32_t first = model.add(brittle()), second = second_modulus == 1 ? first : model.add(brittle(second_modulus));
  const Outline left = rectangle(0, 0, 20, side), right = rectangle(20, 0, 40, side);
  const int32_t a = lattice_first ? model.pd(first, left, 1, 3) : model.bem(first, left, 2);
  const int32_t b = lattice_first ? model.bem(second, right, 2) : model.pd(second, right, 1, 3);
  for (const int32_t region : {a, b}) {
    model.fix(region, 1, BEMPD_BOTH);
    model.prescribe(region, 3, BEMPD_Y, 0, 1);
  }
  model.crack({{0, 12.3}, {10, 12.3}});
}

TEST(RestingTips, a_crack_that_comes_to_another_material_stops) {
  std::vector<std::string> log;
  Model model;
  model.check(bempd_set_log(
      model.get(),
      [](int32_t level, const char* words, void* user) {
        if (level == 1) static_cast<std::vector<std::string>*>(user)->emplace_back(words);
      },
      &log));
  const int32_t left = model.bem(model.add(brittle()), rectangle(0, 0, 20, side), 2);
  const int32_t right = model.bem(model.add(brittle(2)), rectangle(20, 0, 40, side), 2);
  for (const int32_t region : {left, right}) {
    model.fix(region, 1, BEMPD_BOTH);
    model.prescribe(region, 3, BEMPD_Y, 0, 1);
  }
  model.crack({{0, 12.3}, {10, 12.3}});
  EXPECT_EQ(model.run(far).stop_reason, BEMPD_STOP_CRACK_STOPPED);
  EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const std::string& line) {
    return line.find("interface of its region with another material") != std::string::npos;
  }));
  const double load = model.load_factor();
  const std::size_t grown = extensions(model).size();
  EXPECT_EQ(model.step(1.05 * load).stop_reason, BEMPD_STOP_LOAD_FACTOR);
  EXPECT_EQ(extensions(model).size(), grown);
  const SavedState saved = model.save();
  model.restore(saved);
  EXPECT_EQ(model.step(1.1 * load).stop_reason, BEMPD_STOP_LOAD_FACTOR);
}

// Material points of a turned lattice stay where they are when a crack grows into it.
TEST(RestingTips, a_crack_enters_a_turned_lattice) {
  Model model;
  describe_pair(model, false, 1, 0.3);
  const bempd_step_report report = model.run(far);
  EXPECT_NE(report.stop_reason, BEMPD_STOP_CRACK_STOPPED);
  EXPECT_GT(report.total_broken_bonds, 0);
}

TEST(RestingTips, no_bond_breaks_around_a_line_that_has_stopped) {
  Model model;
  describe_pair(model, true, 2, 0);
  EXPECT_EQ(model.run(far).stop_reason, BEMPD_STOP_CRACK_STOPPED);
  const double load = model.load_factor();
  const bempd_step_report next = model.run(1.3 * load);
  EXPECT_EQ(next.stop_reason, BEMPD_STOP_LOAD_FACTOR);
  EXPECT_EQ(next.broken_bonds, 0);
}

// The new area takes the fracture energy, of the last ligaments too; what these release beyond it becomes motion.
TEST(RestingTips, energy_of_new_area_is_apart_from_what_becomes_motion) {
  for (const bool lattice : {true, false}) {
    Model model;
    describe_square(model, lattice, 0, 1, 0.5);
    model.set_text("stepping.control", "path");
    const bempd_step_report end = model.run(far);
    EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
    double area = 0, taken = 0, released = 0;
    for (const bempd_crack_extension& e : extensions(model)) {
      area += e.length, taken += e.surface_energy, released += e.released_energy;
      EXPECT_LE(e.surface_energy, e.released_energy * (1 + 1e-9)) << e.x;
    }
    report(lattice ? "lattice: energy of new area" : "elements: energy of new area", taken / area, 1, "G0");
    EXPECT_NEAR(taken / area, 1, 0.03);
    EXPECT_NEAR(taken, end.bond_energy, 1e-9 * taken);
    EXPECT_NEAR(released, end.released_energy, 2e-3 * released);
    EXPECT_GT(released, taken);
  }
}

TEST(RestingTips, history_tells_ties) {
  for (const bool lattice : {true, false}) {
    Model model;
    describe_square(model, lattice);
    const bempd_step_report first = model.next_event(far);
    EXPECT_EQ(first.ties, 1);
    EXPECT_EQ(model.history().back().ties, 1);
  }
}

// The textbook plate in boundary elements alone: loads that balance, held at two points.
TEST(RestingTips, plate_under_dead_loads_that_balance_comes_apart) {
  for (const char* control : {"load", "path"}) {
    Model model;
    model.set_text("stepping.control", control);
    bempd_material of_plate = brittle();
    of_plate.thickness = 0.5;
    const int32_t region = model.bem(model.add(of_plate), rectangle(-1, -3, 1, 3), 0.5);
    model.crack({{-0.3, 0}, {0.3, 0}});
    model.fix_point({-1, -3}, BEMPD_BOTH), model.fix_point({1, -3}, BEMPD_Y);
    model.traction(region, 1, 0, 1, BEMPD_Y, 0, -1), model.traction(region, 3, 0, 1, BEMPD_Y, 0, 1);
    const bempd_step_report end = model.run(far);
    EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
    const double by_feddersen = 1 / std::sqrt(std::numbers::pi * 0.3 / std::cos(std::numbers::pi * 0.3 / 2));
    report("peak resistance", end.peak_resistance, by_feddersen, "Feddersen");
    EXPECT_NEAR(end.peak_resistance, by_feddersen, 3e-3);
    report("energy of new area", end.bond_energy, 1.4 * 0.5, "G0 times area");
    EXPECT_NEAR(end.bond_energy, 1.4 * 0.5, 1e-9);
    EXPECT_LT(end.released_energy, 1.2 * 0.7);
  }
}

}  // namespace
}  // namespace resting_tips_test

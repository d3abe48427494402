// The path of equilibrium: where growth is unstable the load factor falls, and each event lies exactly where the most
// stretched bond reaches its critical stretch. References: the same bonds torn at a held load factor, scaled; energies
// of single bonds; statics.
#include <gtest/gtest.h>

#include <algorithm>

#include "fracture_scenes.hpp"

namespace fracture_equilibrium_path_test {
namespace {

using namespace host;

constexpr double limit = 1e4;

std::vector<bempd_history_entry> events_of(const Model& model) {
  std::vector<bempd_history_entry> result = model.history();
  std::erase_if(result, [](const bempd_history_entry& line) { return line.event == 0; });
  return result;
}

struct Run {
  BondModel model;
  CentreCrackIds ids{};
  bempd_step_report end{};
  std::vector<bempd_history_entry> events;
};

std::unique_ptr<Run> torn(const char* control, const char* solver, CentreCrack scene) {
  auto run = std::make_unique<Run>();
  run->model.set_text("stepping.control", control);
  run->model.set_text("test.solver", solver);
  run->ids = build(run->model, scene);
  run->end = run->model.run(limit);
  run->events = events_of(run->model);
  return run;
}

double relative(double value, double reference) { return std::abs(value - reference) / std::abs(reference); }

class Path : public testing::TestWithParam<const char*> {};

TEST_P(Path, breaks_the_bonds_of_a_held_load_factor_where_each_is_critical) {
  const auto path = torn("path", GetParam(), CentreCrack::small());
  const auto load = torn("load", GetParam(), CentreCrack::small());
  ASSERT_EQ(path->events.size(), load->events.size());
  double in_load = 0, in_energy = 0, beyond = 0, of_columns = 0, of_bonds = 0;
  for (std::size_t i = 0; i < path->events.size(); ++i) {
    const bempd_history_entry &p = path->events[i], &l = load->events[i];
    EXPECT_EQ(p.total_broken_bonds, l.total_broken_bonds);
    in_load = largest({in_load, relative(p.load_factor, l.load_factor / l.stretch_ratio)});
    in_energy = largest({in_energy, std::abs(p.stored_energy - l.stored_energy / l.stretch_ratio / l.stretch_ratio) /
                                        load->events[0].stored_energy});
    beyond = largest({beyond, std::abs(p.stretch_ratio - 1)});
    of_columns = largest({of_columns, relative(l.critical_load_factor, p.load_factor)});
    of_bonds = largest({of_bonds, relative(l.bond_energy, p.released_energy)});
  }
  EXPECT_LE(report("load factors, relative", in_load, 0, "load factor over stretch ratio"), 1e-9);
  EXPECT_LE(report("energies, of the first", in_energy, 0, "energy over the ratio's square"), 1e-9);
  EXPECT_LE(report("stretch beyond the critical one", beyond, 0, "equilibrium"), 1e-9);
  EXPECT_LE(report("load factors of the columns", of_columns, 0, "the path itself"), 1e-9);
  EXPECT_LE(report("energy of bonds, columns", of_bonds, 0, "released along the path"), 1e-9);
  EXPECT_EQ(path->end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_EQ(path->end.unstable_event, 0);
  EXPECT_GT(load->end.unstable_event, 0);
  EXPECT_LE(worst_energy_balance(path->model), 1e-9);
  EXPECT_LT(path->end.released_energy, load->end.released_energy);
  EXPECT_LE(relative(path->end.bond_energy, path->end.released_energy), 1e-9);
}

TEST_P(Path, snaps_back_and_ends_at_the_load_factor_asked_for) {
  const auto whole = torn("path", GetParam(), CentreCrack::small());
  double highest = 0, fall = 0;
  for (const bempd_history_entry& line : whole->events) {
    highest = std::max(highest, line.load_factor);
    fall = std::max(fall, 1 - line.load_factor / highest);
  }
  EXPECT_GT(fall, 0.05);

  BondModel model;
  model.set_text("stepping.control", "path");
  model.set_text("test.solver", GetParam());
  build(model, CentreCrack::small());
  const bempd_step_report below = model.step(0.999 * whole->events[0].load_factor);
  EXPECT_EQ(below.events, 0);
  double lowest = 1, highest_now = 0;
  model.check(bempd_admissible_load_factors(model.get(), &lowest, &highest_now));
  EXPECT_LT(lowest, 0);
  EXPECT_LE(
      std::abs(report("highest load factor that is borne", highest_now, whole->events[0].load_factor, "first event")),
      1e-9 * highest_now);
  const bempd_step_report beyond = model.step(1.001 * highest);
  EXPECT_EQ(beyond.load_factor, 1.001 * highest);
  EXPECT_GT(beyond.events, 1);
  model.check(bempd_admissible_load_factors(model.get(), &lowest, &highest_now));
  EXPECT_GE(highest_now, 1.001 * highest);
}

// Constant loads shift the path. With them the load factor can lie below 0, and windows meet the general form.
TEST_P(Path, with_constant_loads_is_the_same_path_shifted) {
  CentreCrack scene = CentreCrack::small();
  const auto plain = torn("path", GetParam(), scene);
  scene.constant_openings = 3;
  const auto shifted = torn("path", GetParam(), scene);
  ASSERT_EQ(plain->events.size(), shifted->events.size());
  double worst = 0;
  for (std::size_t i = 0; i < plain->events.size(); ++i) {
    EXPECT_EQ(plain->events[i].total_broken_bonds, shifted->events[i].total_broken_bonds);
    worst = largest({worst, std::abs(shifted->events[i].load_factor + 3 - plain->events[i].load_factor) /
                                plain->events[0].load_factor});
  }
  EXPECT_LE(report("load factors, of the first", worst, 0, "the path without constant parts"), 1e-9);
  EXPECT_LE(worst_energy_balance(shifted->model), 1e-9);
}

// A strip held at both ends: pulled by a constant load across that no load factor along it relieves.
TEST_P(Path, ends_where_constant_loads_leave_no_load_factor) {
  BondModel model;
  model.set_text("stepping.control", "path");
  model.set_text("test.solver", GetParam());
  const int32_t lattice =
      model.pd(model.add(material(30e9, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-4)), rectangle(0, 0, 12, 8), 1, 3);
  model.fix(lattice, 1, BEMPD_BOTH);
  model.prescribe(lattice, 3, BEMPD_X, 0, 1e-6);
  model.prescribe(lattice, 3, BEMPD_Y, 0.01, 0);
  double lowest = 0, highest = 0;
  model.check(bempd_admissible_load_factors(model.get(), &lowest, &highest));
  EXPECT_GT(lowest, highest);
  const bempd_step_report end = model.step(1);
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_NO_ADMISSIBLE_LOAD);
  EXPECT_EQ(end.load_factor, 0);
  EXPECT_EQ(end.events, 0);
}

TEST_P(Path, goes_down_as_it_goes_up) {
  CentreCrack scene = CentreCrack::small();
  const auto up = torn("path", GetParam(), scene);
  scene.opening = -scene.opening;
  BondModel model;
  model.set_text("stepping.control", "path");
  model.set_text("test.solver", GetParam());
  build(model, scene);
  model.run(-limit);
  const auto down = events_of(model);
  ASSERT_EQ(down.size(), up->events.size());
  for (std::size_t i = 0; i < down.size(); ++i) {
    EXPECT_EQ(down[i].total_broken_bonds, up->events[i].total_broken_bonds);
    EXPECT_LE(relative(-down[i].load_factor, up->events[i].load_factor), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(solvers, Path, testing::Values("window", "plain"),
                         [](const auto& test) { return std::string(test.param); });

// Constant loads require a larger load factor while the faces are closed, and a smaller one while they are open.
TEST_P(Path, ends_where_faces_meet_that_turn_it_back_from_both_sides) {
  BondModel model;
  model.set_text("stepping.control", "path");
  model.set_text("test.solver", GetParam());
  const int32_t plate =
      model.pd(model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3)), rectangle(0, 0, 12, 12), 1, 3);
  model.crack({{7.037109267705256, 2.522180158802326},
               {9.44258765694589, 4.143195878445151},
               {4.5248474500477744, 5.423009189447342}});
  model.crack({{6.576823982736077, 7.740239589847834}, {3.69822575668711, 9.522464320345986}});
  model.fix(plate, 1, BEMPD_BOTH);
  model.prescribe(plate, 3, BEMPD_Y, 0, 1e-2);
  model.traction(plate, 2, 0, 1, BEMPD_X, -3.689928229926152e-4, 0);
  model.traction(plate, 4, 0, 1, BEMPD_X, 8.371661481401142e-4, 0);
  const bempd_step_report end = model.run(limit);
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_NO_ADMISSIBLE_LOAD);
  EXPECT_EQ(end.total_broken_bonds, 0);
  // Bonds are stretched too far on either side of it.
  model.set_text("stepping.control", "load");
  for (const double way : {-1e-3, 1e-3}) {
    const SavedState state = model.save();
    EXPECT_GT(model.step(end.load_factor + way).total_broken_bonds, 0);
    model.restore(state);
  }
}

TEST(PathOptions, exclude_increments) {
  BondModel model;
  build(model, CentreCrack::small());
  model.set_text("stepping.control", "path");
  model.set_text("paper.mode", "paper");
  EXPECT_EQ(bempd_step(model.get(), 1, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(model.get())).find("paper.mode"), std::string::npos);
  model.set_text("paper.mode", "event");
  EXPECT_EQ(bempd_step(model.get(), 1, nullptr), BEMPD_OK);
}

TEST(PathOptions, an_uncracked_body_bears_everything) {
  BondModel model;
  const int32_t plate = model.bem(model.add(material(1, 0.3)), rectangle(0, 0, 2, 1), 0.5);
  model.fix(plate, 4, BEMPD_BOTH);
  double lowest = 0, highest = 0;
  model.check(bempd_admissible_load_factors(model.get(), &lowest, &highest));
  EXPECT_EQ(highest, std::numeric_limits<double>::max());
  EXPECT_EQ(lowest, -highest);
  EXPECT_EQ(bempd_admissible_load_factors(model.get(), nullptr, &highest), BEMPD_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace fracture_equilibrium_path_test

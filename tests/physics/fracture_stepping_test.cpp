// How the load factor moves: linear between events, along one path however the host divides it, never back.
// References: the linearity of the elastic response and the same run in other steps.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace fracture_stepping_test {
namespace {

using namespace host;

struct Plate {
  explicit Plate(CentreCrack s = CentreCrack::small()) : scene(s), ids(build(model, scene)) {}
  std::set<BondKey> parted() { return bond_sets(model, scene, ids).parted; }
  CentreCrack scene;
  BondModel model;
  CentreCrackIds ids;
};

// Load factors of the first break and of one at which the crack has grown but still stands.
struct Reference {
  double first_break, growing;
};

const Reference& reference() {
  static const Reference found = [] {
    Plate plate;
    const double first = plate.model.next_event(1e4).load_factor;
    return Reference{first, first + 0.5 * (plate.model.run(1e4).load_factor - first)};
  }();
  return found;
}

TEST(Stepping, the_response_between_events_is_linear_and_costs_no_solution) {
  const double first = reference().first_break;
  Plate plate;
  plate.model.step(0.9 * first);
  const std::vector<double> whole = plate.model.displacements();
  const int64_t solves = plate.model.statistics().solves;
  plate.model.step(0.45 * first);
  const std::vector<double> half = plate.model.displacements();
  EXPECT_LE(report("field at half the load factor", largest_difference(half, whole, 0.5) / largest(whole), 0, "linear"),
            1e-13);
  plate.model.step(0.8 * first);
  EXPECT_EQ(plate.model.statistics().solves, solves);
}

TEST(Stepping, the_path_does_not_depend_on_the_steps) {
  const double end = std::ceil(reference().growing);
  Plate once, often, by_event;
  once.model.step(end);
  for (int n = 1; n <= 300; ++n) often.model.step(end * n / 300);
  while (by_event.model.next_event(end).stop_reason == BEMPD_STOP_EVENT) continue;
  const std::vector<Event> expected = events(once.model);
  ASSERT_GT(expected.size(), 0u);
  for (Plate* other : {&often, &by_event}) {
    const std::vector<Event> found = events(other->model);
    ASSERT_EQ(found.size(), expected.size());
    double worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].broken, expected[i].broken);
      worst = largest({worst, found[i].load_factor / expected[i].load_factor - 1});
    }
    EXPECT_LE(report("load factors of the events", worst, 0, "one step"), 1e-12);
    EXPECT_EQ(other->parted(), once.parted());
    EXPECT_EQ(other->model.load_factor(), end);
    const std::vector<double> u = once.model.displacements();
    EXPECT_LE(largest_difference(u, other->model.displacements()), 1e-10 * largest(u));
  }
}

TEST(Stepping, unloading_heals_nothing_and_breaks_nothing) {
  const double top = reference().growing;
  Plate plate;
  const bempd_step_report up = plate.model.step(top);
  ASSERT_GT(up.total_broken_bonds, 0);
  ASSERT_EQ(up.separated, 0);
  const auto broken = plate.parted();
  const std::vector<double> u = plate.model.displacements();

  const bempd_step_report down = plate.model.step(0);
  EXPECT_EQ(down.events, 0);
  EXPECT_EQ(plate.parted(), broken);
  EXPECT_EQ(down.released_energy, up.released_energy);
  EXPECT_LE(report("stored energy at no load", down.stored_energy / up.stored_energy, 0, "elastic unloading"), 1e-12);
  EXPECT_LE(report("work less release at no load", std::abs(down.work - up.released_energy) / up.work, 0, "first law"),
            1e-8);

  const bempd_step_report again = plate.model.step(top);
  EXPECT_EQ(again.events, 0);
  EXPECT_EQ(plate.parted(), broken);
  EXPECT_LE(report("field when loaded again", largest_difference(u, plate.model.displacements()) / largest(u), 0, "up"),
            1e-12);
  EXPECT_LE(std::abs(report("work when loaded again", again.work, up.work, "way up")), 1e-10 * up.work);
  EXPECT_EQ(plate.model.run(1e4).stop_reason, BEMPD_STOP_SEPARATED);
}

TEST(Stepping, constant_and_proportional_parts_add) {
  const double constant = 30, factor = 40;
  CentreCrack both_parts = CentreCrack::small();
  both_parts.constant_openings = constant;
  Plate both(both_parts), proportional;
  both.model.step(0);
  proportional.model.step(constant);
  const std::vector<double> at_zero = both.model.displacements(), dead = proportional.model.displacements();
  EXPECT_LE(report("constant part alone", largest_difference(at_zero, dead) / largest(dead), 0, "linear"), 1e-12);
  both.model.step(factor);
  proportional.model.step(constant + factor);
  const std::vector<double> sum = proportional.model.displacements();
  EXPECT_LE(report("both parts", largest_difference(both.model.displacements(), sum) / largest(sum), 0, "linear"),
            1e-12);
  EXPECT_LE(report("energy balance", worst_energy_balance(both.model), 0, "first law"), 1e-8);
}

TEST(Stepping, a_constant_load_beyond_the_first_break_breaks_at_load_factor_zero) {
  CentreCrack scene = CentreCrack::small();
  scene.constant_openings = reference().growing;
  Plate plate(scene);
  const bempd_step_report report = plate.model.step(0);
  EXPECT_GT(report.broken_bonds, 0);
  EXPECT_EQ(report.load_factor, 0);
  EXPECT_LE(report.energy_balance_error, 1e-8);
}

// The state kept before a step brings the step back.
TEST(Stepping, a_restored_state_repeats_the_step) {
  const double top = reference().growing;
  Plate plate;
  plate.model.step(0.5 * top);
  const SavedState state = plate.model.save();
  const bempd_step_report first = plate.model.step(top);
  const auto broken = plate.parted();
  plate.model.restore(state);
  EXPECT_EQ(plate.model.load_factor(), 0.5 * top);
  const bempd_step_report second = plate.model.step(top);
  EXPECT_EQ(plate.parted(), broken);
  EXPECT_EQ(second.events, first.events);
  EXPECT_LE(std::abs(report("released energy", second.released_energy, first.released_energy, "first time")),
            1e-10 * first.released_energy);
}

TEST(Stepping, a_tie_band_keeps_a_symmetric_scene_symmetric) {
  Plate exact, band;
  exact.model.set("crack.tie_share", 0.0);
  band.model.set("crack.tie_share", 1e-3);
  const bempd_step_report without = exact.model.run(1e4), with = band.model.run(1e4);
  std::printf("tie band 0: %lld events, %s; 1e-3: %lld events, %s\n", static_cast<long long>(without.total_events),
              symmetric(exact.parted()) ? "symmetric" : "not symmetric", static_cast<long long>(with.total_events),
              symmetric(band.parted()) ? "symmetric" : "not symmetric");
  EXPECT_TRUE(symmetric(band.parted()));
  EXPECT_EQ(without.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_EQ(with.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_GT(without.total_events, with.total_events);
}

}  // namespace
}  // namespace fracture_stepping_test

// Cracks in peridynamic regions with slanted and round edges: windows are the plain loop, states return, a crack runs
// into a hole and out again, and a hole's edge breaks where and when its stress says. Reference of the last:
// the largest stress in the same plate of boundary elements.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <span>

#include "host.hpp"
#include "thorough.hpp"

namespace outlined_fracture_test {
namespace {

using namespace host;

Vector turned(Vector p, double angle) {
  return {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1]};
}

// A strip with an edge crack that points at a hole below the middle; top and bottom are pulled apart.
struct Strip {
  BondModel model;
  int32_t region = 0;

  Strip(const char* solver, double angle, double ratio = 1.0 / 3) {
    model.set_text("test.solver", solver);
    const int32_t id = model.add(material(1, ratio, BEMPD_PLANE_STRESS, 1, 1e-3));
    Outline outline = rectangle(0, 0, 26, 18);
    for (Vector& p : outline) p = turned(p, angle);
    region = model.pd(id, outline, 1, 3);
    model.circular_hole(region, turned({13, 8}, angle), 3);
    model.fix(region, 1, BEMPD_BOTH);
    const Vector pull = turned({0, 0.05}, angle);
    model.prescribe(region, 3, BEMPD_X, 0, pull[0]);
    model.prescribe(region, 3, BEMPD_Y, 0, pull[1]);
    model.crack({turned({0, 8.5}, angle), turned({5, 8.5}, angle)});
  }
};

TEST(OutlinedFracture, windows_break_the_same_bonds_as_the_plain_loop) {
  for (const auto& [angle, ratio] : {std::pair(0.0, 1.0 / 3), {0.4, 1.0 / 3}, {0.4, 0.1}, {0.4, 0.45}}) {
    Strip plain("plain", angle, ratio), window("window", angle, ratio);
    const bempd_step_report a = plain.model.run(1), b = window.model.run(1);
    EXPECT_EQ(a.events, b.events);
    EXPECT_EQ(plain.model.bonds(plain.region).states, window.model.bonds(window.region).states);
    const auto first = plain.model.history(), second = window.model.history();
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t k = 0; k < first.size(); ++k)
      EXPECT_NEAR(first[k].load_factor, second[k].load_factor, 1e-9 * first[k].load_factor);
    EXPECT_LT(a.energy_balance_error, 1e-11);
  }
}

// Chords beside a mouth have other lengths than its own. An elastic plate hardly feels where in its middle the crack
// lies.
TEST(OutlinedFracture, mouths_anywhere_on_long_outlines_have_networks) {
  std::vector<double> pulls;
  const std::vector<double> mouths{0.0, 0.237, 0.513};
  for (const double mouth : std::span(mouths).first(bempd_tests::cases(2, 3))) {
    BondModel model;
    model.lattice_angle = 20 * std::numbers::pi / 180;
    const int32_t plate = model.pd(model.add(material(1, 1.0 / 3)), rectangle(0, -80, 160, 80), 1, 3);
    model.crack({{0, mouth}, {40, mouth}});
    const int32_t low = model.prescribe(plate, 1, BEMPD_Y, 0, -1), high = model.prescribe(plate, 3, BEMPD_Y, 0, 1);
    model.fix_point({160, -80}, BEMPD_X);
    model.step(1);
    pulls.push_back(model.reaction(high)[1]);
    std::printf("mouth at %g: pull %.6f\n", mouth, pulls.back());
    EXPECT_NEAR(pulls.back(), -model.reaction(low)[1], 1e-9 * pulls.back());
    EXPECT_NEAR(pulls.back(), pulls.front(), 2e-3 * pulls.front());
  }
}

TEST(OutlinedFracture, crack_runs_into_the_hole_and_out_again) {
  for (const double angle : {0.0, 0.4}) {
    Strip strip("window", angle);
    strip.model.run(1);
    const auto x = strip.model.vectors(strip.region, BEMPD_POSITION);
    const auto damage = strip.model.field(strip.region, BEMPD_DAMAGE);
    double before = 0, behind = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector p = turned(x[i], -angle);
      if (p[0] > 5.5 && p[0] < 9 && std::abs(p[1] - 8.5) < 3) before = std::max(before, damage[i]);
      if (p[0] > 17 && p[0] < 24) behind = std::max(behind, damage[i]);
    }
    EXPECT_GT(before, 0.3);
    EXPECT_GT(behind, 0.3);
  }
}

// The largest load factor until a crack has gone most of its way through a plate of one region with two vertices more,
// or of two regions with a common edge that leans from one of these to the other.
double load_across(bool divided) {
  BondModel model;
  model.set_text("test.outline_points", "always");
  const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-4));
  std::vector<Outline> parts{{{0, 0}, {8, 0}, {22, 0}, {22, 14}, {14, 14}, {0, 14}}};
  if (divided) parts = {{{0, 0}, {8, 0}, {14, 14}, {0, 14}}, {{8, 0}, {22, 0}, {22, 14}, {14, 14}}};
  std::vector<int32_t> regions;
  for (const Outline& part : parts) {
    regions.push_back(model.pd(id, part, 1, 3));
    for (const int32_t edge : divided ? std::vector<int32_t>{1} : std::vector<int32_t>{1, 2})
      model.prescribe(regions.back(), edge, BEMPD_Y, 0, -0.01);
    for (const int32_t edge : divided ? std::vector<int32_t>{3} : std::vector<int32_t>{4, 5})
      model.prescribe(regions.back(), edge, BEMPD_Y, 0, 0.01);
  }
  model.fix_point({22, 0}, BEMPD_X);
  model.crack({{0, 6.5}, {5, 6.5}});
  model.run(6);
  double damaged = 0;
  const auto x = model.vectors(regions.back(), BEMPD_POSITION);
  const auto damage = model.field(regions.back(), BEMPD_DAMAGE);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i][0] > 15 && x[i][0] < 20) damaged = std::max(damaged, damage[i]);
  EXPECT_GT(damaged, 0.3);
  double largest = 0;
  const auto history = model.history();
  for (const bempd_history_entry& entry : history)
    if (entry.bond_energy < 0.7 * history.back().bond_energy) largest = std::max(largest, entry.load_factor);
  return largest;
}

// The two regions are one body, with the same bonds as the one region.
TEST(OutlinedFracture, crack_crosses_a_common_edge) {
  const double whole = load_across(false), divided = load_across(true);
  EXPECT_LT(std::abs(report("load factor across a common edge", divided, whole, "one region")), 1e-9 * whole);
}

TEST(OutlinedFracture, state_is_returned_to) {
  Strip strip("window", 0.4);
  const ReturnedTo saved = return_from_run(strip.model, 1);
  EXPECT_EQ(strip.model.displacements(), saved.displacements);
  Strip other("window", 0.4);
  other.model.restore(saved.state);
  EXPECT_EQ(other.model.displacements(), saved.displacements);
}

// A crack along a row of the lattice, or through its points aslant, moves the lattice.
TEST(OutlinedFracture, cracks_may_lie_where_points_would_be) {
  for (const Outline& crack : {Outline{{0, 10}, {6, 10}}, Outline{{4, 6}, {8, 10}}}) {
    BondModel model;
    const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
    const int32_t region = model.pd(id, rectangle(0, 0, 26, 20), 1, 3);
    model.circular_hole(region, {17, 10}, 3);
    model.fix(region, 1, BEMPD_BOTH);
    model.prescribe(region, 3, BEMPD_Y, 0, 0.01);
    model.crack(crack);
    model.next_event(1);
    const std::vector<int32_t> states = model.bonds(region).states;
    EXPECT_GT(std::count(states.begin(), states.end(), BEMPD_BOND_CUT), 20);
  }
}

// A crack from an edge, its tip far from it: what the tip carries does not depend on where the points of the edge lie.
TEST(OutlinedFracture, tips_are_those_of_a_region_on_lattice_rows) {
  const auto tip_with = [](const char* points) {
    BondModel model;
    model.set_text("test.outline_points", points);
    const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
    const int32_t region = model.pd(id, rectangle(0, 0, 30, 30), 1, 3);
    model.fix(region, 1, BEMPD_BOTH);
    model.prescribe(region, 3, BEMPD_Y, 0, 0.005);
    model.crack({{0, 15.5}, {12.5, 15.5}});
    model.step(1);
    bempd_crack_tip tip;
    bempd_crack_tip_init(&tip, sizeof tip);
    model.check(bempd_tip(model.get(), 0, &tip));
    return tip;
  };
  const bempd_crack_tip on_rows = tip_with("slanted"), on_outline = tip_with("always");
  EXPECT_GT(on_outline.contours, 0);
  const double value = on_outline.stress_intensity_1, reference = on_rows.stress_intensity_1;
  EXPECT_LT(std::abs(report("stress intensity factor", value, reference, "on lattice rows")), 1e-3 * reference);
}

// A square plate, side 10 radii, pulled along y.
struct Plate {
  static constexpr double radius = 5, side = 50;
  static constexpr Vector centre{0.3, 0.2};
  static int32_t finish(Model& model, int32_t region) {
    const Outline outline = corners();
    model.circular_hole(region, centre, radius);
    model.traction(region, 1, 0, 1, BEMPD_Y, 0, -1);
    model.traction(region, 3, 0, 1, BEMPD_Y, 0, 1);
    model.fix_point(outline[0], BEMPD_BOTH);
    model.fix_point(outline[1], BEMPD_Y);
    return region;
  }
  static Outline corners() { return rectangle(-side / 2, -side / 2, side / 2, side / 2); }
};

double largest_stress_by_elements() {
  BondModel model;
  const int32_t id = model.add(material(1, 1.0 / 3));
  Plate::finish(model, model.bem(id, Plate::corners(), 2));
  model.step(1);
  double largest = 0;
  for (const double side : {-1.0, 1.0})
    largest = std::max(largest, model.evaluate({Plate::centre[0] + side * Plate::radius, Plate::centre[1]}).stress[1]);
  return largest;
}

TEST(OutlinedFracture, hole_breaks_where_and_when_its_edge_is_stressed_most) {
  constexpr double stretch = 1e-3;
  const double reference = stretch / largest_stress_by_elements();
  for (const double angle : {0.0, 0.35}) {
    BondModel model;
    model.lattice_angle = angle;
    const int32_t id = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, stretch));
    const int32_t region = Plate::finish(model, model.pd(id, Plate::corners(), 1, 3));
    model.next_event(1);
    EXPECT_LT(std::abs(report("load factor of the first break", model.load_factor(), reference, "boundary elements")),
              0.05 * reference);
    const Bonds bonds = model.bonds(region);
    const auto x = model.vectors(region, BEMPD_POSITION);
    for (std::size_t b = 0; b < bonds.states.size(); ++b) {
      if (bonds.states[b] == BEMPD_BOND_INTACT) continue;
      const Vector p = x[static_cast<std::size_t>(bonds.points[b][0])],
                   q = x[static_cast<std::size_t>(bonds.points[b][1])];
      EXPECT_NEAR(std::abs(0.5 * (p[0] + q[0]) - Plate::centre[0]), Plate::radius, 0.5);
      EXPECT_LT(std::abs(0.5 * (p[1] + q[1]) - Plate::centre[1]), 2);
    }
  }
}

}  // namespace
}  // namespace outlined_fracture_test

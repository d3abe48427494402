// Pressure in cracks, among bonds and with boundary elements, at rest and while they grow. References: an infinite
// plane under the pressure p in a crack of length 2a opens by 4 p a / E in its middle and has K_I = p sqrt(pi a) (I. N.
// Sneddon, Proc. R. Soc. London A 187, 1946); equilibrium; a strip between clamps, whose energy release rate does not
// depend on where its crack ends (J. R. Rice, J. Appl. Mech. 35, 1968).
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <tuple>

#include "thorough.hpp"
#include "westergaard.hpp"

namespace crack_pressure_test {
namespace {

using namespace host;

constexpr double pi = 3.14159265358979323846;

int32_t press(Model& model, double constant, double proportional) {
  int32_t load = 0;
  model.check(bempd_add_crack_pressure(model.get(), 1, constant, proportional, &load));
  return load;
}

std::vector<bempd_crack_tip> tips_of(Model& model) {
  int64_t count = 0;
  model.check(bempd_tip_count(model.get(), &count));
  std::vector<bempd_crack_tip> tips(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < tips.size(); ++k) {
    model.check(bempd_crack_tip_init(&tips[k], sizeof tips[k]));
    model.check(bempd_tip(model.get(), static_cast<int64_t>(k), &tips[k]));
  }
  return tips;
}

// The plane around a crack of half length a under the pressure 1 in it: it moves as under the tension 1 less what that
// makes without the crack.
struct PressedPlane {
  Vector centre;
  double a, direction;

  Vector displacement(double x, double y) const {
    const double c = std::cos(direction), s = std::sin(direction);
    const double along = c * (x - centre[0]) + s * (y - centre[1]), across = c * (y - centre[1]) - s * (x - centre[0]);
    const Vector pulled = CrackedPlane{a}.displacement(along, across);
    const Vector u{pulled[0] + CrackedPlane::poisson * along, pulled[1] - across};
    return {c * u[0] - s * u[1], s * u[0] + c * u[1]};
  }
};

void surround(Model& model, int32_t body, const PressedPlane& plane) {
  for (int32_t edge = 1; edge <= 4; ++edge)
    model.prescribe(body, edge, 0, 1, [plane](double x, double y) { return plane.displacement(x, y); });
}

// All that a straight cut of any direction feels is the pressure times its length.
TEST(CrackPressure, on_a_cut_has_the_resultant_of_its_length) {
  constexpr double pressure = 3, thickness = 0.5;
  for (const double rise : {0.0, 3.0, 7.0, -5.0}) {
    Model model;
    const int32_t id = model.add(material(1000, 1.0 / 3, BEMPD_PLANE_STRESS, thickness));
    const int32_t body = model.pd(id, rectangle(0, 0, 12, 20), 1, 3);
    model.crack({{0, 10.3 - rise / 2}, {12, 10.3 + rise / 2}});
    press(model, 0, pressure);
    const int32_t top = model.fix(body, 3, BEMPD_BOTH), bottom = model.fix(body, 1, BEMPD_BOTH);
    model.step(1);
    // The left face of the crack, above it, is pushed along its normal (-rise, 12).
    const auto up = model.reaction(top), down = model.reaction(bottom);
    std::printf("rise %g: ", rise);
    EXPECT_LE(std::abs(report("force up", -up[1], pressure * thickness * 12, "p L")), 1e-9);
    EXPECT_LE(std::abs(report("force along", -up[0], -pressure * thickness * rise, "p L")), 1e-9);
    EXPECT_LE(std::abs(up[0] + down[0]) + std::abs(up[1] + down[1]), 1e-9);
  }
}

// A crack in a lattice, along the rows and across their diagonals, opens as a crack in a plane that is longer by the
// distance of the effective tips: none if it grows as a line, else as all bonds across it are cut
// (docs/research/README.md).
void expect_opening_in_a_plane(const char* rule, double direction, double felt) {
  const double half = direction == 0 ? 14.5 : 10.5 * std::sqrt(2);
  const Vector centre = direction == 0 ? Vector{0, 0} : Vector{-0.25, 0.25};
  const PressedPlane plane{centre, half + felt, direction};
  const Vector arm{half * std::cos(direction), half * std::sin(direction)};
  Model model;
  model.set_text("crack.rule", rule);
  const double low = direction == 0 ? -30.5 : -30;
  const int32_t body =
      model.pd(model.add(material(CrackedPlane::young, CrackedPlane::poisson)), rectangle(-30, low, 30, -low), 1, 4);
  model.crack({{centre[0] - arm[0], centre[1] - arm[1]}, {centre[0] + arm[0], centre[1] + arm[1]}});
  press(model, 0, 1);
  surround(model, body, plane);
  model.step(1);
  std::printf("%s at %.0f degrees: ", rule, direction * 180 / pi);
  for (const bempd_crack_tip& tip : tips_of(model)) {
    const double expected = std::sqrt(pi * (half + tip.felt_ahead));
    EXPECT_LE(std::abs(report("K_I", tip.stress_intensity_1, expected, "p sqrt(pi a)")), 3e-3 * expected);
    EXPECT_LE(std::abs(tip.stress_intensity_2), 0.01 * expected);
  }
  // The opening is measured between the two points beside the middle, which are a bond apart.
  const Vector above = direction == 0 ? Vector{0, 0.5} : Vector{0, 1},
               below = direction == 0 ? Vector{0, -0.5} : Vector{0, 0};
  const auto opening = [&](const auto& displacement) {
    const Vector up = displacement(above), down = displacement(below);
    return std::hypot(up[0] - down[0], up[1] - down[1]);
  };
  const double seen = opening([&](const Vector& at) { return model.evaluate(at).displacement; });
  const double expected = opening([&](const Vector& at) { return plane.displacement(at[0], at[1]); });
  EXPECT_LE(std::abs(report("opening", seen, expected, "4 p a / E'")), 5e-3 * expected);
}

TEST(CrackPressure, among_bonds_opens_as_in_a_plane) {
  expect_opening_in_a_plane("bond", 0, 0.38);
  expect_opening_in_a_plane("bond", pi / 4, 0.3);
  expect_opening_in_a_plane("line", 0, 0);
  expect_opening_in_a_plane("line", pi / 4, 0);
}

TEST(CrackPressure, on_boundary_elements_opens_as_in_a_plane) {
  Model model;
  const int32_t body =
      model.bem(model.add(material(CrackedPlane::young, CrackedPlane::poisson)), rectangle(-3, -3, 3, 3), 0.5);
  model.crack({{-1, 0}, {1, 0}});
  press(model, 0, 1);
  surround(model, body, {{0, 0}, 1, 0});
  model.step(1);
  for (const bempd_crack_tip& tip : tips_of(model))
    EXPECT_LE(std::abs(report("K_I", tip.stress_intensity_1, std::sqrt(pi), "p sqrt(pi a)")), 1e-3);
  const double middle = 0.5;
  double opening = 0;
  model.check(bempd_crack_opening(model.get(), 1, 1, &middle, &opening, nullptr));
  EXPECT_LE(std::abs(report("opening", opening, 4, "4 p a / E'")), 4e-3);
}

// A square with cracks that cross the first one, and pressure in all of them.
struct Crossing {
  explicit Crossing(const std::vector<Outline>& cracks) : count(static_cast<int>(cracks.size())) {
    body = model.bem(model.add(material(1, 0.3)), rectangle(-5, -5, 5, 5), 2);
    for (const Outline& crack : cracks) model.crack(crack);
    model.fix_point({5, -5}, BEMPD_BOTH);
    model.fix_point({-5, -5}, BEMPD_Y);
  }
  void press_all(double constant, double proportional) {
    for (int32_t crack = 1; crack <= count; ++crack)
      model.check(bempd_add_crack_pressure(model.get(), crack, constant, proportional, nullptr));
  }
  double largest_factor() {
    double largest = 0;
    for (const bempd_crack_tip& tip : tips_of(model))
      largest = std::max(largest, std::hypot(tip.stress_intensity_1, tip.stress_intensity_2));
    return largest;
  }

  int count;
  Model model;
  int32_t body;
};

// The pressure goes through zero at a load factor at which its parts leave rounding.
TEST(CrackPressure, in_crossing_cracks_may_vanish) {
  for (const double zero : {0.7, 0.1, 3.0})
    for (const double pressure : {0.1, 0.3, 1.0 / 3}) {
      Crossing plate({{{-1.2, 0}, {1, 0}}, {{-0.4, -0.9}, {0.5, 0.8}}});
      plate.press_all(-pressure * zero, pressure);
      plate.model.step(2 * zero);
      const double open = plate.largest_factor();
      EXPECT_GT(open, 0);
      plate.model.step(zero);
      EXPECT_LE(plate.largest_factor(), 1e-9 * open) << zero << ", " << pressure;
      plate.model.step(0);
      EXPECT_LE(plate.largest_factor(), 1e-9 * open) << zero << ", " << pressure;
      plate.model.step(2 * zero);
      EXPECT_NEAR(plate.largest_factor(), open, 1e-6 * open) << zero << ", " << pressure;
    }
}

// The plate is pressed from all sides as much as from its cracks: up to rounding all faces part there at once. Half as
// much from outside leaves what half of the pressure alone does.
TEST(CrackPressure, in_crossing_cracks_may_balance_what_presses_the_plate) {
  std::vector<Outline> cracks{
      {{-2, 0}, {2, 0}},
      {{-1.1513687859789499, -0.13196344751901476}, {-1.3150834431602736, 0.8545442873842659}},
      {{-0.28682575197326676, -0.6599918542262644}, {-0.8639604228338014, 0.15665713505291323}},
      {{-0.30013404769146235, -0.7139725435997694}, {0.014245637521816262, 0.23532478259745532}},
      {{0.4494054677248073, -0.19932697734976687}, {0.490175396861202, 0.7998415834437628}},
      {{0.8316009498714297, -0.24355749860743892}, {1.4223527779223593, 0.5632958199421504}}};
  cracks.resize(bempd_tests::cases(4, 6));
  Crossing alone(cracks), plate(cracks);
  alone.press_all(0.5, 0);
  alone.model.step(1);
  const double open = alone.largest_factor();
  plate.press_all(1, 0);
  for (const auto& [edge, component, way] :
       {std::tuple(1, BEMPD_Y, 1.0), {3, BEMPD_Y, -1.0}, {2, BEMPD_X, -1.0}, {4, BEMPD_X, 1.0}})
    plate.model.traction(plate.body, edge, 0, 1, component, 0, way);
  constexpr std::array loads{1.0, 1 - 1e-15};
  for (const double balanced : std::span(loads).first(bempd_tests::cases(1, 2))) {
    plate.model.step(2);
    EXPECT_LE(plate.largest_factor(), 1e-8);
    plate.model.step(balanced);
    EXPECT_LE(plate.largest_factor(), 1e-7) << 1 - balanced;
    plate.model.step(0.5);
    EXPECT_NEAR(plate.largest_factor(), open, 1e-6 * open) << 1 - balanced;
  }
}

// A strip between clamps whose load factor is the root of the energy release rate over the fracture energy: under the
// pressure p in its crack the rate is p^2 height (1 - nu^2) / (2 E) wherever the crack ends.
struct Strip {
  static constexpr double height = 31, length = 70, start = 20.5, energy = 1e-6, nu = 1.0 / 3;
  double pressure = std::sqrt(2 * energy / (height * (1 - nu * nu)));
  Model model;
  int32_t body = 0, top = 0;

  explicit Strip(const char* control, const char* rule = "bond") {
    model.set_text("stepping.control", control);
    model.set_text("crack.rule", rule);
    bempd_material solid = material(1, nu);
    solid.fracture_energy = energy;
    body = model.pd(model.add(solid), rectangle(0, 0, length, height), 1, 3);
    model.crack({{0, height / 2}, {start, height / 2}});
    press(model, 0, pressure);
    top = model.fix(body, 3, BEMPD_BOTH);
    model.fix(body, 1, BEMPD_BOTH);
    model.prepare();
  }
};

TEST(CrackPressure, follows_a_crack_that_grows) {
  Strip strip("path");
  bempd_step_report step{};
  for (int64_t broken = 0; broken < 280; broken = step.total_broken_bonds) {
    step = strip.model.next_event(10);
    ASSERT_EQ(step.stop_reason, BEMPD_STOP_EVENT);
  }
  const bempd_crack_tip tip = tips_of(strip.model).front();
  EXPECT_TRUE(tip.x > 36 && tip.x < 52) << tip.x;
  const double rate = step.load_factor * step.load_factor * Strip::energy;
  EXPECT_EQ(tip.grown, 1);
  EXPECT_LE(std::abs(report("energy release rate", tip.energy_release_rate, rate, "Rice")), 0.03 * rate);
  // Unloaded it has back what it stored.
  strip.model.set_text("stepping.control", "load");
  step = strip.model.step(0);
  EXPECT_LE(std::abs(report("work of a cycle", step.work, step.released_energy, "released")), 1e-9 * step.work);
  EXPECT_LE(step.stored_energy, 1e-9 * step.work);
}

// A crack that grows as a line, at 1.01 times Griffith's load between clamps that move it. It stays with the load as it
// goes on: the fluid fills what the bonds had stretched, which is part of the energy that growth takes.
TEST(CrackPressure, drives_a_line) {
  Strip strip("path", "line");
  bempd_step_report step{};
  double least = 1e9, most = 0;
  for (int k = 0; k < 20; ++k) {
    step = strip.model.next_event(10);
    ASSERT_EQ(step.stop_reason, BEMPD_STOP_EVENT);
    if (k < 8) continue;
    least = std::min(least, step.load_factor);
    most = std::max(most, step.load_factor);
  }
  EXPECT_LE(std::abs(report("least load in growth", least, 1, "Griffith")), 0.03);
  EXPECT_LE(std::abs(report("largest load in growth", most, 1, "Griffith")), 0.03);
}

TEST(CrackPressure, acts_along_all_of_a_body_that_it_has_parted) {
  Strip strip("load");
  const bempd_step_report step = strip.model.step(1.8);
  const double force = strip.model.reaction(strip.top)[1] / (step.load_factor * strip.pressure);
  EXPECT_LE(std::abs(report("force on the upper part", -force, Strip::length, "p L")), 1e-9 * Strip::length);
  EXPECT_LE(step.energy_balance_error, 1e-9);
}

// The crack grows into one of two parts that other cracks have left on hinges: held parts take no pressure.
TEST(CrackPressure, stays_out_of_parts_that_are_held) {
  Model model;
  model.set_text("crack.rule", "tips");
  const int32_t lattice =
      model.pd(model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3)), rectangle(0, 0, 20, 9), 1, 3);
  model.crack({{6.75933227390331, 7.593102780025112}, {6.002266382103378, 6.543094407462361}});
  model.crack({{6.962935750236143, 1.914786296325531}, {4.097961198059981, 1.3352935842966929}});
  model.crack({{8.718961446916317, 4.809349885667971},
               {1.8333334165520219, 2.6683592963691294},
               {7.988014905591922, 2.8912982937764085}});
  model.fix(lattice, 4, BEMPD_BOTH);
  model.point_force({20, 9}, BEMPD_X, 0, 4e-3);
  press(model, 0, 1e-3);
  for (int event = 0; event < 10; ++event) EXPECT_LE(model.next_event(100).residual, 1e-9) << event;
}

// The sliver between both legs of a folded crack is held on hinges, its pressures balanced until the crack grows.
TEST(CrackPressure, lets_go_of_a_sliver_that_it_no_longer_balances) {
  Model model;
  const int32_t glass = model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
  model.set_text("contact", "none");
  model.set_text("pd.criterion", "opening");
  model.set("crack.tie_share", 0);
  const int32_t left = model.pd(glass, rectangle(0, 0, 6, 10), 1, 4);
  const int32_t right = model.pd(glass, rectangle(6, 0, 15, 10), 1, 4);
  model.crack({{11.710645904933905, 4.731467647711591},
               {8.388413248488495, 1.469794568895984},
               {11.894461906441101, 4.410706742300947}});
  model.fix(left, 4, BEMPD_BOTH);
  model.prescribe(right, 2, BEMPD_Y, 0, 0.015);
  model.traction(right, 1, 0, 1, BEMPD_Y, -3.645739402339319e-4, 0);
  press(model, 2e-4, 0);
  const bempd_step_report end = model.step(0.6);
  // The crack and one that begins at its fold reach the edges; the last ligament tears at one event.
  EXPECT_GE(end.events, 5);
  EXPECT_GT(end.total_broken_bonds, 100);
  EXPECT_LE(end.residual, 1e-9);
  EXPECT_LE(end.energy_balance_error, 1e-9);
}

}  // namespace
}  // namespace crack_pressure_test

// Pressure on edges and moments of supports. References: a disk under pressure p has the stress -p in all directions
// everywhere (Lame); equilibrium of forces and moments.
#include <gtest/gtest.h>

#include "host.hpp"

namespace pressure_test {
namespace {

using namespace host;

void press(Model& model, int32_t region, int32_t edge, const std::vector<double>& proportional) {
  model.check(bempd_add_pressure(model.get(), region, edge, 0, 1, static_cast<int64_t>(proportional.size()), nullptr,
                                 proportional.data(), nullptr));
}

double moment(Model& model, int32_t support, Vector about) {
  double value = 0;
  model.check(bempd_reaction_moment(model.get(), support, about[0], about[1], &value));
  return value;
}

TEST(Pressure, on_a_disk_is_its_stress) {
  constexpr double pressure = 3e6;
  Model model;
  const int32_t disk = model.disk(model.add(material(70e9, 0.3)), {1, 2}, 0.5, 0.1);
  for (int32_t edge = 1; edge <= 4; ++edge) press(model, disk, edge, {pressure});
  model.fix_point({0.5, 2}, BEMPD_BOTH);
  model.fix_point({1.5, 2}, BEMPD_Y);
  model.step(1);
  for (const Vector& at : {Vector{1, 2}, Vector{1.2, 2.3}, Vector{0.7, 1.8}}) {
    const auto stress = model.evaluate(at).stress;
    EXPECT_LE(std::abs(report("stress xx", stress[0], -pressure, "Lame")), 1e-5 * pressure);
    EXPECT_LE(std::abs(report("stress yy", stress[1], -pressure, "Lame")), 1e-5 * pressure);
    EXPECT_LE(std::abs(report("stress xy", stress[2], 0, "Lame")), 1e-5 * pressure);
  }
}

// Pressure pushes against the body on its boundary, in a hole and for both methods: uniform stress -p, no reactions.
TEST(Pressure, from_all_sides_and_in_a_hole_is_hydrostatic) {
  constexpr double pressure = 2e6, thickness = 0.01;
  for (const bool lattice : {false, true}) {
    Model model;
    const int32_t id = model.add(material(3e9, 1.0 / 3, BEMPD_PLANE_STRESS, thickness));
    const Outline outline = rectangle(0, 0, 1, 0.8);
    const int32_t body = lattice ? model.pd(id, outline, 0.05, 3) : model.bem(id, outline, 0.1);
    const int32_t first = model.hole(body, rectangular_hole(0.4, 0.3, 0.6, 0.5));
    for (int32_t edge = 1; edge <= 4; ++edge) press(model, body, edge, {pressure});
    for (int32_t edge = first; edge < first + 4; ++edge) press(model, body, edge, {pressure});
    const int32_t pin = model.fix_point({0, 0}, BEMPD_BOTH), roller = model.fix_point({1, 0}, BEMPD_Y);
    model.step(1);
    const auto stress = model.evaluate({0.2, 0.4}).stress;
    EXPECT_LE(std::abs(report("stress xx", stress[0], -pressure, "hydrostatic")), 1e-7 * pressure);
    EXPECT_LE(std::abs(report("stress yy", stress[1], -pressure, "hydrostatic")), 1e-7 * pressure);
    for (int32_t support : {pin, roller})
      for (double force : model.reaction(support)) EXPECT_LE(std::abs(force), 1e-7 * pressure * thickness);
  }
}

// What opens a crack is stored in the body: half of the integral of pressure times opening, in an infinite body
// pi a^2 p^2 / E (Sneddon, Proc. R. Soc. London A 187, 1946).
TEST(Pressure, in_a_crack_does_the_work_that_is_stored) {
  constexpr double a = 0.5, young = 3, thickness = 0.2;
  Model model;
  model.bem(model.add(material(young, 0.3, BEMPD_PLANE_STRESS, thickness)), rectangle(-8, -8, 8, 8), 2);
  model.crack({{-a, 0}, {a, 0}});
  model.fix_point({-8, -8}, BEMPD_BOTH);
  model.fix_point({8, -8}, BEMPD_Y);
  const double constant[] = {0.5}, proportional[] = {1.5};
  model.check(bempd_add_crack_traction(model.get(), 1, BEMPD_PRESSURE, 1, constant, proportional, nullptr));
  for (const double factor : {0.0, 1.0}) {
    const bempd_step_report done = model.step(factor);
    // Gauss's rule for Chebyshev polynomials of the second kind, whose weight is the opening of an ellipse.
    constexpr int count = 200;
    const double pi = std::acos(-1.0), pressure = constant[0] + factor * proportional[0];
    double integral = 0;
    for (int k = 1; k <= count; ++k) {
      const double angle = pi * k / (count + 1), fraction = 0.5 * (1 + std::cos(angle));
      double normal = 0;
      model.check(bempd_crack_opening(model.get(), 1, 1, &fraction, &normal, nullptr));
      integral += pi / (count + 1) * std::sin(angle) * normal * a;
    }
    const double wanted = 0.5 * thickness * pressure * integral;
    EXPECT_LE(std::abs(report("stored energy", done.stored_energy, wanted, "opening")), 2e-5 * wanted);
    EXPECT_LE(std::abs(report("work", done.work, wanted, "opening")), 2e-5 * wanted);
    EXPECT_LE(done.energy_balance_error, 1e-12);
    const double infinite = pi * a * a * pressure * pressure / young * thickness;
    EXPECT_LE(std::abs(report("stored energy", done.stored_energy, infinite, "Sneddon")), 0.02 * infinite);
  }
}

// A bar clamped on the left under a pressure on its top that grows from 0 to p.
TEST(Moment, of_a_clamp_balances_the_pressure_on_a_bar) {
  constexpr double pressure = 1e5, length = 2, thickness = 0.1;
  for (const bool lattice : {false, true}) {
    Model model;
    const int32_t id = model.add(material(3e9, 1.0 / 3, BEMPD_PLANE_STRESS, thickness));
    const Outline outline = rectangle(0, 0, length, 0.4);
    const int32_t bar = lattice ? model.pd(id, outline, 0.05, 3) : model.bem(id, outline, 0.1);
    press(model, bar, 3, {pressure, 0});  // from right to left
    const int32_t clamp = model.fix(bar, 4, BEMPD_BOTH);
    model.step(1);
    const double force = pressure * length / 2 * thickness, about_origin = force * 2 * length / 3;
    EXPECT_LE(std::abs(report("reaction", model.reaction(clamp)[1], force, "statics")), 1e-8 * force);
    EXPECT_LE(std::abs(report("moment at the clamp", moment(model, clamp, {0, 0}), about_origin, "statics")),
              1e-8 * about_origin);
    EXPECT_LE(std::abs(report("moment about the load", moment(model, clamp, {2 * length / 3, 0.4}), 0, "statics")),
              1e-8 * about_origin);
  }
}

TEST(Pressure, is_given_new_values_and_refused_where_tractions_are) {
  Model model;
  const int32_t id = model.add(material(3e9, 1.0 / 3));
  const int32_t left = model.bem(id, rectangle(0, 0, 1, 1), 0.25), right = model.bem(id, rectangle(1, 0, 2, 1), 0.25);
  const int32_t held = model.fix(left, 4, BEMPD_BOTH);
  const double first = 1e6, second = 3e6;
  int32_t load = 0;
  model.check(bempd_add_pressure(model.get(), right, 2, 0, 1, 1, nullptr, &first, &load));
  model.step(1);
  EXPECT_NEAR(model.reaction(held)[0], first, 1e-6 * first);
  model.check(bempd_set_load_values(model.get(), load, 1, nullptr, &second));
  model.step(1);
  EXPECT_NEAR(model.reaction(held)[0], second, 1e-6 * second);
  Model other;
  other.bem(other.add(material(3e9, 1.0 / 3)), rectangle(0, 0, 1, 1), 0.25);
  EXPECT_EQ(bempd_add_pressure(other.get(), 1, 9, 0, 1, 1, nullptr, &first, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_add_pressure(other.get(), 1, 1, 0, 1, 0, nullptr, &first, nullptr), BEMPD_ERROR_ARGUMENT);
  double value = 0;
  EXPECT_EQ(bempd_reaction_moment(other.get(), 1, 0, 0, &value), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_reaction_moment(model.get(), held, NAN, 0, &value), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_reaction_moment(model.get(), held, 0, 0, nullptr), BEMPD_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace pressure_test

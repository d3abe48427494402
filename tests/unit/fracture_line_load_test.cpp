// Load factors at which the tip of a line grows, against closed forms and against bisection.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "elasticity/kinked_tip.hpp"
#include "fracture/line/line_load.hpp"

namespace fracture_line_load_test {
namespace {

using namespace bempd;
using fracture::AffineIntensity;
using fracture::Control;
using fracture::LineCriterion;
using fracture::LineLoad;

constexpr KinkCriterion both[] = {KinkCriterion::hoop_stress, KinkCriterion::energy_release_rate};

AffineIntensity intensity(const Point& constant, const Point& growing) {
  return {{constant.x(), growing.x()}, {constant.y(), growing.y()}};
}

// Toughness 3 and a plane modulus of 2; factors of the fit count 1.5 times.
LineCriterion criterion_of(KinkCriterion kind, double present = 0, Control control = Control::load) {
  LineCriterion criterion{{}, 1.5, present, control};
  criterion.law.toughness = 3, criterion.law.plane_modulus = 2, criterion.law.criterion = kind;
  return criterion;
}

std::optional<LineLoad> load_of(const AffineIntensity& found, LineCriterion criterion) {
  return fracture::load_of_growth(found, found, criterion);
}

TEST(LineLoad, proportional_opening_grows_straight_on_at_the_toughness) {
  for (const KinkCriterion kind : both) {
    const LineLoad load = load_of(intensity({0, 0}, {0.25, 0}), criterion_of(kind)).value();
    EXPECT_NEAR(load.load_factor, 8, 1e-12);
    EXPECT_EQ(load.angle, 0);
    EXPECT_NEAR(load.constant + load.load_factor * load.growing, 1, 1e-12);
    EXPECT_FALSE(load_of(intensity({0, 0}, {-0.25, 0}), criterion_of(kind)));
    EXPECT_FALSE(load_of(intensity({1, 0}, {0, 0}), criterion_of(kind)));
  }
}

// K_eq = 2 / sqrt(3) K_II at -70.53 degrees by the hoop stress (Erdogan and Sih, 1963).
TEST(LineLoad, proportional_shear_turns_by_the_hoop_stress) {
  const LineLoad load = load_of(intensity({0, 0}, {0, 2}), criterion_of(both[0])).value();
  EXPECT_NEAR(load.load_factor, std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(load.angle, -std::acos(1.0 / 3), 1e-12);
}

TEST(LineLoad, of_random_tips_is_that_of_bisection_and_turns_as_told) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int k = 0; k < 100; ++k) {
    const KinkCriterion kind = both[k % 2];
    const Point constant(any(random), any(random)), growing(0.3 + std::abs(any(random)), any(random));
    const Point turning_constant(any(random), any(random)), turning_growing(any(random), any(random));
    LineCriterion criterion = criterion_of(kind);
    const std::optional<LineLoad> load =
        fracture::load_of_growth(intensity(constant, growing), intensity(turning_constant, turning_growing), criterion);
    ASSERT_TRUE(load);
    const double expected = growth_load_factor(constant, growing, 2, kind);
    EXPECT_NEAR(load->load_factor, expected, 1e-9 * expected) << k;
    EXPECT_NEAR(load->constant + expected * load->growing, 1, 1e-9) << k;
    EXPECT_NEAR(load->angle, kink_of(turning_constant + expected * turning_growing).angle, 1e-6) << k;
  }
}

// A constant load opens the tip and the growing one closes it: the tip grows at once, or never.
TEST(LineLoad, an_overloaded_tip_grows_at_the_present_load_factor_if_loads_are_held) {
  for (const KinkCriterion kind : both) {
    const AffineIntensity closing = intensity({3, 0}, {-0.5, 0});
    for (const double present : {0.0, 1.5, -4.0})
      EXPECT_EQ(load_of(closing, criterion_of(kind, present)).value().load_factor, present);
    EXPECT_FALSE(load_of(closing, criterion_of(kind, 2.5)));
    // Downwards the load factor has the opposite sign.
    EXPECT_NEAR(load_of(intensity({0, 0}, {-0.5, 0}), criterion_of(kind, -9)).value().load_factor, -9, 0);
    EXPECT_FALSE(load_of(intensity({0, 0}, {-0.5, 0}), criterion_of(kind, -3)));
  }
  EXPECT_FALSE(load_of(intensity({3, 0}, {-0.5, 0}), criterion_of(both[0], 1.5, Control::path)));
}

// The ratio to the toughness is a line through the present ratio by the energy: 1 at the load factor 4, 2 at 8.
TEST(LineLoad, by_energy_an_overloaded_tip_has_its_present_ratio) {
  const AffineIntensity opening = intensity({0, 0}, {0.5, 0});
  const LineLoad load = load_of(opening, criterion_of(both[1], 8)).value();
  EXPECT_NEAR(load.load_factor, 4, 1e-12);
  EXPECT_NEAR(load.constant + 4 * load.growing, 1, 1e-12);
  EXPECT_NEAR(load.constant + 8 * load.growing, 2, 1e-12);
  const LineLoad shear = load_of(intensity({0, 0}, {0, 2}), criterion_of(both[1], -5)).value();
  EXPECT_EQ(shear.load_factor, -5);
  EXPECT_NEAR(shear.constant, 5 / load_of(intensity({0, 0}, {0, 2}), criterion_of(both[1])).value().load_factor, 1e-9);
}

// A fracture energy of 0.6 K_I is met where K_I^2 / 2 = 0.6 K_I: at K_I = 1.2.
TEST(LineLoad, a_fracture_energy_of_the_host_is_that_at_the_load_of_growth) {
  const crack::HostResistance resistance([](const crack::TipCycle& held) { return 0.6 * held.highest; });
  for (const KinkCriterion kind : both) {
    LineCriterion criterion = criterion_of(kind);
    criterion.correction = 1;
    criterion.law.asking.function = &resistance;
    const AffineIntensity opening = intensity({0.2, 0}, {0.1, 0});
    const LineLoad load = fracture::load_of_growth(opening, opening, criterion).value();
    EXPECT_NEAR(load.load_factor, 10, 1e-7);
    EXPECT_NEAR(criterion.law.toughness, 1.2, 1e-8);
  }
}

TEST(LineLoad, ratios_of_numbers_that_nothing_can_reach_are_none) {
  EXPECT_EQ(fracture::load_ratio(1, 2), 0.5);
  EXPECT_EQ(fracture::load_ratio(-3, -0.5), 6);
  EXPECT_EQ(fracture::load_ratio(1e-200, 1e-200), 1);
  EXPECT_EQ(fracture::load_ratio(0, 1e-300), 0);
  EXPECT_FALSE(fracture::load_ratio(1, 0));
  EXPECT_FALSE(fracture::load_ratio(-1, 1e-160));
  EXPECT_TRUE(fracture::load_ratio(1, 1e-140));
}

}  // namespace
}  // namespace fracture_line_load_test

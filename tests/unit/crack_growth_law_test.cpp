// The load factors at which a tip grows, in both directions of the load.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "crack/growth_law.hpp"
#include "crack/laws/resistance_curve.hpp"
#include "elasticity/griffith.hpp"

namespace {

using namespace bempd;
using crack::AffineFactors;
using crack::GrowthLaw;
using crack::GrowthRange;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr KinkCriterion both[] = {KinkCriterion::hoop_stress, KinkCriterion::energy_release_rate};

GrowthRange growth_range(const AffineFactors& factors, double toughness, KinkCriterion criterion) {
  return GrowthLaw{toughness, 1, criterion}.range(factors);
}

double growth_ratio(const AffineFactors& factors, double load_factor, double toughness, KinkCriterion criterion) {
  return GrowthLaw{toughness, 1, criterion}.ratio(factors, load_factor);
}

TEST(CrackGrowthLaw, pure_opening_grows_upwards_alone) {
  for (const KinkCriterion criterion : both) {
    const GrowthRange range = growth_range({{0, 0}, {2, 0}}, 3, criterion);
    EXPECT_DOUBLE_EQ(range.highest, 1.5);
    EXPECT_EQ(range.lowest, -infinity);
  }
}

TEST(CrackGrowthLaw, errors_of_shear_do_not_grow_a_tip_that_is_pressed_shut) {
  for (const KinkCriterion criterion : both)
    EXPECT_EQ(growth_range({{0, 0}, {2, 1e-3}}, 3, criterion).lowest, -infinity);
  EXPECT_GT(growth_range({{0, 0}, {2, 5e-3}}, 3, KinkCriterion::hoop_stress).lowest, -1e8);
}

TEST(CrackGrowthLaw, pure_shear_grows_in_both_directions_alike) {
  // K_eq = 2/sqrt(3) K_II by the hoop stress (Erdogan and Sih, 1963).
  const GrowthRange range = growth_range({{0, 0}, {0, 2}}, 3, KinkCriterion::hoop_stress);
  EXPECT_NEAR(range.highest, 1.5 * std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(range.lowest, -range.highest, 1e-12);
}

TEST(CrackGrowthLaw, ends_of_ranges_of_random_tips_are_at_the_toughness) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  int empty = 0;
  for (int k = 0; k < 400; ++k) {
    const KinkCriterion criterion = both[k % 2];
    AffineFactors factors{{any(random), any(random)}, {any(random), any(random)}};
    // Closed tips may open suddenly, at a kink, by the energy release rate.
    if (criterion == KinkCriterion::energy_release_rate) factors.constant *= 0.2, factors.proportional.x() += 2;
    const double toughness = 0.5;
    const GrowthRange range = growth_range(factors, toughness, criterion);
    const auto ratio = [&](double at) { return growth_ratio(factors, at, toughness, criterion); };
    if (range.is_empty()) {
      ++empty;
      for (double at = -10; at <= 10; at += 0.1) EXPECT_GE(ratio(at), 1 - 1e-9);
      continue;
    }
    constexpr double beside = 1e-9;
    if (std::isfinite(range.highest)) {
      EXPECT_LT(ratio(range.highest - beside), 1);
      EXPECT_GT(ratio(range.highest + beside), 1);
    }
    if (criterion == KinkCriterion::energy_release_rate) continue;
    if (std::isfinite(range.lowest)) {
      EXPECT_LT(ratio(range.lowest + beside), 1);
      EXPECT_GT(ratio(range.lowest - beside), 1);
    }
    const double low = std::max(range.lowest, -1e3), high = std::min(range.highest, 1e3);
    for (int i = 1; i < 20; ++i) EXPECT_LT(ratio(low + (high - low) * i / 20), 1 + 1e-9);
  }
  EXPECT_GT(empty, 0);
}

TEST(CrackGrowthLaw, mirrored_loads_mirror_the_range) {
  const AffineFactors factors{{0.1, -0.2}, {0.7, 0.4}};
  const AffineFactors mirrored{factors.constant, -factors.proportional};
  for (const KinkCriterion criterion : both) {
    const GrowthRange range = growth_range(factors, 1, criterion), other = growth_range(mirrored, 1, criterion);
    EXPECT_DOUBLE_EQ(range.highest, -other.lowest);
    EXPECT_DOUBLE_EQ(range.lowest, -other.highest);
  }
}

TEST(CrackGrowthLaw, agrees_with_the_smallest_load_factor_of_growth) {
  const AffineFactors factors{{0.1, -0.2}, {0.7, 0.4}};
  for (const KinkCriterion criterion : both)
    EXPECT_EQ(growth_range(factors, 1, criterion).highest,
              growth_load_factor(factors.constant, factors.proportional, 1, criterion));
}

TEST(CrackGrowthLaw, straight_growth_begins_where_the_energy_release_rate_is_enough) {
  EXPECT_NEAR(straight_load_factor({0, 0}, {3, 4}, 10), 2, 1e-15);
  EXPECT_NEAR(straight_load_factor({-2, 1}, {3, 1}, 5), 2, 1e-15);  // (3 f - 2)^2 + (f + 1)^2 = 25
  EXPECT_EQ(straight_load_factor({3, 4}, {1, 0}, 5), 0);
  EXPECT_GT(straight_load_factor({1, 2}, {0, 0}, 5), 1e300);
  EXPECT_GT(straight_load_factor({0, 0}, {3, 4}, 0), 1e300);
}

// Squares of the factors overflow or vanish in some of these units.
TEST(CrackGrowthLaw, factors_of_any_size_grow_alike) {
  const Point constant(-1, 0.4), proportional(0.8, 1);
  for (const double unit : {1e-200, 1e-160, 1e-3, 1e3, 1e160, 1e200}) {
    EXPECT_NEAR(straight_load_factor(unit * constant, proportional, 3 * unit) / unit,
                straight_load_factor(constant, proportional, 3), 1e-12);
    for (const KinkCriterion criterion : both) {
      const Kink kink = kink_of(proportional, criterion), same = kink_of(unit * proportional, criterion);
      EXPECT_NEAR(same.angle, kink.angle, 2e-7);
      EXPECT_NEAR(same.equivalent_factor / unit, kink.equivalent_factor, 1e-12);
      EXPECT_NEAR(growth_load_factor(unit * constant, unit * proportional, 0.2 * unit, criterion),
                  growth_load_factor(constant, proportional, 0.2, criterion), 1e-12);
    }
  }
}

TEST(CrackGrowthLaw, load_factor_of_growth_may_be_far_above_or_below_one) {
  for (const KinkCriterion criterion : both) {
    EXPECT_NEAR(growth_load_factor({-1, 0}, {50, 0}, 3, criterion), 0.08, 1e-15);
    EXPECT_NEAR(growth_load_factor({-1, 0}, {0.01, 0}, 3, criterion), 400, 1e-10);
    EXPECT_EQ(growth_load_factor({3.5, 0}, {-1, 0}, 3, criterion), 0);  // it grows without any load
  }
}

TEST(CrackGrowthLaw, material_that_does_not_break_never_grows) {
  for (const double toughness : {0.0, infinity}) {
    const GrowthRange range = growth_range({{1, 0}, {1, 1}}, toughness, KinkCriterion::hoop_stress);
    EXPECT_EQ(range.highest, infinity);
    EXPECT_EQ(range.lowest, -infinity);
  }
}

TEST(CrackGrowthLaw, constant_load_beyond_the_toughness_grows_at_every_load_factor) {
  EXPECT_TRUE(growth_range({{2, 0}, {0, 0}}, 1, KinkCriterion::hoop_stress).is_empty());
  EXPECT_FALSE(growth_range({{0, 2}, {0.1, 0}}, 1, KinkCriterion::hoop_stress).holds(0));
}

TEST(CrackGrowthLaw, equal_energies_in_all_directions_change_nothing) {
  const crack::ResistanceDirections even({0.2, 1.0, 2.5}, {1, 1, 1});
  for (const KinkCriterion criterion : both)
    for (const Point& factors : {Point(1, 0), Point(1, 0.3), Point(0.4, -1), Point(0, 2)})
      for (const double heading : {0.0, 0.7, -2.8}) {
        const Kink found = even.kink(factors, heading, criterion), known = kink_of(factors, criterion);
        EXPECT_NEAR(found.angle, known.angle, 2e-7);
        EXPECT_NEAR(found.equivalent_factor, known.equivalent_factor, 1e-12);
      }
}

// A weak plane at 45 degrees is taken in mode I below G_c(45) / G_c(0) = F11^2 + F21^2, with the kinked factors of
// Amestoy and Leblond, Int. J. Solids Struct. 29, 1992; by the hoop stress below cos(22.5)^6.
TEST(CrackGrowthLaw, weak_plane_is_taken_below_the_ratio_of_its_energy_release_rate) {
  constexpr double quarter = std::numbers::pi / 4;
  const double by_energy = kinked_factors({1, 0}, quarter).squaredNorm(), by_hoop = std::pow(std::cos(quarter / 2), 6);
  EXPECT_NEAR(by_energy, 0.7300, 5e-5);
  for (const auto& [criterion, ratio] : {std::pair(both[0], by_hoop), std::pair(both[1], by_energy)})
    for (const double heading : {0.0, 1.1, 3.0})
      for (const double side : {-1.0, 1.0})
        for (const double share : {0.999, 1.001}) {
          const double plane = std::fmod(heading + side * quarter + 8 * std::numbers::pi, std::numbers::pi);
          const crack::ResistanceDirections directions({plane - 1e-3, plane, plane + 1e-3}, {1, share * ratio, 1});
          const Kink kink = directions.kink({1, 0}, heading, criterion);
          EXPECT_NEAR(kink.angle, share < 1 ? side * quarter : 0, 1e-9) << heading << ' ' << side;
          const GrowthLaw law{2, 1, criterion, &directions, heading};
          EXPECT_NEAR(law.range({{0, 0}, {1, 0}}).highest, 2 * std::min(1.0, std::sqrt(share)), 1e-9);
        }
}

// Two directions are worth nearly the same: one is in the table, the other lies between the angles that are tried.
TEST(CrackGrowthLaw, best_direction_between_trial_angles_is_found_beside_a_weak_plane) {
  for (const KinkCriterion criterion : both)
    for (double two = -0.3; two < 0.31; two += 0.05) {
      const Point factors(1, two);
      const Kink smooth = kink_of(factors, criterion);
      const double plane = smooth.angle + (two < 0 ? -0.6 : 0.6);
      for (const double worth : {1 - 1e-6, 1 + 1e-6}) {
        const double share =
            std::pow(factor_of_kink(factors, plane, criterion) / (worth * smooth.equivalent_factor), 2);
        const crack::ResistanceDirections directions({plane - 1e-3, plane, plane + 1e-3}, {1, share, 1});
        const Kink found = directions.kink(factors, 0, criterion);
        EXPECT_NEAR(found.angle, worth < 1 ? smooth.angle : plane, 1e-6) << two;
        EXPECT_NEAR(found.equivalent_factor, std::max(1.0, worth) * smooth.equivalent_factor, 1e-9);
      }
    }
}

TEST(CrackGrowthLaw, directions_without_a_sense_are_the_same) {
  const crack::ResistanceDirections table({0.1, 0.9, 2.2}, {1, 0.4, 2});
  for (double angle = -7; angle < 7; angle += 0.13)
    EXPECT_NEAR(table.share(angle), table.share(angle + std::numbers::pi), 1e-12);
  EXPECT_DOUBLE_EQ(table.share(0.9), 0.4);
  EXPECT_NEAR(table.share(0.5), 0.7, 1e-12);
  EXPECT_NEAR(table.share((2.2 + 0.1 + std::numbers::pi) / 2), 1.5, 1e-12);  // between the last row and the first
}

// A fracture energy of 0.6 K_I is met where K_I^2 / 2 = 0.6 K_I: at K_I = 1.2.
TEST(CrackGrowthLaw, load_factors_of_a_host_function_are_those_of_its_energy) {
  const crack::HostResistance growing([](const crack::TipCycle& held) { return 0.6 * held.highest; });
  const crack::HostResistance large([](const crack::TipCycle&) { return 5e11; });
  GrowthLaw law{1, 2};
  law.asking.function = &growing;
  for (const KinkCriterion criterion : both) {
    law.criterion = criterion;
    const GrowthRange range = law.range({{0.2, 0}, {0.1, 0}});
    EXPECT_NEAR(range.highest, 10, 1e-9);
    EXPECT_EQ(range.lowest, -infinity);
    EXPECT_NEAR(law.first_load_factor({{0.2, 0}, {0.1, 0}}), 10, 1e-9);
    EXPECT_NEAR(law.range({{0.2, 0}, {-0.1, 0}}).lowest, -10, 1e-9);
    EXPECT_EQ(law.first_load_factor({{1.3, 0}, {0.1, 0}}), 0);
  }
  law.asking.function = &large;  // a million times the number that the law begins with
  EXPECT_NEAR(law.range({{0, 0}, {1, 0}}).highest, 1e6, 1e-4);
}

TEST(CrackGrowthLaw, resistance_curve_is_linear_between_its_rows) {
  const crack::ResistanceCurve curve({0, 1, 3}, {1, 2, 1.5});
  EXPECT_EQ(curve.share(0), 1);
  EXPECT_DOUBLE_EQ(curve.share(0.25), 1.25);
  EXPECT_EQ(curve.share(1), 2);
  EXPECT_DOUBLE_EQ(curve.share(2), 1.75);
  EXPECT_EQ(curve.share(7), 1.5);
  EXPECT_EQ(crack::ResistanceCurve({1}, {3}).share(0), 3);
}

}  // namespace

#include <gtest/gtest.h>

#include <cmath>

#include "crack/cycle_step.hpp"
#include "crack/laws/rate_parameters.hpp"
#include "error.hpp"

// Laws of growth by cycles, and the cycles on a step.
namespace bempd::crack {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::unique_ptr<RateLaw> make_rate_law(const RateParameters& parameters) {
  return crack::make_rate_law(parameters, false);
}

TipCycle cycle(double highest, double lowest, double critical = infinity) {
  TipCycle c;
  c.highest = highest, c.lowest = lowest, c.critical = critical;
  return c;
}

RateParameters parameters(RateParameters::Kind kind, double coefficient, double exponent) {
  RateParameters p;
  p.kind = kind, p.coefficient = coefficient, p.exponent = exponent;
  return p;
}

TEST(RateLaws, laws_are_those_of_their_sources) {
  using Kind = RateParameters::Kind;
  RateParameters p = parameters(Kind::paris_walker, 2, 3);
  p.walker = 0.5;
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 1)), 2 * std::pow(3 / std::sqrt(0.75), 3), 1e-12);
  p = parameters(Kind::forman, 2, 3);
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 1, 10)), 2 * 27 / (0.75 * 10 - 3), 1e-12);
  EXPECT_THROW(critical_of(p, infinity), Error);
  EXPECT_EQ(critical_of(p, 10), 10);
  p.critical = 7;
  EXPECT_EQ(critical_of(p, 10), 7);
  p = parameters(Kind::sustained, 2, 3);
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 4)), 2 * 64, 1e-12);
  // Plane stress without load, R = 0: f = A0 = 0.535.
  p = parameters(Kind::nasgro, 2, 3);
  p.p = 0.5, p.q = 1, p.threshold = 1;
  const double expected = 2 * std::pow(0.465 * 4, 3) * std::sqrt(0.75) / 0.6;
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 0, 10)), expected, 1e-12 * expected);
  EXPECT_NEAR(p.closure.opening(1), 1, 1e-12);
}

TEST(RateLaws, tips_below_the_threshold_or_pressed_together_do_not_grow) {
  RateParameters p = parameters(RateParameters::Kind::paris_walker, 2, 3);
  p.threshold = 3;
  EXPECT_EQ(make_rate_law(p)->rate(cycle(4, 1)), 0);
  EXPECT_GT(make_rate_law(p)->rate(cycle(4, 0.9)), 0);
  EXPECT_EQ(make_rate_law(p)->rate(cycle(-1, -5)), 0);
}

// K = S sqrt(pi a) at both ends, with levels 0, 1 and 2 of the load factor: a^(-1/2) is linear in cycles for m = 3.
std::vector<TipOnStep> wide_plate(const RateLaw& law, double from, double to) {
  TipOnStep tip;
  tip.tip = {1, 1}, tip.law = &law;
  tip.length = 2 * from, tip.growth = to - from, tip.crack_growth = 2 * (to - from);
  for (const double load : {0.0, 1.0, 2.0}) {
    const auto at = [&](double a) { return LevelFactors{{load * std::sqrt(M_PI * a), 0}, load * std::sqrt(M_PI * a)}; };
    tip.before.push_back(at(from)), tip.after.push_back(at(to));
  }
  return {tip};
}

double exact(double from, double to, double rate) {
  return (std::pow(from, -0.5) - std::pow(to, -0.5)) / (0.5 * rate * std::pow(M_PI, 1.5));
}

TEST(CyclesOnStep, constant_amplitude_has_the_closed_form) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  const std::vector<Block> blocks{{1, 0, 1}};
  const CycleProgram program({blocks.data(), 1});
  std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  for (TipOnStep& tip : tips) tip.before.erase(tip.before.begin() + 1), tip.after.erase(tip.after.begin() + 1);
  const CyclesOnStep found = CycleIntegration(program, tips).run({}, {0}, 0, 0.1, infinity);
  EXPECT_EQ(found.end, CyclesEnd::growth);
  EXPECT_NEAR(found.cycles, exact(0.1, 0.2, 8e-6), 1e-6 * found.cycles);
  const CyclesOnStep half = CycleIntegration(program, tips).run({}, {0}, 0, 0.1, 0.5 * found.cycles);
  EXPECT_EQ(half.end, CyclesEnd::cycles);
  EXPECT_EQ(half.cycles, 0.5 * found.cycles);
}

// Factors at low loads are negative without contact of faces, and a power of the length all the same.
TEST(CyclesOnStep, reversed_loads_without_contact_have_the_closed_form) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  for (auto* levels : {&tips[0].before, &tips[0].after})
    levels->at(0).equivalent = -levels->at(1).equivalent, levels->at(0).factors = -levels->at(1).factors;
  const std::vector<Block> blocks{{1, 0, 1}};
  const CyclesOnStep found = CycleIntegration(CycleProgram(blocks), tips).run({}, {0}, 0, 0.1, infinity);
  EXPECT_NEAR(found.cycles, exact(0.1, 0.2, 8e-6), 1e-6 * found.cycles);
  const LevelFactors middle = tips[0].at(0.05, 0);
  EXPECT_NEAR(middle.factors.x(), -std::sqrt(M_PI * 0.15), 1e-3);
}

// Many short programs at once, and long blocks one by one, take the growth of their blocks.
TEST(CyclesOnStep, programs_are_passed_at_their_mean_rate_and_blocks_in_order) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  const std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  const std::vector<Block> together{{2, 1, 10}, {2, 0, 30}};
  const CyclesOnStep mean = CycleIntegration(CycleProgram(together), tips).run({}, {0}, 0, 0.1, infinity);
  EXPECT_NEAR(mean.cycles, exact(0.1, 0.2, 1e-6 * (10 + 30 * 8) / 40), 1e-4 * mean.cycles);
  const std::vector<Block> apart{{2, 1, 1e5}, {2, 0, 1e9}};
  const CyclesOnStep ordered = CycleIntegration(CycleProgram(apart), tips).run({}, {0}, 0, 0.1, infinity);
  const double between = std::pow(std::pow(0.1, -0.5) - 0.5e-6 * 1e5 * std::pow(M_PI, 1.5), -2);
  EXPECT_NEAR(ordered.cycles, 1e5 + exact(between, 0.2, 8e-6), 1e-6 * ordered.cycles);
  EXPECT_EQ(ordered.place.block, 1u);
}

TEST(CyclesOnStep, a_tip_breaks_where_its_block_reaches_the_critical_factor) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  tips[0].critical = {2 * std::sqrt(M_PI * 0.15)};
  const std::vector<Block> blocks{{2, 1, 3}, {2, 0, 5}};
  const CyclesOnStep found = CycleIntegration(CycleProgram(blocks), tips).run({}, {0}, 0, 0.1, infinity);
  EXPECT_EQ(found.end, CyclesEnd::critical);
  EXPECT_NEAR(found.growth[0], 0.05, 1e-6);
}

// A weak place in the middle of a step stops the tip there, also where both ends of the step are tough.
TEST(CyclesOnStep, a_toughness_that_varies_along_the_step_breaks_the_tip_in_its_middle) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  tips[0].critical = {9, 9, 1, 9, 9};  // K = 2 sqrt(pi a) is 1.37 at 0.15, and reaches a line from 9 to 1 before it
  const std::vector<Block> blocks{{2, 0, 5}};
  const CyclesOnStep found = CycleIntegration(CycleProgram(blocks), tips).run({}, {0}, 0, 0.1, infinity);
  ASSERT_EQ(found.end, CyclesEnd::critical);
  double low = 0.025, high = 0.05;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (2 * std::sqrt(M_PI * (0.1 + middle)) < 9 - 8 * (middle - 0.025) / 0.025 ? low : high) = middle;
  }
  EXPECT_NEAR(found.growth[0], low, 1e-7);
}

TEST(CyclesOnStep, a_net_section_ends_the_way_where_it_bears_no_more) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  // Shares of a strip of half width 0.25, whose rest falls to what level 2 needs at 0.16.
  for (std::size_t level = 0; level < 3; ++level) {
    tips[0].before[level].net_section = 0.5 * static_cast<double>(level) * 0.09 / 0.15;
    tips[0].after[level].net_section = 0.5 * static_cast<double>(level) * 0.09 / 0.05;
  }
  const std::vector<Block> blocks{{1, 0, 3}, {2, 0, 5}};
  const CyclesOnStep found = CycleIntegration(CycleProgram(blocks), tips).run({}, {0}, 0, 0.1, infinity);
  EXPECT_EQ(found.end, CyclesEnd::net_section);
  EXPECT_NEAR(found.growth[0], 0.06, 1e-6);
}

TEST(CyclesOnStep, a_program_in_which_nothing_grows_ends_the_run) {
  RateParameters p = parameters(RateParameters::Kind::paris_walker, 1e-6, 3);
  p.threshold = 5;
  const auto law = make_rate_law(p);
  const std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  const std::vector<Block> blocks{{2, 1, 3}, {2, 0, 5}};
  EXPECT_EQ(CycleIntegration(CycleProgram(blocks), tips).run({}, {0}, 0, 0.1, infinity).end, CyclesEnd::none_grows);
}

}  // namespace
RateParameters slowed(RateParameters::Retarding kind) {
  RateParameters p = parameters(RateParameters::Kind::paris_walker, 2, 3);
  p.walker = 0.5, p.threshold = 1, p.retarding = kind, p.yield_strength = 10, p.wheeler_exponent = 1.5;
  p.shutoff_ratio = 3;
  return p;
}

TEST(Retardation, plastic_zones_are_larger_in_plane_stress) {
  for (const bool strain : {false, true}) {
    const auto law = crack::make_rate_law(slowed(RateParameters::Retarding::wheeler), strain);
    EXPECT_NEAR(law->retardation()->zone(4), 0.16 / ((strain ? 6 : 2) * std::numbers::pi), 1e-15);
  }
  RateParameters p = slowed(RateParameters::Retarding::wheeler);
  p.zone_constraint = 1;
  EXPECT_NEAR(make_rate_law(p)->retardation()->zone(-4), 0, 0);
  EXPECT_NEAR(make_rate_law(p)->retardation()->zone(4), 0.16 / std::numbers::pi, 1e-15);
}

TEST(Retardation, wheelers_share_is_one_at_the_end_of_the_zone) {
  const auto law = make_rate_law(slowed(RateParameters::Retarding::wheeler));
  const Overload overload = law->retardation()->after({}, 0, 8);
  const double own = law->retardation()->zone(4), whole = law->rate(cycle(4, 1));
  EXPECT_NEAR(law->rate(cycle(4, 1), overload, 0), whole * std::pow(0.25, 1.5), 1e-12 * whole);
  EXPECT_NEAR(law->rate(cycle(4, 1), overload, overload.end - own * (1 + 1e-9)), whole, 1e-8 * whole);
  EXPECT_EQ(law->rate(cycle(4, 1), overload, overload.end - 0.9 * own), whole);
  EXPECT_EQ(law->retardation()->after(overload, 0, 4).highest, 8);
  EXPECT_EQ(law->retardation()->after(overload, overload.end - 0.9 * own, 4).highest, 4);
}

TEST(Retardation, willenborgs_overload_by_the_shutoff_ratio_stops_a_tip) {
  const auto law = make_rate_law(slowed(RateParameters::Retarding::willenborg));
  // phi = (1 - 1 / 4) / (3 - 1), and both factors are less by phi (8 - 4).
  const double less = 0.375 * 4;
  EXPECT_NEAR(law->rate(cycle(4, 1), law->retardation()->after({}, 0, 8), 0), law->rate(cycle(4 - less, 1 - less)),
              1e-12);
  RateParameters p = slowed(RateParameters::Retarding::willenborg);
  p.threshold = 0;
  const auto without = make_rate_law(p);
  EXPECT_NEAR(without->rate(cycle(4, 1), without->retardation()->after({}, 0, 12 - 1e-9), 0), 0, 1e-3);
  EXPECT_EQ(without->rate(cycle(4, 1), without->retardation()->after({}, 0, 12 + 1e-9), 0), 0);
}

}  // namespace bempd::crack

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
  p.critical = 0.5;
  EXPECT_EQ(critical_of(p, 10), 0.5);
  p = parameters(Kind::sustained, 2, 3);
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 4)), 2 * 64, 1e-12);
  // Plane stress without load, R = 0: f = A0 = 0.535.
  p = parameters(Kind::nasgro, 2, 3);
  p.p = 0.5, p.q = 1, p.threshold = 1;
  const double expected = 2 * std::pow(0.465 * 4, 3) * std::sqrt(0.75) / 0.6;
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 0, 10)), expected, 1e-12 * expected);
  EXPECT_NEAR(p.closure.opening(1), 1, 1e-12);
}

// f of Newman, Int. J. Fract. 24, 1984, computed by hand for alpha 2.5 and 1 and S_max / flow stress 0.3.
TEST(RateLaws, nasgro_opens_a_crack_at_the_share_of_newman) {
  const Nasgro::Closure near_strain{2.5, 0.3}, stress{1, 0.3};
  EXPECT_NEAR(near_strain.opening(0), 0.2745302482, 1e-10);
  EXPECT_NEAR(near_strain.opening(0.5), 0.5211713741, 1e-10);
  EXPECT_NEAR(stress.opening(0), 0.4766884904, 1e-10);
  EXPECT_NEAR(stress.opening(0.1), 0.4907004127, 1e-10);
  EXPECT_NEAR(stress.opening(0.7), 0.7464663139, 1e-10);
  // The share is a line below R = 0, and constant below R = -2.
  EXPECT_NEAR(near_strain.opening(-1), 0.2745302482 - 0.07125, 1e-10);
  EXPECT_NEAR(near_strain.opening(-2), 0.2745302482 - 0.1425, 1e-10);
  EXPECT_EQ(near_strain.opening(-3), near_strain.opening(-2));
  // The curve meets the line f = R, which is the least that f can be, at R = 1.
  EXPECT_NEAR((stress.opening(1) - stress.opening(1 - 1e-4)) / 1e-4, 1, 1e-3);
  EXPECT_EQ((Nasgro::Closure{3, 0.8}.opening(0.7)), 0.7);
}

TEST(RateLaws, nasgro_knows_the_load_ratio_by_closure_alone) {
  RateParameters p = parameters(RateParameters::Kind::nasgro, 2, 3);
  p.closure = {2.5, 0.3}, p.p = 0.5, p.q = 0.25, p.threshold = 0.8;
  const double effective = (1 - 0.5211713741) / 0.5 * 2;  // K from 2 to 4
  const double expected = 2 * std::pow(effective, 3) * std::sqrt(1 - 0.4) / std::pow(1 - 0.5, 0.25);
  EXPECT_NEAR(make_rate_law(p)->rate(cycle(4, 2, 8)), expected, 1e-9 * expected);
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

// A tip that takes part of a cycle for its whole way is stopped within that cycle.
TEST(CyclesOnStep, a_part_of_a_cycle_has_the_closed_form) {
  const double rate = exact(0.1, 0.2, 1) / 0.75;
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, rate, 3));
  const std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  const std::vector<Block> blocks{{1, 0, 1}};
  const CyclesOnStep found = CycleIntegration(CycleProgram(blocks), tips).run({}, {0}, 0, 0.1, infinity);
  EXPECT_EQ(found.end, CyclesEnd::growth);
  EXPECT_NEAR(found.cycles, 0.75, 1e-6);
  EXPECT_NEAR(found.growth[0], 0.1, 1e-9);
}

// ln K = ln 0.02 + 0.4 x + 0.1 x^2 with x = ln(a / 0.1), known at x = -0.1, 0 and 0.3, is met between them.
TEST(TipOnStep, factors_bend_as_through_the_step_before) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1, 3));
  const auto level = [](double x) {
    const double k = 0.02 * std::exp(0.4 * x + 0.1 * x * x);
    return std::vector<LevelFactors>{{{k, 0}, k}};
  };
  TipOnStep tip;
  tip.law = law.get(), tip.length = 0.1;
  tip.growth = tip.crack_growth = 0.1 * std::expm1(0.3), tip.past_growth = -0.1 * std::expm1(-0.1);
  tip.past = level(-0.1), tip.before = level(0), tip.after = level(0.3);
  EXPECT_NEAR(tip.bend(0), 0.1, 1e-9);
  for (const double x : {0.05, 0.15, 0.25})
    EXPECT_NEAR(tip.at(0.1 * std::expm1(x), 0).equivalent, level(x)[0].equivalent, 1e-12);
  tip.past_growth = 0.071;  // much longer than this step: it tells nothing
  EXPECT_EQ(tip.bend(0), 0);
}

// What a law of the host is told of a cycle, a third of the way along a step.
TEST(TipOnStep, places_and_lengths_of_a_cycle_change_evenly) {
  TipOnStep tip;
  tip.length = 2, tip.growth = 0.3, tip.crack_growth = 0.6, tip.from = {1, 2}, tip.to = {1.3, 1.7};
  tip.before = {{{1, 0.5}, 1, 0, 6}, {}}, tip.after = {{{1, 0.5}, 1, 0, 9}, {}};
  const TipCycle third = tip.cycle(0.1, {0, 1, 1});
  EXPECT_NEAR((third.place - Point(1.1, 1.9)).norm(), 0, 1e-15);
  EXPECT_NEAR(third.length, 2.2, 1e-15);
  EXPECT_NEAR(third.t_stress, 7, 1e-14);
  EXPECT_NEAR((third.high - Point(1, 0.5)).norm(), 0, 1e-15);
}

TEST(TipOnStep, critical_factors_are_linear_between_even_shares_of_the_step) {
  TipOnStep tip;
  tip.growth = 0.4, tip.critical = {9, 7, 1, 2, 4};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(tip.critical_at(0.1 * k), tip.critical[k], 1e-12) << k;
  EXPECT_NEAR(tip.critical_at(0.05), 8, 1e-12);
  EXPECT_NEAR(tip.critical_at(0.375), 3.5, 1e-12);
  EXPECT_NEAR(tip.critical_at(0.5), 4, 1e-12);  // as at the end
  tip.critical = {9, 7};
  EXPECT_NEAR(tip.critical_at(0.1), 8.5, 1e-12);
  EXPECT_NEAR(tip.critical_at(0.4), 7, 1e-12);
  tip.critical = {9, infinity};  // nothing is known of one end
  EXPECT_EQ(tip.critical_at(0.2), 9);
}

TEST(CycleProgram, place_after_cycles_is_that_of_going_on) {
  const std::vector<Block> blocks{{1, 0, 3}, {2, 0, 5}, {3, 0, 2}};
  const CycleProgram program(blocks);
  const CycleProgram::Place in_second = program.place_after(24), in_third = program.place_after(8.5);
  EXPECT_EQ(in_second.block, 1u);
  EXPECT_EQ(in_second.done, 1);
  EXPECT_EQ(in_third.block, 2u);
  EXPECT_EQ(in_third.done, 0.5);
  EXPECT_EQ(program.place_after(10).block, 0u);
  CycleProgram::Place place;
  for (int cycle = 1; cycle <= 25; ++cycle) {
    program.go_on(place, 1);
    const CycleProgram::Place found = program.place_after(cycle);
    EXPECT_EQ(found.block, place.block) << cycle;
    EXPECT_EQ(found.done, place.done) << cycle;
  }
}

TEST(CycleProgram, mean_rate_leaves_out_blocks_that_break_the_tip) {
  const auto law = make_rate_law(parameters(RateParameters::Kind::paris_walker, 1e-6, 3));
  std::vector<TipOnStep> tips = wide_plate(*law, 0.1, 0.2);
  const double once = 1e-6 * std::pow(M_PI * 0.1, 1.5);  // by a cycle between the levels 0 and 1
  const std::vector<Block> blocks{{1, 0, 3}, {2, 0, 5}};
  EXPECT_NEAR(mean_rate(tips[0], 0, CycleProgram(blocks)), once * (3 + 5 * 8) / 8, 1e-12 * once);
  EXPECT_NEAR(mean_rate(tips[0], 0, CycleProgram({&blocks[1], 1})), 8 * once, 1e-12 * once);
  tips[0].critical = {1.5 * std::sqrt(M_PI * 0.1)};
  EXPECT_NEAR(mean_rate(tips[0], 0, CycleProgram(blocks)), once * 3 / 8, 1e-12 * once);
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

// K stays the same, so the rate of Wheeler is a power of the distance to the end of the zone until the zones meet. The
// same cycles in two blocks are passed by whole programs.
TEST(Retardation, cycles_in_the_zone_of_an_overload_have_the_closed_form) {
  RateParameters p = slowed(RateParameters::Retarding::wheeler);
  p.coefficient = 1e-6;
  const auto law = make_rate_law(p);
  constexpr double way = 0.08, once = 8e-6;  // growth, and its rate under K = 2 without retardation
  TipOnStep tip;
  tip.law = law.get(), tip.length = 1, tip.growth = tip.crack_growth = way;
  tip.before = tip.after = {{}, {{2, 0}, 2}};
  tip.overload = law->retardation()->after({}, 0, 6);
  const double end = tip.overload.end, own = law->retardation()->zone(2);
  const double inside = (std::pow(end, 2.5) - std::pow(own, 2.5)) / (2.5 * std::pow(own, 1.5) * once);
  const double expected = inside + (way - (end - own)) / once;
  const std::vector<TipOnStep> tips{tip};
  const std::vector<Block> blocks{{1, 0, 10}, {1, 0, 30}};
  for (const std::size_t count : {1, 2}) {
    const CycleProgram program({blocks.data(), count});
    const CyclesOnStep found = CycleIntegration(program, tips).run({}, {0}, 0, way, infinity);
    EXPECT_EQ(found.end, CyclesEnd::growth);
    EXPECT_NEAR(found.cycles, expected, 1e-4 * expected) << count;
    EXPECT_NEAR(found.overloads[0].highest, 2, 0);
  }
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

// One scene in extreme units and under extreme loads. Reference: dimensional analysis.
#include <gtest/gtest.h>

#include "../fracture_scenes.hpp"
#include "scaled_plate.hpp"

namespace extremes_units_test {
namespace {

using namespace host;

constexpr double tolerance = 1e-9;

const Outcome& reference() {
  static const Outcome result = outcome({});
  return result;
}

double relative(const std::vector<double>& a, const std::vector<double>& b) {
  return largest_difference(a, b) / largest(b);
}

void expect_same(const Outcome& a, const std::string& what) {
  const Outcome& b = reference();
  const auto near_zero = [&](const char* quantity, double difference) {
    EXPECT_LE(std::abs(report((what + ": " + quantity).c_str(), difference, 0, "dimensional analysis")), tolerance);
  };
  near_zero("displacement", relative(a.displacement, b.displacement));
  near_zero("stress", relative(a.stress, b.stress));
  near_zero("reaction", relative({a.reaction[0], a.reaction[1]}, {b.reaction[0], b.reaction[1]}));
  near_zero("residual", a.residual);
}

void expect_same_energies(const Outcome& a, const std::string& what) {
  const Outcome& b = reference();
  EXPECT_LE(
      std::abs(report((what + ": energy").c_str(), a.stored_energy / b.stored_energy - 1, 0, "dimensional analysis")),
      tolerance);
  EXPECT_LE(std::abs(a.work / b.work - 1), tolerance);
  EXPECT_LE(a.balance, tolerance);
}

std::string named(const char* what, double value) {
  char line[64];
  std::snprintf(line, sizeof line, "%s %g", what, value);
  return line;
}

TEST(ExtremeUnits, length_from_1e_minus_9_to_1e9) {
  for (double length : {1e-9, 1e-3, 1e3, 1e9}) {
    ScaledPlate s;
    s.length = length;
    const Outcome result = outcome(s);
    expect_same(result, named("length", length));
    expect_same_energies(result, named("length", length));
  }
}

TEST(ExtremeUnits, modulus_from_1e_minus_12_to_1e15) {
  for (double modulus : {1e-12, 1e-6, 1e9, 1e15}) {
    ScaledPlate s;
    s.modulus = modulus;
    const Outcome result = outcome(s);
    expect_same(result, named("modulus", modulus));
    expect_same_energies(result, named("modulus", modulus));
  }
}

TEST(ExtremeUnits, thickness_from_1e_minus_6_to_1e6) {
  for (double thickness : {1e-6, 1e6}) {
    ScaledPlate s;
    s.thickness = thickness;
    const Outcome result = outcome(s);
    expect_same(result, named("thickness", thickness));
    expect_same_energies(result, named("thickness", thickness));
  }
}

TEST(ExtremeUnits, all_units_at_once) {
  ScaledPlate s;
  s.length = 1e-9, s.modulus = 1e15, s.thickness = 1e6;
  expect_same(outcome(s), "small, stiff, thick");
  s.length = 1e9, s.modulus = 1e-12, s.thickness = 1e-6;
  expect_same(outcome(s), "large, soft, thin");
}

TEST(ExtremeLoads, of_1e_minus_140_and_1e140_scale_exactly) {
  for (double load : {1e-140, 1e140}) {
    ScaledPlate s;
    s.load = load;
    const Outcome result = outcome(s);
    expect_same(result, named("load", load));
    expect_same_energies(result, named("load", load));
  }
}

int warnings_of_energy(int32_t level, const char* message) {
  return level == 1 && std::string(message).find("energ") != std::string::npos ? 1 : 0;
}

TEST(ExtremeLoads, of_1e_minus_300_and_1e300_give_displacements_and_warn_of_energies) {
  for (double load : {1e-300, 1e300}) {
    ScaledPlate s;
    s.load = load;
    expect_same(outcome(s), named("load", load));
    Model model;
    build(model, s);
    int warnings = 0;
    model.check(bempd_set_log(
        model.get(),
        [](int32_t level, const char* message, void* user) {
          *static_cast<int*>(user) += warnings_of_energy(level, message);
        },
        &warnings));
    model.step(1);
    EXPECT_EQ(warnings, 1) << "at load " << load;
    model.step(0.5);
    EXPECT_EQ(warnings, 1) << "one warning is enough";
  }
}

TEST(ExtremeLoads, of_ordinary_size_come_without_a_warning) {
  Model model;
  build(model, ScaledPlate{});
  int warnings = 0;
  model.check(bempd_set_log(
      model.get(),
      [](int32_t level, const char* message, void* user) {
        *static_cast<int*>(user) += warnings_of_energy(level, message);
      },
      &warnings));
  model.step(1);
  EXPECT_EQ(warnings, 0);
}

// A crack run in other units: the same bonds at the same load factors.
TEST(ExtremeUnits, cracks_run_the_same_way) {
  const auto run = [](double unit, double young, double thickness) {
    CentreCrack scene = CentreCrack::small();
    scene.unit *= unit, scene.young *= young, scene.thickness *= thickness;
    Model model;
    const CentreCrackIds ids = build(model, scene);
    model.run(1e4);
    return std::pair(events(model), bond_sets(model, scene, ids).parted);
  };
  const auto expected = run(1, 1, 1);
  for (const auto& [unit, young, thickness] : {std::array{1e-6, 1e5, 1e6}, std::array{1e9, 1e-20, 1e-6}}) {
    const auto got = run(unit, young, thickness);
    EXPECT_EQ(got.second, expected.second);
    ASSERT_EQ(got.first.size(), expected.first.size());
    double worst = 0;
    for (std::size_t i = 0; i < got.first.size(); ++i)
      worst = largest({worst, got.first[i].load_factor / expected.first[i].load_factor - 1});
    EXPECT_LE(report(named("unit", unit).c_str(), worst, 0, "dimensional analysis"), tolerance);
  }
}

}  // namespace
}  // namespace extremes_units_test

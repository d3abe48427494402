// Loads of cracks that grow as lines where the stress ahead of a tip is not the tip's own: behind a kink, under shear,
// of short and of pressed cracks, before another material. Against boundary elements with the same crack before each
// step.
#include <gtest/gtest.h>

#include <claims.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "host.hpp"

namespace line_loads_test {
namespace {

using namespace host;

constexpr double side = 60;  // of a plate, in spacings
constexpr int horizon_ratio = 4;

bempd_material solid(double young) {
  bempd_material result = material(young, 1.0 / 3);
  result.fracture_energy = 1;
  return result;
}

struct Scene {
  Outline crack;
  int steps;
  double sideways;     // motion of the upper edge, for a unit upwards
  double right_young;  // of the right part of the plate, where it is not 1
  double upwards = 1;  // motion of the upper edge
};

void build(const Scene& scene, bool elements, Model& model) {
  const auto add = [&](double young, double left, double right) {
    const Outline box = rectangle(left, 0, right, side);
    const int32_t id = model.add(solid(young));
    const int32_t body = elements ? model.bem(id, box, side / 16) : model.pd(id, box, 1, horizon_ratio);
    model.fix(body, 1, BEMPD_BOTH);
    model.prescribe(body, 3, BEMPD_Y, 0, scene.upwards);
    model.prescribe(body, 3, BEMPD_X, 0, scene.sideways);
  };
  if (scene.right_young == 1) {
    add(1, 0, side);
  } else {
    add(1, 0, side / 2), add(scene.right_young, side / 2, side);
  }
}

// Load factor at which the last tip of the crack grows.
double known_load(const Scene& scene, const Outline& crack) {
  Model model;
  build(scene, true, model);
  model.crack(crack);
  if (scene.upwards < 0) model.step(1e-3);  // so that the faces press on each other
  int64_t count = 0;
  model.check(bempd_tip_count(model.get(), &count));
  bempd_crack_tip tip;
  bempd_crack_tip_init(&tip, sizeof tip);
  model.check(bempd_tip(model.get(), count - 1, &tip));
  return tip.critical_load_factor;
}

// Load factors of the steps of the crack's end over those of boundary elements.
std::vector<double> ratios_of(const Scene& scene) {
  Model model;
  model.set_text("crack.rule", "tips");
  model.set_text("stepping.control", "path");
  build(scene, false, model);
  model.crack(scene.crack);
  Outline crack = scene.crack;
  std::vector<double> ratios;
  for (int k = 0; k < scene.steps; ++k) {
    const double load = model.next_event(1e6).load_factor;
    bempd_crack_extension last;
    model.check(bempd_crack_extension_init(&last, sizeof last));
    model.check(bempd_extension(model.get(), k, &last));
    ratios.push_back(load / known_load(scene, crack));
    crack.push_back({last.x, last.y});
  }
  return ratios;
}

double worst_of(const char* name, const Scene& scene) {
  double worst = 0;
  std::printf("%s:", name);
  for (const double ratio : ratios_of(scene)) {
    std::printf(" %.3f", ratio);
    worst = std::max(worst, std::abs(ratio - 1));
  }
  std::printf("\n");
  return worst;
}

TEST(LineLoads, behind_a_kink) {
  const double worst = worst_of("kink", {{{0, 30.3}, {24.5, 30.3}}, 4, 2, 1});
  EXPECT_LE(worst, claims::line_kink_loads / 100);
}

TEST(LineLoads, of_sheared_tips) {
  for (const double sideways : {2.0, 4.0, 10.0}) {
    const double worst = worst_of("sheared", {{{0, 30.3}, {24.5, 30.3}}, 1, sideways, 1});
    EXPECT_LE(worst, claims::line_sheared_load / 100) << sideways;
  }
}

TEST(LineLoads, of_a_short_crack) {
  const double worst = worst_of("crack of 6", {{{27.3, 30.4}, {33.3, 30.4}}, 1, 0, 1});
  EXPECT_LE(worst, claims::line_short_load / 100);
}

TEST(LineLoads, of_inclined_edge_cracks) {
  for (const double degrees : {20.0, 30.0, 45.0, 60.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const double x = 14 * std::cos(angle), y = 7 * std::sin(angle);
    const double worst = worst_of("inclined", {{{0, 30.3 - y}, {x, 30.3 + y}}, 1, 0, 1});
    EXPECT_LE(worst, claims::line_inclined_load / 100) << degrees;
  }
}

// Cracks at 45 and 60 degrees to the pressed edges, whose faces press on each other.
TEST(LineLoads, of_pressed_cracks) {
  for (const double half : {3.0, 6.0, 10.0})
    for (const double degrees : {45.0, 60.0}) {
      const double angle = degrees * std::numbers::pi / 180;
      const double x = half * std::cos(angle), y = half * std::sin(angle);
      const double worst = worst_of("pressed", {{{30.3 - x, 30.4 - y}, {30.3 + x, 30.4 + y}}, 1, 0, 1, -1});
      EXPECT_LE(worst, claims::line_pressed_load / 100) << half << " at " << degrees;
    }
}

TEST(LineLoads, before_a_stiffer_material) {
  const double worst = worst_of("towards three times the modulus", {{{0, 30.4}, {21.3, 30.4}}, 5, 0, 3});
  EXPECT_LE(worst, claims::line_interface_loads / 100);
}

}  // namespace
}  // namespace line_loads_test

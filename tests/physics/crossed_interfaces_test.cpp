// Cracks that lie across interfaces of BEM regions of one material, or grow across them: the body is that of one
// region.
#include <gtest/gtest.h>

#include <algorithm>

#include "host.hpp"

namespace crossed_interfaces_test {
namespace {

using namespace host;

constexpr double width = 80, height = 64;

// How the plate is divided. `crosswise`: in four, numbered so that the second one meets the first at a corner.
enum class Division { none, halves, slanted, quarters, crosswise };

struct Plate {
  Model model;

  Plate(Division division, const Outline& crack, double pull = 1) {
    bempd_material glass = material(1, 1.0 / 3);
    glass.fracture_energy = 1;
    const int32_t id = model.add(glass);
    const double x = width / 2, y = height / 2, s = division == Division::slanted ? 15 : 0;
    const bool in_four = division >= Division::quarters;
    std::vector<Outline> outlines{rectangle(0, 0, x, y), rectangle(x, 0, width, y), rectangle(0, y, x, height),
                                  rectangle(x, y, width, height)};
    if (division == Division::none) outlines = {rectangle(0, 0, width, height)};
    if (division == Division::halves || division == Division::slanted)
      outlines = {{{0, 0}, {x - s, 0}, {x + s, height}, {0, height}},
                  {{x - s, 0}, {width, 0}, {width, height}, {x + s, height}}};
    if (division == Division::crosswise) std::swap(outlines[1], outlines[3]);
    for (const Outline& outline : outlines) {
      const int32_t region = model.bem(id, outline, 4);
      if (!in_four || outline[0][1] == 0) model.fix(region, 1, BEMPD_Y);
      if (!in_four || outline[2][1] == height) model.prescribe(region, 3, BEMPD_Y, 0, pull);
    }
    model.fix_point({0, 0}, BEMPD_X);
    model.crack(crack);
  }

  std::vector<bempd_crack_tip> tips() {
    int64_t count = 0;
    model.check(bempd_tip_count(model.get(), &count));
    std::vector<bempd_crack_tip> all(static_cast<std::size_t>(count));
    for (int64_t k = 0; k < count; ++k) {
      bempd_crack_tip& tip = all[static_cast<std::size_t>(k)];
      bempd_crack_tip_init(&tip, sizeof tip);
      model.check(bempd_tip(model.get(), k, &tip));
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.end < b.end; });
    return all;
  }

  std::vector<bempd_crack_extension> extensions() {
    int64_t count = 0;
    model.check(bempd_extension_count(model.get(), &count));
    std::vector<bempd_crack_extension> all(static_cast<std::size_t>(count));
    for (int64_t k = 0; k < count; ++k) {
      bempd_crack_extension& one = all[static_cast<std::size_t>(k)];
      bempd_crack_extension_init(&one, sizeof one);
      model.check(bempd_extension(model.get(), k, &one));
    }
    return all;
  }

  int64_t pieces() {
    int64_t count = 0;
    model.check(bempd_piece_count(model.get(), &count));
    return count;
  }
};

// Largest difference of both factors over their size.
double difference(const std::vector<bempd_crack_tip>& found, const std::vector<bempd_crack_tip>& expected) {
  double worst = found.size() == expected.size() ? 0 : 1;
  for (std::size_t k = 0; k < std::min(found.size(), expected.size()); ++k) {
    const auto &a = found[k], &b = expected[k];
    worst = std::max(
        worst, std::hypot(a.stress_intensity_1 - b.stress_intensity_1, a.stress_intensity_2 - b.stress_intensity_2) /
                   std::hypot(b.stress_intensity_1, b.stress_intensity_2));
  }
  return worst;
}

// The crack runs from the middle of one half to a place behind the interface.
TEST(CrossedInterfaces, leave_the_factors_of_tips_as_they_are) {
  for (const double degrees : {0.0, 45.0, 70.0}) {
    const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
    for (const double way : {0.1, 0.5, 2.0, 8.0}) {
      const Outline crack{{40 - 20 * c, 30 - 20 * s}, {40 + way * c, 30 + way * s}};
      Plate whole(Division::none, crack, 1e-3), halves(Division::halves, crack, 1e-3);
      whole.model.step(1), halves.model.step(1);
      const double off = difference(halves.tips(), whole.tips());
      std::printf("%2.0f degrees, tip %.1f behind the interface: factors off by %.1e\n", degrees, way, off);
      EXPECT_LT(off, 1e-3);
    }
  }
}

// The crack passes through the corner of four regions, with a load on its faces.
TEST(CrossedInterfaces, pass_through_corners_and_under_pressure) {
  const Outline crack{{24, 24}, {56, 40}};
  Plate whole(Division::none, crack, 1e-3);
  int32_t load = 0;
  whole.model.check(bempd_add_crack_pressure(whole.model.get(), 1, 0, 1e-3, &load));
  const double energy = whole.model.step(1).stored_energy;
  for (const Division division : {Division::halves, Division::slanted, Division::quarters, Division::crosswise}) {
    Plate plate(division, crack, 1e-3);
    plate.model.check(bempd_add_crack_pressure(plate.model.get(), 1, 0, 1e-3, &load));
    report("stored energy", plate.model.step(1).stored_energy, energy, "one region");
    EXPECT_LT(difference(plate.tips(), whole.tips()), 1e-3);
    const double fractions[] = {0.1, 0.45, 0.55, 0.8};
    double normal[2][4], along[4];
    whole.model.check(bempd_crack_opening(whole.model.get(), 1, 4, fractions, normal[0], along));
    plate.model.check(bempd_crack_opening(plate.model.get(), 1, 4, fractions, normal[1], along));
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(normal[1][k] / normal[0][k], 1, 1e-3);
  }
}

// A crack runs from an edge to the opposite one: loads, path, energies and separation are those of one region.
TEST(CrossedInterfaces, are_crossed_by_growing_cracks) {
  const Outline crack{{0, 26}, {20, 21}};
  const auto torn = [&](Division division) {
    auto plate = std::make_unique<Plate>(division, crack);
    plate->model.set_text("stepping.control", "path");
    plate->model.set("crack.step", 6);
    return plate;
  };
  const auto whole = torn(Division::none);
  const bempd_step_report expected = whole->model.run(1e6);
  EXPECT_EQ(expected.stop_reason, BEMPD_STOP_SEPARATED);
  const auto reference = whole->extensions();
  for (const Division division : {Division::slanted, Division::quarters}) {
    const auto plate = torn(division);
    const bempd_step_report found = plate->model.run(1e6);
    EXPECT_EQ(found.stop_reason, BEMPD_STOP_SEPARATED);
    EXPECT_EQ(plate->pieces(), 2);
    EXPECT_LT(found.energy_balance_error, 1e-11);
    const auto steps = plate->extensions();
    ASSERT_GE(steps.size(), 8U);
    // Steps may end elsewhere beside an interface: loads and heights are compared between vertices of the reference.
    double load = 0, height_off = 0;
    for (const auto& one : steps) {
      for (std::size_t k = 1; k < reference.size() && one.x < 76; ++k) {
        const auto &a = reference[k - 1], &b = reference[k];
        if (one.x < a.x || one.x > b.x) continue;
        const double part = (one.x - a.x) / (b.x - a.x);
        height_off = std::max(height_off, std::abs(one.y - a.y - part * (b.y - a.y)));
        if (part < 0.01 || part > 0.99)
          load = std::max(load, std::abs(one.load_factor / (part < 0.5 ? a : b).load_factor - 1));
      }
    }
    std::printf("%zu steps: loads off by %.1e, path by %.4f, released energy by %+.1e\n", steps.size(), load,
                height_off, found.released_energy / expected.released_energy - 1);
    EXPECT_LT(load, 1e-3);
    EXPECT_LT(height_off, 0.05);
    EXPECT_NEAR(found.released_energy / expected.released_energy, 1, 1e-3);
  }
}

TEST(CrossedInterfaces, are_crossed_again_from_states) {
  Plate plate(Division::halves, {{0, 30}, {30, 31}});
  plate.model.set_text("stepping.control", "path");
  plate.model.set("crack.step", 8);
  plate.model.next_event(1e6);
  const SavedState before = plate.model.save();
  const auto go_on = [&] {
    for (int k = 0; k < 3; ++k) plate.model.next_event(1e6);
    return plate.model.load_factor();
  };
  const double first = go_on();
  EXPECT_GT(plate.extensions().back().x, 45);
  const SavedState behind = plate.model.save();
  plate.model.restore(before);
  EXPECT_EQ(go_on(), first);
  const double next = (plate.model.next_event(1e6), plate.model.load_factor());
  plate.model.restore(behind);
  plate.model.next_event(1e6);
  EXPECT_EQ(plate.model.load_factor(), next);
}

}  // namespace
}  // namespace crossed_interfaces_test

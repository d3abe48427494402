// What breaks in bodies that are pressed, by the option pd.criterion. References: Hooke's law, by which a block under
// uniaxial pressure p is stretched across it by nu p / E, and by (1 + nu) nu p / E in plane strain; and the criterion
// stretch itself where nothing is pressed.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace compression_test {
namespace {

using namespace host;

constexpr double critical = 1e-3;

struct Block {
  double nu = 1.0 / 3;
  bempd_plane plane = BEMPD_PLANE_STRESS;
  bool in_two = false, clamped = false;
};

// 12 by 20 cells whose upper edge moves by -1 per load factor.
void build(Model& model, const Block& block, const char* criterion) {
  model.set_text("pd.criterion", criterion);
  const int32_t id = model.add(material(1, block.nu, block.plane, 1, critical));
  const double middle = block.in_two ? 8 : 20;
  const int32_t lower = model.pd(id, rectangle(0, 0, 12, middle), 1, 4);
  const int32_t upper = block.in_two ? model.pd(id, rectangle(0, 8, 12, 20), 1, 4) : lower;
  model.fix(lower, 1, block.clamped ? BEMPD_BOTH : BEMPD_Y);
  model.prescribe(upper, 3, BEMPD_Y, 0, -1);
  if (block.clamped) model.fix(upper, 3, BEMPD_X);
  if (!block.clamped) model.fix_point({0, 0}, BEMPD_X);
}

// Pressure over E' s_c, the strength under tension.
double strength(const Block& block, const char* criterion, double limit) {
  BondModel model;
  build(model, block, criterion);
  const bempd_step_report step = model.next_event(limit * 20 * critical);
  return step.stop_reason == BEMPD_STOP_EVENT ? step.load_factor / (20 * critical)
                                              : std::numeric_limits<double>::infinity();
}

TEST(Compression, stretch_across_breaks_a_sound_block) {
  // The lateral stretch reaches s_c, by Hooke's law, at 1 / nu in plane stress and (1 - nu) / nu in plane strain.
  EXPECT_LE(std::abs(report("plane stress", strength({}, "stretch", 100), 3, "1 / nu")), 0.01);
  EXPECT_LE(std::abs(report("plane strain", strength({0.25, BEMPD_PLANE_STRAIN}, "stretch", 100), 3, "(1 - nu) / nu")),
            0.01);
}

TEST(Compression, without_it_a_sound_block_bears_any_pressure) {
  for (const Block& block : {Block{}, Block{0.25, BEMPD_PLANE_STRAIN}, Block{0.2}, Block{0.45},
                             Block{0.4, BEMPD_PLANE_STRAIN}, Block{1.0 / 3, BEMPD_PLANE_STRESS, true}})
    EXPECT_TRUE(std::isinf(strength(block, "opening", 1e4))) << block.nu;
}

// Blocks with points on the outline bear any pressure, whatever the direction of the lattice's rows.
TEST(Compression, without_it_blocks_on_any_lattice_bear_any_pressure) {
  for (const double angle : {0.0, 0.4}) {
    BondModel model;
    model.set_text("test.outline_points", "always");
    model.lattice_angle = angle;
    build(model, {}, "opening");
    EXPECT_NE(model.next_event(1e4 * 20 * critical).stop_reason, BEMPD_STOP_EVENT) << angle;
  }
}

TEST(Compression, between_rough_plates_more_is_borne) {
  const Block rough{1.0 / 3, BEMPD_PLANE_STRESS, false, true};
  const double before = strength(rough, "stretch", 1e4), now = strength(rough, "opening", 1e4);
  std::printf("first break between rough plates: %.3f by stretch, %.3f by opening\n", before, now);
  EXPECT_GT(now, 2 * before);
}

std::vector<bempd_history_entry> pulled(const char* criterion, const char* solver) {
  BondModel model;
  model.set_text("pd.criterion", criterion);
  model.set_text("test.solver", solver);
  build(model, CentreCrack::small());
  model.run(1e4);
  return model.history();
}

// Tension gives the same under both criteria, digit by digit, until the last part of the plate is torn, whose faces
// overlap: there other bonds out of several alike break first.
TEST(Compression, a_pulled_crack_grows_as_before) {
  const auto by_stretch = pulled("stretch", "plain");
  const int64_t all = by_stretch.back().total_broken_bonds;
  for (const char* solver : {"plain", "window"}) {
    const auto by_opening = pulled("opening", solver);
    EXPECT_EQ(by_opening.back().total_broken_bonds, all);
    EXPECT_NEAR(by_opening.back().load_factor, by_stretch.back().load_factor, 1e-9 * by_stretch.back().load_factor);
    std::size_t compared = 0;
    for (; by_stretch[compared].total_broken_bonds < 0.8 * all; ++compared) {
      const bempd_history_entry &one = by_stretch[compared], &other = by_opening[compared];
      const double rounding = solver == std::string("plain") ? 0 : 1e-9;
      EXPECT_EQ(one.total_broken_bonds, other.total_broken_bonds);
      EXPECT_LE(std::abs(one.load_factor - other.load_factor), rounding * one.load_factor);
      EXPECT_LE(std::abs(one.released_energy - other.released_energy), rounding * one.work);
    }
    EXPECT_GT(compared, 100u);
  }
}

// A plate with a slot at 45 degrees, pressed and held at the sides.
void build_slot(Model& model, const char* solver) {
  model.set_text("pd.criterion", "opening");
  model.set_text("test.solver", solver);
  const int32_t body =
      model.pd(model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, critical)), rectangle(0, 0, 36, 44), 1, 3);
  model.crack({{12.4, 16.6}, {23.6, 27.8}});
  model.fix(body, 1, BEMPD_Y);
  model.prescribe(body, 3, BEMPD_Y, 0, -1);
  model.fix_point({0, 0}, BEMPD_X);
}

TEST(Compression, windows_break_a_pressed_plate_as_the_whole_body_does) {
  std::vector<Event> seen[2];
  for (const bool window : {false, true}) {
    BondModel model;
    build_slot(model, window ? "window" : "plain");
    for (int k = 0; k < 40; ++k) model.next_event(1e3);
    seen[window ? 1 : 0] = events(model);
    std::printf("%zu events, the last at %.6g with %lld bonds\n", seen[window].size(), seen[window].back().load_factor,
                static_cast<long long>(seen[window].back().broken));
  }
  ASSERT_EQ(seen[0].size(), seen[1].size());
  for (std::size_t k = 0; k < seen[0].size(); ++k) {
    EXPECT_EQ(seen[0][k].broken, seen[1][k].broken);
    EXPECT_NEAR(seen[0][k].load_factor, seen[1][k].load_factor, 1e-9 * seen[0][k].load_factor);
  }
}

TEST(Compression, a_state_goes_on_as_the_run_did) {
  BondModel model;
  build_slot(model, "plain");
  for (int k = 0; k < 5; ++k) model.next_event(1e3);
  const auto state = model.save();
  for (int k = 0; k < 10; ++k) model.next_event(1e3);
  const std::vector<Event> first = events(model);
  model.restore(state);
  for (int k = 0; k < 10; ++k) model.next_event(1e3);
  const std::vector<Event> again = events(model);
  ASSERT_EQ(first.size(), again.size());
  EXPECT_EQ(first.back().broken, again.back().broken);
  EXPECT_EQ(first.back().load_factor, again.back().load_factor);
}

}  // namespace
}  // namespace compression_test

// Pieces that come free, and bodies that come apart under dead loads: no matrix may become singular in silence, no
// number may become NaN, and the run goes on. References: statics.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace fracture_fragments_test {
namespace {

using namespace host;

// A lattice of 21 x 21 cells pulled at its ends, with a square of 8 x 8 cells inside that cracks surround but for gaps
// in its left and right sides, so that the square is stretched with the frame.
struct FramedSquare {
  explicit FramedSquare(double half_gap) {
    const int32_t id = model.add(material(30e9, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3));
    plate = model.pd(id, rectangle(0, 0, 21, 21), 1, 3);
    const double lower = 10.5 - half_gap, upper = 10.5 + half_gap;
    if (half_gap > 0) {
      model.crack({{6.5, lower}, {6.5, 6.5}, {14.5, 6.5}, {14.5, lower}});
      model.crack({{6.5, upper}, {6.5, 14.5}, {14.5, 14.5}, {14.5, upper}});
    } else {
      model.crack({{6.5, 6.5}, {14.5, 6.5}, {14.5, 14.5}, {6.5, 14.5}, {6.5, 6.5}});
    }
    model.prescribe(plate, 4, BEMPD_X, 0, -1e-3);
    right_end = model.prescribe(plate, 2, BEMPD_X, 0, 1e-3);
    model.fix_point({0, 10}, BEMPD_Y);
    model.set("crack.tie_share", 1e-3);
  }
  void expect_finite_fields() {
    for (int32_t field : {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_BOND_STRETCH, BEMPD_DAMAGE})
      EXPECT_TRUE(all_finite(model.field(plate, field))) << "field " << field;
    EXPECT_TRUE(std::isfinite(model.reaction(right_end)[0]));
  }
  BondModel model;
  int32_t plate = 0, right_end = 0;
};

TEST(Fragments, a_square_cut_out_by_cracks_is_a_fragment_from_the_start) {
  FramedSquare scene(0);
  const bempd_step_report first = scene.model.step(0.1);
  EXPECT_EQ(report("fragments", static_cast<double>(first.fragments), 1, "closed crack"), 0);
  EXPECT_LE(first.residual, 1e-9);
  scene.expect_finite_fields();
  EXPECT_LT(
      report("stress in the fragment", largest({scene.model.evaluate({10.5, 10.5}).stress[0]}) / 30e9, 0, "statics"),
      1e-12);

  const bempd_step_report end = scene.model.run(1e4);
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_GE(end.fragments, 1);
  EXPECT_LE(report("energy balance", worst_energy_balance(scene.model), 0, "first law"), 1e-8);
  scene.expect_finite_fields();
}

TEST(Fragments, a_square_that_tears_off_both_ligaments_comes_free_and_the_run_goes_on) {
  FramedSquare scene(1);
  EXPECT_EQ(scene.model.step(1e-3).fragments, 0);
  int64_t events_before = 0, events_after = 0;
  bempd_step_report last{};
  do {
    last = scene.model.next_event(1e4);
    (last.fragments == 0 ? events_before : events_after) += last.events;
    ASSERT_LE(last.residual, 1e-9);
  } while (last.stop_reason == BEMPD_STOP_EVENT && last.separated == 0);
  std::printf("events before the square comes free %lld, after %lld\n", static_cast<long long>(events_before),
              static_cast<long long>(events_after));
  EXPECT_GT(events_before, 0);
  EXPECT_GT(events_after, 0);
  EXPECT_EQ(last.separated, 1);
  EXPECT_LE(report("energy balance", worst_energy_balance(scene.model), 0, "first law"), 1e-8);
  scene.expect_finite_fields();
}

}  // namespace
}  // namespace fracture_fragments_test

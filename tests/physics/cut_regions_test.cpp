// BEM regions that cracks cut into pieces, from the start or by growing: each piece is as if it were described as a
// region of its own. References: those regions, each in a model of its own, and statics.
#include <gtest/gtest.h>

#include <algorithm>

#include "host.hpp"

namespace cut_regions_test {
namespace {

using namespace host;

constexpr double width = 1, height = 2;

bempd_material glass(double fracture_energy = 1) {
  bempd_material glass = material(1, 0.3);
  glass.fracture_energy = fracture_energy;
  return glass;
}

int64_t piece_count(Model& model) {
  int64_t count = 0;
  model.check(bempd_piece_count(model.get(), &count));
  return count;
}

bempd_piece piece(Model& model, int32_t number) {
  bempd_piece piece;
  bempd_piece_init(&piece, sizeof piece);
  model.check(bempd_get_piece(model.get(), number, &piece));
  return piece;
}

bempd_growth grow(Model& model, double length) {
  bempd_growth growth;
  bempd_growth_init(&growth, sizeof growth);
  model.check(bempd_grow_cracks(model.get(), length, &growth));
  return growth;
}

const Field side_load = [](double, double y) -> Vector { return {0.02 * y, 0.01}; };

// Part below or above the cut of a strip that is cut from its left edge to its right one, with eight elements on the
// cut: held at its far end, with a load on one side.
struct Piece {
  Model model;
  int32_t region = 0, support = 0;

  Piece(const Outline& outline, int32_t held_edge, int32_t cut_edge, double element_length) {
    region = model.bem(model.add(glass()), outline, element_length);
    const auto from = static_cast<std::size_t>(cut_edge - 1);
    const Vector &start = outline[from], &end = outline[(from + 1) % outline.size()];
    model.mesh(region, cut_edge, 1.0001 / 8 * std::hypot(end[0] - start[0], end[1] - start[1]), 1);
    support = model.fix(region, held_edge, BEMPD_BOTH);
    model.traction(region, 2, side_load);
    model.step(1);
  }
};

struct CutStrip {
  Model model;
  int32_t region = 0, below = 0, above = 0;

  CutStrip(const Outline& cut, double element_length) {
    model.set_text("contact", "none");
    region = model.bem(model.add(glass()), rectangle(0, 0, width, height), element_length);
    model.crack(cut);
    below = model.fix(region, 1, BEMPD_BOTH);
    above = model.fix(region, 3, BEMPD_BOTH);
    model.traction(region, 2, side_load);
    model.step(1);
  }
};

struct Difference {
  double displacement = 0, stress = 0, reaction = 0, energy = 0;
};

// Relative to the largest one of each piece.
Difference difference_of(const Vector& left, const Vector& right, double element_length) {
  CutStrip strip({left, right}, element_length);
  Piece below({{0, 0}, {width, 0}, right, left}, 1, 3, element_length);
  Piece above({left, right, {width, height}, {0, height}}, 3, 1, element_length);
  Difference worst;
  for (const bool upper : {false, true}) {
    Piece& alone = upper ? above : below;
    double displacement = 0, stress = 0, largest_displacement = 0, largest_stress = 0;
    for (const double x : {0.13, 0.4, 0.62, 0.9})
      for (const double part : {0.1, 0.35, 0.6, 0.9}) {
        const double at_cut = left[1] + (right[1] - left[1]) * x / width, far = upper ? height : 0;
        const Vector place{x, far + part * (at_cut - far)};
        const Model::Values own = alone.model.evaluate(place), cut = strip.model.evaluate(place);
        for (int c = 0; c < 2; ++c) {
          displacement = std::max(displacement, std::abs(own.displacement[c] - cut.displacement[c]));
          largest_displacement = std::max(largest_displacement, std::abs(own.displacement[c]));
        }
        for (int c = 0; c < 3; ++c) {
          stress = std::max(stress, std::abs(own.stress[c] - cut.stress[c]));
          largest_stress = std::max(largest_stress, std::abs(own.stress[c]));
        }
      }
    worst.displacement = std::max(worst.displacement, displacement / largest_displacement);
    worst.stress = std::max(worst.stress, stress / largest_stress);
    const Vector own = alone.model.reaction(alone.support),
                 cut = strip.model.reaction(upper ? strip.above : strip.below);
    const double size = std::hypot(own[0], own[1]);
    worst.reaction = std::max(worst.reaction, std::hypot(own[0] - cut[0], own[1] - cut[1]) / size);
  }
  const double energy = below.model.history().back().stored_energy + above.model.history().back().stored_energy;
  worst.energy = std::abs(strip.model.history().back().stored_energy / energy - 1);
  EXPECT_EQ(piece_count(strip.model), 2);
  return worst;
}

// The elements are no longer than those of the cut, so that both bodies have the same element ends.
TEST(CutRegions, pieces_of_a_strip_are_like_regions_of_their_own) {
  for (const auto& [left, right] : {std::pair<Vector, Vector>{{0, 1}, {width, 1}}, {{0, 0.8}, {width, 1.3}}}) {
    const Difference d = difference_of(left, right, 0.125);
    std::printf("cut from %g to %g: displacement %.1e, stress %.1e, reaction %.1e, energy %.1e\n", left[1], right[1],
                d.displacement, d.stress, d.reaction, d.energy);
    EXPECT_LE(d.reaction, 1e-12);
    EXPECT_LE(d.displacement, 1e-9);
    EXPECT_LE(d.stress, 1e-8);
    EXPECT_LE(d.energy, 1e-10);
  }
}

// A crack from the left edge to the right one whose path has a hole in it, and two that meet.
TEST(CutRegions, cracks_cut_together) {
  struct Case {
    const char* name;
    std::vector<Outline> cracks;
    bool hole;
    int64_t pieces;
  };
  for (const Case& c : {Case{"to a hole from both edges", {{{0, 1}, {0.3, 1}}, {{0.7, 1}, {1, 1.2}}}, true, 2},
                        Case{"two that meet", {{{0, 0.9}, {0.5, 1.1}}, {{0.5, 1.1}, {1, 1}}}, false, 2},
                        Case{"one that ends at the other", {{{0, 0.9}, {1, 1}}, {{0.5, 1.5}, {0.6, 0.96}}}, false, 2},
                        Case{"one from a hole to the edge", {{{0, 1}, {0.3, 1}}}, true, 1}}) {
    Model model;
    const int32_t plate = model.bem(model.add(glass()), rectangle(0, 0, width, height), 0.25);
    if (c.hole) model.circular_hole(plate, {0.5, 1}, 0.2);
    for (const Outline& crack : c.cracks) model.crack(crack);
    const int32_t below = model.fix(plate, 1, BEMPD_BOTH), above = model.fix(plate, 3, BEMPD_BOTH);
    model.traction(plate, 2, [](double, double) -> Vector { return {0.02, 0.01}; });
    model.step(1);
    EXPECT_EQ(piece_count(model), c.pieces) << c.name;
    int32_t connected = -1;
    model.check(bempd_are_connected(model.get(), below, above, &connected));
    EXPECT_EQ(connected, c.pieces == 1 ? 1 : 0) << c.name;
    const Vector one = model.reaction(below), other = model.reaction(above);
    EXPECT_NEAR(one[0] + other[0], -0.02 * height, 1e-12) << c.name;
    EXPECT_NEAR(one[1] + other[1], -0.01 * height, 1e-12) << c.name;
  }
}

// A piece that nothing holds has no equilibrium to begin with.
TEST(CutRegions, a_piece_that_nothing_holds_is_named) {
  Model model;
  const int32_t plate = model.bem(model.add(glass()), rectangle(0, 0, width, height), 0.25);
  model.crack({{0, 1}, {1, 1.2}});
  model.fix(plate, 1, BEMPD_BOTH);
  try {
    model.step(1);
    FAIL() << "no error";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("region 1 can translate in x and y, and rotate"), std::string::npos)
        << error.what();
  }
}

// A closed ring of cracks: what it cuts out has no stress, and the plate around it is one with a hole.
TEST(CutRegions, an_island_is_a_hole_to_the_rest) {
  Model cut, bored;
  const Outline ring{{0.3, 0.8}, {0.7, 0.8}, {0.7, 1.2}, {0.3, 1.2}, {0.3, 0.8}};
  std::array<double, 2> energies{};
  std::array<Vector, 2> moved{};
  for (const bool with_hole : {false, true}) {
    Model& model = with_hole ? bored : cut;
    const int32_t plate = model.bem(model.add(glass()), rectangle(0, 0, width, height), 0.05);
    if (with_hole)
      model.hole(plate, rectangular_hole(0.3, 0.8, 0.7, 1.2));
    else
      model.crack(ring);
    model.fix(plate, 1, BEMPD_BOTH);
    model.traction(plate, 3, 0, 1, BEMPD_Y, 0, 0.01);
    model.set_text("contact", "none");
    model.step(1);
    energies[with_hole] = model.history().back().stored_energy;
    moved[with_hole] = model.evaluate({0.85, 1.5}).displacement;
  }
  EXPECT_LE(std::abs(report("energy beside a ring of cracks", energies[0], energies[1], "plate with a hole")),
            5e-4 * energies[1]);
  EXPECT_LE(std::abs(report("displacement", moved[0][1], moved[1][1], "plate with a hole")), 5e-4 * moved[1][1]);
  EXPECT_EQ(piece_count(cut), 2);
  const Model::Values inside = cut.evaluate({0.5, 0.93});
  EXPECT_LE(largest({inside.stress[0], inside.stress[1], inside.stress[2]}), 1e-12);
}

// Faces that press on each other carry what the uncut strip carries.
TEST(CutRegions, pieces_press_on_each_other) {
  Model model;
  model.set_text("contact", "faces");
  const int32_t plate = model.bem(model.add(glass()), rectangle(0, 0, width, height), 0.25);
  model.crack({{0, 1}, {1, 1}});
  const int32_t below = model.fix(plate, 1, BEMPD_Y), above = model.prescribe(plate, 3, BEMPD_Y, 0, -0.01);
  model.fix_point({0, 0}, BEMPD_X);
  model.fix_point({0, 2}, BEMPD_X);
  model.step(1);
  const double force = 0.01 / height * width;
  EXPECT_NEAR(report("force through pressed faces", model.reaction(below)[1], force, "Hooke's law"), 0, 1e-9 * force);
  EXPECT_NEAR(model.reaction(above)[1], -force, 1e-9 * force);
  const Model::Values values = model.evaluate({0.4, 1.3});
  EXPECT_NEAR(report("stress above the cut", values.stress[1], -force, "Hooke's law"), 0, 1e-8 * force);
  EXPECT_NEAR(values.displacement[1], -0.01 * 1.3 / height, 1e-9);
}

// An edge crack grows to the other edge of a plate that is pulled apart; then each half is free of stress.
TEST(CutRegions, a_plate_is_torn_in_two) {
  Model model;
  const int32_t plate = model.bem(model.add(glass(1e-4)), rectangle(0, 0, width, height), 0.125);
  model.crack({{0, 1}, {0.3, 1}});
  const int32_t below = model.fix(plate, 1, BEMPD_BOTH), above = model.prescribe(plate, 3, BEMPD_Y, 0, 0.01);
  model.prepare();
  EXPECT_EQ(piece_count(model), 1);
  const SavedState whole = model.save();
  int steps = 0;
  double released = 0, length = 0;
  for (bempd_growth growth{}; growth.ended == 0; ++steps) {
    ASSERT_LT(steps, 40);
    growth = grow(model, 0.08);
    length += growth.length;
    released += growth.released_energy;
  }
  const double load_factor = model.load_factor();
  EXPECT_EQ(piece_count(model), 2);
  int32_t connected = -1;
  model.check(bempd_are_connected(model.get(), below, above, &connected));
  EXPECT_EQ(connected, 0);
  EXPECT_NEAR(report("length of growth", length, 0.7, "width less crack"), 0, 0.01);
  std::printf("%d steps, released energy %g\n", steps, released);
  EXPECT_LE(std::abs(report("force across", model.reaction(above)[1], 0, "torn")), 1e-12);
  EXPECT_LE(model.history().back().stored_energy, 1e-12);
  EXPECT_NEAR(model.evaluate({0.5, 1.7}).displacement[1], 0.01 * load_factor, 1e-9);
  EXPECT_NEAR(model.evaluate({0.5, 0.3}).displacement[1], 0, 1e-9);
  EXPECT_NEAR(piece(model, 1).deviation, 0, 1e-9);
  // A state saved before, and one saved after.
  const SavedState torn = model.save();
  model.restore(whole);
  EXPECT_EQ(piece_count(model), 1);
  model.restore(torn);
  EXPECT_EQ(piece_count(model), 2);
  EXPECT_EQ(model.load_factor(), load_factor);
  EXPECT_LE(std::abs(model.reaction(above)[1]), 1e-12);
}

// A cracked body that is torn by its own steps; the report of the last one.
bempd_step_report run_to_the_end(Model& model) {
  bempd_step_report report = model.next_event(1e9);
  for (int steps = 0; steps < 40 && report.stop_reason == BEMPD_STOP_EVENT; ++steps) report = model.next_event(1e9);
  return report;
}

// A piece that a crack frees stays where it is. The rest of the body springs back against it, and its faces pass
// through that piece, which nothing holds.
TEST(CutRegions, faces_do_not_press_on_a_piece_that_nothing_holds) {
  Model model;
  const int32_t glass = model.add(cut_regions_test::glass(1.6e-6));
  const int32_t left = model.bem(glass, rectangle(0, 0, 10, 13), 4),
                right = model.bem(glass, rectangle(10, 0, 13, 13), 4);
  model.crack({{2.18, 13}, {4.65, 2.16}});
  model.fix(left, 4, BEMPD_BOTH);
  model.prescribe(right, 2, BEMPD_Y, 0, 0.013);
  model.prescribe(right, 4, BEMPD_Y, 0, 0.001);
  const bempd_step_report report = run_to_the_end(model);
  EXPECT_EQ(report.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_LE(host::report("residual", report.residual, 0, "equilibrium"), 1e-12);
  EXPECT_LE(report.energy_balance_error, 1e-12);
}

// A wedge that is cut off and held in x alone: faces that press on it would push it out along y without an end. They
// do not, and equilibrium is kept.
TEST(CutRegions, faces_do_not_push_a_piece_along_its_support) {
  Model model;
  const int32_t plate = model.bem(model.add(glass(1.6e-6)), rectangle(0, 0, 13, 13), 2);
  model.crack({{10, 13}, {2, 3.6}});
  const int32_t held = model.fix(plate, 4, BEMPD_X);
  const int32_t pressed = model.prescribe(plate, 2, BEMPD_X, 0, -0.026);
  const double still = 0;
  int32_t part = 0;
  model.check(bempd_prescribe_edge(model.get(), plate, 1, 0.25, 0.5, BEMPD_Y, 1, &still, &still, &part));
  const bempd_step_report report = run_to_the_end(model);
  EXPECT_EQ(report.stop_reason, BEMPD_STOP_NO_FURTHER_EVENT);
  EXPECT_EQ(piece_count(model), 2);
  EXPECT_LE(host::report("residual", report.residual, 0, "equilibrium"), 1e-12);
  const double force = model.reaction(held)[0];
  EXPECT_NEAR(model.reaction(pressed)[0], -force, 1e-10 * force);
}

// A plate that hangs under its own weight tears: what falls off has no equilibrium. The run ends just before, with the
// weight on the support, and says that the body is separated.
TEST(CutRegions, a_plate_tears_under_its_weight) {
  for (const bool to_a_load_factor : {false, true}) {
    Model model;
    const int32_t plate = model.bem(model.add(glass(1e-4)), rectangle(0, 0, width, height), 0.25);
    model.crack({{0, 1.2}, {0.3, 1.2}});
    const int32_t top = model.fix(plate, 3, BEMPD_BOTH);
    model.check(bempd_add_body_force(model.get(), plate, BEMPD_Y, 0, -0.01, nullptr));
    const bempd_step_report report = to_a_load_factor ? model.step(100) : run_to_the_end(model);
    EXPECT_EQ(report.stop_reason, to_a_load_factor ? BEMPD_STOP_NO_EQUILIBRIUM : BEMPD_STOP_SEPARATED);
    EXPECT_EQ(report.separated, 1);
    EXPECT_EQ(piece_count(model), 1);
    EXPECT_LE(report.energy_balance_error, 1e-9);
    const double weight = 0.01 * width * height * model.load_factor();
    EXPECT_NEAR(host::report("support's force", model.reaction(top)[1], weight, "weight"), 0, 1e-6 * weight);
    const double reached = model.load_factor();
    EXPECT_EQ(model.next_event(100).stop_reason, BEMPD_STOP_SEPARATED);
    EXPECT_EQ(model.load_factor(), reached);
  }
}

}  // namespace
}  // namespace cut_regions_test

// Arcs by centre and radius, and round regions. References: the same scene by places on the arcs; a disc under pressure
// p has the stress -p in all directions everywhere (Lame).
#include <gtest/gtest.h>

#include "host.hpp"

namespace arc_about_test {
namespace {

using namespace host;

int32_t disc(Model& model, int32_t material, Vector centre, double radius, double length) {
  int32_t id = 0;
  model.check(bempd_add_bem_disc(model.get(), material, centre[0], centre[1], radius, length, &id));
  return id;
}

void bend(Model& model, int32_t region, int32_t edge, Vector centre, double radius, int32_t turn) {
  model.check(bempd_set_edge_arc_about(model.get(), region, edge, centre[0], centre[1], radius, turn));
}

bempd_status try_bend(Model& model, int32_t edge, Vector centre, double radius, int32_t turn) {
  return bempd_set_edge_arc_about(model.get(), 1, edge, centre[0], centre[1], radius, turn);
}

TEST(ArcAbout, puts_the_nodes_on_the_circle_on_the_side_of_its_turn) {
  // A unit square; the lower edge bulges out by a half circle, or in by an eighth of one, or turns three quarters
  // round.
  struct Case {
    Vector centre;
    double radius;
    int32_t turn;
    double lowest, highest;  // of the edge's nodes
  };
  const double h = std::sqrt(0.5);
  for (const Case& c :
       {Case{{0.5, 0}, 0.5, BEMPD_COUNTER_CLOCKWISE, -0.5, 0}, Case{{0.5, -0.5}, h, BEMPD_CLOCKWISE, 0, h - 0.5},
        Case{{0.5, -0.5}, h, BEMPD_COUNTER_CLOCKWISE, -0.5 - h, 0}}) {
    Model model;
    const int32_t body = model.bem(model.add(material(1, 0.3)), rectangle(0, 0, 1, 1), 0.25);
    bend(model, body, 1, c.centre, c.radius, c.turn);
    model.fix(body, 3, BEMPD_BOTH);
    double lowest = 1, highest = -1;
    for (const Vector& p : model.vectors(body, BEMPD_POSITION)) {
      const double off = std::hypot(p[0] - c.centre[0], p[1] - c.centre[1]) - c.radius;
      const bool on_other_edge = std::min({std::abs(p[0]), std::abs(p[0] - 1), std::abs(p[1] - 1)}) < 1e-12;
      if (std::abs(off) > 1e-12) {
        EXPECT_TRUE(on_other_edge) << p[0] << " " << p[1];
        continue;
      }
      lowest = std::min(lowest, p[1]), highest = std::max(highest, p[1]);
    }
    EXPECT_NEAR(lowest, c.lowest, c.lowest < -0.3 ? 0.02 : 1e-12);
    EXPECT_NEAR(highest, c.highest, c.highest > 0.1 ? 0.01 : 1e-12);
  }
}

TEST(ArcAbout, is_the_arc_through_a_place) {
  double displacement[2][2];
  for (const bool about : {false, true}) {
    Model model;
    const int32_t body = model.bem(model.add(material(1, 0.3)), rectangle(0, 0, 2, 1), 0.2);
    // The centre is (1, -2), so the radius is the root of 5.
    const double radius = std::sqrt(5.0);
    if (about)
      bend(model, body, 1, {1, -2}, radius, BEMPD_CLOCKWISE);
    else
      model.check(bempd_set_edge_arc(model.get(), body, 1, 1, radius - 2));
    model.fix(body, 4, BEMPD_BOTH);
    model.traction(body, 2, 0, 1, BEMPD_Y, 0, -1);
    model.step(1);
    const Vector u = model.evaluate({2, 0.7}).displacement;
    displacement[about][0] = u[0], displacement[about][1] = u[1];
  }
  for (int c = 0; c < 2; ++c) EXPECT_NEAR(displacement[1][c], displacement[0][c], 1e-11 * std::abs(displacement[0][c]));
}

TEST(ArcAbout, refuses_what_is_not_on_the_circle_with_both_distances) {
  Model model;
  model.bem(model.add(material(1, 0.3)), rectangle(0, 0, 1, 1), 0.25);
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, 0.5 + 1e-8, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(model.get())).find("begins 0.5 and ends 0.5 from the centre"),
            std::string::npos);
  EXPECT_EQ(try_bend(model, 1, {0.4, 0}, 0.5, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, 0, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, -0.5, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, NAN, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 1, {NAN, 0}, 0.5, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, 0.5, 0), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, 0.5, 3), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(try_bend(model, 5, {0.5, 0}, 0.5, BEMPD_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  // The arc bulges into the body up to its upper edge and beyond.
  EXPECT_EQ(try_bend(model, 1, {0.5, 0.6}, std::hypot(0.5, 0.6), BEMPD_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  // The radius is within the tolerance: 1e-9 of the diagonal.
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, 0.5 + 1e-9, BEMPD_COUNTER_CLOCKWISE), BEMPD_OK);
  EXPECT_EQ(bempd_set_edge_arc_about(model.get(), 2, 1, 0.5, 0, 0.5, BEMPD_CLOCKWISE), BEMPD_ERROR_ARGUMENT);
  model.fix(1, 3, BEMPD_BOTH);
  model.prepare();
  EXPECT_EQ(try_bend(model, 1, {0.5, 0}, 0.5, BEMPD_COUNTER_CLOCKWISE), BEMPD_ERROR_ORDER);
}

TEST(Disc, under_pressure_has_its_stress) {
  constexpr double pressure = 3e6;
  Model model;
  const int32_t body = disc(model, model.add(material(70e9, 0.3)), {1, 2}, 0.5, 0.1);
  for (int32_t edge = 1; edge <= 4; ++edge)
    model.check(bempd_add_pressure(model.get(), body, edge, 0, 1, 1, nullptr, &pressure, nullptr));
  model.fix_point({0.5, 2}, BEMPD_BOTH);
  model.fix_point({1.5, 2}, BEMPD_Y);
  model.step(1);
  for (const Vector& at : {Vector{1, 2}, Vector{1.2, 2.3}, Vector{0.7, 1.8}}) {
    const auto stress = model.evaluate(at).stress;
    EXPECT_LE(std::abs(report("stress xx", stress[0], -pressure, "Lame")), 1e-5 * pressure);
    EXPECT_LE(std::abs(report("stress yy", stress[1], -pressure, "Lame")), 1e-5 * pressure);
  }
}

// A plate with a disc of its own material in a circular hole is the plate.
TEST(Disc, fits_into_a_circular_hole) {
  Model model;
  const int32_t id = model.add(material(1, 0.3));
  const int32_t plate = model.bem(id, rectangle(0, 0, 2, 1), 0.2);
  model.circular_hole(plate, {0.9, 0.5}, 0.3);
  disc(model, id, {0.9, 0.5}, 0.3, 0.2);
  model.fix(plate, 4, BEMPD_X);
  model.fix_point({0, 0}, BEMPD_Y);
  model.traction(plate, 2, 0, 1, BEMPD_X, 0, 1);
  model.step(1);
  for (const Vector& at : {Vector{0.9, 0.5}, Vector{1.1, 0.6}, Vector{0.3, 0.2}}) {
    const Model::Values values = model.evaluate(at);
    EXPECT_NEAR(values.displacement[0], at[0], 1e-9);
    EXPECT_NEAR(values.stress[0], 1, 1e-8);
    EXPECT_EQ(values.region, std::hypot(at[0] - 0.9, at[1] - 0.5) < 0.3 ? 2 : 1);
  }
}

TEST(Disc, needs_a_radius_and_a_material) {
  Model model;
  const int32_t id = model.add(material(1, 0.3));
  for (const double wrong : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_EQ(bempd_add_bem_disc(model.get(), id, 0, 0, wrong, 0.1, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_add_bem_disc(model.get(), id, NAN, 0, 1, 0.1, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_add_bem_disc(model.get(), id, 0, 0, 1, 0, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_add_bem_disc(model.get(), 2, 0, 0, 1, 0.1, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_add_bem_disc(model.get(), id, 0, 0, 1, 0.1, nullptr), BEMPD_OK);
}

}  // namespace
}  // namespace arc_about_test

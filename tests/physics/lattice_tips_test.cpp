// Stress intensity factors of cracks in lattices against those of cracks in boundary elements, which closed forms vouch
// for (crack_factors_test), as long as the lattice's are felt.
#include <gtest/gtest.h>

#include <limits>

#include "host.hpp"

namespace lattice_tips_test {
namespace {

using namespace host;

std::vector<bempd_crack_tip> tips(Model& model) {
  int64_t count = 0;
  model.check(bempd_tip_count(model.get(), &count));
  std::vector<bempd_crack_tip> found(static_cast<std::size_t>(count));
  for (int64_t k = 0; k < count; ++k) {
    bempd_crack_tip_init(&found[static_cast<std::size_t>(k)], sizeof(bempd_crack_tip));
    model.check(bempd_tip(model.get(), k, &found[static_cast<std::size_t>(k)]));
  }
  return found;
}

// A plate 4 x 6 around the origin with one crack, pulled by 1 in y; a lattice if it has a spacing.
struct Plate {
  double spacing = 0;
  int horizon_ratio = 0;
  int32_t plane = BEMPD_PLANE_STRESS;
  const char* rule = "bond";
  std::array<double, 3> stress{0, 1, 0};  // xx, yy, xy

  std::vector<bempd_crack_tip> tips_of(const Outline& crack) const {
    BondModel model;
    model.set_text("crack.rule", rule);
    const int32_t id = model.add(material(1, bond_poisson(plane), plane));
    const Outline box = rectangle(-2, -3, 2, 3);
    const int32_t body = spacing > 0 ? model.pd(id, box, spacing, horizon_ratio) : model.bem(id, box, 0.25);
    model.crack(crack);
    model.fix_point({-2, -3}, BEMPD_BOTH);
    model.fix_point({2, -3}, BEMPD_Y);
    for (const auto& [edge, sign] : {std::pair(3, 1.0), std::pair(1, -1.0)}) {
      model.traction(body, edge, 0, 1, BEMPD_Y, 0, sign * stress[1]);
      if (stress[2] != 0) model.traction(body, edge, 0, 1, BEMPD_X, 0, sign * stress[2]);
    }
    for (const auto& [edge, sign] : {std::pair(2, 1.0), std::pair(4, -1.0)}) {
      if (stress[0] != 0) model.traction(body, edge, 0, 1, BEMPD_X, 0, sign * stress[0]);
      if (stress[2] != 0) model.traction(body, edge, 0, 1, BEMPD_Y, 0, sign * stress[2]);
    }
    model.step(1);
    return tips(model);
  }
};

Outline inclined(double degrees, double from, double to, Vector centre) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  return {{centre[0] + from * c, centre[1] + from * s}, {centre[0] + to * c, centre[1] + to * s}};
}

void compare(const Plate& lattice, double degrees, double half_length, Vector centre, double limit, double limit_of_t) {
  const auto found = lattice.tips_of(inclined(degrees, -half_length, half_length, centre));
  ASSERT_EQ(found.size(), 2u);
  const Plate elements{0, 0, lattice.plane};
  const auto felt = elements.tips_of(
      inclined(degrees, -half_length - found[0].felt_ahead, half_length + found[1].felt_ahead, centre));
  const auto stated = elements.tips_of(inclined(degrees, -half_length, half_length, centre));
  for (int k = 0; k < 2; ++k) {
    const double size = std::hypot(felt[k].stress_intensity_1, felt[k].stress_intensity_2);
    std::printf("felt %.3f spacings ahead; factors of the stated length are off by %+.2e\n",
                found[k].felt_ahead / lattice.spacing, found[k].stress_intensity_1 / stated[k].stress_intensity_1 - 1);
    const double one = report("K_I", found[k].stress_intensity_1, felt[k].stress_intensity_1, "boundary elements");
    const double two = report("K_II", found[k].stress_intensity_2, felt[k].stress_intensity_2, "boundary elements");
    const double along = report("T", found[k].t_stress, felt[k].t_stress, "boundary elements");
    EXPECT_LT(std::hypot(one, two), limit * size);
    EXPECT_LT(std::abs(along), limit_of_t);
    EXPECT_EQ(found[k].contours, 3);
    EXPECT_LT(found[k].error, limit * size);
    EXPECT_GT(found[k].felt_ahead / lattice.spacing, 0.1);
    EXPECT_LT(found[k].felt_ahead / lattice.spacing, 1.0);
  }
}

TEST(LatticeTips, of_a_centre_crack_have_its_factors) {
  for (const int m : {3, 4, 5}) compare({0.05, m}, 0, 0.475, {0, 0.025}, 4e-3, 0.06);
}

// Effective tips of cracks that grow as lines are at the stated places, wherever these are within a spacing and for any
// direction of the crack.
TEST(LatticeTips, are_felt_where_they_are_stated) {
  struct Case {
    int horizon_ratio;
    double degrees;
    Vector shift;
  };
  double largest = 0;
  for (const Case& c : {Case{3, 0, {0.03, 0.5}},
                        {3, 0, {0.42, 0.5}},
                        {3, 0, {0.8, 0.5}},
                        {4, 0, {0.2, 0.5}},
                        {4, 0, {0.6, 0.5}},
                        {4, 30, {0.11, 0.42}},
                        {5, 20, {0.7, 0.13}}}) {
    constexpr double dx = 0.05;
    Plate lattice{dx, c.horizon_ratio};
    lattice.rule = "line";
    const double angle = c.degrees * 3.14159265358979323846 / 180;
    Vector normal{-std::sin(angle), std::cos(angle)};
    lattice.stress = {normal[0] * normal[0], normal[1] * normal[1], normal[0] * normal[1]};
    const auto found = lattice.tips_of(inclined(c.degrees, -15 * dx, 15 * dx, {c.shift[0] * dx, c.shift[1] * dx}));
    ASSERT_EQ(found.size(), 2u);
    for (const bempd_crack_tip& tip : found) {
      std::printf("m %d, %.0f degrees: felt %+.3f spacings ahead\n", c.horizon_ratio, c.degrees, tip.felt_ahead / dx);
      largest = std::max(largest, std::abs(tip.felt_ahead) / dx);
    }
  }
  EXPECT_LT(report("felt ahead, spacings", largest, 0, "the stated place"), 0.1);
}

// Points on the crack as it is described lie beside it in the lattice, all on one side. The plate is the same from left
// to right, and so are both tips.
TEST(LatticeTips, of_a_crack_through_points_are_alike_at_both_ends) {
  for (const char* rule : {"bond", "line"}) {
    Plate lattice{0.05, 4};
    lattice.rule = rule;
    const auto found = lattice.tips_of({{-0.487, 0}, {0.487, 0}});
    ASSERT_EQ(found.size(), 2u);
    const double reference = found[0].stress_intensity_1;
    EXPECT_LT(std::abs(report("K_I", found[1].stress_intensity_1, reference, "the other end")), 1e-2 * reference);
    EXPECT_NEAR(found[1].felt_ahead, found[0].felt_ahead, 0.1 * lattice.spacing);
    EXPECT_LT(found[1].error, 2e-2 * reference);
  }
}

// The faces of a crack bear the pressure across it; they slide as those of boundary elements.
TEST(LatticeTips, of_a_crack_that_is_pressed_shut_have_no_mode_I) {
  const Outline crack = inclined(30, -0.487, 0.487, {0.011, 0.017});
  const std::array<double, 3> pressure{0, -1, 0};
  const auto elements = Plate{0, 0, BEMPD_PLANE_STRESS, "bond", pressure}.tips_of(crack);
  for (const char* rule : {"bond", "line"}) {
    const auto found = Plate{0.05, 4, BEMPD_PLANE_STRESS, rule, pressure}.tips_of(crack);
    ASSERT_EQ(found.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(found[k].stress_intensity_1, 0);
      const double known = elements[k].stress_intensity_2;
      EXPECT_LT(std::abs(report("K_II", found[k].stress_intensity_2, known, "boundary elements")),
                0.08 * std::abs(known));
    }
  }
}

TEST(LatticeTips, of_a_crack_that_is_only_pressed_never_grow) {
  Model model;
  model.set_text("crack.load", "energy");
  model.lattice_angle = 17 * 3.14159265358979323846 / 180;
  bempd_material solid = material(1, 1.0 / 3);
  solid.fracture_energy = 1;
  const int32_t body = model.pd(model.add(solid), rectangle(0, 0, 40, 40), 1, 4);
  model.crack({{13.2, 20.4}, {27.3, 20.4}});
  model.fix_point({0, 0}, BEMPD_BOTH);
  model.fix_point({40, 0}, BEMPD_Y);
  model.traction(body, 1, 0, 1, BEMPD_Y, 0, 1);
  model.traction(body, 3, 0, 1, BEMPD_Y, 0, -1);
  model.step(1e-3);
  const auto found = tips(model);
  ASSERT_EQ(found.size(), 2u);
  for (const bempd_crack_tip& tip : found) {
    EXPECT_EQ(tip.stress_intensity_1, 0);
    EXPECT_EQ(tip.critical_load_factor, std::numeric_limits<double>::max());
  }
}

TEST(LatticeTips, of_an_inclined_crack_have_both_modes) {
  compare({0.05, 3}, 45, 0.7, {-0.0125, 0.0125}, 1.5e-2, 0.03);
  compare({0.05, 3}, 30, 0.7, {0.011, 0.017}, 2e-2, 0.05);
}

TEST(LatticeTips, in_plane_strain_have_its_factors) {
  compare({0.05, 3, BEMPD_PLANE_STRAIN}, 0, 0.475, {0, 0.025}, 4e-3, 0.06);
}

// A crack of 80 spacings in a plate of 320, pulled by the load factor; in a patch of lattice whose ends are 14.5
// spacings ahead of the tips and 8.5 beside them, so that rings reach beyond it, or in boundary elements.
constexpr double dx = 1.0 / 40;

int32_t build_plate(Model& model, int horizon_ratio, double half_length) {
  bempd_material solid = material(1, 1.0 / 3);
  solid.fracture_energy = 1;
  const int32_t id = model.add(solid), plate = model.bem(id, rectangle(-4, -4, 4, 4), 0.5);
  const double x = 1 + 14.5 * dx, y = 8.5 * dx;
  if (horizon_ratio > 0) {
    model.hole(plate, rectangular_hole(-x, -y, x, y));
    model.pd(id, rectangle(-x, -y, x, y), dx, horizon_ratio);
  }
  model.crack({{-half_length, 0}, {half_length, 0}});
  model.fix_point({-4, -4}, BEMPD_BOTH);
  model.fix_point({4, -4}, BEMPD_Y);
  model.traction(plate, 3, 0, 1, BEMPD_Y, 0, 1);
  model.traction(plate, 1, 0, 1, BEMPD_Y, 0, -1);
  return plate;
}

bempd_crack_tip tip_in_elements(double half_length, double load_factor) {
  BondModel model;
  build_plate(model, 0, half_length);
  for (const int32_t end : {BEMPD_CRACK_START, BEMPD_CRACK_END})
    model.check(bempd_set_tip_frozen(model.get(), 1, end, 1));
  model.step(load_factor);
  return tips(model)[1];
}

TEST(LatticeTips, of_a_patch_in_boundary_elements_have_their_factors) {
  for (const int m : {3, 4, 5}) {
    BondModel model;
    build_plate(model, m, 1);
    model.step(0.01);
    const auto found = tips(model);
    ASSERT_EQ(found.size(), 2u);
    const bempd_crack_tip felt = tip_in_elements(1 + found[1].felt_ahead, 0.01);
    EXPECT_LT(std::abs(report("K_I of a patch", found[1].stress_intensity_1, felt.stress_intensity_1, "elements")),
              1e-3 * felt.stress_intensity_1);
    EXPECT_LT(std::abs(report("T of a patch", found[1].t_stress, felt.t_stress, "elements")), 1.5e-2 * 0.01);
    EXPECT_LT(found[1].error, 1e-4 * felt.stress_intensity_1);
    EXPECT_NEAR(found[1].stress_intensity_1, found[0].stress_intensity_1, 1e-8);
    EXPECT_NEAR(found[1].stress_intensity_2, 0, 1e-8);
  }
}

// The stored energy grows at constant load by the energy released at both tips.
TEST(LatticeTips, have_the_energy_release_rate_that_longer_cracks_tell) {
  const auto stored = [](double half_length) {
    BondModel model;
    build_plate(model, 4, half_length);
    return model.step(0.01).stored_energy;
  };
  BondModel model;
  build_plate(model, 4, 1);
  model.step(0.01);
  const double rate = (stored(1 + dx) - stored(1 - dx)) / (4 * dx), told = tips(model)[1].energy_release_rate;
  EXPECT_LT(std::abs(report("energy release rate", told, rate, "energies of two lattices")), 4e-3 * rate);
}

TEST(LatticeTips, move_on_with_the_broken_bonds) {
  BondModel model;
  build_plate(model, 4, 1);
  for (int event = 0; event < 60; ++event) model.next_event(1e6);
  const auto found = tips(model);
  ASSERT_EQ(found.size(), 2u);
  for (const bempd_crack_tip& tip : found) {
    EXPECT_EQ(tip.grown, 1);
    EXPECT_EQ(tip.branched, 0);
    EXPECT_GT(std::abs(tip.x), 1 + 1.5 * dx);
    EXPECT_NEAR(tip.y, 0, 1e-9);
    EXPECT_NEAR(std::abs(tip.direction_x), 1, 1e-9);
    EXPECT_LT(std::abs(tip.felt_ahead), dx);
    const double felt = tip_in_elements(std::abs(tip.x) + tip.felt_ahead, model.load_factor()).stress_intensity_1;
    EXPECT_LT(std::abs(report("K_I of a grown tip", tip.stress_intensity_1, felt, "elements")), 1.5e-3 * felt);
  }
}

// Rings reach into the stiffer half, where their fields do not belong.
TEST(LatticeTips, beside_another_material_have_their_factors) {
  const auto tip = [](double spacing, double longer) {
    BondModel model;
    const int32_t soft = model.add(material(1, 1.0 / 3)), stiff = model.add(material(4, 1.0 / 3));
    const Outline left = rectangle(-2, -2.025, 0, 2.025), right = rectangle(0, -2.025, 1, 2.025);
    const int32_t a = spacing > 0 ? model.pd(soft, left, spacing, 3) : model.bem(soft, left, 0.25);
    const int32_t b = spacing > 0 ? model.pd(stiff, right, spacing, 3) : model.bem(stiff, right, 0.25);
    model.crack({{-2, 0}, {-0.625 + longer, 0}});
    model.fix_point({-2, -2.025}, BEMPD_BOTH);
    model.fix_point({1, -2.025}, BEMPD_Y);
    for (const int32_t body : {a, b}) {
      model.traction(body, 3, 0, 1, BEMPD_Y, 0, 1);
      model.traction(body, 1, 0, 1, BEMPD_Y, 0, -1);
    }
    model.step(1);
    return tips(model)[0];
  };
  const bempd_crack_tip found = tip(0.05, 0), felt = tip(0, found.felt_ahead);
  EXPECT_GT(found.contour_radius, 0.7);
  EXPECT_LT(std::abs(report("K_I", found.stress_intensity_1, felt.stress_intensity_1, "boundary elements")),
            1e-2 * felt.stress_intensity_1);
  EXPECT_LT(std::abs(report("T", found.t_stress, felt.t_stress, "boundary elements")), 0.15);
}

TEST(LatticeTips, are_gone_when_the_body_is_in_two) {
  BondModel model;
  bempd_material solid = material(1, 1.0 / 3);
  solid.fracture_energy = 1;
  const int32_t body = model.pd(model.add(solid), rectangle(0, -8.5, 16, 8.5), 1, 3);
  model.crack({{0, 0}, {6.5, 0}});
  model.fix(body, 1, BEMPD_BOTH);
  model.prescribe(body, 3, BEMPD_Y, 0, 1);
  model.step(1e-3);
  ASSERT_EQ(tips(model).size(), 1u);
  EXPECT_EQ(tips(model)[0].end, BEMPD_CRACK_END);
  model.run(1e3);
  EXPECT_EQ(tips(model).size(), 0u);
}

}  // namespace
}  // namespace lattice_tips_test

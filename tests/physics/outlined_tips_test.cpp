// Stress intensity factors in lattices with points on their outline: cracks that begin at a hole's edge or at a corner,
// whatever the direction of the lattice. Reference: boundary elements, their cracks as long as those in the lattice are
// felt to be; the scene is that of Bowie (1956) in a finite plate.
#include <gtest/gtest.h>

#include "host.hpp"

namespace outlined_tips_test {
namespace {

using namespace host;

std::vector<bempd_crack_tip> tips_of(Model& model) {
  int64_t found = 0;
  model.check(bempd_tip_count(model.get(), &found));
  std::vector<bempd_crack_tip> tips(static_cast<std::size_t>(found));
  for (std::size_t k = 0; k < tips.size(); ++k) {
    bempd_crack_tip_init(&tips[k], sizeof tips[k]);
    model.check(bempd_tip(model.get(), static_cast<int64_t>(k), &tips[k]));
  }
  return tips;
}

enum class Method { lattice, elements };

int32_t add_body(Model& model, Method method, const Outline& outline, double length) {
  const int32_t id = model.add(material(1, 1.0 / 3));
  return method == Method::lattice ? model.pd(id, outline, 1, 4) : model.bem(id, outline, length);
}

void pull(Model& model, int32_t region, const Outline& outline) {
  model.fix_point(outline[0], BEMPD_BOTH);
  model.fix_point(outline[1], BEMPD_Y);
  model.traction(region, 1, 0, 1, BEMPD_Y, 0, -1);
  model.traction(region, 3, 0, 1, BEMPD_Y, 0, 1);
  model.step(1);
}

// Cracks to the right and the left of a hole, at ends of its quarter circles.
std::vector<bempd_crack_tip> cracked_hole(Method method, const Vector& lengths, double angle = 0) {
  constexpr double radius = 10, half = 32;
  Model model;
  model.lattice_angle = angle;
  const Outline outline = rectangle(-half, -half, half, half);
  const int32_t region = add_body(model, method, outline, half / 4);
  model.circular_hole(region, {0, 0}, radius);
  model.crack({{radius, 0}, {radius + lengths[0], 0}});
  model.crack({{-radius, 0}, {-radius - lengths[1], 0}});
  pull(model, region, outline);
  return tips_of(model);
}

void expect_as_felt(double angle, double tolerance) {
  constexpr double length = 10.5;
  const auto found = cracked_hole(Method::lattice, {length, length}, angle);
  ASSERT_EQ(found.size(), 2U);
  const auto felt = cracked_hole(Method::elements, {length + found[0].felt_ahead, length + found[1].felt_ahead});
  ASSERT_EQ(felt.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(found[k].contours, 0);
    EXPECT_LT(std::abs(found[k].felt_ahead), 0.6);
    const double reference = felt[k].stress_intensity_1;
    EXPECT_LT(std::abs(report("K_I", found[k].stress_intensity_1, reference, "boundary elements")),
              tolerance * reference);
  }
}

TEST(OutlinedTips, of_cracks_at_a_hole_are_those_of_boundary_elements) { expect_as_felt(0, 4e-3); }

TEST(OutlinedTips, of_cracks_at_a_hole_in_a_turned_lattice) { expect_as_felt(0.4, 2.5e-2); }

// A crack that begins at a round hole closely beside a point of the outline has the factors of one that begins at it:
// the bond across its mouth lies off the body, and is parted all the same.
TEST(OutlinedTips, of_a_crack_beside_a_point_of_a_round_hole) {
  const auto factor = [](double aside) {
    Model model;
    const Outline outline = rectangle(-24, -24, 24, 24);
    const int32_t region = add_body(model, Method::lattice, outline, 4);
    model.circular_hole(region, {0, 0}, 6);
    const double x = 6 * std::cos(aside / 6), y = 6 * std::sin(aside / 6);
    model.crack({{x, y}, {x + 6, y}});
    pull(model, region, outline);
    return tips_of(model).at(0).stress_intensity_1;
  };
  const double reference = factor(0);
  EXPECT_LT(std::abs(report("K_I", factor(0.02), reference, "0.02 spacings beside it")), 0.03 * reference);
}

// Tips of a crack from a corner of a square that stands on its corner, half-way to its middle.
std::vector<bempd_crack_tip> cracked_corner(Method method, double length) {
  constexpr double half = 30;
  Model model;
  const Outline outline = {{0, -half}, {half, 0}, {0, half}, {-half, 0}};
  const int32_t region = add_body(model, method, outline, half / 5);
  model.crack({{-half, 0}, {-half + length, 0}});
  model.fix_point(outline[1], BEMPD_BOTH);
  model.fix_point(outline[2], BEMPD_X);
  // The load is not beside the mouth: a force on the corner's point would act on one side of the crack.
  model.traction(region, 3, 0, 0.5, BEMPD_Y, 0, 1);
  model.traction(region, 4, 0.5, 1, BEMPD_Y, 0, -1);
  model.step(1);
  return tips_of(model);
}

TEST(OutlinedTips, of_a_crack_from_a_corner) {
  const auto found = cracked_corner(Method::lattice, 15.5);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_GT(found[0].contours, 0);
  const double reference = cracked_corner(Method::elements, 15.5 + found[0].felt_ahead)[0].stress_intensity_1;
  EXPECT_LT(std::abs(report("K_I", found[0].stress_intensity_1, reference, "boundary elements")), 1e-2 * reference);
}

}  // namespace
}  // namespace outlined_tips_test

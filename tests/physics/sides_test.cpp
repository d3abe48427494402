// Values as one region has them at an interface, and on either face of a crack. References: two bonded strips under one
// strain along the interface (stress along it jumps with Young's modulus); Westergaard's crack.
#include <gtest/gtest.h>

#include "host.hpp"

namespace sides_test {
namespace {

using namespace host;

struct Values {
  Vector displacement;
  std::array<double, 3> stress;
};

Values values_in(Model& model, int32_t region, Vector at, int32_t face = BEMPD_FACE_LEFT) {
  Values values{};
  model.check(
      bempd_evaluate_in(model.get(), region, face, 1, at.data(), values.displacement.data(), values.stress.data()));
  return values;
}

// Lower strip of modulus 1, upper one of modulus 3, the same Poisson's ratio, stretched along the interface by 1 with
// free lower and upper edges: the stress along it is Young's modulus, on either side.
void expect_jump(Model& model) {
  for (const double x : {0.5, 0.8, 1.3}) {
    for (const int32_t region : {1, 2}) {
      const Values values = values_in(model, region, {x, 1});
      const double modulus = region == 1 ? 1 : 3;
      EXPECT_LE(std::abs(report("stress xx", values.stress[0], modulus, "uniaxial stress")), 1e-7);
      EXPECT_LE(std::abs(report("stress yy", values.stress[1], 0, "uniaxial stress")), 1e-7);
      EXPECT_NEAR(values.displacement[0], x, 1e-9);
    }
    const Model::Values chosen = model.evaluate({x, 1});
    EXPECT_EQ(chosen.stress, values_in(model, chosen.region, {x, 1}).stress);
  }
}

void stretch(Model& model) {
  for (const int32_t region : {1, 2}) {
    model.prescribe(region, 4, BEMPD_X, 0, 0);
    model.prescribe(region, 2, BEMPD_X, 0, 2);
  }
  model.fix_point({0, 0}, BEMPD_Y);
  model.step(1);
}

TEST(SidesOfAnInterface, have_the_stress_of_their_region) {
  for (const int lattices : {0, 1, 2}) {
    Model model;
    const int32_t soft = model.add(material(1, 1.0 / 3)), stiff = model.add(material(3, 1.0 / 3));
    const Outline lower = rectangle(0, 0, 2, 1), upper = rectangle(0, 1, 2, 2);
    lattices > 1 ? model.pd(soft, lower, 0.1, 3) : model.bem(soft, lower, 0.2);
    lattices > 0 ? model.pd(stiff, upper, 0.1, 3) : model.bem(stiff, upper, 0.2);
    stretch(model);
    EXPECT_EQ(model.evaluate({1, 1}).region, lattices == 1 ? 2 : 1);
    expect_jump(model);
  }
}

TEST(SidesOfAnInterface, are_asked_of_regions_that_have_the_place) {
  Model model;
  const int32_t id = model.add(material(1, 1.0 / 3));
  model.bem(id, rectangle(0, 0, 2, 1), 0.2);
  model.bem(id, rectangle(0, 1, 2, 2), 0.2);
  stretch(model);
  const double above[2] = {1, 1.5}, wrong[2] = {NAN, 1};
  double u[2];
  const auto ask = [&](int32_t region, int32_t face, const double* at) {
    return bempd_evaluate_in(model.get(), region, face, 1, at, u, nullptr);
  };
  EXPECT_EQ(ask(2, BEMPD_FACE_LEFT, above), BEMPD_OK);
  EXPECT_EQ(ask(1, BEMPD_FACE_LEFT, above), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(model.get())).find("outside region 1"), std::string::npos);
  EXPECT_EQ(ask(0, BEMPD_FACE_LEFT, above), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(ask(3, BEMPD_FACE_LEFT, above), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(ask(2, 0, above), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(ask(2, 3, above), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(ask(2, BEMPD_FACE_LEFT, wrong), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_evaluate_in(model.get(), 2, BEMPD_FACE_LEFT, 1, nullptr, u, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_evaluate_in(model.get(), 2, BEMPD_FACE_LEFT, 0, above, nullptr, nullptr), BEMPD_OK);
}

// A crack in a wide plate under tension and shear, from right to left, so that its left face lies below.
TEST(FacesOfACrack, differ_by_its_opening_and_are_free) {
  Model model;
  const int32_t plate = model.bem(model.add(material(1, 0.3)), rectangle(-3, -3, 3, 3), 0.5);
  model.crack({{1, 0}, {0.4, 0}, {-1, 0}});  // 0.4: certainly an end of elements
  const auto load = [&](int32_t edge, int32_t component, double value) {
    model.traction(plate, edge, 0, 1, component, 0, value);
  };
  load(3, BEMPD_Y, 1), load(1, BEMPD_Y, -1), load(3, BEMPD_X, 0.3), load(1, BEMPD_X, -0.3);
  load(2, BEMPD_Y, 0.3), load(4, BEMPD_Y, -0.3);
  model.fix_point({-3, -3}, BEMPD_BOTH);
  model.fix_point({3, -3}, BEMPD_Y);
  model.step(1);
  for (const double x : {0.9, 0.4, 0.0, -0.6}) {
    const double fraction = 0.5 * (1 - x);
    double normal = 0, tangential = 0;
    model.check(bempd_crack_opening(model.get(), 1, 1, &fraction, &normal, &tangential));
    const Values left = values_in(model, plate, {x, 0}, BEMPD_FACE_LEFT),
                 right = values_in(model, plate, {x, 0}, BEMPD_FACE_RIGHT);
    // The direction along the crack is -x, and to its left -y.
    EXPECT_NEAR(-(left.displacement[1] - right.displacement[1]), normal, 1e-8);
    EXPECT_NEAR(-(left.displacement[0] - right.displacement[0]), tangential, 1e-8);
    EXPECT_EQ(model.evaluate({x, 0}).stress, left.stress);
    for (const double side : {-1e-6, 1e-6}) {
      const Values& face = side < 0 ? left : right;
      const Model::Values beside = model.evaluate({x, side});
      for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(face.displacement[c], beside.displacement[c], 1e-4);
      // The openings have kinks at ends of elements.
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(face.stress[c], beside.stress[c], x == 0.4 || x == 0.0 ? 0.3 : 1e-3);
      EXPECT_LE(std::abs(report("stress yy on a face", face.stress[1], 0, "a free face")), 0.05);
      EXPECT_LE(std::abs(report("stress xy on a face", face.stress[2], 0, "a free face")), 0.05);
    }
    // The shear opens a difference of stress along the crack between its faces (Westergaard).
    const double jump = right.stress[0] - left.stress[0];
    std::printf("x = %.1f: stress along the crack differs by %.4f between its faces\n", x, jump);
    if (x != 0.0) {
      EXPECT_GT(-jump * x, 0);
    }
  }
}

}  // namespace
}  // namespace sides_test

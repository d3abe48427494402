// Scheme `paper`: collocation, uncorrected lattice, coupling by shared nodes. Reference: Y. Yang and Y. Liu, Int. J.
// Solids Struct. (2021), tables 4 and 5; best reading of an independent prototype for the same layout: 12.5, 1.69, 0.36
// %.
#include <gtest/gtest.h>

#include "host.hpp"

namespace paper_scheme_test {
namespace {

using namespace host;
constexpr double young = 100e9;

void choose(Model& model, const char* option, const char* value) {
  model.check(bempd_set_option_text(model.get(), option, value));
}

struct Stretching {
  Model model;
  int32_t left, middle, right;

  // A plate 1.0 x 0.2 pulled apart at both ends by 1 each, peridynamics in its middle.
  Stretching(const char* scheme, double spacing, int32_t plane = BEMPD_PLANE_STRESS) {
    choose(model, "scheme", scheme);
    const int32_t id = model.add(material(young, bond_poisson(plane), plane));
    left = model.bem(id, rectangle(0, 0, 0.3, 0.2), 1);
    middle = model.pd(id, rectangle(0.3, 0, 0.7, 0.2), spacing, 4);
    right = model.bem(id, rectangle(0.7, 0, 1, 0.2), 1);
    model.prescribe(left, 4, BEMPD_X, 0, -1);
    model.prescribe(right, 2, BEMPD_X, 0, 1);
    model.fix_point({0, 0}, BEMPD_Y);
    model.fix_point({1, 0}, BEMPD_Y);
    model.step(1);
  }
  double interface_error() { return 100 * (model.evaluate({0.7, 0.1}).displacement[0] / 0.4 - 1); }
};

TEST(PaperScheme, stretching_has_the_published_sizes_and_errors) {
  struct Row {
    double spacing;
    int64_t boundary_nodes, points;
    double published, prototype;
  };
  for (const Row& row :
       {Row{0.05, 20, 42, 13.28, 12.5}, Row{0.01, 52, 842, 1.36, 1.69}, Row{0.005, 92, 3282, 0.19, 0.36}}) {
    Stretching scene("paper", row.spacing);
    const bempd_statistics s = scene.model.statistics();
    EXPECT_EQ(s.boundary_nodes, row.boundary_nodes);
    EXPECT_EQ(s.material_points, row.points);
    const double error = scene.interface_error();
    report("interface error [%]", error, row.published, "published");
    // The digits that the prototype's figures have.
    EXPECT_LE(std::abs(report("interface error [%]", error, row.prototype, "prototype")), 0.02);
  }
}

TEST(PaperScheme, stretching_is_exact_in_scheme_symmetric) {
  for (double spacing : {0.05, 0.01, 0.005}) {
    Stretching scene("symmetric", spacing);
    EXPECT_LE(std::abs(report("interface error [%]", scene.interface_error(), 0, "closed form")), 1e-7);
    double worst = 0;
    for (int32_t region : {scene.left, scene.middle, scene.right}) {
      const auto x = scene.model.vectors(region, BEMPD_POSITION), u = scene.model.vectors(region, BEMPD_DISPLACEMENT);
      for (std::size_t i = 0; i < x.size(); ++i) worst = largest({worst, u[i][0] - (2 * x[i][0] - 1)});
    }
    EXPECT_LE(report("largest error", worst, 0, "closed form"), 1e-9);
  }
}

TEST(PaperScheme, errors_fall_with_the_spacing_in_plane_strain_too) {
  double before = 100;
  for (double spacing : {0.05, 0.025, 0.0125}) {
    Stretching scene("paper", spacing, BEMPD_PLANE_STRAIN);
    const double error = std::abs(report("interface error [%]", scene.interface_error(), 0, "closed form"));
    EXPECT_LE(error, 0.6 * before);
    before = error;
  }
}

// A rigid motion strains nothing, whatever the reading and however many boundary regions there are.
struct Reading {
  const char *lattice, *interface, *corners;
};

class PaperReadings : public testing::TestWithParam<Reading> {};

TEST_P(PaperReadings, rigid_motions_cause_no_stress) {
  Model model;
  choose(model, "scheme", "paper");
  choose(model, "paper.lattice", GetParam().lattice);
  choose(model, "paper.interface", GetParam().interface);
  choose(model, "paper.corner_tractions", GetParam().corners);
  const int32_t id = model.add(material(young, 1.0 / 3));
  const int32_t left = model.bem(id, rectangle(0, 0, 0.4, 0.6), 0.2);
  const int32_t top = model.bem(id, rectangle(0.4, 0.4, 0.8, 0.6), 0.2);
  const int32_t lattice = model.pd(id, rectangle(0.4, 0, 0.8, 0.4), 0.05, 3);
  const int32_t right = model.bem(id, rectangle(0.8, 0, 1, 0.6), 0.2);
  const Field motion = [](double x, double y) -> Vector { return {1e-3 - 2e-3 * y, -5e-4 + 2e-3 * x}; };
  model.prescribe(left, 4, 0, 1, motion);
  model.step(1);
  double error = 0;
  for (int32_t region : {left, top, lattice, right}) {
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector e = motion(x[i][0], x[i][1]);
      error = largest({error, u[i][0] - e[0], u[i][1] - e[1]});
    }
  }
  EXPECT_LE(report("largest error", error / 1e-3, 0, "rigid motion"), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, PaperReadings,
                         testing::Values(Reading{"cell_centred", "nodal_force", "two"},
                                         Reading{"cell_centred", "nodal_force", "one"},
                                         Reading{"cell_centred", "traction", "two"},
                                         Reading{"cell_centred", "traction", "one"},
                                         Reading{"nodal", "nodal_force", "two"}, Reading{"nodal", "traction", "one"}));

// The scheme is collocation alone without a lattice, and constant strain is exact; inside, the values are those of Eq.
// 5.
TEST(PaperScheme, constant_strain_is_exact_in_boundary_element_regions) {
  Model model;
  choose(model, "scheme", "paper");
  const int32_t id = model.add(material(young, 0.3));
  const int32_t left = model.bem(id, rectangle(0, 0, 0.5, 0.2), 0.05),
                right = model.bem(id, rectangle(0.5, 0, 1, 0.2), 0.1);
  model.prescribe(left, 4, BEMPD_X, 0, 0);
  model.fix_point({0, 0}, BEMPD_Y);
  model.traction(right, 2, 0, 1, BEMPD_X, 0, 1e6);
  model.step(1);
  for (const Vector p : {Vector{0.1, 0.13}, Vector{0.77, 0.02}, Vector{1, 0.1}}) {
    const Model::Values v = model.evaluate(p);
    EXPECT_LE(std::abs(report("u_x", v.displacement[0], p[0] * 1e-5, "closed form")), 1e-12 * 1e-5);
    EXPECT_LE(std::abs(report("u_y", v.displacement[1], -0.3 * p[1] * 1e-5, "closed form")), 1e-12 * 1e-5);
    EXPECT_LE(std::abs(report("stress xx", v.stress[0], 1e6, "closed form")), 1e-10 * 1e6);
  }
}

// Boundary nodes every 0.05, lattice every 0.01: only five points of the interface are shared.
TEST(PaperScheme, interface_that_does_not_match_has_a_large_error) {
  double tip[2];
  int k = 0;
  for (const char* scheme : {"paper", "symmetric"}) {
    Model model;
    choose(model, "scheme", scheme);
    const int32_t id = model.add(material(young, 1.0 / 3));
    const int32_t left = model.bem(id, rectangle(0, 0, 0.5, 0.2), 0.1),
                  right = model.pd(id, rectangle(0.5, 0, 1, 0.2), 0.01, 4);
    model.mesh(left, 2, 0.1, 1);
    model.prescribe(left, 4, BEMPD_X, 0, 0);
    model.fix_point({0, 0}, BEMPD_Y);
    model.traction(right, 2, 0, 1, BEMPD_X, 0, 5.25e6);
    model.step(1);
    tip[k++] = model.evaluate({1, 0.1}).displacement[0];
  }
  const double exact = 5.25e-5;
  EXPECT_GE(std::abs(report("tip, paper", tip[0], exact, "closed form")), 0.01 * exact);
  EXPECT_LE(std::abs(report("tip, symmetric", tip[1], exact, "closed form")), 1e-9 * exact);
}

TEST(PaperScheme, loads_on_a_lattice_edge_act_on_its_outermost_layer) {
  Model model;
  choose(model, "scheme", "paper");
  const int32_t id = model.add(material(young, 1.0 / 3));
  const int32_t lattice = model.pd(id, rectangle(0, 0, 0.4, 0.2), 0.02, 3);
  const int32_t clamp = model.fix(lattice, 4, BEMPD_BOTH);
  model.traction(lattice, 2, 0, 1, BEMPD_X, 0, 1e6);
  model.step(1);
  EXPECT_LE(std::abs(report("reaction", model.reaction(clamp)[0], -2e5, "equilibrium")), 1e-8 * 2e5);
  const auto x = model.vectors(lattice, BEMPD_POSITION), u = model.vectors(lattice, BEMPD_DISPLACEMENT);
  ASSERT_EQ(x.size(), 200u);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(std::abs(std::remainder(x[i][0] / 0.02, 1)), 0.5, 1e-9);
    if (x[i][0] < 0.02) {
      EXPECT_EQ(u[i][0], 0);
    }
  }
}

TEST(PaperScheme, elements_of_a_clamped_edge_are_as_long_as_others) {
  Model model;
  choose(model, "scheme", "paper");
  const int32_t region = model.bem(model.add(material(young, 0.3)), rectangle(0, 0, 10, 8), 2);
  model.fix(region, 4, BEMPD_BOTH);
  model.prepare();
  EXPECT_EQ(model.statistics().boundary_elements, 18);
}

TEST(PaperScheme, refuses_what_it_does_not_cover) {
  const auto sentence = [](Model& model) {
    EXPECT_EQ(bempd_prepare(model.get()), BEMPD_ERROR_ARGUMENT);
    return std::string(bempd_last_error(model.get()));
  };
  Model touching;
  choose(touching, "scheme", "paper");
  const int32_t id = touching.add(material(young, 1.0 / 3));
  touching.pd(id, rectangle(0, 0, 0.5, 0.5), 0.05, 3);
  touching.pd(id, rectangle(0.5, 0, 1, 0.5), 0.05, 3);
  EXPECT_NE(sentence(touching).find("make them one region"), std::string::npos);
  choose(touching, "scheme", "symmetric");
  touching.fix(1, 4, BEMPD_BOTH);

  Model strain;
  choose(strain, "critical_stretch", "printed");
  bempd_material m = material(young, 0.25, BEMPD_PLANE_STRAIN);
  m.fracture_energy = 100;
  const int32_t brittle = strain.add(m);
  strain.pd(brittle, rectangle(0, 0, 0.5, 0.5), 0.05, 3);
  EXPECT_NE(sentence(strain).find("plane stress"), std::string::npos);
}

}  // namespace
}  // namespace paper_scheme_test

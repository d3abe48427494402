// Places where stress is unbounded, with their exponents. References: M. L. Williams, J. Appl. Mech. 19, 1952, and what
// follows from his equations for known angles.
#include <gtest/gtest.h>

#include <algorithm>

#include "host.hpp"

namespace singularities_test {
namespace {

using namespace host;

constexpr double pi = 3.14159265358979323846, corner_of_270 = 0.5444837368;

std::vector<bempd_singularity> singularities(Model& model) {
  int64_t count = -1;
  model.check(bempd_singularity_count(model.get(), &count));
  std::vector<bempd_singularity> all(static_cast<std::size_t>(count));
  for (int64_t k = 0; k < count; ++k) {
    bempd_singularity_init(&all[static_cast<std::size_t>(k)], sizeof(bempd_singularity));
    model.check(bempd_get_singularity(model.get(), k, &all[static_cast<std::size_t>(k)]));
  }
  return all;
}

struct Wanted {
  int32_t kind;
  Vector place;
  double exponent, oscillation;
};

void expect(Model& model, const std::vector<Wanted>& wanted) {
  const std::vector<bempd_singularity> found = singularities(model);
  EXPECT_EQ(found.size(), wanted.size());
  for (const bempd_singularity& s : found)
    std::printf("kind %d at (%g, %g) of region %d: %.8f + %.8f i\n", s.kind, s.x, s.y, s.region, s.exponent,
                s.oscillation);
  for (const Wanted& w : wanted) {
    const auto same = std::find_if(found.begin(), found.end(), [&](const bempd_singularity& s) {
      return std::hypot(s.x - w.place[0], s.y - w.place[1]) < 1e-9;
    });
    ASSERT_NE(same, found.end()) << "(" << w.place[0] << ", " << w.place[1] << ")";
    EXPECT_EQ(same->kind, w.kind);
    EXPECT_NEAR(same->exponent, w.exponent, 1e-7);
    EXPECT_NEAR(same->oscillation, w.oscillation, 1e-6);
  }
}

// kappa of plane stress; exponent where a straight edge ceases to be clamped: 1/2 + i ln(kappa) / (2 pi).
double kolosov(double nu) { return (3 - nu) / (1 + nu); }
double oscillation(double nu) { return std::log(kolosov(nu)) / (2 * pi); }

// Exponent between a clamped and a free face that meet at a right angle.
double clamped_corner(double nu) {
  const double k = kolosov(nu);
  double low = 0.3, high = 0.99;
  for (int i = 0; i < 100; ++i) {
    const double l = 0.5 * (low + high), s = std::sin(0.5 * pi * l);
    ((s * s < ((k + 1) * (k + 1) - 4 * l * l) / (4 * k)) ? low : high) = l;
  }
  return low;
}

const Outline l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(Singularities, of_an_l_are_its_inner_corner_and_the_ends_of_its_clamp) {
  for (const bool lattice : {false, true}) {
    Model model;
    const int32_t id = model.add(material(1, 1.0 / 3));
    const int32_t body = lattice ? model.pd(id, l_shape, 0.1, 3) : model.bem(id, l_shape, 0.25);
    model.fix(body, 6, BEMPD_BOTH);
    expect(model, {{BEMPD_SINGULAR_CORNER, {1, 1}, corner_of_270, 0},
                   {BEMPD_SINGULAR_CORNER, {0, 0}, clamped_corner(1.0 / 3), 0},
                   {BEMPD_SINGULAR_CORNER, {0, 2}, clamped_corner(1.0 / 3), 0}});
  }
}

// A support on a part of an edge; one that holds the normal component only is a plane of symmetry, which ends as a
// crack.
TEST(Singularities, of_supports_lie_where_they_end) {
  Model model;
  const double zero = 0;
  const int32_t body = model.bem(model.add(material(1, 0.3)), rectangle(0, 0, 4, 2), 0.5);
  for (const int32_t component : {BEMPD_X, BEMPD_Y})
    model.check(bempd_prescribe_edge(model.get(), body, 1, 0.25, 0.5, component, 1, &zero, nullptr, nullptr));
  model.check(bempd_prescribe_edge(model.get(), body, 3, 0.5, 1, BEMPD_Y, 1, &zero, nullptr, nullptr));
  expect(model, {{BEMPD_SINGULAR_CORNER, {1, 0}, 0.5, oscillation(0.3)},
                 {BEMPD_SINGULAR_CORNER, {2, 0}, 0.5, oscillation(0.3)},
                 {BEMPD_SINGULAR_CORNER, {2, 2}, 0.5, 0}});
}

TEST(Singularities, of_cracks_are_tips_and_kinks) {
  Model model;
  const int32_t body = model.bem(model.add(material(1, 0.3)), rectangle(-4, -4, 4, 4), 1);
  model.crack({{-1, 0}, {0, 0}, {0, 1}});
  model.crack({{4, 2}, {3, 2}});
  model.fix(body, 4, BEMPD_X);
  model.fix_point({-4, 0}, BEMPD_Y);
  expect(model, {{BEMPD_SINGULAR_CRACK, {-1, 0}, 0.5, 0},
                 {BEMPD_SINGULAR_CRACK, {0, 0}, corner_of_270, 0},
                 {BEMPD_SINGULAR_CRACK, {0, 1}, 0.5, 0},
                 {BEMPD_SINGULAR_CRACK, {3, 2}, 0.5, 0},
                 {BEMPD_SINGULAR_POINT, {-4, 0}, 0, 0}});
}

// Exponent where an interface of two materials meets a straight free edge at right angles (D. B. Bogy, J. Appl. Mech.
// 35, 1968); none for equal materials.
TEST(Singularities, of_interfaces_are_their_ends_if_materials_differ) {
  for (const double ratio : {1.0, 10.0}) {
    Model model;
    const int32_t soft = model.add(material(1, 0.3)), stiff = model.add(material(ratio, 0.3));
    model.bem(soft, rectangle(0, 0, 2, 1), 0.25);
    model.bem(stiff, rectangle(0, 1, 2, 2), 0.25);
    model.fix_point({1, 0.0}, BEMPD_BOTH);
    model.fix_point({1.5, 0.0}, BEMPD_Y);
    const std::vector<bempd_singularity> found = singularities(model);
    EXPECT_EQ(
        std::count_if(found.begin(), found.end(), [](const auto& s) { return s.kind == BEMPD_SINGULAR_INTERFACE; }),
        ratio == 1 ? 0 : 2);
    if (ratio == 1) continue;
    // Bogy's equation at right angles and a straight edge, in Dundurs' parameters of plane stress.
    const double k = kolosov(0.3), alpha = (ratio - 1) / (ratio + 1),
                 beta = (ratio * (k - 1) - (k - 1)) / (ratio * (k + 1) + (k + 1));
    const auto bogy = [&](double l) {
      const double s2 = std::pow(std::sin(0.5 * pi * l), 2), l2 = l * l;
      return std::pow(s2 - l2, 2) * beta * beta + 2 * l2 * (s2 - l2) * alpha * beta + l2 * (l2 - 1) * alpha * alpha +
             std::pow(std::sin(pi * l), 2) / 4;
    };
    double low = 0.5, high = 0.99999;
    for (int i = 0; i < 200; ++i) ((bogy(0.5 * (low + high)) > 0) ? low : high) = 0.5 * (low + high);
    expect(model, {{BEMPD_SINGULAR_INTERFACE, {0, 1}, low, 0},
                   {BEMPD_SINGULAR_INTERFACE, {2, 1}, low, 0},
                   {BEMPD_SINGULAR_POINT, {1, 0}, 0, 0},
                   {BEMPD_SINGULAR_POINT, {1.5, 0}, 0, 0}});
  }
}

// A square hole that another body fills is none; a re-entrant corner that a second region closes neither.
TEST(Singularities, are_none_where_regions_of_one_material_complete_each_other) {
  Model model;
  const int32_t id = model.add(material(1, 1.0 / 3));
  const int32_t body = model.bem(id, l_shape, 0.25);
  model.pd(id, rectangle(1, 1, 2, 2), 0.25, 2);
  model.fix(body, 6, BEMPD_X);
  model.prescribe(body, 1, BEMPD_Y, 0, 0);
  expect(model, {});
}

TEST(Singularities, are_marked_in_the_field_and_refused_on_demand) {
  Model model;
  const int32_t body = model.bem(model.add(material(1, 1.0 / 3)), l_shape, 0.25);
  model.fix(body, 6, BEMPD_X);
  model.prescribe(body, 1, BEMPD_Y, 0, 0);
  model.traction(body, 2, 0, 1, BEMPD_X, 0, 1);
  model.step(1);
  const std::vector<Vector> places = model.vectors(body, BEMPD_POSITION);
  const std::vector<double> orders = model.field(body, BEMPD_STRESS_ORDER);
  ASSERT_EQ(orders.size(), places.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const bool corner = std::hypot(places[i][0] - 1, places[i][1] - 1) < 1e-9;
    EXPECT_NEAR(orders[i], corner ? 1 - corner_of_270 : 0, 1e-7);
  }
  const double corner[2] = {1, 1}, beside[2] = {1 - 1e-6, 1};
  double stress[3], u[2];
  const auto ask = [&](const double* at, double* s) { return bempd_evaluate(model.get(), 1, at, u, s, nullptr); };
  EXPECT_EQ(ask(corner, stress), BEMPD_OK);
  const double both[4] = {corner[0], corner[1], beside[0], beside[1]};
  double asked[2] = {-1, -1};
  ASSERT_EQ(bempd_stress_orders(model.get(), 2, both, asked), BEMPD_OK);
  EXPECT_NEAR(asked[0], 1 - corner_of_270, 1e-7);
  EXPECT_EQ(asked[1], 0);
  EXPECT_EQ(bempd_stress_orders(model.get(), 2, both, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_stress_orders(model.get(), 0, nullptr, nullptr), BEMPD_OK);
  EXPECT_EQ(ask(beside, stress), BEMPD_OK);
  bempd_singularity one{};
  EXPECT_EQ(bempd_get_singularity(model.get(), 0, &one), BEMPD_ERROR_ARGUMENT);  // no struct_size
  bempd_singularity_init(&one, sizeof one);
  EXPECT_EQ(bempd_get_singularity(model.get(), 1, &one), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_get_singularity(model.get(), -1, &one), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_singularity_count(model.get(), nullptr), BEMPD_ERROR_ARGUMENT);
}

// The boundary elements' own stress beside the corner of an L goes with the exponent that is told.
TEST(Singularities, tell_how_stress_grows) {
  Model model;
  const int32_t body = model.bem(model.add(material(1, 1.0 / 3)), l_shape, 0.1);
  model.fix(body, 6, BEMPD_X);
  model.prescribe(body, 1, BEMPD_Y, 0, 0);
  model.traction(body, 2, 0, 1, BEMPD_X, 0, 1);
  model.step(1);
  // The opening is taken on the line of symmetry of the corner, into the body.
  const auto opening = [&](double r) {
    const auto s = model.evaluate({1 - r * std::sqrt(0.5), 1 - r * std::sqrt(0.5)}).stress;
    return 0.5 * (s[0] + s[1]) - s[2];  // across the line
  };
  const double found = std::log(opening(2e-3) / opening(4e-3)) / std::log(0.5);
  EXPECT_LE(std::abs(report("exponent of stress", found, corner_of_270 - 1, "Williams")), 0.02);
}

}  // namespace
}  // namespace singularities_test

// Peridynamic regions with slanted and round edges inside bodies of boundary elements: constant stress passes
// interfaces of any direction, whether the elements follow the material points or have lengths of their own. Reference:
// linear displacement.
#include <gtest/gtest.h>

#include <cmath>

#include "host.hpp"

namespace outlined_interface_test {
namespace {

using namespace host;

struct Uniform {
  static constexpr double xx = 3e6, yy = -1e6, xy = 2e6, young = 2e9;
  static inline double poisson = 1.0 / 3;
  static Vector displacement(double x, double y) {
    const double exx = (xx - poisson * yy) / young, eyy = (yy - poisson * xx) / young;
    const double exy = (1 + poisson) * xy / young;
    return {exx * x + exy * y, exy * x + eyy * y};
  }
  static Vector traction(double nx, double ny) { return {xx * nx + xy * ny, xy * nx + yy * ny}; }
};

// Another Poisson's ratio than that of bonds alone.
struct WithRatio {
  explicit WithRatio(double ratio) { Uniform::poisson = ratio; }
  ~WithRatio() { Uniform::poisson = 1.0 / 3; }
};

// Tractions of the constant stress on straight free edges.
void pull(Model& model, int32_t region, const Outline& loop, const std::vector<std::size_t>& edges) {
  for (const std::size_t k : edges) {
    const Vector a = loop[k - 1], b = loop[k % loop.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Vector t = Uniform::traction((b[1] - a[1]) / length, (a[0] - b[0]) / length);
    model.traction(region, static_cast<int32_t>(k), 0, 1, BEMPD_X, 0, t[0]);
    model.traction(region, static_cast<int32_t>(k), 0, 1, BEMPD_Y, 0, t[1]);
  }
}

void expect_uniform(Model& model, const Outline& places) {
  model.step(1);
  double scale = 0, error = 0;
  for (int32_t region = 1; region <= model.region_count(); ++region) {
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector e = Uniform::displacement(x[i][0], x[i][1]);
      scale = largest({scale, std::hypot(e[0], e[1])});
      error = largest({error, std::hypot(u[i][0] - e[0], u[i][1] - e[1])});
    }
  }
  EXPECT_LT(report("displacement, error over the largest", error / scale, 0, "linear"), 1e-10);
  for (const Vector& at : places) {
    const Model::Values values = model.evaluate(at);
    EXPECT_NEAR(values.stress[0], Uniform::xx, 1e-8 * Uniform::xx) << at[0] << " " << at[1];
    EXPECT_NEAR(values.stress[1], Uniform::yy, 1e-8 * Uniform::xx);
  }
}

// A slanted strip of material points between two blocks of elements.
class SlantedInterfaces : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(SlantedInterfaces, pass_constant_stress) {
  const auto [length, ratio] = GetParam();
  const WithRatio with(ratio);
  Model model;
  const int32_t id = model.add(material(Uniform::young, Uniform::poisson));
  const Outline left{{0, 0}, {1, 0}, {1.35, 1}, {0, 1}}, middle{{1, 0}, {1.8, 0}, {2.15, 1}, {1.35, 1}},
      right{{1.8, 0}, {3, 0}, {3, 1}, {2.15, 1}};
  const int32_t a = model.bem(id, left, 0.3), b = model.pd(id, middle, 0.1, 4), c = model.bem(id, right, 0.3);
  if (length > 0) {
    model.mesh(a, 2, length, 1);
    model.mesh(c, 4, length, 1);
  }
  pull(model, a, left, {1, 3, 4});
  pull(model, b, middle, {1, 3});
  pull(model, c, right, {1, 2, 3});
  const Vector corner = left[0], other = right[1];
  const Vector u = Uniform::displacement(corner[0], corner[1]), v = Uniform::displacement(other[0], other[1]);
  model.prescribe_point(corner, BEMPD_X, u[0]);
  model.prescribe_point(corner, BEMPD_Y, u[1]);
  model.prescribe_point(other, BEMPD_Y, v[1]);
  expect_uniform(model, {{0.4, 0.4}, {1.6, 0.5}, {2.5, 0.7}});
}

INSTANTIATE_TEST_SUITE_P(ElementLengthsAndRatios, SlantedInterfaces,
                         testing::Values(std::pair(0.0, 1.0 / 3), std::pair(0.13, 1.0 / 3), std::pair(0.25, 1.0 / 3),
                                         std::pair(0.4, 1.0 / 3), std::pair(0.0, 0.2), std::pair(0.25, 0.45)));

// Peridynamic regions of all kinds side by side share the points of common edges.
TEST(SharedPoints, pass_constant_stress) {
  Model model;
  const int32_t id = model.add(material(Uniform::young, Uniform::poisson));
  const Outline left = rectangle(0, 0, 1, 1), middle{{1, 0}, {2, 0}, {2.6, 0.8}, {1.8, 1.4}, {1, 1.4}},
                right{{2, 0}, {2.8, -0.6}, {3.4, 0.2}, {2.6, 0.8}};
  const int32_t a = model.pd(id, left, 0.1, 3), b = model.pd(id, middle, 0.1, 3), c = model.pd(id, right, 0.1, 4);
  pull(model, a, left, {1, 3, 4});
  pull(model, b, middle, {1, 3, 4});
  const Vector beside = Uniform::traction(-1, 0);
  model.traction(b, 5, 0, 0.4 / 1.4, BEMPD_X, 0, beside[0]);
  model.traction(b, 5, 0, 0.4 / 1.4, BEMPD_Y, 0, beside[1]);
  pull(model, c, right, {1, 2, 3});
  const Vector u = Uniform::displacement(0, 0), v = Uniform::displacement(2, 0);
  model.prescribe_point({0, 0}, BEMPD_X, u[0]);
  model.prescribe_point({0, 0}, BEMPD_Y, u[1]);
  model.prescribe_point({2, 0}, BEMPD_Y, v[1]);
  expect_uniform(model, {{0.4, 0.4}, {1.6, 0.5}, {2.7, 0.1}});
}

// A round region of material points in a plate of elements, with a hole of its own or none.
TEST(RoundInterfaces, pass_constant_stress) {
  for (const auto& [hole, ratio] : {std::pair(0.0, 1.0 / 3), {0.3, 1.0 / 3}, {0.0, -0.1}, {0.3, 0.45}}) {
    const WithRatio with(ratio);
    Model model;
    const int32_t id = model.add(material(Uniform::young, Uniform::poisson));
    const Outline outline = rectangle(-2, -1.5, 2, 1.5);
    const double radius = 0.8, half = radius * std::sqrt(0.5);
    const int32_t plate = model.bem(id, outline, 0.5);
    model.circular_hole(plate, {0, 0}, radius);
    const int32_t disc = model.pd(id, {{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}}, 0.1, 4);
    model.check(bempd_set_edge_arc(model.get(), disc, 1, half, half));
    model.check(bempd_set_edge_arc(model.get(), disc, 2, -half, half));
    model.check(bempd_set_edge_arc(model.get(), disc, 3, -half, -half));
    model.check(bempd_set_edge_arc(model.get(), disc, 4, half, -half));
    if (hole > 0) {
      const int32_t first = model.circular_hole(disc, {0.1, 0}, hole);
      for (int32_t k = first; k < first + 4; ++k)
        model.traction(disc, k,
                       [hole = hole](double x, double y) { return Uniform::traction((0.1 - x) / hole, -y / hole); });
    }
    pull(model, plate, outline, {1, 2, 3, 4});
    const Vector u = Uniform::displacement(-2, -1.5), v = Uniform::displacement(2, -1.5);
    model.prescribe_point({-2, -1.5}, BEMPD_X, u[0]);
    model.prescribe_point({-2, -1.5}, BEMPD_Y, u[1]);
    model.prescribe_point({2, -1.5}, BEMPD_Y, v[1]);
    expect_uniform(model, {{1.5, 1}, {-0.5, 0.3}, {-1.2, 0.4}});
  }
}

// A slanted block of material points that elements surround, its edges no multiples of the spacing.
class SurroundedRegion : public testing::TestWithParam<double> {};

TEST_P(SurroundedRegion, passes_constant_stress) {
  const WithRatio with(GetParam());
  Model model;
  const int32_t id = model.add(material(Uniform::young, Uniform::poisson));
  const Outline outline = rectangle(-2, -2, 2, 2), block{{-0.63, -0.4}, {0.5, -0.71}, {0.83, 0.44}, {-0.3, 0.8}};
  const int32_t plate = model.bem(id, outline, 0.5);
  model.hole(plate, {block[0], block[3], block[2], block[1]});
  model.pd(id, block, 0.1, 4);
  pull(model, plate, outline, {1, 2, 3, 4});
  const Vector u = Uniform::displacement(-2, -2), v = Uniform::displacement(2, -2);
  model.prescribe_point({-2, -2}, BEMPD_X, u[0]);
  model.prescribe_point({-2, -2}, BEMPD_Y, u[1]);
  model.prescribe_point({2, -2}, BEMPD_Y, v[1]);
  expect_uniform(model, {{1.5, 1}, {0.1, 0.2}, {-1.2, 0.4}});
}

INSTANTIATE_TEST_SUITE_P(Ratios, SurroundedRegion, testing::Values(1.0 / 3, 0.2, 0.45));

// Material points along a piece of a hole's edge only, the rest of a wide plate in elements.
TEST(PatchAtAHole, tells_the_largest_stress) {
  constexpr double spacing = 1.0 / 16, side = 12, open = 0.35, reach = 0.55;
  Model model;
  const int32_t id = model.add(material(1, 1.0 / 3));
  const Vector low{std::cos(open), -std::sin(open)}, high{std::cos(open), std::sin(open)},
      out{std::cos(open) + reach, 0};
  const int32_t plate = model.bem(id, rectangle(-side, -side, side, side), 2);
  const int32_t first = model.hole(plate, {low, {0, -1}, {-1, 0}, {0, 1}, high, out});
  const int32_t patch = model.pd(id, {low, out, high}, spacing, 4);
  const auto arc = [&](int32_t region, int32_t edge, Vector centre, double radius, int32_t turn) {
    model.check(bempd_set_edge_arc_about(model.get(), region, edge, centre[0], centre[1], radius, turn));
  };
  for (int32_t k = first; k < first + 4; ++k) arc(plate, k, {0, 0}, 1, BEMPD_CLOCKWISE);
  // The circle through the patch's ends on the hole and its outermost place.
  const double h = std::sin(open), radius = (h * h + reach * reach) / (2 * reach);
  const Vector centre{out[0] - radius, 0};
  for (int32_t k = 0; k < 2; ++k) {
    arc(plate, first + 4 + k, centre, radius, BEMPD_CLOCKWISE);
    arc(patch, 1 + k, centre, radius, BEMPD_COUNTER_CLOCKWISE);
  }
  arc(patch, 3, {0, 0}, 1, BEMPD_CLOCKWISE);
  model.traction(plate, 1, 0, 1, BEMPD_Y, 0, -1);
  model.traction(plate, 3, 0, 1, BEMPD_Y, 0, 1);
  model.fix_point({-side, -side}, BEMPD_BOTH);
  model.fix_point({side, -side}, BEMPD_Y);
  model.step(1);
  const auto x = model.vectors(patch, BEMPD_POSITION);
  const auto stress = model.field(patch, BEMPD_STRESS);
  double largest_stress = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(std::hypot(x[i][0], x[i][1]) - 1) < 1e-9) largest_stress = std::max(largest_stress, stress[3 * i + 1]);
  std::printf("%zu material points\n", x.size());
  EXPECT_LT(std::abs(report("largest stress at the hole", largest_stress, 3, "Kirsch")), 0.12);
}

}  // namespace
}  // namespace outlined_interface_test

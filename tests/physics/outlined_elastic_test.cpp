// Peridynamic regions with slanted and round edges: constant stress is exact, a plate with a hole and a cantilever at
// any angle converge with second order. References: G. Kirsch 1898, and S. P. Timoshenko and J. N. Goodier, Theory of
// Elasticity, 3rd ed., arts. 21 and 35.
#include <gtest/gtest.h>

#include <cmath>

#include "cantilever.hpp"

namespace outlined_elastic_test {
namespace {

using namespace host;

Vector turned(Vector p, double angle) {
  return {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1]};
}
Outline turned(Outline points, double angle) {
  for (Vector& p : points) p = turned(p, angle);
  return points;
}

// --- Constant stress

struct Uniform {
  static constexpr double xx = 3e6, yy = -1e6, xy = 2e6, young = 2e9, poisson = 1.0 / 3;
  double ratio = poisson;
  int32_t plane = BEMPD_PLANE_STRESS;

  Vector displacement(double x, double y) const {
    const bool strain = plane == BEMPD_PLANE_STRAIN;
    const double modulus = strain ? young / (1 - ratio * ratio) : young, nu = strain ? ratio / (1 - ratio) : ratio;
    const double exx = (xx - nu * yy) / modulus, eyy = (yy - nu * xx) / modulus, exy = (1 + nu) * xy / modulus;
    return {exx * x + exy * y, exy * x + eyy * y};
  }
  static Vector traction(double nx, double ny) { return {xx * nx + xy * ny, xy * nx + yy * ny}; }
};

void pull_straight_edges(Model& model, int32_t region, const Outline& loop, int32_t first_edge) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vector a = loop[k], b = loop[(k + 1) % loop.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Vector t = Uniform::traction((b[1] - a[1]) / length, (a[0] - b[0]) / length);
    for (const int32_t c : {0, 1})
      model.traction(region, first_edge + static_cast<int32_t>(k), 0, 1, c == 0 ? BEMPD_X : BEMPD_Y, 0, t[c]);
  }
}

// Held as a statically determined body at three corners.
void hold(Model& model, const Outline& loop, const Uniform& exact = {}) {
  const Vector a = loop[0], b = loop[1];
  const Vector u = exact.displacement(a[0], a[1]), v = exact.displacement(b[0], b[1]);
  model.prescribe_point(a, BEMPD_X, u[0]);
  model.prescribe_point(a, BEMPD_Y, u[1]);
  model.prescribe_point(b, BEMPD_Y, v[1]);
}

void expect_uniform(Model& model, int32_t region, const Outline& places, double spacing, const Uniform& exact = {}) {
  model.step(1);
  const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
  const auto stress = model.field(region, BEMPD_STRESS);
  double scale = 0, displacement = 0, stresses = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector e = exact.displacement(x[i][0], x[i][1]);
    scale = largest({scale, std::hypot(e[0], e[1])});
    displacement = largest({displacement, std::hypot(u[i][0] - e[0], u[i][1] - e[1])});
    stresses = largest(
        {stresses, stress[3 * i] - Uniform::xx, stress[3 * i + 1] - Uniform::yy, stress[3 * i + 2] - Uniform::xy});
  }
  EXPECT_LT(report("displacement, error over the largest", displacement / scale, 0, "linear"), 1e-11);
  EXPECT_LT(report("stress at points, error over the largest", stresses / Uniform::xx, 0, "constant"), 1e-9);
  for (const Vector& at : places) {
    const Model::Values values = model.evaluate(at);
    const Vector e = exact.displacement(at[0], at[1]);
    EXPECT_NEAR(values.displacement[0], e[0], 1e-11 * scale) << at[0] << " " << at[1] << " spacing " << spacing;
    EXPECT_NEAR(values.displacement[1], e[1], 1e-11 * scale);
    EXPECT_NEAR(values.stress[0], Uniform::xx, 1e-9 * Uniform::xx);
  }
}

TEST(OutlinedRegion, carries_constant_stress_between_slanted_edges) {
  const Outline outline = turned({{0, 0}, {2, 0}, {2.6, 0.9}, {1.5, 1.7}, {1.1, 0.9}, {0.1, 1.4}}, 0.37);
  Outline hole = turned({{1.2, 0.3}, {1.4, 0.6}, {1.7, 0.25}}, 0.37);
  for (const int ratio : {3, 4}) {
    Model model;
    const int32_t id = model.add(material(Uniform::young, Uniform::poisson));
    const int32_t region = model.pd(id, outline, 0.05, ratio);
    const int32_t first = model.hole(region, hole);
    pull_straight_edges(model, region, outline, 1);
    pull_straight_edges(model, region, hole, first);
    hold(model, outline);
    expect_uniform(model, region, turned({{0.5, 0.4}, {1.9, 0.8}, {0.0, 0.0}, {1.55, 1.2}}, 0.37), 0.05);
  }
}

// The body has chords of several lengths, so that squares of cells have to be balanced as bonds are.
TEST(OutlinedRegion, carries_constant_stress_at_any_ratio) {
  const Outline outline = turned({{0, 0}, {2, 0}, {2.6, 0.9}, {1.5, 1.7}, {1.1, 0.9}, {0.1, 1.4}}, 0.37);
  for (const Uniform& exact : {Uniform{-0.2, BEMPD_PLANE_STRESS}, Uniform{0.45, BEMPD_PLANE_STRESS},
                               Uniform{0.1, BEMPD_PLANE_STRAIN}, Uniform{0.49, BEMPD_PLANE_STRAIN}}) {
    Model model;
    const int32_t id = model.add(material(Uniform::young, exact.ratio, exact.plane));
    const int32_t region = model.pd(id, outline, 0.07, 4);
    const int32_t first = model.circular_hole(region, {1.3, 0.9}, 0.2);
    for (int32_t k = first; k < first + 4; ++k)
      model.traction(region, k, [](double x, double y) { return Uniform::traction((1.3 - x) / 0.2, (0.9 - y) / 0.2); });
    pull_straight_edges(model, region, outline, 1);
    hold(model, outline, exact);
    expect_uniform(model, region, turned({{0.5, 0.4}, {1.9, 0.8}, {0.0, 0.0}}, 0.37), 0.07, exact);
  }
}

TEST(OutlinedRegion, carries_constant_stress_around_round_holes) {
  const Outline outline = rectangle(0, 0, 2, 1.5);
  Model model;
  const int32_t id = model.add(material(Uniform::young, Uniform::poisson));
  const int32_t region = model.pd(id, outline, 0.05, 4);
  pull_straight_edges(model, region, outline, 1);
  hold(model, outline);
  const std::vector<std::pair<Vector, double>> holes = {{{0.6, 0.7}, 0.3}, {{1.4, 0.8}, 0.08}};
  for (const auto& [centre, radius] : holes) {
    const int32_t first = model.circular_hole(region, centre, radius);
    for (int32_t k = first; k < first + 4; ++k)
      model.traction(region, k, [c = centre, r = radius](double x, double y) {
        return Uniform::traction((c[0] - x) / r, (c[1] - y) / r);
      });
  }
  // Points are inside, on the hole's edge, and between it and the nearest chord.
  expect_uniform(model, region,
                 {{1, 1}, {0.6, 1.0}, {0.9, 0.7}, {0.6 + 0.3 * std::cos(0.1), 0.7 + 0.3 * std::sin(0.1)}}, 0.05);
}

// --- Plate with a hole

struct Kirsch {
  static constexpr double young = 1;
  double poisson = 1.0 / 3;
  int32_t plane = BEMPD_PLANE_STRESS;

  static std::array<double, 3> stress(double x, double y) {
    const double r2 = x * x + y * y, r4 = r2 * r2, t = std::atan2(y, x);
    const double c2 = std::cos(2 * t), c4 = std::cos(4 * t), s2 = std::sin(2 * t), s4 = std::sin(4 * t);
    return {1 - (1.5 * c2 + c4) / r2 + 1.5 * c4 / r4, -(0.5 * c2 - c4) / r2 - 1.5 * c4 / r4,
            -(0.5 * s2 + s4) / r2 + 1.5 * s4 / r4};
  }
  Vector displacement(double x, double y) const {
    const double kappa = plane == BEMPD_PLANE_STRESS ? (3 - poisson) / (1 + poisson) : 3 - 4 * poisson;
    const double shear = young / (2 + 2 * poisson), r = std::hypot(x, y), t = std::atan2(y, x), r3 = r * r * r;
    return {(r * (kappa + 1) * std::cos(t) + 2 / r * ((1 + kappa) * std::cos(t) + std::cos(3 * t)) -
             2 / r3 * std::cos(3 * t)) /
                (8 * shear),
            (r * (kappa - 3) * std::sin(t) + 2 / r * ((1 - kappa) * std::sin(t) + std::sin(3 * t)) -
             2 / r3 * std::sin(3 * t)) /
                (8 * shear)};
  }
};

struct KirschErrors {
  double displacement, largest_stress;
};

// Square plate with the exact tractions on its edges, turned by an angle about the hole.
KirschErrors plate_with_hole(int spacings_a_radius, double angle, const Kirsch& exact = {}) {
  Model model;
  const int32_t id = model.add(material(Kirsch::young, exact.poisson, exact.plane));
  const Outline outline = turned(rectangle(-3, -3, 3, 3), angle);
  const int32_t region = model.pd(id, outline, 1.0 / spacings_a_radius, 4);
  model.circular_hole(region, {0, 0}, 1);
  for (int32_t k = 0; k < 4; ++k) {
    const double n = angle + (k - 1) * std::acos(0.0), nx = std::cos(n), ny = std::sin(n);
    model.traction(region, k + 1, [nx, ny](double x, double y) {
      const auto s = Kirsch::stress(x, y);
      return Vector{s[0] * nx + s[2] * ny, s[2] * nx + s[1] * ny};
    });
  }
  const Vector a = outline[0], b = outline[1];
  model.prescribe_point(a, BEMPD_X, exact.displacement(a[0], a[1])[0]);
  model.prescribe_point(a, BEMPD_Y, exact.displacement(a[0], a[1])[1]);
  model.prescribe_point(b, BEMPD_Y, exact.displacement(b[0], b[1])[1]);
  model.step(1);
  const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
  const auto stress = model.field(region, BEMPD_STRESS);
  double error = 0, scale = 0, hoop = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector e = exact.displacement(x[i][0], x[i][1]);
    error += std::pow(u[i][0] - e[0], 2) + std::pow(u[i][1] - e[1], 2);
    scale += e[0] * e[0] + e[1] * e[1];
    if (std::abs(std::hypot(x[i][0], x[i][1]) - 1) > 1e-9) continue;
    const double c = x[i][0], s = x[i][1];
    hoop = std::max(hoop, stress[3 * i] * s * s + stress[3 * i + 1] * c * c - 2 * stress[3 * i + 2] * s * c);
  }
  return {std::sqrt(error / scale), hoop};
}

TEST(OutlinedRegion, plate_with_a_round_hole_converges_with_second_order) {
  constexpr double angle = 0.3;
  const KirschErrors coarse = plate_with_hole(4, angle), middle = plate_with_hole(8, angle),
                     fine = plate_with_hole(16, angle);
  std::printf("error at 4, 8, 16 spacings a radius: %.2e %.2e %.2e\n", coarse.displacement, middle.displacement,
              fine.displacement);
  EXPECT_GE(report("order", 0.5 * std::log2(coarse.displacement / fine.displacement), 2, "Kirsch"), -0.2);
  EXPECT_LT(report("displacement, relative error", fine.displacement, 0, "Kirsch"), 6e-4);
  EXPECT_LT(std::abs(report("largest stress at the hole", fine.largest_stress, 3, "Kirsch")), 0.1);
}

// Measured: 2.4, 2.8, 2.9, 2.0; errors of up to three times that of bonds alone.
TEST(OutlinedRegion, plate_with_a_round_hole_converges_at_any_ratio) {
  for (const Kirsch& exact : {Kirsch{-0.2, BEMPD_PLANE_STRESS}, Kirsch{0.2, BEMPD_PLANE_STRESS},
                              Kirsch{0.45, BEMPD_PLANE_STRESS}, Kirsch{0.4, BEMPD_PLANE_STRAIN}}) {
    const KirschErrors coarse = plate_with_hole(4, 0.3, exact), fine = plate_with_hole(16, 0.3, exact);
    EXPECT_GE(report("order", 0.5 * std::log2(coarse.displacement / fine.displacement), 2, "Kirsch"), -0.2);
    EXPECT_LT(report("displacement, relative error", fine.displacement, 0, "Kirsch"), 9e-4);
    EXPECT_LT(std::abs(report("largest stress at the hole", fine.largest_stress, 3, "Kirsch")), 0.1);
  }
}

// --- Cantilever at an angle

double cantilever_error(int spacings_over_height, double angle, double ratio = cantilever::poisson) {
  using namespace cantilever;
  Model model;
  const int32_t id = model.add(material(young, ratio));
  const int32_t region = model.pd(id, turned(rectangle(0, 0, length, height), angle), height / spacings_over_height, 4);
  model.prescribe(region, 4, 0, 1, [angle, ratio](double x, double y) {
    const Vector p = turned(Vector{x, y}, -angle);
    return turned(cantilever::exact_at_ratio(p[0], p[1], ratio), angle);
  });
  model.traction(region, 2, [angle](double x, double y) {
    const Vector p = turned(Vector{x, y}, -angle);
    return turned(end_traction(p[0], p[1]), angle);
  });
  model.step(1);
  const auto places = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
  double scale = 0, error = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector p = turned(places[i], -angle), e = turned(cantilever::exact_at_ratio(p[0], p[1], ratio), angle);
    scale = largest({scale, std::hypot(e[0], e[1])});
    error = largest({error, std::hypot(u[i][0] - e[0], u[i][1] - e[1])});
  }
  return error / scale;
}

TEST(OutlinedRegion, turned_cantilever_is_as_good_as_one_on_lattice_rows) {
  constexpr double angle = 0.302;
  const double coarse = cantilever_error(5, angle), fine = cantilever_error(20, angle);
  const double aligned = cantilever_error(20, 0);
  EXPECT_GE(report("order", 0.5 * std::log2(coarse / fine), 2, "Timoshenko"), -0.2);
  EXPECT_LT(report("error over the largest displacement", fine, aligned, "on lattice rows"), aligned);
  for (const double ratio : {-0.2, 0.45}) {
    const double turned_one = cantilever_error(20, angle, ratio), on_rows = cantilever_error(20, 0, ratio);
    EXPECT_LT(report("error at another ratio", turned_one, on_rows, "on lattice rows"), on_rows);
  }
}

}  // namespace
}  // namespace outlined_elastic_test

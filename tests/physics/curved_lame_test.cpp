// Rings and disks under pressure (Lame; Timoshenko and Goodier, Theory of Elasticity, section 28), bonded bars.
// Elements on arcs represent radial displacements and tractions, so the closed forms come back to rounding at every
// mesh.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "host.hpp"

namespace curved_lame_test {
namespace {

using namespace host;
constexpr const char* source = "Lame";

// sigma_rr = a - b / r^2, sigma_tt = a + b / r^2.
struct Lame {
  double a, b, young, poisson;  // plane strain

  double displacement(double r) const { return (1 + poisson) / young * ((1 - 2 * poisson) * a * r + b / r); }
  Vector displacement(Vector at) const {
    const double r = std::hypot(at[0], at[1]), u = displacement(r);
    return {u * at[0] / r, u * at[1] / r};
  }
  std::array<double, 3> stress(Vector at) const {
    const double r2 = at[0] * at[0] + at[1] * at[1], rr = a - b / r2, tt = a + b / r2;
    return {(rr * at[0] * at[0] + tt * at[1] * at[1]) / r2, (rr * at[1] * at[1] + tt * at[0] * at[0]) / r2,
            (rr - tt) * at[0] * at[1] / r2};
  }
};

struct Errors {
  double displacement, stress, near;
};

// Largest errors on a region's nodes over the largest values there; `near`: stress a millionth of an element inside.
Errors errors_of(Model& model, int32_t region, const Lame& exact, std::vector<double> radii, double inset) {
  const std::vector<Vector> places = model.vectors(region, BEMPD_POSITION),
                            u = model.vectors(region, BEMPD_DISPLACEMENT);
  const std::vector<double> stress = model.field(region, BEMPD_STRESS);
  Errors errors{0, 0, 0};
  double largest_u = 0, largest_stress = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector wanted = exact.displacement(places[i]);
    const auto wanted_stress = exact.stress(places[i]);
    largest_u = std::max(largest_u, std::hypot(wanted[0], wanted[1]));
    errors.displacement = std::max(errors.displacement, std::hypot(u[i][0] - wanted[0], u[i][1] - wanted[1]));
    for (std::size_t c = 0; c < 3; ++c) {
      largest_stress = std::max(largest_stress, std::abs(wanted_stress[c]));
      errors.stress = std::max(errors.stress, std::abs(stress[3 * i + c] - wanted_stress[c]));
    }
  }
  for (const double radius : radii)
    for (double angle = 0.001; angle < 6.28; angle += 0.3) {
      const Vector at{(radius + inset) * std::cos(angle), (radius + inset) * std::sin(angle)};
      const auto found = model.evaluate(at).stress, wanted = exact.stress(at);
      for (std::size_t c = 0; c < 3; ++c) errors.near = std::max(errors.near, std::abs(found[c] - wanted[c]));
      inset = -inset;
    }
  return {errors.displacement / largest_u, errors.stress / largest_stress, errors.near / largest_stress};
}

// Inner radius 1 with unit pressure, outer radius 2: free, or clamped.
Errors ring_errors(const char* scheme, double poisson, bool clamped, double element_length) {
  Model model;
  model.set_text("scheme", scheme);
  const int32_t region = model.disk(model.add(material(1000, poisson, BEMPD_PLANE_STRAIN)), {0, 0}, 2, element_length);
  const int32_t first = model.circular_hole(region, {0, 0}, 1);
  for (int32_t k = 0; k < 4; ++k) model.traction(region, first + k, [](double x, double y) { return Vector{x, y}; });
  if (clamped) {
    for (int32_t edge = 1; edge <= 4; ++edge) model.fix(region, edge, BEMPD_BOTH);
  } else {
    model.fix_point({2, 0}, BEMPD_Y);
    model.fix_point({-2, 0}, BEMPD_Y);
    model.fix_point({0, 2}, BEMPD_X);
  }
  model.step(1);
  const double a = clamped ? -1 / (1 + 4 * (1 - 2 * poisson)) : 1.0 / 3;
  const Lame exact{a, clamped ? -4 * (1 - 2 * poisson) * a : 4 * a, 1000, poisson};
  return errors_of(model, region, exact, {1.0000005, 1.9999995}, 0);
}

void expect_claims(const Errors& e) {
  EXPECT_LE(e.displacement, claims::lame_displacement);
  EXPECT_LE(std::max(e.stress, e.near), claims::lame_stress);
}

double worst(const Errors& e) { return std::max({e.displacement, e.stress, e.near}); }

TEST(Lame, ring_is_exact_at_every_mesh_in_every_scheme) {
  for (const char* scheme : all_schemes())
    for (const double length : {2.0, 0.8, 0.2}) {
      const Errors e = ring_errors(scheme, 0.3, false, length);
      std::printf(
          "ring, scheme %-9s elements of %.1f: reference 0 (%s), u off by %.1e, stress by %.1e, 5e-7 inside %.1e\n",
          scheme, length, source, e.displacement, e.stress, e.near);
      expect_claims(e);
    }
}

// The loss of digits towards incompressibility is 1 / (1 - 2 nu), and no more.
TEST(Lame, ring_is_exact_for_every_poisson_ratio) {
  for (const bool clamped : {false, true})
    for (const double poisson : {-0.9, -0.5, 0.0, 0.3, 0.49, 0.4999, 0.499999, 0.4999999}) {
      const Errors e = ring_errors("symmetric", poisson, clamped, 0.5);
      std::printf("%s ring, nu %.7f: reference 0 (%s), u off by %.1e, stress by %.1e, 5e-7 inside %.1e\n",
                  clamped ? "clamped" : "free", poisson, source, e.displacement, e.stress, e.near);
      if (poisson < 0.495) expect_claims(e);
      if (poisson == 0.4999999) {
        EXPECT_LE(worst(e), claims::lame_nearly_incompressible);
      }
      const double lost = 1e-14 / (1 - 2 * poisson);
      EXPECT_LE(e.displacement, 1e-12 + lost);
      EXPECT_LE(e.stress, 1e-11 + lost);
      EXPECT_LE(e.near, 1e-10 + lost);
    }
}

TEST(Lame, incompressible_ring_is_solved) {
  for (const double length : {2.0, 0.8, 0.5, 0.2}) {
    const Errors e = ring_errors("symmetric", 0.5, false, length);
    std::printf(
        "incompressible ring, elements of %.1f: reference 0 (%s), u off by %.1e, stress by %.1e, 5e-7 inside %.1e\n",
        length, source, e.displacement, e.stress, e.near);
    EXPECT_LE(worst(e), claims::lame_incompressible);
  }
}

// An L-shaped body whose shape changes at constant volume under constant stress: the pressure comes from the tractions.
TEST(Incompressible, constant_stress_in_a_body_with_a_re_entrant_corner_is_solved) {
  const double young = 1000, shear = young / 3, normal_strain = 1e-3, pressure = 2;
  const std::array<double, 3> stress{2 * shear * normal_strain - pressure, -2 * shear * normal_strain - pressure, 0.3};
  const auto exact = [&](Vector at) {
    return Vector{normal_strain * at[0] + stress[2] / shear * at[1], -normal_strain * at[1]};
  };
  for (const double length : {1.0, 0.3, 0.1}) {
    Model model;
    const Outline outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    const int32_t region = model.bem(model.add(material(young, 0.5, BEMPD_PLANE_STRAIN)), outline, length);
    const Vector normals[] = {{0, -1}, {1, 0}, {0, 1}, {1, 0}, {0, 1}, {-1, 0}};
    for (int32_t edge = 1; edge <= 6; ++edge)
      model.traction(region, edge, [&stress, n = normals[edge - 1]](double, double) {
        return Vector{stress[0] * n[0] + stress[2] * n[1], stress[2] * n[0] + stress[1] * n[1]};
      });
    model.fix_point({0, 0}, BEMPD_BOTH);
    model.prescribe_point({2, 0}, BEMPD_Y, 0);
    model.step(1);
    const auto places = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    const auto found = model.field(region, BEMPD_STRESS);
    double error = 0, size = 0, stress_error = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vector wanted = exact(places[i]);
      size = largest({size, wanted[0], wanted[1]});
      error = largest({error, u[i][0] - wanted[0], u[i][1] - wanted[1]});
      for (std::size_t c = 0; c < 3; ++c) stress_error = largest({stress_error, found[3 * i + c] - stress[c]});
    }
    std::printf("elements of %.1f: ", length);
    EXPECT_LE(report("displacement, off by", error / size, 0, "linear field"), claims::incompressible);
    std::printf("elements of %.1f: ", length);
    EXPECT_LE(report("stress, off by", stress_error / largest({stress[0], stress[1], stress[2]}), 0, "linear field"),
              claims::incompressible);
  }
}

std::string sentence_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

// A square of 2 x 2 that is held all around, whole or in two halves.
void prepare_held(double left_poisson, double right_poisson) {
  Model model;
  const int32_t left =
      model.bem(model.add(material(1000, left_poisson, BEMPD_PLANE_STRAIN)), rectangle(0, 0, 1, 2), 0.5);
  const int32_t right =
      model.bem(model.add(material(1000, right_poisson, BEMPD_PLANE_STRAIN)), rectangle(1, 0, 2, 2), 0.5);
  for (const int32_t edge : {1, 3, 4}) model.fix(left, edge, BEMPD_BOTH);
  for (const int32_t edge : {1, 2, 3}) model.fix(right, edge, BEMPD_BOTH);
  model.prepare();
}

TEST(Incompressible, undetermined_pressure_is_reported_and_determined_pressure_is_not) {
  EXPECT_EQ(sentence_of([] { prepare_held(0.5, 0.3); }), "");
  EXPECT_EQ(sentence_of([] { prepare_held(0.4999999, 0.4999999); }), "");
  const std::string sentence = sentence_of([] { prepare_held(0.5, 0.5); });
  EXPECT_NE(sentence.find("BEMPD_ERROR_UNSOLVABLE"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("pressure in the incompressible regions 1, 2 is undetermined"), std::string::npos)
      << sentence;
  EXPECT_EQ(sentence_of([] { ring_errors("symmetric", 0.5, true, 0.5); }), "");
}

// Disk of another material, shrunk into a ring under outer pressure: both fields are Lame's.
TEST(Lame, disk_bonded_into_a_ring_is_exact) {
  Model model;
  const double young[] = {3000, 1000}, poisson[] = {0.2, 0.4};  // disk, ring
  const int32_t inner = model.add(material(young[0], poisson[0], BEMPD_PLANE_STRAIN));
  const int32_t outer = model.add(material(young[1], poisson[1], BEMPD_PLANE_STRAIN));
  const int32_t ring = model.disk(outer, {0, 0}, 2, 0.6);
  model.circular_hole(ring, {0, 0}, 1);
  const int32_t disk = model.disk(inner, {0, 0}, 1, 0.4);
  for (int32_t edge = 1; edge <= 4; ++edge)
    model.traction(ring, edge, [](double x, double y) { return Vector{x / 2, y / 2}; });
  model.fix_point({2, 0}, BEMPD_Y);
  model.fix_point({-2, 0}, BEMPD_Y);
  model.fix_point({0, 2}, BEMPD_X);
  model.step(1);
  // Unit tension at r = 2, equal sigma_rr = p and equal u at r = 1.
  const double c0 = (1 + poisson[0]) * (1 - 2 * poisson[0]) / young[0], e1 = (1 + poisson[1]) / young[1];
  // a - b / 4 = 1, p = a - b, c0 p = e1 ((1 - 2 nu) a + b).
  const double k = 1 - 2 * poisson[1];
  const double b = (e1 * k - c0) / (-0.75 * c0 - e1 * (0.25 * k + 1)), a = 1 + b / 4, p = a - b;
  const Errors in_ring = errors_of(model, ring, {a, b, young[1], poisson[1]}, {1.5}, 0.499999);
  const Errors in_disk = errors_of(model, disk, {p, 0, young[0], poisson[0]}, {0.5}, 0.499999);
  report("radial displacement of the interface", model.evaluate({1, 0}).displacement[0], c0 * p, source);
  std::printf("ring: u off by %.1e, stress by %.1e, near %.1e; disk: %.1e, %.1e, %.1e (reference 0, %s)\n",
              in_ring.displacement, in_ring.stress, in_ring.near, in_disk.displacement, in_disk.stress, in_disk.near,
              source);
  expect_claims(in_ring);
  expect_claims(in_disk);
}

// Two bars in a row between frictionless walls: the strain along them is stress over E (1 - nu) / ((1 + nu) (1 - 2
// nu)).
TEST(Bar, of_two_materials_between_walls_stretches_like_two_springs) {
  Model model;
  const double young[] = {100, 900}, poisson[] = {0.45, -0.3};
  double stretch = 0;
  for (int k = 0; k < 2; ++k) {
    const int32_t id = model.add(material(young[k], poisson[k], BEMPD_PLANE_STRAIN));
    const int32_t bar = model.bem(id, rectangle(2.0 * k, 0, 2.0 * k + 2, 1), 0.4 + 0.1 * k);
    for (const int32_t edge : {1, 3}) model.fix(bar, edge, BEMPD_Y);
    const double nu = poisson[k];
    stretch += 2 / (young[k] * (1 - nu) / ((1 + nu) * (1 - 2 * nu)));
  }
  model.fix(1, 4, BEMPD_X);
  model.traction(2, 2, 0, 1, BEMPD_X, 0, 1);
  model.step(1);
  EXPECT_LE(std::abs(report("end of the bar", model.evaluate({4, 0.3}).displacement[0], stretch, "springs in a row")),
            1e-12 * stretch);
  EXPECT_LE(std::abs(report("stress at the joint", model.evaluate({2, 0.5}).stress[0], 1, "equilibrium")), 1e-10);
}

// A row of edges through places on a circle is that circle.
TEST(SmoothRow, through_points_of_a_circle_is_the_circle) {
  Model model;
  Outline vertices;
  for (const double angle : {0.0, 0.5, 1.4, 2.0, 2.9, 3.7, 4.4, 5.6})
    vertices.push_back({2 * std::cos(angle), 2 * std::sin(angle)});
  const int32_t region = model.bem(model.add(material(1000, 0.3, BEMPD_PLANE_STRAIN)), vertices, 0.6);
  model.check(bempd_set_edges_smooth(model.get(), region, 1, 8));
  const int32_t first = model.circular_hole(region, {0, 0}, 1);
  for (int32_t k = 0; k < 4; ++k) model.traction(region, first + k, [](double x, double y) { return Vector{x, y}; });
  model.fix_point({1, 0}, BEMPD_Y);
  model.fix_point({-1, 0}, BEMPD_Y);
  model.fix_point({0, 1}, BEMPD_X);
  model.step(1);
  const Errors e = errors_of(model, region, {1.0 / 3, 4.0 / 3, 1000, 0.3}, {1.5}, 0.499999);
  std::printf("ring with smooth outer row: reference 0 (%s), u off by %.1e, stress by %.1e\n", source, e.displacement,
              e.stress);
  EXPECT_LE(e.displacement, 1e-12);
  EXPECT_LE(e.stress, 1e-11);
}

}  // namespace
}  // namespace curved_lame_test

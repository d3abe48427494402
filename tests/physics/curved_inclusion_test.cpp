// A plate with a circular hole, or with a bonded disk of another material, under the exact tractions of the infinite
// plate on its outer edges: order of displacements, stress at the hole's edge and next to it.
#include <gtest/gtest.h>

#include <claims.hpp>

#include "circular_inclusion.hpp"
#include "host.hpp"

namespace curved_inclusion_test {
namespace {

using namespace host;
constexpr double pi = 3.14159265358979323846;
constexpr const char* source = "Kirsch, Goodier";

struct Errors {
  double displacement;  // over the largest displacement
  double edge_stress;   // at the nodes of the circle, over the remote stress
  double near_stress;   // 1e-6 of an element from the circle, also next to the ends of elements
};

void read_errors(Model& model, int32_t region, const CircularInclusion& exact, double side, Errors& errors) {
  const std::vector<Vector> places = model.vectors(region, BEMPD_POSITION),
                            u = model.vectors(region, BEMPD_DISPLACEMENT);
  const std::vector<double> stress = model.field(region, BEMPD_STRESS);
  double largest = 0, off = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [x, y] = places[i];
    const auto wanted = exact.displacement(x, y);
    off = std::max(off, std::hypot(u[i][0] - wanted[0], u[i][1] - wanted[1]));
    largest = std::max(largest, std::hypot(wanted[0], wanted[1]));
    if (std::hypot(x, y) > 1 + 1e-9) continue;
    const auto wanted_stress = exact.stress((1 + side * 1e-12) * x, (1 + side * 1e-12) * y);
    for (std::size_t c = 0; c < 3; ++c)
      errors.edge_stress = std::max(errors.edge_stress, std::abs(stress[3 * i + c] - wanted_stress[c]));
  }
  errors.displacement = std::max(errors.displacement, off / largest);
}

Errors solve(const char* scheme, double poisson, const double* disk_young, int refinement) {
  Model model;
  model.set_text("scheme", scheme);
  const double young = 1000, half = 3, element = pi / 4 / refinement;
  const auto plate_solid = CircularInclusion::plane_strain(young, poisson);
  const CircularInclusion exact =
      disk_young ? CircularInclusion(plate_solid, CircularInclusion::plane_strain(*disk_young, 0.1))
                 : CircularInclusion(plate_solid);
  const int32_t plate_material = model.add(material(young, poisson, BEMPD_PLANE_STRAIN));
  const int32_t plate = model.bem(plate_material, rectangle(-half, -half, half, half), 2.0 / refinement);
  const int32_t first = model.circular_hole(plate, {0, 0}, 1);
  for (int32_t k = 0; k < 4; ++k) model.mesh(plate, first + k, element, 1);
  int32_t disk = 0;
  if (disk_young) disk = model.disk(model.add(material(*disk_young, 0.1, BEMPD_PLANE_STRAIN)), {0, 0}, 1, element);
  const Vector normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int32_t edge = 1; edge <= 4; ++edge)
    model.traction(plate, edge, [&exact, n = normals[edge - 1]](double x, double y) {
      const auto s = exact.stress(x, y);
      return Vector{s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
    });
  model.prescribe_point({-half, 0}, BEMPD_X, exact.displacement(-half, 0)[0]);
  model.prescribe_point({-half, 0}, BEMPD_Y, exact.displacement(-half, 0)[1]);
  model.prescribe_point({half, 0}, BEMPD_Y, exact.displacement(half, 0)[1]);
  model.step(1);
  Errors errors{0, 0, 0};
  read_errors(model, plate, exact, 1, errors);
  if (disk) read_errors(model, disk, exact, -1, errors);
  for (int e = 0; e < 8 * refinement; ++e)
    for (const double part : {1e-6, 1e-3, 0.3, 0.5, 1 - 1e-6}) {
      const double angle = (e + part) * element;
      for (const double side : {1.0, -1.0}) {
        if (side < 0 && !disk) continue;
        const double r = 1 + side * 1e-6 * element, x = r * std::cos(angle), y = r * std::sin(angle);
        const auto found = model.evaluate({x, y}).stress, wanted = exact.stress(x, y);
        for (std::size_t c = 0; c < 3; ++c)
          errors.near_stress = std::max(errors.near_stress, std::abs(found[c] - wanted[c]));
      }
    }
  return errors;
}

void expect_order(const char* scheme, double poisson, const double* disk_young) {
  Errors last{0, 0, 0};
  for (const int refinement : {2, 4, 8}) {
    const Errors e = solve(scheme, poisson, disk_young, refinement);
    const double order = last.displacement > 0 ? std::log2(last.displacement / e.displacement) : 0;
    std::printf(
        "%-9s nu %-9.7g %s, %2d elements on the circle: reference 0 (%s), u off by %.2e, order %.2f, stress on the "
        "circle %.1e, 1e-6 of an element off it %.1e\n",
        scheme, poisson, disk_young ? "disk" : "hole", 8 * refinement, source, e.displacement, order, e.edge_stress,
        e.near_stress);
    if (last.displacement > 0) {
      EXPECT_GE(order, 3);
    }
    last = e;
  }
  EXPECT_LE(last.displacement, 5e-5);
  EXPECT_LE(last.edge_stress, 1e-4);
  EXPECT_LE(last.near_stress, 1e-4);
}

TEST(Kirsch, displacements_are_of_third_order_and_stress_holds_up_to_the_hole_in_every_scheme) {
  for (const char* scheme : all_schemes()) expect_order(scheme, 0.3, nullptr);
}

TEST(Kirsch, stress_at_the_hole_is_as_good_as_claimed) {
  for (const auto& [refinement, bound] : {std::pair{2, claims::kirsch_16}, {8, claims::kirsch_64}}) {
    const double value = solve("symmetric", 0.3, nullptr, refinement).edge_stress;
    std::printf("%2d elements on the circle: ", 8 * refinement);
    EXPECT_LE(report("stress on the circle, off by", value, 0, source), bound);
  }
}

TEST(Kirsch, nearly_incompressible_plates_are_as_good) { expect_order("symmetric", 0.4999999, nullptr); }

TEST(Goodier, bonded_disks_stiff_and_soft_are_of_third_order) {
  const double stiff = 5000, soft = 50;
  expect_order("symmetric", 0.3, &stiff);
  expect_order("symmetric", 0.3, &soft);
}

}  // namespace
}  // namespace curved_inclusion_test

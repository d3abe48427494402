// Extreme shapes and meshes. References: fields that solve the equations of elasticity in any body, so that every
// difference is an error of integration or rounding: constant strain, and pure bending.
#include <gtest/gtest.h>

#include "../coupled_scene.hpp"

namespace extremes_shapes_test {
namespace {

using namespace host;

constexpr double young = 2.5;

// A displacement field and its stress, for plane stress.
struct Exact {
  double poisson;
  Field displacement;
  std::function<std::array<double, 3>(double, double)> stress;  // xx, yy, xy
};

// u = (a x + b y, b x + c y)
Exact constant_strain(double poisson) {
  const double a = 0.7, b = 0.2, c = -0.4, k = young / (1 - poisson * poisson);
  return {poisson,
          [=](double x, double y) {
            return Vector{a * x + b * y, b * x + c * y};
          },
          [=](double, double) {
            return std::array{k * (a + poisson * c), k * (c + poisson * a), young / (1 + poisson) * b};
          }};
}

// Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 102: sigma_xx = E y about the middle y0.
Exact pure_bending(double poisson, double y0) {
  return {poisson,
          [=](double x, double y) {
            const double t = y - y0;
            return Vector{x * t, -(x * x + poisson * t * t) / 2};
          },
          [=](double, double y) {
            return std::array{young * (y - y0), 0.0, 0.0};
          }};
}

Field traction(const Exact& exact, Vector n) {
  return [stress = exact.stress, n](double x, double y) {
    const auto s = stress(x, y);
    return Vector{s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
  };
}

// Tractions on every free edge but the first two, whose displacements are prescribed.
void load(Model& model, const std::vector<Piece>& pieces, const std::vector<int32_t>& regions, const Exact& exact) {
  int count = 0;
  for (const EdgePart& part : free_parts(pieces)) {
    const int32_t region = regions[part.piece];
    if (count++ == 0) {
      model.prescribe(region, part.edge, part.from, part.to, exact.displacement);
    } else {
      model.traction(region, part.edge, traction(exact, part.normal()));
    }
  }
}

double largest_error(Model& model, const std::vector<int32_t>& regions, const Exact& exact) {
  double error = 0, size = 0;
  for (int32_t region : regions) {
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector v = exact.displacement(x[i][0], x[i][1]);
      error = largest({error, u[i][0] - v[0], u[i][1] - v[1]});
      size = largest({size, v[0], v[1]});
    }
  }
  return error / size;
}

double solved_error(Model& model, const std::vector<int32_t>& regions, const Exact& exact, const char* what) {
  model.step(1);
  return report(what, largest_error(model, regions, exact), 0, "exact field");
}

// Bending makes a bar of slenderness s about s^4 times softer than stretching does; rounding of the stiff part is lost
// in the soft one. Finite elements of displacements share the fate.
double slender_loss(double slenderness) { return 1e-10 + 1e-15 * std::pow(slenderness, 4); }

TEST(ExtremeShapes, bars_up_to_a_thousand_times_as_long_as_high) {
  for (double slenderness : {10.0, 100.0, 1000.0}) {
    const std::vector<Piece> pieces{{Method::boundary_elements, rectangle(0, 0, slenderness, 1)}};
    for (double elements : {1, 10, 50}) {
      for (bool bent : {false, true}) {
        const Exact exact = bent ? pure_bending(0.3, 0.5) : constant_strain(0.3);
        Model model;
        const int32_t id = model.add(material(young, exact.poisson));
        const auto regions = add_pieces(model, pieces, id, 0, 0, slenderness / elements);
        model.prescribe(1, 4, 0, 1, exact.displacement);
        model.traction(1, 1, traction(exact, {0, -1}));
        model.traction(1, 2, traction(exact, {1, 0}));
        model.traction(1, 3, traction(exact, {0, 1}));
        char what[64];
        std::snprintf(what, sizeof what, "%s bar %g : 1, %g elements", bent ? "bent" : "strained", slenderness,
                      elements);
        EXPECT_LE(solved_error(model, regions, exact, what), slender_loss(slenderness));
      }
    }
  }
}

TEST(ExtremeShapes, coupled_bars_a_thousand_times_as_long_as_high) {
  const std::vector<Piece> pieces{{Method::boundary_elements, rectangle(0, 0, 490, 1)},
                                  {Method::peridynamics, rectangle(490, 0, 510, 1)},
                                  {Method::boundary_elements, rectangle(510, 0, 1000, 1)}};
  const Exact exact = constant_strain(1.0 / 3);
  Model model;
  const int32_t id = model.add(material(young, exact.poisson));
  const auto regions = add_pieces(model, pieces, id, 0.125, 3, 50);
  load(model, pieces, regions, exact);
  EXPECT_LE(solved_error(model, regions, exact, "strained coupled bar 1000 : 1"), slender_loss(1000));
}

TEST(ExtremeShapes, neighbouring_elements_ten_thousand_times_as_long) {
  const std::vector<Piece> pieces{{Method::boundary_elements, rectangle(0, 0, 1, 1)}};
  const Exact exact = constant_strain(0.3);
  Model model;
  const int32_t id = model.add(material(young, exact.poisson));
  const auto regions = add_pieces(model, pieces, id, 0, 0, 1);
  // A small element in each corner, growing fourfold from there.
  for (int32_t edge : {1, 3}) model.mesh(1, edge, 0.1, 4);
  load(model, pieces, regions, exact);
  const auto elements = model.elements(1);
  const auto x = model.vectors(1, BEMPD_POSITION);
  double shortest = 1, longest = 0;
  for (const auto& e : elements) {
    const Vector a = x[static_cast<std::size_t>(e[0])], b = x[static_cast<std::size_t>(e[2])];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  std::printf("elements between %g and %g long\n", shortest, longest);
  EXPECT_LE(solved_error(model, regions, exact, "elements of very different length"), 1e-11);
}

// A short edge beside long ones: the corner is cut off by 1e-4.
TEST(ExtremeShapes, an_edge_ten_thousand_times_shorter_than_its_neighbours) {
  const std::vector<Piece> pieces{{Method::boundary_elements, {{0, 0}, {1 - 1e-4, 0}, {1, 1e-4}, {1, 1}, {0, 1}}}};
  const Exact exact = constant_strain(0.3);
  Model model;
  const auto regions = add_pieces(model, pieces, model.add(material(young, exact.poisson)), 0, 0, 1);
  load(model, pieces, regions, exact);
  EXPECT_LE(solved_error(model, regions, exact, "corner cut off by 1e-4"), 1e-11);
}

// Faces 1e-4 apart with elements of 0.1: a thousand element widths of nearness.
TEST(ExtremeShapes, a_notch_1e_minus_4_wide) {
  const double w = 1e-4;
  const std::vector<Piece> pieces{
      {Method::boundary_elements,
       {{0, 0}, {1, 0}, {1, 1}, {0.5 + w / 2, 1}, {0.5 + w / 2, 0.5}, {0.5 - w / 2, 0.5}, {0.5 - w / 2, 1}, {0, 1}}}};
  const Exact exact = constant_strain(0.3);
  Model model;
  const auto regions = add_pieces(model, pieces, model.add(material(young, exact.poisson)), 0, 0, 0.1);
  load(model, pieces, regions, exact);
  EXPECT_LE(solved_error(model, regions, exact, "notch 1e-4 wide"), 1e-9);
}

TEST(ExtremeShapes, horizons_of_2_to_8_spacings) {
  const std::vector<Piece> pieces{{Method::boundary_elements, rectangle(0, 0, 1, 1)},
                                  {Method::peridynamics, rectangle(1, 0, 2, 1)}};
  const Exact exact = constant_strain(1.0 / 3);
  for (int m = 2; m <= 8; ++m) {
    Model model;
    const auto regions = add_pieces(model, pieces, model.add(material(young, exact.poisson)), 1.0 / 17, m, 0.25);
    load(model, pieces, regions, exact);
    EXPECT_LE(solved_error(model, regions, exact, ("horizon ratio " + std::to_string(m)).c_str()), 1e-10);
  }
}

// Coordinates of 1e6 body sizes leave ten digits for the shape. What is lost is stated: errors grow with the distance,
// rounding of the coordinates (1e-16 of the distance) over the lattice spacing or element length.
TEST(ExtremeShapes, bodies_a_million_sizes_from_the_origin) {
  const Exact at_origin = constant_strain(1.0 / 3);
  for (double distance : {0.0, 1e2, 1e4, 1e6}) {
    const Exact exact{at_origin.poisson,
                      [&](double x, double y) { return at_origin.displacement(x - distance, y - distance); },
                      at_origin.stress};
    const auto piece = [&](Method method, double x0) {
      return Piece{method, rectangle(distance + x0, distance, distance + x0 + 1, distance + 1)};
    };
    const std::vector<Piece> pieces{piece(Method::boundary_elements, 0), piece(Method::peridynamics, 1),
                                    piece(Method::boundary_elements, 2)};
    Model model;
    const auto regions = add_pieces(model, pieces, model.add(material(young, exact.poisson)), 0.0625, 4, 0.25);
    load(model, pieces, regions, exact);
    char what[64];
    std::snprintf(what, sizeof what, "%g body sizes from the origin", distance);
    EXPECT_LE(solved_error(model, regions, exact, what), 1e-11 + 2e-14 * distance);
  }
}

}  // namespace
}  // namespace extremes_shapes_test

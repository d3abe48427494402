// Large BEM regions are cut into subdomains: exact fields come back, and results are those of the outline.
// References: constant strain; a bar under its own weight (Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art.
// 96, with E = 1); free expansion.
#include <gtest/gtest.h>

#include <cstdio>

#include "host.hpp"

namespace subdomains_test {
namespace {

using namespace host;

constexpr double poisson = 0.25;

using Hole = std::array<double, 3>;  // centre and radius
const std::vector<Hole> holes{{0.8, 0.9, 0.4},  {2.2, 0.7, 0.3}, {3.7, 0.9, 0.5}, {5.2, 0.7, 0.35},
                              {0.9, 2.2, 0.45}, {2.4, 2, 0.6},   {4, 2.3, 0.4},   {5.2, 2.1, 0.5}};

bempd_material warm() {
  bempd_material sheet = material(1, poisson);
  sheet.thermal_expansion = 0.01;
  return sheet;
}

// Plate of 6 x 3 with eight round holes and more than 500 elements. Its first four edges are the outer ones.
struct Sheet {
  Model model;
  int32_t region;

  explicit Sheet(double x = 0) : region(model.bem(model.add(warm()), rectangle(x, 0, x + 6, 3), 0.07)) {
    for (const Hole& hole : holes) model.circular_hole(region, {x + hole[0], hole[1]}, hole[2]);
  }

  void hold_outer_edges(const Field& displacement) {
    for (int32_t edge = 1; edge <= 4; ++edge) model.prescribe(region, edge, 0, 1, displacement);
  }
  // Tractions of a stress (xx, yy, xy) on the holes; outward normals point to their centres.
  void load_holes(const std::function<std::array<double, 3>(Vector)>& stress) {
    for (std::size_t k = 0; k < holes.size(); ++k) {
      const Hole hole = holes[k];
      for (int32_t quarter = 0; quarter < 4; ++quarter)
        model.traction(region, 5 + 4 * static_cast<int32_t>(k) + quarter, [=](double x, double y) {
          const double nx = (hole[0] - x) / hole[2], ny = (hole[1] - y) / hole[2];
          const auto s = stress({x, y});
          return Vector{s[0] * nx + s[2] * ny, s[2] * nx + s[1] * ny};
        });
    }
  }

  // Largest errors of displacement, and of stress at places inside, on cuts and at the outline.
  double error_of(const Field& displacement, const std::function<std::array<double, 3>(Vector)>& stress) {
    std::vector<double> errors;
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector exact = displacement(x[i][0], x[i][1]);
      errors.insert(errors.end(), {u[i][0] - exact[0], u[i][1] - exact[1]});
    }
    for (double px = 0.01; px < 6; px += 0.37)
      for (double py = 0.02; py < 3; py += 0.43) {
        Vector at{px, py};
        std::array<double, 2> found{};
        std::array<double, 3> values{};
        int32_t where = 0;
        if (bempd_evaluate(model.get(), 1, at.data(), found.data(), values.data(), &where) != BEMPD_OK) continue;
        const Vector exact = displacement(px, py);
        const auto wanted = stress(at);
        errors.insert(errors.end(), {found[0] - exact[0], found[1] - exact[1]});
        for (std::size_t k = 0; k < 3; ++k) errors.push_back(values[k] - wanted[k]);
      }
    const std::vector<double> at_nodes = model.field(region, BEMPD_STRESS);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) errors.push_back(at_nodes[3 * i + k] - stress(x[i])[k]);
    return largest(errors);
  }
};

TEST(Subdomains, return_constant_strain) {
  Sheet sheet;
  const auto u = [](double x, double y) { return Vector{0.3 * x + 0.2 * y + 0.1, -0.4 * y + 0.1 * x}; };
  const double c = 1 / (1 - poisson * poisson);
  const std::array<double, 3> stress{c * (0.3 - 0.4 * poisson), c * (-0.4 + 0.3 * poisson), 0.15 / (1 + poisson)};
  sheet.hold_outer_edges(u);
  sheet.load_holes([&](Vector) { return stress; });
  sheet.model.step(1);
  const bempd_statistics sizes = sheet.model.statistics();
  EXPECT_GT(sizes.subdomains, 5);
  EXPECT_GT(sizes.cut_nodes, 50);
  EXPECT_EQ(sizes.boundary_nodes, static_cast<int64_t>(sheet.model.vectors(sheet.region, BEMPD_POSITION).size()));
  const double error = sheet.error_of(u, [&](Vector) { return stress; });
  std::printf("%d subdomains: largest error %.1e\n", static_cast<int>(sizes.subdomains), error);
  EXPECT_LE(error, 1e-9);
  double force = 0;
  for (const int32_t edge : {2, 4}) {
    Vector reaction{};
    double moment = 0;
    sheet.model.check(bempd_edge_reaction(sheet.model.get(), sheet.region, edge, 0, 0, reaction.data(), &moment));
    force += reaction[0];
    EXPECT_NEAR(std::abs(reaction[0]), 3 * stress[0], 1e-9);
  }
  EXPECT_NEAR(force, 0, 1e-9);
}

TEST(Subdomains, hang_under_their_weight) {
  Sheet sheet;
  const auto u = [](double x, double y) { return Vector{-poisson * x * y, (y * y + poisson * x * x) / 2}; };
  const auto stress = [](Vector at) { return std::array<double, 3>{0, at[1], 0}; };
  sheet.hold_outer_edges(u);
  sheet.load_holes(stress);
  int32_t load = 0;
  sheet.model.check(bempd_add_body_force(sheet.model.get(), sheet.region, BEMPD_Y, 0, -1, &load));
  sheet.model.step(1);
  const double error = sheet.error_of(u, stress);
  std::printf("under weight: largest error %.1e\n", error);
  EXPECT_LE(error, 1e-9);
}

TEST(Subdomains, expand_freely_also_when_the_temperature_changes) {
  Sheet sheet;
  sheet.model.fix_point({0, 0}, BEMPD_BOTH);
  sheet.model.fix_point({6, 0}, BEMPD_Y);
  int32_t load = 0;
  sheet.model.check(bempd_add_temperature(sheet.model.get(), sheet.region, 20, 0, &load));
  for (const double temperature : {20.0, 50.0}) {
    const double constant = temperature, none = 0;
    if (temperature > 20) sheet.model.check(bempd_set_load_values(sheet.model.get(), load, 1, &constant, &none));
    sheet.model.step(1);
    const double strain = 0.01 * temperature;
    const double error = sheet.error_of(
        [&](double x, double y) {
          return Vector{strain * x, strain * y};
        },
        [](Vector) { return std::array<double, 3>{}; });
    std::printf("%g K warmer: largest error %.1e\n", temperature, error);
    EXPECT_LE(error, 1e-9);
  }
}

TEST(Subdomains, of_equal_regions_share_their_operators) {
  const auto evaluations = [](int copies) {
    Model model;
    const int32_t one = model.add(warm());
    for (int k = 0; k < copies; ++k) {
      const double x = 8 * k;
      const int32_t region = model.bem(one, rectangle(x, 0, x + 6, 3), 0.0625);
      for (const double cx : {1.0, 3.0, 5.0}) model.circular_hole(region, {x + cx, 1.5}, 0.5);
      model.fix(region, 4, BEMPD_BOTH);
    }
    model.step(1);
    return model.statistics().kernel_evaluations;
  };
  EXPECT_EQ(evaluations(2), evaluations(1));
}

TEST(Subdomains, hide_the_nodes_on_their_cuts_from_points) {
  // Nodes on the first cut of this square are nearer to its middle than those of its edges.
  Model model;
  const int32_t square = model.bem(model.add(warm()), rectangle(0, 0, 1, 1), 1 / 160.0);
  model.fix(square, 4, BEMPD_BOTH);
  model.fix_point({0.5, 0.5}, BEMPD_BOTH);
  EXPECT_EQ(bempd_prepare(model.get()), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(model.get())).find("the nearest is (0.5, 0)"), std::string::npos);
}

TEST(Subdomains, that_are_too_large_for_the_memory_are_refused_before_they_are_built) {
  Sheet sheet;
  sheet.model.set("memory.limit", 0.001);
  EXPECT_EQ(bempd_prepare(sheet.model.get()), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(sheet.model.get())).find("memory.limit"), std::string::npos);
  sheet.model.set("memory.limit", 0);
  sheet.hold_outer_edges([](double x, double) { return Vector{x, 0}; });
  sheet.model.step(1);
}

}  // namespace
}  // namespace subdomains_test

// Force and moment of every edge that is held. Reference: in a body that is strained uniformly by what its edges are
// given, an edge of length L and normal n feels t L sigma n, corners included; and all edges together balance.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "host.hpp"

namespace edge_reaction_test {
namespace {

using namespace host;

struct Reaction {
  Vector force;
  double moment;
};

Reaction edge_reaction(Model& model, int32_t region, int32_t edge, Vector about = {0, 0}) {
  Reaction reaction{};
  model.check(
      bempd_edge_reaction(model.get(), region, edge, about[0], about[1], reaction.force.data(), &reaction.moment));
  return reaction;
}

constexpr double young = 4, thickness = 0.1;
const Vector strained(double x, double y) { return {0.01 * x + 0.002 * y, -0.003 * x + 0.004 * y}; }

std::array<double, 3> stress(double nu) {
  const double c = young / (1 - nu * nu), xx = 0.01, yy = 0.004, shear = 0.002 - 0.003;
  return {c * (xx + nu * yy), c * (yy + nu * xx), 0.5 * young / (1 + nu) * shear};
}

// The order in which supports are added decides which of them counts the corner of a lattice in bempd_reaction(); it
// matters to no edge, and not to supports of elements.
TEST(EdgeReaction, of_uniform_stress_is_its_resultant_in_whatever_order_supports_are_added) {
  constexpr double width = 1.5, height = 0.9, nu = 1.0 / 3;
  const std::array<double, 3> s = stress(nu);
  for (const bool lattice : {false, true}) {
    for (const std::vector<int32_t>& order : {std::vector<int32_t>{1, 2, 3, 4}, {4, 2, 1, 3}}) {
      Model model;
      const int32_t id = model.add(material(young, nu, BEMPD_PLANE_STRESS, thickness));
      const Outline outline = rectangle(0, 0, width, height);
      const int32_t body = lattice ? model.pd(id, outline, 0.1, 3) : model.bem(id, outline, 0.2);
      std::map<int32_t, int32_t> supports;  // by edge
      for (const int32_t edge : order) supports[edge] = model.prescribe(body, edge, 0, 1, strained);
      model.step(1);
      const Vector normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
      const Vector middles[] = {{0.5 * width, 0}, {width, 0.5 * height}, {0.5 * width, height}, {0, 0.5 * height}};
      for (int32_t edge = 1; edge <= 4; ++edge) {
        const auto [nx, ny] = normals[edge - 1];
        const double length = thickness * (edge % 2 == 1 ? width : height);
        const Reaction found = edge_reaction(model, body, edge, middles[edge - 1]);
        const double fx = length * (s[0] * nx + s[2] * ny), fy = length * (s[2] * nx + s[1] * ny);
        EXPECT_LE(std::abs(report(lattice ? "lattice, x" : "elements, x", found.force[0], fx, "uniform stress")),
                  1e-12);
        EXPECT_LE(std::abs(report(lattice ? "lattice, y" : "elements, y", found.force[1], fy, "uniform stress")),
                  1e-12);
        EXPECT_NEAR(found.moment, 0, 1e-12);
        if (lattice) continue;
        const Vector of_support = model.reaction(supports[edge]);
        EXPECT_LE(std::abs(report("support, x", of_support[0], fx, "uniform stress")), 1e-12);
        EXPECT_LE(std::abs(report("support, y", of_support[1], fy, "uniform stress")), 1e-12);
        double moment = 0;
        model.check(
            bempd_reaction_moment(model.get(), supports[edge], middles[edge - 1][0], middles[edge - 1][1], &moment));
        EXPECT_NEAR(moment, 0, 1e-12);
      }
    }
  }
}

// The stress xx of bent elements is `bending` times y and all others are zero, so the left and the right edge have all
// of the load.
TEST(EdgeReaction, of_bent_elements_is_that_of_tractions_that_change_along_edges) {
  constexpr double width = 1.2, height = 0.8, nu = 0.3, bending = 0.05;
  const auto bent = [](double x, double y) -> Vector {
    return {bending / young * x * y, -0.5 * bending / young * (x * x + nu * y * y)};
  };
  for (const double target : {0.6, 0.2}) {
    Model model;
    const int32_t id = model.add(material(young, nu, BEMPD_PLANE_STRESS, thickness));
    const int32_t body = model.bem(id, rectangle(0, 0, width, height), target);
    std::map<int32_t, int32_t> supports;  // by edge
    for (int32_t edge = 1; edge <= 4; ++edge) supports[edge] = model.prescribe(body, edge, 0, 1, bent);
    model.step(1);
    const double force = 0.5 * thickness * bending * height * height, moment = -force * height * 2 / 3;  // about y = 0
    for (const auto& [edge, support] : supports) {
      const double sign = edge == 2 ? 1 : edge == 4 ? -1 : 0;
      const Reaction found = edge_reaction(model, body, edge, {edge == 2 ? width : 0.0, 0});
      const Vector of_support = model.reaction(support);
      EXPECT_NEAR(found.force[0], sign * force, 1e-11) << edge;
      EXPECT_NEAR(found.force[1], 0, 1e-11) << edge;
      EXPECT_NEAR(found.moment, sign * moment, 1e-11) << edge;
      EXPECT_NEAR(of_support[0], sign * force, 1e-11) << edge;
      EXPECT_NEAR(of_support[1], 0, 1e-11) << edge;
    }
  }
}

// A block clamped at three edges with corners in common, of two regions, pushed from above: the edges have all that the
// supports have.
TEST(EdgeReaction, of_all_edges_sums_to_that_of_all_supports) {
  for (const int kinds : {0, 1, 2}) {
    Model model;
    const int32_t id = model.add(material(young, 1.0 / 3, BEMPD_PLANE_STRESS, thickness));
    const Outline left = rectangle(0, 0, 1, 1), right = rectangle(1, 0, 2, 1);
    if (kinds == 0) model.bem(id, left, 0.1), model.bem(id, right, 0.2);
    if (kinds == 1) model.bem(id, left, 0.1), model.pd(id, right, 0.1, 3);
    if (kinds == 2) model.pd(id, left, 0.1, 3), model.pd(id, right, 0.1, 4);
    std::vector<int32_t> supports{model.fix(1, 1, BEMPD_BOTH), model.fix(1, 4, BEMPD_BOTH), model.fix(2, 1, BEMPD_BOTH),
                                  model.fix(2, 2, BEMPD_X), model.prescribe(2, 2, BEMPD_Y, 0, 0)};
    model.traction(1, 3, 0, 1, BEMPD_Y, -1, 0);
    model.traction(2, 3, 0, 1, BEMPD_X, 0.3, 0.5);
    model.step(1);
    Vector sum{0, 0}, wanted{0, 0};
    double moment = 0, wanted_moment = 0;
    for (const int32_t support : supports) {
      double value = 0;
      model.check(bempd_reaction_moment(model.get(), support, 0.3, 0.2, &value));
      wanted_moment += value;
      for (std::size_t c = 0; c < 2; ++c) wanted[c] += model.reaction(support)[c];
    }
    for (const auto& [region, edge] : {std::array{1, 1}, {1, 4}, {2, 1}, {2, 2}}) {
      const Reaction found = edge_reaction(model, region, edge, {0.3, 0.2});
      moment += found.moment;
      for (std::size_t c = 0; c < 2; ++c) sum[c] += found.force[c];
    }
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(sum[c], wanted[c], 1e-14);
    EXPECT_NEAR(moment, wanted_moment, 1e-14);
    EXPECT_NEAR(sum[1], thickness, 1e-9);
    EXPECT_NEAR(sum[0], -0.8 * thickness, 1e-9);
  }
}

// A support alone on its edge: the same as bempd_reaction().
TEST(EdgeReaction, of_an_edge_alone_is_that_of_its_support) {
  Model model;
  const int32_t body = model.bem(model.add(material(young, 0.3)), rectangle(0, 0, 2, 1), 0.2);
  const int32_t held = model.fix(body, 4, BEMPD_BOTH);
  model.traction(body, 2, 0, 1, BEMPD_Y, 0, 1);
  model.step(1);
  const Reaction found = edge_reaction(model, body, 4);
  EXPECT_EQ(found.force, model.reaction(held));
  EXPECT_NEAR(found.moment, -2, 1e-9);
  model.check(bempd_edge_reaction(model.get(), body, 4, 0, 0, nullptr, nullptr));
  for (const int32_t edge : {0, 1, 5}) {
    double force[2];
    EXPECT_EQ(bempd_edge_reaction(model.get(), body, edge, 0, 0, force, nullptr), BEMPD_ERROR_ARGUMENT);
  }
  EXPECT_EQ(bempd_edge_reaction(model.get(), 2, 1, 0, 0, nullptr, nullptr), BEMPD_ERROR_ARGUMENT);
  EXPECT_EQ(bempd_edge_reaction(model.get(), body, 4, NAN, 0, nullptr, nullptr), BEMPD_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace edge_reaction_test

// Regions of one lattice with slanted and round common edges are one body: constant stress passes, and points, results
// and the loads of cracks are those of one region. Reference: linear displacement, and the body of one region.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host.hpp"

namespace joined_outlines_test {
namespace {

using namespace host;

constexpr double quarter = 0.41421356237309503;  // bulge of a quarter circle, tan(90 degrees / 4)

struct Part {
  Outline outline;
  std::vector<double> bulges{};       // of its edges; empty for straight ones
  std::vector<int32_t> free_edges{};  // by number
  double hole = 0;                    // radius of a hole about the origin, which another part fills
};

Part disc(double radius) {
  return {{{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}}, std::vector<double>(4, quarter), {}};
}

// Parts of a rectangle, by how they meet.
struct Body {
  const char* name;
  std::vector<Part> parts;
  Outline whole;  // of one region, with vertices where common edges end
  Vector low, high;
  const char* points = "always";  // parts and whole that have points on their outlines (test.outline_points)
  // Share of the energy of all bonds that break up to which loads of a crack are compared: then rounding decides when
  // the last bonds of a hinge are left.
  double compared = 0.8;
};

const Body slanted{
    "slanted",
    {{{{0, 0}, {8, 0}, {14, 14}, {0, 14}}, {}, {1, 3, 4}}, {{{8, 0}, {22, 0}, {22, 14}, {14, 14}}, {}, {1, 2, 3}}},
    {{0, 0}, {8, 0}, {22, 0}, {22, 14}, {14, 14}, {0, 14}},
    {0, 0},
    {22, 14}};
// Seen from the left part, the common edge is an outside arc, then an inside arc.
Body with_arc(double bulge) {
  return {"arc",
          {{{{0, 0}, {8, 0}, {12, 14}, {0, 14}}, {0, bulge, 0, 0}, {1, 3, 4}},
           {{{8, 0}, {22, 0}, {22, 14}, {12, 14}}, {0, 0, 0, -bulge}, {1, 2, 3}}},
          {{0, 0}, {8, 0}, {22, 0}, {22, 14}, {12, 14}, {0, 14}},
          {0, 0},
          {22, 14}};
}
const Body around_disc{"disc",
                       {{{{-11, -6}, {11, -6}, {11, 8}, {-11, 8}}, {}, {1, 2, 3, 4}, 3.5}, disc(3.5)},
                       {{-11, -6}, {11, -6}, {11, 8}, {-11, 8}},
                       {-11, -6},
                       {11, 8}};
const Body three_inside{"three inside",
                        {{{{0, 0}, {8, 0}, {11, 7}, {12, 14}, {0, 14}}, {}, {1, 4, 5}},
                         {{{8, 0}, {22, 0}, {22, 5}, {11, 7}}, {}, {1, 2}},
                         {{{22, 5}, {22, 14}, {12, 14}, {11, 7}}, {}, {1, 2}}},
                        {{0, 0}, {8, 0}, {22, 0}, {22, 5}, {22, 14}, {12, 14}, {0, 14}},
                        {0, 0},
                        {22, 14}};
// The part in the middle has a corner of 39 degrees.
const Body three_at_an_edge{"three at an edge",
                            {{{{0, 0}, {5, 0}, {11, 14}, {0, 14}}, {}, {1, 3, 4}},
                             {{{5, 0}, {15, 0}, {11, 14}}, {}, {1}},
                             {{{15, 0}, {22, 0}, {22, 14}, {11, 14}}, {}, {1, 2, 3}}},
                            {{0, 0}, {5, 0}, {15, 0}, {22, 0}, {22, 14}, {11, 14}, {0, 14}},
                            {0, 0},
                            {22, 14}};

// Parts whose outlines follow lattice rows, beside and below a part with a slanted edge.
const Body beside_rows{"beside rows",
                       {{rectangle(0, 0, 8, 14), {}, {1, 3, 4}}, {{{8, 0}, {22, 0}, {26, 14}, {8, 14}}, {}, {1, 2, 3}}},
                       {{0, 0}, {8, 0}, {22, 0}, {26, 14}, {8, 14}, {0, 14}},
                       {0, 0},
                       {22, 14},
                       "slanted",
                       0.3};
const Body above_rows{"above rows",
                      {{rectangle(0, 0, 22, 6), {}, {1, 2, 4}}, {{{0, 6}, {22, 6}, {26, 14}, {0, 14}}, {}, {2, 3, 4}}},
                      {{0, 0}, {22, 0}, {22, 6}, {26, 14}, {0, 14}, {0, 6}},
                      {0, 0},
                      {22, 14},
                      "slanted"};

std::vector<Body> bodies() {
  return {slanted, with_arc(0.2), with_arc(-0.2), around_disc, three_inside, three_at_an_edge, beside_rows, above_rows};
}

std::vector<int32_t> add(Model& model, int32_t material, const std::vector<Part>& parts, int horizon_ratio,
                         const char* outline_points = "always") {
  model.set_text("test.outline_points", outline_points);
  std::vector<int32_t> regions;
  for (const Part& part : parts) {
    int32_t id = 0;
    model.check(bempd_add_turned_pd_region(
        model.get(), material, static_cast<int64_t>(part.outline.size()), part.outline.data()->data(),
        part.bulges.empty() ? nullptr : part.bulges.data(), 1, horizon_ratio, 0, &id));
    if (part.hole > 0) model.circular_hole(id, {0, 0}, part.hole);
    regions.push_back(id);
  }
  return regions;
}

std::vector<Part> one_part(const Body& body) {
  Part part{body.whole, {}, {}};
  for (std::size_t k = 1; k <= body.whole.size(); ++k) part.free_edges.push_back(static_cast<int32_t>(k));
  return {part};
}

struct Uniform {
  double xx = 3e-3, yy = -1e-3, xy = 2e-3, ratio = 1.0 / 3;
  Vector displacement(const Vector& p) const {
    const double exx = xx - ratio * yy, eyy = yy - ratio * xx, exy = (1 + ratio) * xy;
    return {exx * p[0] + exy * p[1], exy * p[0] + eyy * p[1]};
  }
};

TEST(JoinedOutlines, pass_constant_stress) {
  for (const double ratio : {1.0 / 3, 0.2}) {
    for (const Body& body : bodies()) {
      const Uniform uniform{.ratio = ratio};
      Model model;
      const auto regions = add(model, model.add(material(1, ratio)), body.parts, 4, body.points);
      for (std::size_t k = 0; k < regions.size(); ++k) {
        const Outline& loop = body.parts[k].outline;
        for (const int32_t edge : body.parts[k].free_edges) {
          const Vector a = loop[static_cast<std::size_t>(edge) - 1],
                       b = loop[static_cast<std::size_t>(edge) % loop.size()];
          const double length = std::hypot(b[0] - a[0], b[1] - a[1]), nx = (b[1] - a[1]) / length,
                       ny = (a[0] - b[0]) / length;
          model.traction(regions[k], edge, 0, 1, BEMPD_X, 0, uniform.xx * nx + uniform.xy * ny);
          model.traction(regions[k], edge, 0, 1, BEMPD_Y, 0, uniform.xy * nx + uniform.yy * ny);
        }
      }
      const Vector corner{body.high[0], body.low[1]};
      model.prescribe_point(body.low, BEMPD_X, uniform.displacement(body.low)[0]);
      model.prescribe_point(body.low, BEMPD_Y, uniform.displacement(body.low)[1]);
      model.prescribe_point(corner, BEMPD_Y, uniform.displacement(corner)[1]);
      model.step(1);
      double error = 0, scale = 0;
      for (const int32_t region : regions) {
        const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
        for (std::size_t i = 0; i < x.size(); ++i) {
          const Vector e = uniform.displacement(x[i]);
          scale = largest({scale, std::hypot(e[0], e[1])});
          error = largest({error, std::hypot(u[i][0] - e[0], u[i][1] - e[1])});
        }
      }
      EXPECT_LT(report(body.name, error / scale, 0, "linear"), 1e-12);
      for (double s = 0.02; s < 1; s += 0.07) {
        const Vector at{body.low[0] + s * (body.high[0] - body.low[0]), body.low[1] + s * (body.high[1] - body.low[1])};
        const Model::Values values = model.evaluate(at);
        EXPECT_NEAR(values.stress[0], uniform.xx, 1e-10 * uniform.xx) << body.name << " " << at[0] << " " << at[1];
        EXPECT_NEAR(values.stress[1], uniform.yy, 1e-10 * uniform.xx);
        EXPECT_NEAR(values.stress[2], uniform.xy, 1e-10 * uniform.xx);
      }
    }
  }
}

// A plate that is pulled apart across a crack from its left edge.
struct Pulled {
  BondModel model;
  std::vector<int32_t> regions;

  Pulled(const Body& body, bool divided, const char* rule, double ratio = 1.0 / 3) {
    model.set_text("crack.rule", rule);
    const std::vector<Part> parts = divided ? body.parts : one_part(body);
    regions = add(model, model.add(material(1, ratio, BEMPD_PLANE_STRESS, 1, 1e-3)), parts, 3, body.points);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Outline& loop = parts[k].outline;
      for (const int32_t edge : parts[k].free_edges) {
        const double y = loop[static_cast<std::size_t>(edge) - 1][1];
        if (loop[static_cast<std::size_t>(edge) % loop.size()][1] != y) continue;
        model.prescribe(regions[k], edge, BEMPD_Y, 0, y == body.low[1] ? -0.01 : 0.01);
      }
      model.check(bempd_add_body_force(model.get(), regions[k], BEMPD_X, 1e-5, 0, nullptr));
    }
    model.fix_point({body.high[0], body.low[1]}, BEMPD_X);
    const double y = 0.5 * (body.low[1] + body.high[1]) - 0.5;
    model.crack({{body.low[0], y}, {body.low[0] + 5, y}});
  }

  // Values at all points of the body, each once.
  std::map<std::array<int64_t, 2>, std::vector<double>> at_points(int32_t field) {
    std::map<std::array<int64_t, 2>, std::vector<double>> all;
    for (const int32_t region : regions) {
      const auto x = model.vectors(region, BEMPD_POSITION);
      const std::vector<double> values = model.field(region, field);
      const std::size_t count = values.size() / x.size();
      for (std::size_t i = 0; i < x.size(); ++i)
        all[{std::llround(1e6 * x[i][0]), std::llround(1e6 * x[i][1])}] = {values.begin() + i * count,
                                                                           values.begin() + (i + 1) * count};
    }
    return all;
  }
};

TEST(JoinedOutlines, are_one_region) {
  for (const double ratio : {1.0 / 3, 0.2}) {
    for (const Body& body : bodies()) {
      Pulled one(body, false, "line", ratio), divided(body, true, "line", ratio);
      one.model.step(0.01), divided.model.step(0.01);
      EXPECT_EQ(one.model.statistics().bonds, divided.model.statistics().bonds) << body.name;
      for (const int32_t field : {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_DAMAGE}) {
        const auto wanted = one.at_points(field), found = divided.at_points(field);
        ASSERT_EQ(wanted.size(), found.size()) << body.name;
        double difference = 0, scale = 0;
        for (const auto& [place, values] : wanted) {
          ASSERT_TRUE(found.count(place)) << body.name;
          for (std::size_t k = 0; k < values.size(); ++k) {
            difference = largest({difference, values[k] - found.at(place)[k]});
            scale = largest({scale, values[k]});
          }
        }
        EXPECT_LT(report(body.name, difference / scale, 0, "one region"), 1e-11);
      }
    }
  }
}

TEST(JoinedOutlines, cracks_cross_common_edges_as_in_one_region) {
  for (const char* rule : {"line", "bond"}) {
    for (const Body& body : {slanted, with_arc(0.2), around_disc, three_inside, beside_rows, above_rows}) {
      Pulled one(body, false, rule), divided(body, true, rule);
      one.model.run(100), divided.model.run(100);
      const auto wanted = one.model.history(), found = divided.model.history();
      const double most = body.compared * wanted.back().bond_energy;
      double difference = 0;
      for (std::size_t i = 0; i < wanted.size() && wanted[i].bond_energy < most; ++i) {
        ASSERT_LT(i, found.size()) << body.name;
        difference = largest({difference, wanted[i].load_factor - found[i].load_factor});
      }
      const double peak = std::max_element(wanted.begin(), wanted.end(), [](const auto& a, const auto& b) {
                            return a.load_factor < b.load_factor;
                          })->load_factor;
      EXPECT_LT(report(body.name, difference / peak, 0, "one region"), 1e-9) << rule;
    }
  }
}

// The weight of one of two regions is that of its area, though the common edge passes through cells.
TEST(JoinedOutlines, body_forces_act_on_the_area_of_a_region) {
  for (const Body& body : {slanted, with_arc(0.2), around_disc, beside_rows}) {
    for (std::size_t k = 0; k < 2; ++k) {
      Model model;
      const auto regions = add(model, model.add(material(1, 1.0 / 3)), body.parts, 3, body.points);
      model.check(bempd_add_body_force(model.get(), regions[k], BEMPD_Y, 1, 0, nullptr));
      const int32_t support = model.fix(regions[0], 1, BEMPD_BOTH);
      model.step(1);
      double area = 0;
      const auto add_loop = [&](const Outline& loop, const std::vector<double>& bulges) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const Vector a = loop[i], b = loop[(i + 1) % loop.size()];
          area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
          const double sweep = bulges.empty() ? 0 : 4 * std::atan(bulges[i]);
          if (sweep != 0) {
            const double radius = std::hypot(b[0] - a[0], b[1] - a[1]) / (2 * std::sin(sweep / 2));
            area += 0.5 * radius * radius * (sweep - std::sin(sweep));
          }
        }
      };
      add_loop(body.parts[k].outline, body.parts[k].bulges);
      if (body.parts[k].hole > 0) area -= 3.141592653589793 * body.parts[k].hole * body.parts[k].hole;
      EXPECT_LT(std::abs(report("weight", -model.reaction(support)[1], area, "area")), 1e-4 * area) << body.name;
    }
  }
}

// Only the outline of a body has points, so a support at a common edge keeps the interface, which shares points.
TEST(JoinedOutlines, supports_on_common_edges_have_points) {
  const std::vector<Part> quarters{{{{0, 0}, {8, 0}, {0, 8}}, {0, quarter, 0}, {2}},
                                   {{{0, 0}, {0, 8}, {-8, 0}}, {0, quarter, 0}, {2}},
                                   {{{0, 0}, {-8, 0}, {0, -8}}, {0, quarter, 0}, {2}},
                                   {{{0, 0}, {0, -8}, {8, 0}}, {0, quarter, 0}, {2}}};
  const auto has_centre = [&](const std::function<void(Model&)>& support) {
    Model model;
    const auto regions = add(model, model.add(material(1, 1.0 / 3)), quarters, 4);
    support(model);
    model.step(1);
    const auto x = model.vectors(regions[0], BEMPD_POSITION);
    int on_edge = 0;
    for (const Vector& p : x) on_edge += std::abs(p[1]) < 1e-9 && p[0] > -1e-9 && p[0] < 8 - 1e-9;
    return on_edge == 8;
  };
  EXPECT_TRUE(has_centre([](Model& model) {
    model.fix_point({0, 0}, BEMPD_BOTH);
    model.fix_point({8, 0}, BEMPD_Y);
  }));
  EXPECT_TRUE(has_centre([](Model& model) { model.fix(2, 1, BEMPD_BOTH); }));
  EXPECT_TRUE(has_centre([](Model& model) {
    model.fix_point({4, 0}, BEMPD_BOTH);
    model.fix_point({8, 0}, BEMPD_Y);
  }));
}

// A part on lattice rows keeps them where a support needs points on the common edge, and where one body would have no
// network of bonds: a leg of one spacing has none off its rows.
TEST(JoinedOutlines, parts_keep_their_rows_where_they_need_them) {
  const auto nodes_on_edge = [](const Outline& rows, bool supported) {
    Model model;
    const auto regions =
        add(model, model.add(material(1, 1.0 / 3)), {{rows}, beside_rows.parts[1]}, 3, beside_rows.points);
    model.fix(regions[1], 1, BEMPD_BOTH);
    if (supported) model.fix(regions[0], 2, BEMPD_X);
    model.traction(regions[1], 3, 0, 1, BEMPD_X, 0, 1e-3);
    model.step(1);
    int64_t nodes = 0, element = 0;
    model.check(bempd_edge_size(model.get(), regions[0], 2, &nodes, &element));
    return nodes;
  };
  EXPECT_LT(nodes_on_edge(rectangle(0, 0, 8, 14), false), 3);
  EXPECT_EQ(nodes_on_edge(rectangle(0, 0, 8, 14), true), 15);
  const Outline with_leg{{-8, 0}, {8, 0}, {8, 14}, {0, 14}, {0, 1}, {-8, 1}};
  EXPECT_EQ(nodes_on_edge(with_leg, false), 15);
}

// A warning names the regions that cannot be one body; another body of the scene leaves its rows all the same.
TEST(JoinedOutlines, rows_that_stay_are_told) {
  Model model;
  std::vector<std::string> lines;
  model.check(bempd_set_log(
      model.get(),
      [](int32_t level, const char* line, void* user) {
        if (level == 1) static_cast<std::vector<std::string>*>(user)->push_back(line);
      },
      &lines));
  std::vector<Part> parts{{{{-8, 0}, {8, 0}, {8, 14}, {0, 14}, {0, 1}, {-8, 1}}}, beside_rows.parts[1]};
  parts.push_back({rectangle(40, 0, 48, 14)});
  parts.push_back({{{48, 0}, {62, 0}, {66, 14}, {48, 14}}});
  const auto regions = add(model, model.add(material(1, 1.0 / 3)), parts, 3, "slanted");
  model.fix(regions[1], 1, BEMPD_BOTH);
  model.fix(regions[3], 1, BEMPD_BOTH);
  model.step(1);
  const auto tells = [](const std::string& line) {
    return line.find("no network of positive bonds was found for regions 1 and 2 together") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), tells), 1);
  int64_t nodes = 0, element = 0;
  model.check(bempd_edge_size(model.get(), regions[0], 2, &nodes, &element));
  EXPECT_EQ(nodes, 15);
  model.check(bempd_edge_size(model.get(), regions[2], 2, &nodes, &element));
  EXPECT_LT(nodes, 3);
}

// Regions of two materials, horizons or directions of the lattice share the points of the common edge.
TEST(JoinedOutlines, other_lattices_share_points) {
  for (const int other : {0, 1, 2}) {
    Model model;
    const int32_t first = model.add(material(1, 1.0 / 3)), second = model.add(material(2, 1.0 / 3));
    const auto left = add(model, first, {slanted.parts[0]}, 4);
    if (other == 2) model.lattice_angle = 0.1;
    const int32_t right = model.pd(other == 0 ? second : first, slanted.parts[1].outline, 1, other == 1 ? 3 : 4);
    model.fix_point({0, 0}, BEMPD_BOTH);
    model.fix_point({22, 0}, BEMPD_Y);
    model.traction(right, 2, 0, 1, BEMPD_X, 0, 1e-3);
    model.traction(left[0], 4, 0, 1, BEMPD_X, 0, -1e-3);
    model.step(1);
    int64_t nodes = 0, element = 0;
    model.check(bempd_edge_size(model.get(), left[0], 2, &nodes, &element));
    EXPECT_EQ(nodes, 16);
    EXPECT_NEAR(model.evaluate({2, 7}).stress[0], 1e-3, 2e-5);
    EXPECT_NEAR(model.evaluate({20, 7}).stress[0], 1e-3, 2e-5);
  }
}

// Fluid presses a crack open across the common edge.
TEST(JoinedOutlines, pressure_acts_on_bonds_across_common_edges) {
  for (const bool rows : {true, false}) {
    std::vector<double> widest;
    for (const bool divided : {false, true}) {
      Model model;
      std::vector<Part> parts = divided ? slanted.parts : one_part(slanted);
      if (rows) parts = {{rectangle(0, 0, divided ? 11 : 22, 14)}};
      if (rows && divided) parts.push_back({rectangle(11, 0, 22, 14)});
      const auto regions = add(model, model.add(material(1, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 1e-3)), parts, 4,
                               rows ? "slanted" : "always");
      model.fix_point({0, 0}, BEMPD_BOTH);
      model.fix_point({22, 0}, BEMPD_Y);
      model.crack({{4, 6.5}, {15, 6.5}});
      model.check(bempd_add_crack_pressure(model.get(), 1, 1e-4, 0, nullptr));
      model.step(0);
      widest.push_back(largest(model.displacements()));
    }
    EXPECT_LT(std::abs(report("largest displacement", widest[1], widest[0], "one region")), 1e-11 * widest[0]);
  }
}

TEST(JoinedOutlines, states_are_returned_to) {
  Pulled plate(slanted, true, "line");
  const ReturnedTo saved = return_from_run(plate.model, 100);
  EXPECT_EQ(plate.model.displacements(), saved.displacements);
}

}  // namespace
}  // namespace joined_outlines_test

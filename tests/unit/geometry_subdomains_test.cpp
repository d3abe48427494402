// Subdivision of bodies: the subdomains fill the body, keep its elements, and share the cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "geometry/outline.hpp"
#include "geometry/segment.hpp"
#include "geometry/subdomains.hpp"

namespace geometry_subdomains_test {
namespace {

using namespace bempd;

std::vector<Panel> loop_of(const std::vector<Point>& corners, double target) {
  std::vector<Panel> loop;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point &from = corners[k], &to = corners[(k + 1) % corners.size()];
    loop.push_back({from, to, element_stations((to - from).norm(), target)});
  }
  return loop;
}

// Clockwise circle of four panels.
std::vector<Panel> round_hole(const Point& centre, double radius, int elements_of_quarter) {
  constexpr double quarter = std::numbers::pi / 2;
  const auto at = [&](int k) -> Point {
    return centre + radius * Point(std::cos(k * quarter), -std::sin(k * quarter));
  };
  std::vector<Panel> loop;
  for (int k = 0; k < 4; ++k)
    loop.push_back({at(k), at(k + 1), element_stations(1, 1.0 / elements_of_quarter), -quarter});
  return loop;
}

// Square plate with a hole of random size and place in each unit cell.
BoundaryMesh random_sheet(int cells, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double side = cells;
  std::vector<std::vector<Panel>> loops{loop_of({{0, 0}, {side, 0}, {side, side}, {0, side}}, 0.2)};
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double radius = 0.1 + 0.35 * uniform(random), room = 0.9 * (1 - 2 * radius);
      const Point low(i + 0.5 * (1 - room), j + 0.5 * (1 - room));
      loops.push_back(round_hole(low + room * Point(uniform(random), uniform(random)), radius, 6));
    }
  return mesh_boundary(loops);
}

double area_of(const BoundaryMesh& mesh) {
  std::vector<Edge> edges;
  for (const BoundaryElement& e : mesh.elements)
    edges.emplace_back(Arc{mesh.nodes[e.nodes[0]], mesh.nodes[e.nodes[2]], e.sweep});
  return signed_area(edges);
}

// Checks what holds for every subdivision, and returns the number of elements on cuts.
int check(const BoundaryMesh& body, const Subdivision& cut) {
  std::vector<int> found(body.elements.size(), 0);
  std::map<int, int> uses_of_middle;  // of elements on cuts
  double area = 0;
  const auto place = [&](int node) {
    const int own = static_cast<int>(body.nodes.size());
    return node < own ? body.nodes[node] : cut.cut_nodes[node - own];
  };
  for (const Subdomain& part : cut.subdomains) {
    const double own = area_of(part.mesh);
    EXPECT_GT(own, 0);
    area += own;
    for (std::size_t i = 0; i < part.nodes.size(); ++i) EXPECT_EQ(part.mesh.nodes[i], place(part.nodes[i]));
    for (std::size_t e = 0; e < part.elements.size(); ++e) {
      const BoundaryElement& element = part.mesh.elements[e];
      if (part.elements[e] < 0) {
        ++uses_of_middle[part.nodes[element.nodes[1]]];
        continue;
      }
      const BoundaryElement& source = body.elements[part.elements[e]];
      ++found[part.elements[e]];
      for (int k = 0; k < 3; ++k) EXPECT_EQ(part.nodes[element.nodes[k]], source.nodes[k]);
      EXPECT_EQ(element.sweep, source.sweep);
    }
  }
  EXPECT_NEAR(area, area_of(body), 1e-12 * area);
  for (const int count : found) EXPECT_EQ(count, 1);
  for (const auto& [node, count] : uses_of_middle) EXPECT_EQ(count, 2) << "node " << node;
  return static_cast<int>(uses_of_middle.size());
}

TEST(Subdomains, fill_sheets_with_random_holes) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const BoundaryMesh body = random_sheet(6, seed);
    const Subdivision cut = subdivide(body, 80);
    const int on_cuts = check(body, cut);
    EXPECT_LE(cut.largest(), 80U) << "seed " << seed;
    EXPECT_GE(cut.subdomains.size(), body.elements.size() / 80);
    EXPECT_LE(on_cuts, 2 * static_cast<int>(body.elements.size()));
  }
}

TEST(Subdomains, of_one_outline_with_many_elements) {
  const std::vector<Point> l_shape{{0, 0}, {2, 0}, {2, 0.3}, {0.4, 0.5}, {0.3, 3}, {0, 3}};
  const BoundaryMesh body = mesh_boundary({loop_of(l_shape, 0.004)});
  const Subdivision cut = subdivide(body, 80);
  check(body, cut);
  EXPECT_LE(cut.largest(), 95U);  // no part of a cut may keep more than 0.85 of the elements
  const BoundaryMesh disc = mesh_boundary({[] {
    std::vector<Panel> loop = round_hole({3, 1}, 2, 200), turned;
    for (auto panel = loop.rbegin(); panel != loop.rend(); ++panel)
      turned.push_back({panel->end, panel->start, panel->stations, -panel->sweep});
    return turned;
  }()});
  check(disc, subdivide(disc, 80));
}

TEST(Subdomains, of_a_small_body_are_the_body_itself) {
  const BoundaryMesh body = random_sheet(1, 3);
  const Subdivision cut = subdivide(body, 80);
  ASSERT_EQ(cut.subdomains.size(), 1U);
  EXPECT_EQ(check(body, cut), 0);
  EXPECT_TRUE(cut.cut_nodes.empty());
}

TEST(Subdomains, of_bodies_that_differ_by_a_translation_do_so_too) {
  const BoundaryMesh body = random_sheet(5, 7);
  BoundaryMesh shifted = body;
  for (Point& node : shifted.nodes) node += Point(64, -32);
  const Subdivision one = subdivide(body, 80), other = subdivide(shifted, 80);
  ASSERT_EQ(one.subdomains.size(), other.subdomains.size());
  for (std::size_t i = 0; i < one.subdomains.size(); ++i)
    EXPECT_TRUE(differ_by_translation(one.subdomains[i].mesh, other.subdomains[i].mesh)) << i;
}

// Cracks, with short elements at both ends, that begin at round holes.
std::vector<Stations> cracks_at_holes(int cells, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Stations> cracks;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double angle = 2 * std::numbers::pi * uniform(random), length = 0.1 + 0.15 * uniform(random);
      if (uniform(random) > 0.2) continue;
      cracks.emplace_back();
      for (const double share : {0.0, 0.1, 0.3, 0.6, 0.85, 0.95, 1.0})
        cracks.back().push_back(Point(i + 0.5, j + 0.5) +
                                (0.2 + share * length) * Point(std::cos(angle), std::sin(angle)));
    }
  return cracks;
}

BoundaryMesh regular_sheet(int cells) {
  const double side = cells;
  std::vector<std::vector<Panel>> loops{loop_of({{0, 0}, {side, 0}, {side, side}, {0, side}}, 1.0 / 6)};
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) loops.push_back(round_hole({i + 0.5, j + 0.5}, 0.2, 4));
  return mesh_boundary(loops);
}

bool crosses(const Stations& cut, const Stations& crack) {
  for (std::size_t c = 0; c + 1 < cut.size(); ++c)
    for (std::size_t k = 0; k + 1 < crack.size(); ++k)
      if (closest_approach({cut[c], cut[c + 1]}, {crack[k], crack[k + 1]}).distance < 1e-3) return true;
  return false;
}

void expect_same(const Subdivision& a, const Subdivision& b) {
  EXPECT_EQ(a.cut_nodes, b.cut_nodes);
  EXPECT_EQ(a.cuts, b.cuts);
  ASSERT_EQ(a.subdomains.size(), b.subdomains.size());
  for (std::size_t i = 0; i < a.subdomains.size(); ++i) {
    const Subdomain &one = a.subdomains[i], &other = b.subdomains[i];
    EXPECT_EQ(one.nodes, other.nodes);
    EXPECT_EQ(one.elements, other.elements);
    EXPECT_EQ(one.cracks, other.cracks);
    EXPECT_EQ(one.mesh.nodes, other.mesh.nodes);
  }
}

TEST(Subdomains, lie_around_cracks_and_change_beside_them_only) {
  int kept = 0, all = 0, shared = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const int cells = 4 + static_cast<int>(seed % 3);
    const BoundaryMesh body = regular_sheet(cells);
    const std::size_t most = 60 + 20 * (seed % 4);
    const Subdivision without = subdivide(body, most);
    std::vector<Stations> cracks = cracks_at_holes(cells, seed);
    const Subdivision cut = subdivide(body, most, without.cuts, cracks);
    check(body, cut);
    std::vector<int> found(cracks.size(), 0);
    for (const Subdomain& part : cut.subdomains) {
      for (const int crack : part.cracks) ++found[static_cast<std::size_t>(crack)];
      // No subdomain has both faces of a cut.
      std::vector<int> nodes = part.nodes;
      std::sort(nodes.begin(), nodes.end());
      EXPECT_EQ(std::adjacent_find(nodes.begin(), nodes.end()), nodes.end()) << "seed " << seed;
    }
    for (const int count : found) EXPECT_EQ(count, 1) << "seed " << seed;
    for (const Stations& one : cut.cuts)
      for (const Stations& crack : cracks) EXPECT_FALSE(crosses(one, crack)) << "seed " << seed;
    // A crack that grows leaves the subdomains elsewhere as they are.
    if (cracks.empty()) continue;
    Stations& grown = cracks.front();
    grown.push_back(grown.back() + 0.2 * (grown.back() - grown.front()));
    const Subdivision next = subdivide(body, most, without.cuts, cracks);
    expect_same(subdivide(body, most, without.cuts, cracks, &cut), next);
    shared += subdivide(body, most, without.cuts, cracks, &cut).joined == cut.joined ? 1 : 0;
    for (const Subdomain& part : next.subdomains) {
      ++all;
      kept += std::any_of(cut.subdomains.begin(), cut.subdomains.end(),
                          [&](const Subdomain& one) { return one.mesh.nodes == part.mesh.nodes; });
    }
  }
  EXPECT_GT(kept, 0.9 * all);
  EXPECT_GT(shared, 10);
}

TEST(Subdomains, of_another_mesh_or_with_other_cuts_are_made_anew) {
  const int cells = 5;
  const BoundaryMesh body = regular_sheet(cells);
  const std::vector<Stations> cracks = cracks_at_holes(cells, 3);
  const std::vector<Stations> cuts = subdivide(body, 80).cuts;
  const Subdivision cut = subdivide(body, 80, cuts, cracks);
  BoundaryMesh moved = body;
  for (Point& node : moved.nodes) node.x() *= 1.001;
  const std::vector<Stations> fewer(cuts.begin(), cuts.end() - 1);
  const std::vector<Stations> other_cracks{{{2.5, 1.9}, {2.5, 2.0}, {2.5, 2.1}}};
  expect_same(subdivide(moved, 80, cuts, cracks, &cut), subdivide(moved, 80, cuts, cracks));
  expect_same(subdivide(body, 80, fewer, cracks, &cut), subdivide(body, 80, fewer, cracks));
  expect_same(subdivide(body, 80, cuts, other_cracks, &cut), subdivide(body, 80, cuts, other_cracks));
}

TEST(Subdomains, are_none_where_a_cut_leaves_the_body) {
  const std::vector<Point> places{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}, {2, 2}};
  const SubdomainLoop square{{{0, 4, 1}}, {{1, 5, 2}}, {{2, 6, 3}}, {{3, 7, 0}}};
  const SubdomainLoop inside{{{0, 6, 2}}}, outside{{{2, 6, 8}}, {{8, 6, 3}}};
  EXPECT_EQ(split({square}, {inside}, places).size(), 2U);
  EXPECT_TRUE(split({square}, {outside}, places).empty());
}

}  // namespace
}  // namespace geometry_subdomains_test

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>

#include "geometry/body_mesh.hpp"
#include "geometry/delaunay.hpp"
#include "geometry/outline.hpp"

namespace {

using namespace bempd;

double area_of(const BodyMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += 0.5 * cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
  return sum;
}

// Smallest angle of all triangles [degrees].
double smallest_angle(const BodyMesh& mesh) {
  double smallest = 180;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Point a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]],
                  b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      smallest = std::min(smallest, std::atan2(cross(a, b), a.dot(b)) * 180 / std::numbers::pi);
    }
  return smallest;
}

// Sides of triangles and how many of these each belongs to.
std::map<std::pair<int, int>, int> sides_of(const BodyMesh& mesh) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  return sides;
}

const Outline square_with_hole{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}, {}};

TEST(Delaunay, circles_through_triangles_hold_no_other_point) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Delaunay delaunay(Box(Point(-1, -1), Point(1, 1)));
  std::vector<Point> points;
  // A square grid, whose points lie on common circles, and others between them.
  for (int i = 0; i < 100; ++i) points.emplace_back(-0.9 + 0.2 * (i % 10), -0.9 + 0.2 * static_cast<int>(i / 10));
  for (int i = 0; i < 200; ++i) points.emplace_back(coordinate(random), coordinate(random));
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(delaunay.insert(points[i]), static_cast<int>(i));
  EXPECT_EQ(delaunay.insert(points[5]), 5);
  int triangles = 0;
  for (const Delaunay::Triangle& t : delaunay.triangles()) {
    if (!t.exists || t.points[0] < 0 || t.points[1] < 0 || t.points[2] < 0) continue;
    ++triangles;
    const Point a = points[t.points[0]], b = points[t.points[1]] - a, c = points[t.points[2]] - a;
    const Point centre = a + Point(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                                   b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
                                 (2 * cross(b, c));
    const double radius = (centre - a).norm();
    EXPECT_GT(cross(b, c), 0);
    for (const Point& p : points) EXPECT_GT((p - centre).norm(), radius - 1e-5 * (1 + radius * radius));
  }
  EXPECT_GT(triangles, 500);  // 2 n less the points on the hull
}

TEST(BodyMesh, fills_the_body_and_leaves_its_hole) {
  for (const double size : {0.7, 0.2}) {
    const BodyMesh mesh = mesh_body(edges_of(square_with_hole), {}, size);
    EXPECT_NEAR(area_of(mesh), 15, 1e-9);
    EXPECT_GT(smallest_angle(mesh), 15);
    for (const auto& [side, count] : sides_of(mesh)) {
      EXPECT_LE(count, 2);
      EXPECT_LT((mesh.points[side.first] - mesh.points[side.second]).norm(), 1.5 * size);
    }
    EXPECT_LT(mesh.triangles.size(), 8 * 15 / (size * size) + 200);
  }
}

TEST(BodyMesh, follows_arcs) {
  Outline ring{{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0.9, 0}, {0, -0.9}, {-0.9, 0}, {0, 0.9}}}, {}};
  const double quarter = std::numbers::pi / 2;
  for (int k = 0; k < 4; ++k) {
    ring.curved.emplace(k, Edge(Arc{ring.loops[0][k], ring.loops[0][(k + 1) % 4], quarter}));
    ring.curved.emplace(4 + k, Edge(Arc{ring.loops[1][k], ring.loops[1][(k + 1) % 4], -quarter}));
  }
  const BodyMesh mesh = mesh_body(edges_of(ring), {}, 0.5);
  EXPECT_NEAR(area_of(mesh), std::numbers::pi * (1 - 0.81), 0.02);
  EXPECT_GT(smallest_angle(mesh), 15);
  for (const Point& p : mesh.points) {
    EXPECT_LT(p.norm(), 1 + 1e-12);
    EXPECT_GT(p.norm(), 0.9 - 1e-12);
  }
}

TEST(BodyMesh, has_cracks_as_sides) {
  const std::vector<Edge> edges = edges_of(square_with_hole);
  // One crack comes from the edge and ends inside, another one meets it.
  const CrackLines cracks =
      crack_lines({{1, {{3, 0}, {3.1, 1.5}, {2.6, 3}}}, {2, {{3.05, 0.75}, {3.8, 0.9}}}}, edges, 1e-9);
  const BodyMesh mesh = mesh_body(edges, cracks, 0.3);
  EXPECT_NEAR(area_of(mesh), 15, 1e-9);
  const auto sides = sides_of(mesh);
  double length = 0;
  for (const auto& side : mesh.crack_sides) {
    const auto found = sides.find(std::minmax(side[0], side[1]));
    ASSERT_NE(found, sides.end());
    EXPECT_EQ(found->second, 2);
    length += (mesh.points[side[0]] - mesh.points[side[1]]).norm();
  }
  EXPECT_NEAR(length, std::hypot(0.1, 1.5) + std::hypot(0.5, 1.5) + std::hypot(0.75, 0.15), 1e-9);
}

TEST(BodyMesh, comes_to_an_end_at_sharp_corners) {
  const Outline wedge{{{{0, 0}, {4, 0}, {4, 0.1}}}, {}};
  const BodyMesh mesh = mesh_body(edges_of(wedge), {}, 0.05);
  EXPECT_NEAR(area_of(mesh), 0.2, 1e-6);
  EXPECT_LT(mesh.triangles.size(), 10000u);
}

}  // namespace

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/arrangement.hpp"
#include "geometry/outline_check.hpp"
#include "geometry/smooth_curve.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;
constexpr double pi = std::numbers::pi;

Point on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Circle of quarters; clockwise for holes.
Outline circle(const Point& centre, double radius, int first_edge = 0, double direction = 1) {
  Outline result;
  result.loops.emplace_back();
  for (int k = 0; k < 4; ++k) result.loops[0].push_back(centre + radius * on_circle(direction * 0.5 * pi * k));
  for (int k = 0; k < 4; ++k)
    result.curved.emplace(first_edge + k,
                          Edge(Arc{result.loops[0][k], result.loops[0][(k + 1) % 4], direction * 0.5 * pi}));
  return result;
}

Outline with_circular_hole(Outline body, const Point& centre, double radius) {
  const int first_edge = static_cast<int>(body.loops[0].size());
  Outline hole = circle(centre, radius, first_edge, -1);
  body.loops.push_back(hole.loops[0]);
  body.curved.insert(hole.curved.begin(), hole.curved.end());
  return body;
}

TEST(Arc, runs_on_its_circle_with_turning_tangent) {
  for (const double sweep : {1e-9, 0.3, -2.0, 4.5, -6.0}) {
    const Arc arc{{1, 2}, {1.5, 1.7}, sweep};
    EXPECT_EQ(arc.at(0), arc.start);
    EXPECT_EQ(arc.at(1), arc.end);
    for (const double f : {0.1, 0.5, 0.8}) {
      constexpr double d = 1e-6;
      const Point slope = (arc.at(f + d) - arc.at(f - d)) / (2 * d);
      EXPECT_NEAR(slope.norm(), arc.length(), 1e-9 * arc.length());
      EXPECT_NEAR((slope / arc.length() - arc.tangent(f)).norm(), 0, 1e-8);
      EXPECT_NEAR(closest_fraction(arc, arc.at(f)), f, 1e-12);
      const Point normal(-arc.tangent(f).y(), arc.tangent(f).x());
      EXPECT_NEAR(closest_fraction(arc, arc.at(f) + 1e-2 * normal), f, 1e-11) << sweep;
    }
  }
}

TEST(Arc, through_a_place_is_found_up_to_nearly_a_full_turn) {
  for (const double sweep : {0.01, 1.0, pi, 5.0, 6.2}) {
    for (const double sign : {1.0, -1.0}) {
      const Arc arc{on_circle(0), on_circle(sign * sweep), sign * sweep};
      for (const double f : {0.2, 0.5, 0.9}) {
        const auto found = arc_through(arc.start, on_circle(f * sign * sweep), arc.end);
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->sweep, sign * sweep, 1e-12);
      }
    }
  }
  EXPECT_TRUE(arc_through({0, 0}, {1, 0}, {2, 0})->straight());
  EXPECT_FALSE(arc_through({0, 0}, {3, 0}, {2, 0}).has_value());
  EXPECT_FALSE(arc_through({0, 0}, {0, 0}, {2, 0}).has_value());
}

TEST(Arc, circular_segment_is_found_for_flat_and_for_large_arcs) {
  const Arc half{{0, 0}, {2, 0}, pi};  // below its chord
  EXPECT_TRUE(in_circular_segment(half, {1, -0.9}));
  EXPECT_FALSE(in_circular_segment(half, {1, -1.1}));
  EXPECT_FALSE(in_circular_segment(half, {1, 0.1}));
  const Arc large{{0, 0}, {2, 0}, 1.8 * pi};
  EXPECT_TRUE(in_circular_segment(large, {-1, -1}));
  EXPECT_FALSE(in_circular_segment(large, {1, 0.01}));
  const Arc flat{{0, 0}, {2, 0}, 4e-6};
  EXPECT_TRUE(in_circular_segment(flat, {1, -0.99e-6}));
  EXPECT_FALSE(in_circular_segment(flat, {1, -1.01e-6}));
}

TEST(Outline, of_arcs_has_the_area_and_the_inside_of_a_ring) {
  const Outline ring = with_circular_hole(circle({3, -1}, 2), {3.1, -1}, 1);
  EXPECT_TRUE(check_outline(ring).sound());
  EXPECT_NEAR(area(ring), 3 * pi, 1e-13);
  const Box box = bounding_box(ring);
  EXPECT_NEAR((box.min() - Point(1, -3)).norm(), 0, 1e-14);
  EXPECT_NEAR((box.max() - Point(5, 1)).norm(), 0, 1e-14);
  const double tolerance = geometric_tolerance(box);
  for (double angle = 0.01; angle < 6.3; angle += 0.1) {
    const auto at = [&](double radius) { return locate(ring, Point(3.1, -1) + radius * on_circle(angle), tolerance); };
    EXPECT_EQ(at(0.999), Location::outside);
    EXPECT_EQ(at(1), Location::on_boundary);
    EXPECT_EQ(at(1.001), Location::inside);
    EXPECT_EQ(at(1.899), Location::inside);
    EXPECT_EQ(at(2.101), Location::outside);
  }
}

TEST(OutlineCheck, finds_arcs_that_cross_touch_or_turn_back) {
  const auto defect = [](const Outline& outline) { return check_outline(outline).defect; };
  EXPECT_EQ(defect(with_circular_hole(box(0, 0, 2, 2), {1, 1}, 0.99)), OutlineDefect::none);
  EXPECT_EQ(defect(with_circular_hole(box(0, 0, 2, 2), {1, 1}, 1)), OutlineDefect::hole_outside);
  EXPECT_EQ(defect(with_circular_hole(box(0, 0, 2, 2), {1, 1}, 1.2)), OutlineDefect::hole_outside);
  EXPECT_EQ(defect(with_circular_hole(with_circular_hole(box(0, 0, 6, 2), {1.5, 1}, 0.5), {4, 1}, 0.5)),
            OutlineDefect::none);
  Outline two = with_circular_hole(box(0, 0, 6, 2), {1.5, 1}, 0.5);
  Outline touching = circle({2.4, 1}, 0.45, 8, -1);
  two.loops.push_back(touching.loops[0]);
  two.curved.insert(touching.curved.begin(), touching.curved.end());
  EXPECT_EQ(defect(two), OutlineDefect::holes_overlap);

  // An edge that bulges into the opposite one, and arcs that end in a cusp or meet again next to their vertex.
  const auto arced = [](double sweep) {
    Outline body = box(0, 0, 2, 1);
    body.curved.emplace(0, Edge(Arc{{0, 0}, {2, 0}, sweep}));
    return body;
  };
  EXPECT_EQ(defect(arced(pi)), OutlineDefect::none);
  EXPECT_EQ(defect(arced(-0.8 * pi)), OutlineDefect::none);
  EXPECT_EQ(defect(arced(-1.01 * pi)), OutlineDefect::self_crossing);
  EXPECT_EQ(defect(arced(1.5 * pi)), OutlineDefect::none);
  Outline cusp = box(0, 0, 2, 1);
  cusp.curved.emplace(0, Edge(Arc{{0, 0}, {2, 0}, -pi}));
  cusp.curved.emplace(1, Edge(Arc{{2, 0}, {2, 1}, -0.001}));
  EXPECT_EQ(defect(cusp), OutlineDefect::self_crossing);
}

TEST(Arrangement, disk_in_a_plate_shares_its_whole_circle) {
  const std::vector<Outline> regions{with_circular_hole(box(0, 0, 4, 3), {1.7, 1.4}, 0.8), circle({1.7, 1.4}, 0.8)};
  const Arrangement found = arrange(regions);
  EXPECT_FALSE(found.overlap.has_value());
  EXPECT_TRUE(found.hinges.empty());
  ASSERT_EQ(found.contacts.size(), 8u);
  for (const Contact& c : found.contacts) {
    EXPECT_EQ(c.from, 0);
    EXPECT_EQ(c.to, 1);
  }
}

TEST(Arrangement, half_disks_share_parts_of_arcs_and_overlaps_are_found) {
  // The lower half of a disk, cut at an odd angle, in the hole of a plate.
  Outline half;
  half.loops = {{on_circle(-2.9), on_circle(-0.4)}};
  half.loops[0].insert(half.loops[0].begin() + 1, on_circle(-1.3));
  half.curved.emplace(0, Edge(Arc{half.loops[0][0], half.loops[0][1], 1.6}));
  half.curved.emplace(1, Edge(Arc{half.loops[0][1], half.loops[0][2], 0.9}));
  ASSERT_TRUE(check_outline(half).sound());
  const Arrangement found = arrange({with_circular_hole(box(-2, -2, 2, 2), {0, 0}, 1), half});
  EXPECT_FALSE(found.overlap.has_value());
  EXPECT_TRUE(found.hinges.empty());
  double shared = 0;
  for (const Contact& c : found.contacts)
    if (c.region == 1) shared += (c.to - c.from) * edges_of(half)[c.edge].length();
  EXPECT_NEAR(shared, 2.5, 1e-9);
  EXPECT_TRUE(arrange({with_circular_hole(box(-2, -2, 2, 2), {0, 0}, 0.9), half}).overlap.has_value());
  EXPECT_TRUE(arrange({circle({0, 0}, 1), circle({1.5, 0}, 1)}).overlap.has_value());
  EXPECT_FALSE(arrange({circle({0, 0}, 1), circle({2.5, 0}, 1)}).overlap.has_value());
}

TEST(SmoothCurve, meets_points_with_continuous_tangents_and_gives_circles_back) {
  std::vector<Point> on_one;
  for (const double angle : {0.0, 0.7, 1.1, 2.5, 4.0, 5.0}) on_one.push_back(Point(2, 3) + 5 * on_circle(angle));
  for (const bool closed : {true, false})
    for (const Edge& edge : smooth_curve(on_one, closed)) {
      EXPECT_EQ(edge.piece_count(), 1);
      EXPECT_NEAR((edge.piece(0).centre() - Point(2, 3)).norm(), 0, 1e-13);
    }
  double last = 0;
  for (const int count : {8, 16, 32, 64}) {
    std::vector<Point> ellipse;
    for (int i = 0; i < count; ++i) ellipse.push_back({3 * std::cos(2 * pi * i / count), std::sin(2 * pi * i / count)});
    const std::vector<Edge> edges = smooth_curve(ellipse, true);
    double error = 0;
    for (int i = 0; i < count; ++i) {
      const Edge &edge = edges[i], &next = edges[(i + 1) % count];
      EXPECT_NEAR((edge.tangent(1) - next.tangent(0)).norm(), 0, 1e-12);
      EXPECT_NEAR((edge.piece(0).tangent(1) - edge.piece(edge.piece_count() - 1).tangent(0)).norm(), 0,
                  edge.piece_count() == 1 ? 10 : 1e-12);
      EXPECT_EQ(edge.at(1), next.at(0));
      for (double f = 0.05; f < 1; f += 0.1) {
        const Point p = edge.at(f);
        error = std::max(error, std::abs(std::hypot(p.x() / 3, p.y()) - 1));
        EXPECT_NEAR(closest_fraction(edge, p), f, 1e-9);
      }
    }
    std::printf("ellipse through %d points: off by %.2e\n", count, error);
    if (last > 0) {
      EXPECT_GE(std::log2(last / error), 2.5);
    }
    last = error;
  }
}

}  // namespace

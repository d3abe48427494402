#include <gtest/gtest.h>

#include <limits>

#include "geometry/outline_check.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

TEST(Segment, closest_place_is_clamped_to_the_ends) {
  const Segment s{{0, 0}, {2, 0}};
  EXPECT_DOUBLE_EQ(closest_fraction(s, {0.5, 3}), 0.25);
  EXPECT_EQ(closest_fraction(s, {-1, 1}), 0);
  EXPECT_EQ(closest_fraction(s, {5, 1}), 1);
  EXPECT_DOUBLE_EQ(distance(s, {5, 4}), 5);
  EXPECT_DOUBLE_EQ(distance(s, {1, -2}), 2);
}

TEST(Segment, without_length_is_a_point) { EXPECT_DOUBLE_EQ(distance(Segment{{1, 1}, {1, 1}}, {4, 5}), 5); }

TEST(Segment, ends_are_met_exactly) {
  const Segment s{{0.1, 1e9}, {0.7, 1.0 / 3}};
  EXPECT_EQ(s.at(0), s.start);
  EXPECT_EQ(s.at(1), s.end);
}

TEST(Segment, proper_crossing_gives_both_fractions) {
  const auto crossing = proper_crossing({{0, 0}, {4, 0}}, {{1, -1}, {1, 3}});
  ASSERT_TRUE(crossing);
  EXPECT_DOUBLE_EQ(crossing->fraction_a, 0.25);
  EXPECT_DOUBLE_EQ(crossing->fraction_b, 0.25);
}

TEST(Segment, touching_parallel_and_distant_pairs_do_not_cross_properly) {
  const Segment s{{0, 0}, {4, 0}};
  EXPECT_FALSE(proper_crossing(s, {{1, 0}, {1, 3}}));
  EXPECT_FALSE(proper_crossing(s, {{1, 0}, {3, 0}}));
  EXPECT_FALSE(proper_crossing(s, {{1, 1}, {3, 1}}));
  EXPECT_FALSE(proper_crossing(s, {{5, -1}, {5, 1}}));
}

TEST(Segment, closest_approach_of_two_segments) {
  EXPECT_EQ(closest_approach({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}).distance, 0);
  const Approach apart = closest_approach({{0, 0}, {2, 0}}, {{1, 3}, {1, 1}});
  EXPECT_DOUBLE_EQ(apart.distance, 1);
  EXPECT_DOUBLE_EQ(apart.where.x(), 1);
  EXPECT_DOUBLE_EQ(apart.where.y(), 0.5);
}

TEST(Outline, area_is_exact_far_from_the_origin) {
  const Outline ring{{box_loop(1e9, 1e9, 1e9 + 4, 1e9 + 2), reversed(box_loop(1e9 + 1, 1e9 + 0.5, 1e9 + 2, 1e9 + 1))}};
  const std::vector<Edge> edges = edges_of(ring);
  EXPECT_DOUBLE_EQ(signed_area({edges.begin(), edges.begin() + 4}), 8);
  EXPECT_DOUBLE_EQ(signed_area({edges.begin() + 4, edges.end()}), -0.5);
  EXPECT_DOUBLE_EQ(area(ring), 7.5);
}

TEST(Outline, tolerance_never_drops_below_the_rounding_of_coordinates) {
  EXPECT_DOUBLE_EQ(geometric_tolerance(bounding_box(box(0, 0, 3, 4))), 5e-9);
  EXPECT_GE(geometric_tolerance(bounding_box(box(1e9, 0, 1e9 + 3, 4))), 2 * std::ldexp(1.0, -52) * 1e9);
}

TEST(Outline, points_are_located_in_a_ring_at_any_size_and_place) {
  const Outline ring{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1, 3, 3))}};
  for (const Placement& place : placements()) {
    const Outline body = place(ring);
    const double tolerance = geometric_tolerance(bounding_box(body));
    const auto where = [&](double x, double y) { return locate(body, place(Point(x, y)), tolerance); };
    EXPECT_EQ(where(0.5, 2), Location::inside);
    EXPECT_EQ(where(0.5, 1), Location::inside) << "level with vertices of the hole";
    EXPECT_EQ(where(2, 2), Location::outside);
    EXPECT_EQ(where(-1, 0), Location::outside) << "level with an edge";
    EXPECT_EQ(where(5, 4), Location::outside);
    EXPECT_EQ(where(4, 2), Location::on_boundary);
    EXPECT_EQ(where(1, 1), Location::on_boundary);
    EXPECT_EQ(where(2, 3), Location::on_boundary);
  }
}

TEST(OutlineCheck, sound_outlines_pass_at_any_size_and_place) {
  const Outline ring{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1, 2, 3)), reversed(box_loop(2.1, 1, 3, 3))}};
  const Outline slender{{box_loop(0, 0, 1e4, 1)}};
  const Outline collinear{{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}}};
  for (const Placement& place : placements()) {
    if (place.shift.norm() > 1e7 * place.scale) continue;  // the coordinates themselves no longer resolve the body
    for (const Outline& shape : {ring, slender, collinear}) EXPECT_TRUE(check_outline(place(shape)).sound());
  }
}

TEST(OutlineCheck, bow_tie_names_the_crossing_edges_and_the_place) {
  for (const Placement& place : placements()) {
    const OutlineCheck check = check_outline(place(Outline{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}));
    EXPECT_EQ(check.defect, OutlineDefect::self_crossing);
    EXPECT_EQ(check.edge_a, 0);
    EXPECT_EQ(check.edge_b, 2);
    EXPECT_LT((check.where - place(Point(1, 1))).norm(), 1e-6 * place.scale);
  }
}

TEST(OutlineCheck, loop_that_touches_itself_is_refused) {
  const Outline vertex_on_edge{{{{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}}}};
  EXPECT_EQ(check_outline(vertex_on_edge).defect, OutlineDefect::self_crossing);
  const Outline vertex_on_vertex{{{{0, 0}, {2, 1}, {4, 0}, {4, 3}, {2, 1}, {0, 3}}}};
  EXPECT_EQ(check_outline(vertex_on_vertex).defect, OutlineDefect::self_crossing);
}

TEST(OutlineCheck, clockwise_loop_and_counter_clockwise_hole_have_the_wrong_orientation) {
  for (const Placement& place : placements()) {
    EXPECT_EQ(check_outline(place(Outline{{reversed(box_loop(0, 0, 1, 1))}})).defect, OutlineDefect::wrong_orientation);
    const OutlineCheck hole = check_outline(place(Outline{{box_loop(0, 0, 3, 3), box_loop(1, 1, 2, 2)}}));
    EXPECT_EQ(hole.defect, OutlineDefect::wrong_orientation);
    EXPECT_EQ(hole.loop, 1);
  }
}

TEST(OutlineCheck, spikes_and_loops_without_area_are_refused) {
  const OutlineCheck spike = check_outline({{{{0, 0}, {2, 0}, {2, 1}, {2, 3}, {2, 1}, {0, 1}}}});
  EXPECT_EQ(spike.defect, OutlineDefect::spike);
  EXPECT_EQ(spike.edge_a, 2);
  EXPECT_EQ(spike.edge_b, 3);
  EXPECT_EQ(check_outline({{{{0, 0}, {1, 1}, {2, 2}}}}).defect, OutlineDefect::spike);
  EXPECT_EQ(check_outline({{{{0, 0}, {3, 0}, {1, 0}, {-1, 0}}}}).defect, OutlineDefect::spike);
}

TEST(OutlineCheck, degenerate_loops_are_refused) {
  EXPECT_EQ(check_outline({}).defect, OutlineDefect::too_few_vertices);
  EXPECT_EQ(check_outline({{{{0, 0}, {1, 0}}}}).defect, OutlineDefect::too_few_vertices);
  const OutlineCheck empty_hole = check_outline({{box_loop(0, 0, 1, 1), {}}});
  EXPECT_EQ(empty_hole.defect, OutlineDefect::too_few_vertices);
  EXPECT_EQ(empty_hole.loop, 1);
  const OutlineCheck repeated = check_outline({{{{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}}}});
  EXPECT_EQ(repeated.defect, OutlineDefect::repeated_vertex);
  EXPECT_EQ(repeated.edge_a, 2);
  const OutlineCheck closed_twice = check_outline({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}}});
  EXPECT_EQ(closed_twice.defect, OutlineDefect::repeated_vertex);
  EXPECT_EQ(closed_twice.edge_a, 4);
  EXPECT_EQ(check_outline({{{{2, 2}, {2, 2}, {2, 2}}}}).defect, OutlineDefect::repeated_vertex);
}

TEST(OutlineCheck, numbers_that_cannot_be_computed_with_are_refused) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300}) {
    const OutlineCheck check = check_outline({{box_loop(0, 0, 9, 9), {{1, 1}, {1, 2}, {2, bad}, {2, 1}}}});
    EXPECT_EQ(check.defect, OutlineDefect::not_finite);
    EXPECT_EQ(check.loop, 1);
    EXPECT_EQ(check.edge_a, 6);
  }
}

TEST(OutlineCheck, holes_must_lie_strictly_inside) {
  const auto check_with_hole = [](double x0, double y0, double x1, double y1) {
    return check_outline({{box_loop(0, 0, 4, 4), reversed(box_loop(x0, y0, x1, y1))}});
  };
  EXPECT_EQ(check_with_hole(3, 1, 5, 2).defect, OutlineDefect::hole_outside);
  EXPECT_EQ(check_with_hole(5, 1, 6, 2).defect, OutlineDefect::hole_outside);
  EXPECT_EQ(check_with_hole(5, 1, 6, 2).edge_a, -1);
  EXPECT_EQ(check_with_hole(-1, -1, 5, 5).defect, OutlineDefect::hole_outside);
  const OutlineCheck touching = check_with_hole(3, 1, 4, 2);
  EXPECT_EQ(touching.defect, OutlineDefect::hole_outside);
  EXPECT_EQ(touching.edge_a, 1);
  EXPECT_EQ(check_outline({{box_loop(0, 0, 4, 4), {{0, 2}, {2, 3}, {2, 1}}}}).defect, OutlineDefect::hole_outside);
  EXPECT_EQ(check_outline({{box_loop(0, 0, 4, 4), reversed(box_loop(0, 0, 4, 4))}}).defect,
            OutlineDefect::hole_outside);
}

TEST(OutlineCheck, holes_must_keep_apart) {
  const auto check_with_holes = [](const std::vector<Point>& a, const std::vector<Point>& b) {
    return check_outline({{box_loop(0, 0, 9, 9), reversed(a), reversed(b)}});
  };
  const auto hole = box_loop(2, 2, 5, 5);
  EXPECT_EQ(check_with_holes(hole, box_loop(4, 4, 6, 6)).defect, OutlineDefect::holes_overlap);
  EXPECT_EQ(check_with_holes(hole, box_loop(5, 2, 6, 5)).defect, OutlineDefect::holes_overlap);
  EXPECT_EQ(check_with_holes(hole, box_loop(5, 5, 6, 6)).defect, OutlineDefect::holes_overlap);
  EXPECT_EQ(check_with_holes(hole, box_loop(3, 3, 4, 4)).defect, OutlineDefect::holes_overlap);
  EXPECT_EQ(check_with_holes(box_loop(3, 3, 4, 4), hole).defect, OutlineDefect::holes_overlap);
  EXPECT_TRUE(check_with_holes(hole, box_loop(6, 2, 7, 5)).sound());
}

}  // namespace

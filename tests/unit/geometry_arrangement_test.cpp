#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/arrangement.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

double contact_length(const Arrangement& arrangement, const std::vector<Outline>& regions, int region) {
  double sum = 0;
  for (const Contact& c : arrangement.contacts)
    if (c.region == region) sum += (c.to - c.from) * edges_of(regions[region])[c.edge].length();
  return sum;
}

std::size_t breakpoint_count(const Arrangement& arrangement) {
  std::size_t count = 0;
  for (const auto& region : arrangement.breakpoints)
    for (const auto& edge : region) count += edge.size();
  return count;
}

// What must hold for every arrangement: contacts in pairs, places that agree, fractions that are breakpoints or ends.
void expect_consistent(const Arrangement& arrangement, const std::vector<Outline>& regions) {
  Box all;
  for (const Outline& outline : regions) all.extend(bounding_box(outline));
  const double tolerance = 4 * geometric_tolerance(all);
  const auto is_known = [&](int region, int edge, double f) {
    const auto& known = arrangement.breakpoints[region][edge];
    return f == 0 || f == 1 || std::find(known.begin(), known.end(), f) != known.end();
  };
  for (const Contact& c : arrangement.contacts) {
    EXPECT_LT(c.from, c.to);
    EXPECT_GT(c.other_from, c.other_to);
    const Edge own = edges_of(regions[c.region])[c.edge], other = edges_of(regions[c.other_region])[c.other_edge];
    EXPECT_LT((own.at(c.from) - other.at(c.other_from)).norm(), tolerance);
    EXPECT_LT((own.at(c.to) - other.at(c.other_to)).norm(), tolerance);
    EXPECT_TRUE(is_known(c.region, c.edge, c.from) && is_known(c.region, c.edge, c.to));
    const auto mirrored =
        std::count_if(arrangement.contacts.begin(), arrangement.contacts.end(), [&](const Contact& m) {
          return m.region == c.other_region && m.edge == c.other_edge && m.other_region == c.region &&
                 m.other_edge == c.edge && m.from == c.other_to && m.to == c.other_from && m.other_from == c.to &&
                 m.other_to == c.from;
        });
    EXPECT_EQ(mirrored, 1);
  }
}

// Runs `check(arrangement, regions, place)` on the regions at every size and place.
template <typename Check>
void everywhere(const std::vector<Outline>& shapes, const Check& check) {
  for (const Placement& place : placements()) {
    SCOPED_TRACE(::testing::Message() << "scale " << place.scale << " angle " << place.angle << " shift "
                                      << place.shift.transpose());
    const std::vector<Outline> regions = place(shapes);
    const Arrangement arrangement = arrange(regions);
    expect_consistent(arrangement, regions);
    check(arrangement, regions, place);
  }
}

TEST(Arrangement, squares_side_by_side_share_one_whole_edge) {
  everywhere({box(0, 0, 1, 1), box(1, 0, 2, 1)}, [](const Arrangement& a, const auto&, const Placement&) {
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.hinges.empty());
    ASSERT_EQ(a.contacts.size(), 2u);
    const Contact& c = a.contacts[0];
    EXPECT_EQ(c.region, 0);
    EXPECT_EQ(c.edge, 1);
    EXPECT_EQ(c.from, 0);
    EXPECT_EQ(c.to, 1);
    EXPECT_EQ(c.other_region, 1);
    EXPECT_EQ(c.other_edge, 3);
    EXPECT_EQ(c.other_from, 1);
    EXPECT_EQ(c.other_to, 0);
    EXPECT_EQ(breakpoint_count(a), 0u);
  });
}

TEST(Arrangement, offset_squares_share_the_common_part_and_break_both_edges) {
  everywhere({box(0, 0, 1, 1), box(1, 0.25, 2, 1.25)}, [](const Arrangement& a, const auto&, const Placement& place) {
    const double near = place.shift.norm() > 1e7 * place.scale ? 1e-6 : 1e-8;
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.hinges.empty());
    ASSERT_EQ(a.contacts.size(), 2u);
    EXPECT_NEAR(a.contacts[0].from, 0.25, near);
    EXPECT_EQ(a.contacts[0].to, 1);
    EXPECT_NEAR(a.contacts[0].other_from, 1, near);
    EXPECT_EQ(a.contacts[0].other_from, 1);
    EXPECT_NEAR(a.contacts[0].other_to, 0.25, near);
    ASSERT_EQ(a.breakpoints[0][1].size(), 1u);
    ASSERT_EQ(a.breakpoints[1][3].size(), 1u);
    EXPECT_EQ(breakpoint_count(a), 2u);
  });
}

TEST(Arrangement, one_edge_may_meet_several_regions) {
  // A plate below a row of three blocks; the middle one hangs between the others.
  everywhere({box(0, 0, 3, 1), box(0, 1, 1, 2), box(1, 1.5, 2, 2), box(2, 1, 2.5, 2)},
             [](const Arrangement& a, const std::vector<Outline>& regions, const Placement& place) {
               EXPECT_FALSE(a.overlap);
               EXPECT_TRUE(a.hinges.empty());
               EXPECT_EQ(a.breakpoints[0][2].size(), 3u);
               EXPECT_EQ(a.contacts.size(), 8u);
               EXPECT_NEAR(contact_length(a, regions, 0) / place.scale, 1.5, 1e-5);
               EXPECT_NEAR(contact_length(a, regions, 2) / place.scale, 1.0, 1e-5);
             });
}

TEST(Arrangement, checkerboard_of_four_is_no_hinge) {
  everywhere({box(0, 0, 1, 1), box(1, 0, 2, 1), box(0, 1, 1, 2), box(1, 1, 2, 2)},
             [](const Arrangement& a, const auto&, const Placement&) {
               EXPECT_FALSE(a.overlap);
               EXPECT_TRUE(a.hinges.empty());
               EXPECT_EQ(a.contacts.size(), 8u);
               EXPECT_EQ(breakpoint_count(a), 0u);
             });
}

TEST(Arrangement, three_of_four_squares_are_no_hinge) {
  everywhere({box(0, 0, 1, 1), box(1, 0, 2, 1), box(1, 1, 2, 2)}, [](const Arrangement& a, const auto&, const auto&) {
    EXPECT_TRUE(a.hinges.empty());
    EXPECT_EQ(a.contacts.size(), 4u);
  });
}

TEST(Arrangement, two_diagonal_squares_are_a_hinge) {
  everywhere({box(0, 0, 1, 1), box(1, 1, 2, 2)}, [](const Arrangement& a, const auto&, const Placement& place) {
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.contacts.empty());
    ASSERT_EQ(a.hinges.size(), 1u);
    EXPECT_LT((a.hinges[0].where - place(Point(1, 1))).norm(), 1e-6 * place.scale);
    EXPECT_EQ(a.hinges[0].groups, (std::vector<std::vector<int>>{{0}, {1}}));
  });
}

TEST(Arrangement, two_pairs_that_meet_in_a_point_are_a_hinge_of_two_groups) {
  const Outline upper_left{{{{0, 0}, {0, 2}, {-2, 2}}}}, upper_right{{{{0, 0}, {2, 2}, {0, 2}}}};
  const Outline lower_left{{{{0, 0}, {-2, -2}, {0, -2}}}}, lower_right{{{{0, 0}, {0, -2}, {2, -2}}}};
  everywhere({upper_left, lower_left, upper_right, lower_right}, [](const Arrangement& a, const auto&, const auto&) {
    EXPECT_FALSE(a.overlap);
    ASSERT_EQ(a.hinges.size(), 1u);
    EXPECT_EQ(a.hinges[0].groups, (std::vector<std::vector<int>>{{0, 2}, {1, 3}}));
    EXPECT_EQ(a.contacts.size(), 4u);
  });
}

TEST(Arrangement, vertex_on_an_edge_is_a_hinge_and_a_breakpoint) {
  const Outline wedge{{{{0.4, 1}, {0.6, 2}, {0.2, 2}}}};
  everywhere({box(0, 0, 1, 1), wedge}, [](const Arrangement& a, const auto&, const Placement&) {
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.contacts.empty());
    ASSERT_EQ(a.breakpoints[0][2].size(), 1u);
    EXPECT_NEAR(a.breakpoints[0][2][0], 0.6, 1e-6);
    EXPECT_EQ(a.hinges.size(), 1u);
  });
}

TEST(Arrangement, a_hinge_elsewhere_connected_is_still_a_hinge) {
  // A frame with a gap: the two blocks are joined below, and touch in one more point above.
  const Outline left{{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 3}, {0, 3}}}};
  const Outline right{{{{2, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 3}, {3, 3}, {3, 1}, {2, 1}}}};
  everywhere({left, right}, [](const Arrangement& a, const auto&, const Placement& place) {
    EXPECT_FALSE(a.overlap);
    EXPECT_EQ(a.contacts.size(), 2u);
    ASSERT_EQ(a.hinges.size(), 1u);
    EXPECT_LT((a.hinges[0].where - place(Point(2, 3))).norm(), 1e-6 * place.scale);
  });
}

TEST(Arrangement, box_fills_a_hole) {
  const Outline plate{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1, 3, 2))}};
  everywhere({plate, box(1, 1, 3, 2)},
             [](const Arrangement& a, const std::vector<Outline>& regions, const auto& place) {
               EXPECT_FALSE(a.overlap);
               EXPECT_TRUE(a.hinges.empty());
               EXPECT_EQ(a.contacts.size(), 8u);
               EXPECT_NEAR(contact_length(a, regions, 0) / place.scale, 6, 1e-5);
               EXPECT_TRUE(std::all_of(a.contacts.begin(), a.contacts.end(),
                                       [](const Contact& c) { return c.region == 1 || c.edge >= 4; }));
             });
}

TEST(Arrangement, two_boxes_fill_a_hole_together) {
  const Outline plate{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1, 3, 2))}};
  everywhere({plate, box(1, 1, 1.75, 2), box(1.75, 1, 3, 2)}, [](const Arrangement& a, const auto&, const auto&) {
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.hinges.empty());
    EXPECT_EQ(a.contacts.size(), 14u);
    EXPECT_EQ(breakpoint_count(a), 2u);
  });
}

TEST(Arrangement, body_inside_a_hole_without_contact_is_apart) {
  const Outline plate{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1, 3, 2))}};
  everywhere({plate, box(1.2, 1.2, 2.8, 1.8)}, [](const Arrangement& a, const auto&, const auto&) {
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.contacts.empty());
    EXPECT_TRUE(a.hinges.empty());
  });
}

TEST(Arrangement, l_shape_in_a_notch) {
  const Outline notched{{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}};
  const Outline filling{{{{1, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}}}};
  everywhere({notched, filling}, [](const Arrangement& a, const auto&, const auto&) {
    EXPECT_FALSE(a.overlap);
    EXPECT_TRUE(a.hinges.empty());
    EXPECT_EQ(a.contacts.size(), 4u);
    EXPECT_EQ(breakpoint_count(a), 0u);
  });
}

TEST(Arrangement, collinear_vertices_split_the_contact) {
  const Outline with_middle{{{{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}}}};
  everywhere({box(0, 0, 1, 1), with_middle}, [](const Arrangement& a, const auto&, const auto&) {
    EXPECT_EQ(a.contacts.size(), 4u);
    EXPECT_EQ(a.breakpoints[0][1].size(), 1u);
  });
}

TEST(Arrangement, overlaps_are_found_whatever_their_kind) {
  const std::vector<std::vector<Outline>> cases{
      {box(0, 0, 2, 2), box(1, 1, 3, 3)},                                    // crossing
      {box(0, 0, 4, 4), box(1, 1, 2, 2)},                                    // nested without contact
      {box(1, 1, 2, 2), box(0, 0, 4, 4)},                                    // the same, inner one first
      {box(0, 0, 2, 2), box(0, 0, 2, 2)},                                    // equal
      {box(0, 0, 2, 2), box(0, 0, 1, 2)},                                    // nested along three sides
      {box(0, 0, 2, 2), box(0, 0.5, 1, 1.5)},                                // nested along one side
      {box(0, 1, 3, 2), box(1, 0, 2, 3)},                                    // cross
      {box(0, 0, 2, 2), Outline{{{{1, 1}, {3, 0}, {3, 2}}}}},                // a tip inside
      {box(0, 0, 2, 2), Outline{{{{0, 0}, {2, 2}, {0, 2}}}}},                // through the corners
      {Outline{{{{1, 0}, {2, 1}, {1, 2}, {0, 1}}}}, box(0, 0, 2, 2)},        // inscribed, touching in four points
      {box(0, 0, 1, 1), box(1, 0, 2, 1), box(0.999999, 0.2, 1.000001, 0.4)}  // thin
  };
  for (const auto& shapes : cases)
    everywhere(shapes, [](const Arrangement& a, const std::vector<Outline>& regions, const Placement&) {
      ASSERT_TRUE(a.overlap);
      Box all;
      for (const Outline& outline : regions) all.extend(bounding_box(outline));
      const double tolerance = 2 * geometric_tolerance(all);
      EXPECT_LT(a.overlap->region_a, a.overlap->region_b);
      EXPECT_NE(locate(regions[a.overlap->region_a], a.overlap->where, tolerance), Location::outside);
      EXPECT_NE(locate(regions[a.overlap->region_b], a.overlap->where, tolerance), Location::outside);
    });
}

TEST(Arrangement, body_larger_than_the_hole_around_it_overlaps) {
  const Outline plate{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1, 3, 2))}};
  EXPECT_TRUE(arrange({plate, box(0.5, 0.5, 3.5, 2.5)}).overlap);
  EXPECT_TRUE(arrange({plate, box(1, 1, 3, 2.5)}).overlap);
  EXPECT_TRUE(arrange({plate, box(0, 0, 4, 4)}).overlap);
}

TEST(Arrangement, mismatch_below_the_tolerance_counts_as_contact_above_it_does_not) {
  const auto contacts = [](double shift) { return arrange({box(0, 0, 1, 1), box(1 + shift, 0, 2, 1)}); };
  for (double shift : {-1e-9, 1e-9}) {
    const Arrangement close = contacts(shift);
    EXPECT_FALSE(close.overlap);
    EXPECT_EQ(close.contacts.size(), 2u);
    EXPECT_TRUE(close.hinges.empty());
  }
  EXPECT_TRUE(contacts(-1e-8).overlap);
  EXPECT_TRUE(contacts(1e-8).contacts.empty());
}

TEST(Arrangement, skew_contact_below_the_tolerance_is_one_piece) {
  // Two edges cross at a tiny angle; that must not break the shared piece.
  const Outline left{{{{0, 0}, {1 + 5e-10, 0}, {1 - 5e-10, 1}, {0, 1}}}};
  const Arrangement a = arrange({left, box(1, 0, 2, 1)});
  EXPECT_FALSE(a.overlap);
  ASSERT_EQ(a.contacts.size(), 2u);
  EXPECT_EQ(breakpoint_count(a), 0u);
}

TEST(Arrangement, strip_of_many_regions_is_a_chain) {
  std::vector<Outline> strip;
  for (int k = 0; k < 50; ++k) strip.push_back(box(k / 3.0, 0, (k + 1) / 3.0, 0.1));
  const Arrangement a = arrange(strip);
  EXPECT_EQ(a.contacts.size(), 98u);
  EXPECT_TRUE(a.hinges.empty());
  EXPECT_FALSE(a.overlap);
}

TEST(Arrangement, nothing_and_one_region_are_fine) {
  EXPECT_TRUE(arrange({}).contacts.empty());
  const Arrangement one = arrange({box(0, 0, 1, 1)});
  EXPECT_TRUE(one.contacts.empty());
  EXPECT_EQ(one.breakpoints[0].size(), 4u);
}

}  // namespace

#include <gtest/gtest.h>

#include "geometry/rectilinear.hpp"
#include "unit/geometry_shapes.hpp"

namespace {

using namespace bempd;
using namespace bempd::test;

TEST(FitLattice, rectangle_becomes_lattice_points_counted_from_its_lower_left) {
  // 49.5 / 0.1 and the corners' coordinates are not exact in binary.
  const LatticeFit fit = fit_lattice({{{{0.3, 49.7}, {0.3, 0.2}, {50.3, 0.2}, {50.3, 49.7}}}}, 0.1);
  ASSERT_TRUE(fit.fits());
  EXPECT_NEAR(fit.outline.origin.x(), 0.3, 1e-13);
  EXPECT_NEAR(fit.outline.origin.y(), 0.2, 1e-13);
  EXPECT_EQ(fit.outline.loops[0], (std::vector<LatticePoint>{{0, 495}, {0, 0}, {500, 0}, {500, 495}}));
}

TEST(FitLattice, collinear_vertices_go_but_every_edge_keeps_its_lattice_points) {
  const Outline outline{{{{0, 0}, {2, 0}, {3, 0}, {3, 2}, {1, 2}, {1, 1}, {0, 1}}}};
  const LatticeFit fit = fit_lattice(outline, 0.5);
  ASSERT_TRUE(fit.fits());
  EXPECT_EQ(fit.outline.loops[0], (std::vector<LatticePoint>{{0, 0}, {6, 0}, {6, 4}, {2, 4}, {2, 2}, {0, 2}}));
  ASSERT_EQ(fit.outline.edges.size(), 7u);
  EXPECT_EQ(fit.outline.edges[1][0], LatticePoint(4, 0));
  EXPECT_EQ(fit.outline.edges[1][1], LatticePoint(6, 0));
  EXPECT_EQ(fit.outline.edges[6][1], LatticePoint(0, 0));
}

TEST(FitLattice, holes_follow_the_lattice_of_the_outer_loop) {
  const Outline ring{{box_loop(0, 0, 4, 4), reversed(box_loop(1, 1.5, 3, 3))}};
  const LatticeFit fit = fit_lattice(ring, 0.5);
  ASSERT_TRUE(fit.fits());
  EXPECT_EQ(fit.outline.loops[1], (std::vector<LatticePoint>{{2, 6}, {6, 6}, {6, 3}, {2, 3}}));
  const Outline shifted{{box_loop(0, 0, 4, 4), reversed(box_loop(1.1, 1.5, 3.1, 3))}};
  const LatticeFit misfit = fit_lattice(shifted, 0.5);
  EXPECT_EQ(misfit.misfit, LatticeMisfit::shifted_hole);
  EXPECT_EQ(misfit.loop, 1);
  EXPECT_EQ(misfit.edge, 4);
  EXPECT_NEAR(misfit.length, 1.1, 1e-14);
  EXPECT_TRUE(misfit.suggestions.empty()) << "0.1 is too far from 0.5 to be of use";
  EXPECT_EQ(fit_lattice(shifted, 0.15).suggestions, (std::vector<double>{0.1}));
}

TEST(FitLattice, fits_at_any_size_and_place) {
  for (double scale : {1e-9, 1.0, 1e9})
    for (double offset : {0.0, 1e5}) {
      const Placement place{scale, 0, {offset * scale / 3, -offset * scale / 7}};
      const LatticeFit fit = fit_lattice(place(box(0, 0, 0.7, 0.3)), 0.1 * scale);
      ASSERT_TRUE(fit.fits());
      EXPECT_EQ(fit.outline.loops[0][2], LatticePoint(7, 3));
    }
}

TEST(FitLattice, oblique_edge_is_named) {
  const LatticeFit fit = fit_lattice({{{{0, 0}, {2, 0}, {2, 1}, {1, 1.5}, {0, 1}}}}, 0.5);
  EXPECT_EQ(fit.misfit, LatticeMisfit::oblique_edge);
  EXPECT_EQ(fit.edge, 2);
}

TEST(FitLattice, indivisible_edge_is_named_with_spacings_that_fit) {
  const LatticeFit fit = fit_lattice(box(0, 0, 0.3, 0.2), 0.03);
  EXPECT_EQ(fit.misfit, LatticeMisfit::indivisible_edge);
  EXPECT_EQ(fit.edge, 1);
  EXPECT_NEAR(fit.length, 0.2, 1e-15);
  EXPECT_EQ(fit.suggestions, (std::vector<double>{0.025, 0.05}));
}

TEST(FitLattice, every_suggestion_fits) {
  const std::vector<Outline> shapes{box(0, 0, 50, 49.5),
                                    box(0, 0, 1.0 / 3, 2.0 / 3),
                                    box(0.1, 0.2, 0.8, 1.3),
                                    {{{{0, 0}, {7, 0}, {7, 2}, {4.2, 2}, {4.2, 3.5}, {0, 3.5}}}}};
  int count = 0;
  for (const Outline& shape : shapes)
    for (double spacing : {0.0123, 0.07, 0.33, 0.61})
      for (double suggestion : fit_lattice(shape, spacing).suggestions) {
        EXPECT_TRUE(fit_lattice(shape, suggestion).fits()) << spacing << " -> " << suggestion;
        EXPECT_LE(std::abs(std::log(suggestion / spacing)), std::log(3.0) + 1e-12);
        ++count;
      }
  EXPECT_GE(count, 16);
}

TEST(FitLattice, lengths_without_common_measure_get_no_suggestion) {
  const LatticeFit fit = fit_lattice(box(0, 0, 1, std::sqrt(2.0)), 0.1);
  EXPECT_EQ(fit.misfit, LatticeMisfit::indivisible_edge);
  EXPECT_TRUE(fit.suggestions.empty());
}

TEST(FitLattice, spacing_larger_than_the_body_is_indivisible) {
  const LatticeFit fit = fit_lattice(box(0, 0, 1, 1), 1.5);
  EXPECT_EQ(fit.misfit, LatticeMisfit::indivisible_edge);
  EXPECT_EQ(fit.suggestions, (std::vector<double>{1}));
  EXPECT_EQ(fit_lattice(box(0, 0, 1, 1), 1e12).misfit, LatticeMisfit::indivisible_edge);
}

TEST(FitLattice, useless_spacings_are_refused) {
  for (double spacing : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-12, 1e-300})
    EXPECT_EQ(fit_lattice(box(0, 0, 1, 1), spacing).misfit, LatticeMisfit::bad_spacing) << spacing;
}

TEST(FitLattice, a_relative_error_of_1e_7_is_not_taken_for_rounding) {
  EXPECT_FALSE(fit_lattice(box(0, 0, 1, 1), 0.1 * (1 + 1e-7)).fits());
  EXPECT_TRUE(fit_lattice(box(0, 0, 1, 1 + 1e-10), 0.1).fits());
}

}  // namespace

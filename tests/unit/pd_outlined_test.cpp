// Networks with points on outlines of every kind.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cstdio>
#include <span>
#include <vector>

#include "pd/cell_squares.hpp"
#include "pd/outlined/outlined_bonds.hpp"
#include "pd/outlined/surface_balance.hpp"
#include "thorough.hpp"
#include "unit/pd_outlines.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

// Any place and direction of the lattice.
LatticePlace some_place(std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  const double x = part(random), y = part(random);
  return {{x, y}, 1.5 * part(random)};
}

void expect_exact(const NamedOutline& outline, int m, std::mt19937& random) {
  const OutlinedBody body = body_of(outline.loops, some_place(random), m);
  SCOPED_TRACE(outline.name + ", horizon ratio " + std::to_string(m));
  EXPECT_TRUE(body.is_exact());
  EXPECT_LT(patch_error(body), 1e-11);
  EXPECT_GT(body.network.min_weight_ratio, 0.019);
  for (const Bond& bond : body.network.bonds) ASSERT_GT(bond.stiffness, 0);
}

void expect_exact(const std::vector<NamedOutline>& outlines, const std::vector<int>& horizons) {
  std::mt19937 random(4);
  for (const NamedOutline& outline : outlines)
    for (const int m : horizons) expect_exact(outline, m, random);
}

std::string named(const char* what, double value) { return what + std::string(" ") + std::to_string(value); }

TEST(OutlinedNetwork, is_exact_around_round_holes_of_any_radius) {
  std::vector<NamedOutline> outlines;
  for (const double radius : {1.0, 1.7, 3.0, 6.2})
    outlines.push_back({named("hole of radius", radius), {polygon(box(19, 18)), circle({9.3, 8.8}, radius, true)}});
  expect_exact(outlines, {3, 4});
  expect_exact({outlines[1]}, {5});
}

TEST(OutlinedNetwork, is_exact_on_discs) {
  std::vector<NamedOutline> outlines;
  for (const double radius : {2.0, 2.5, 3.0, 4.0, 6.0, 9.0})
    outlines.push_back({named("disc of radius", radius), {circle({0.3, 0.1}, radius, false)}});
  expect_exact(outlines, {3, 4, 5});
}

TEST(OutlinedNetwork, is_exact_between_slanted_edges) {
  std::vector<NamedOutline> outlines;
  for (const double width : {3.0, 4.4, 7.0})
    outlines.push_back({named("strip of width", width), {polygon(turned(box(17.3, width), 23 * degree))}});
  expect_exact(outlines, {3, 4, 5});
}

TEST(OutlinedNetwork, is_exact_at_convex_corners_from_65_degrees_on) {
  std::vector<NamedOutline> outlines;
  for (const double angle : {65.0, 75.0, 100.0, 140.0, 170.0})
    outlines.push_back({named("corner of", angle), {polygon(wedge(angle * degree, 11.3))}});
  expect_exact(outlines, {4});
  expect_exact({outlines[1], outlines[3]}, {3, 5});
}

TEST(OutlinedNetwork, is_exact_at_re_entrant_corners) {
  std::vector<NamedOutline> outlines;
  for (const double angle : {250.0, 300.0, 350.0})
    outlines.push_back({named("corner of", angle), {polygon(notched(angle * degree))}});
  outlines.push_back(
      {"turned L",
       {polygon(
           turned(std::vector<Point>{{0, 0}, {17.2, 0}, {17.2, 8.4}, {7.3, 8.4}, {7.3, 19}, {0, 19}}, 31 * degree))}});
  expect_exact(outlines, {3, 4});
}

TEST(OutlinedNetwork, is_exact_in_smooth_curves) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> part(0, 1);
  for (const int m : {3, 4}) {
    std::vector<Point> points;
    for (int k = 0; k < 9; ++k) points.push_back(turned(Point(7 + 4 * part(random), 0), k * 40 * degree));
    expect_exact({"curve", {smooth_loop(points)}}, m, random);
  }
}

// Chords half a spacing to either side of a crack's mouth are one spacing long, those between them and the corners not:
// multipliers grow along the outline, and nothing is left to tell the rows' dependence from long waves.
TEST(OutlinedNetwork, is_exact_on_long_outlines_whose_chords_differ) {
  const std::vector<Point> corners = box(160, 160);
  const std::vector<double> mouths{79.763, 80.0};
  for (const double mouth : std::span(mouths).first(bempd_tests::cases(1, 2))) {
    std::vector<Point> vertices{corners[0], corners[1], corners[2], corners[3]};
    vertices.emplace_back(0, mouth + 0.5), vertices.emplace_back(0, mouth - 0.5);
    const OutlinedBody body =
        build_outlined_body(make_chords({polygon(vertices)}), {{0.0625, 0.375}, 20 * degree, true}, 3, bonds_alone, 1);
    std::printf("mouth at %g: %s, patch test %.0e\n", mouth, body.is_balanced_by_piece ? "with care" : "without",
                patch_error(body));
    EXPECT_TRUE(body.is_exact());
    EXPECT_LT(patch_error(body), 1e-11);
    EXPECT_GT(body.network.min_weight_ratio, 0.019);
  }
}

// Bonds and squares of cells; the last two have chords of several lengths, so that their surface vectors have factors.
TEST(OutlinedNetwork, is_exact_for_any_ratio) {
  const std::vector<PlaneElasticity> materials{{1, -0.2, PlaneState::stress, 1}, {1, 0.2, PlaneState::stress, 1},
                                               {1, 0.45, PlaneState::stress, 1}, {1, 0.1, PlaneState::strain, 1},
                                               {1, 0.4, PlaneState::strain, 1},  {1, 0.49, PlaneState::strain, 1}};
  const std::vector<Loops> outlines{
      {polygon(box(19, 18)), circle({9.3, 8.8}, 3, true)},
      {circle({0.3, 0.1}, 6, false)},
      {polygon(turned(box(17.3, 7.7), 23 * degree)), circle(turned(Point(5, 4), 23 * degree), 1.5, true)},
      {polygon(notched(300 * degree))}};
  for (const Loops& outline : outlines) {
    for (const int m : {3, 4}) {
      const LatticePlace place{{0.3, 0.1}, 0.2};
      const OutlinedBody bonds = body_of(outline, place, m);
      for (const PlaneElasticity& material : materials) {
        OutlinedBody body = bonds;
        for (Bond& bond : body.network.bonds) bond.stiffness *= bond_c1111(material);
        std::printf("%.1e %.1e | ", patch_error(body, material), cell_stencils(body).max_residual);
        EXPECT_LT(patch_error(body, material), 1e-11);
      }
      std::printf("\n");
    }
  }
}

TEST(OutlinedNetwork, has_three_rigid_modes_and_resists_all_others) {
  const OutlinedBody body = body_of(
      {polygon(turned(box(9.3, 6.2), 0.4)), circle(turned(Point(4.4, 3), 0.4), 1.2, true)}, {{0.3, 0.1}, 0.2}, 4);
  const auto n = 2 * static_cast<Eigen::Index>(body.points.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (const Bond& bond : body.network.bonds) {
    Eigen::VectorXd along = Eigen::VectorXd::Zero(n);
    const Point direction = (body.points[bond.second] - body.points[bond.first]).normalized();
    along.segment<2>(2 * bond.first) = direction;
    along.segment<2>(2 * bond.second) = -direction;
    stiffness += bond.stiffness * along * along.transpose();
  }
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness).eigenvalues();
  for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(values[k]), 1e-13 * values[n - 1]);
  EXPECT_GT(values[3], 1e-4 * values[n - 1]);
}

TEST(OutlinedNetwork, keeps_the_bulk_stiffness_inside) {
  const OutlinedBody body = body_of({circle({0, 0}, 13, false)}, {{0.3, 0.1}, 0.2}, 4);
  int deep = 0;
  for (std::size_t b = 0; b < body.network.bonds.size(); ++b) {
    const Bond& bond = body.network.bonds[b];
    if (std::max(body.points[bond.first].norm(), body.points[bond.second].norm()) > 8.9) continue;
    EXPECT_NEAR(bond.stiffness, body.network.offsets[body.network.offset_of[b]].bulk_stiffness, 1e-15);
    ++deep;
  }
  EXPECT_GT(deep, 2000);
}

TEST(OutlinedNetwork, bonds_do_not_leave_the_body) {
  const Loops loops{polygon(box(16, 14)), circle({8, 7}, 3, true)};
  const OutlinedBody body = body_of(loops, {}, 4);
  for (const Bond& bond : body.network.bonds) {
    const Point &p = body.points[bond.first], &q = body.points[bond.second];
    // Chords cut the circle, no bond comes closer to its middle than they do.
    const double nearest = distance(Segment{p, q}, {8, 7});
    EXPECT_GT(nearest, 3 * std::cos(0.5 * body.chords.length(body.chords.loop_start[1]) / 3) - 1e-2);
  }
}

TEST(OutlinedNetwork, cells_fill_the_polygon_without_overlap) {
  for (const Loops& loops : {Loops{polygon(turned(box(16.3, 13), 0.3)), circle(turned(Point(8, 6), 0.3), 3.1, true)},
                             Loops{polygon(notched(350 * degree))}, Loops{circle({0, 0}, 5.5, false)}}) {
    const OutlinedBody body = body_of(loops, {{0.2, 0.6}, 0.5}, 4);
    double whole = 0, filled = 0, shared = 0;
    for (const Chord& c : body.chords.chords)
      whole += 0.5 * cross(body.chords.nodes[c.first], body.chords.nodes[c.second]);
    for (const auto& cell : body.cells) {
      const Point &a = body.points[cell[0]], &b = body.points[cell[1]], &c = body.points[cell[2]];
      const double half = 0.5 * cross(b - a, c - a);
      EXPECT_GT(half, 1e-3);
      filled += is_triangle(cell) ? half : 2 * half;
    }
    for (const double area : body.areas) shared += area;
    EXPECT_NEAR(filled, whole, 1e-10 * whole);
    EXPECT_NEAR(shared, whole, 1e-10 * whole);
  }
}

// A loop whose pieces have chords of different lengths has no exact network of any sign without the factors.
TEST(SurfaceBalance, changes_surface_vectors_little_and_keeps_forces_and_moments) {
  const Chords chords = make_chords({polygon(wedge(75 * degree, 11.3))});
  const std::vector<double> plain(chords.nodes.size(), 1.0), factors = balancing_factors(chords);
  EXPECT_GT(imbalance(chords, plain), 1e-6);
  EXPECT_LT(imbalance(chords, factors), 1e-14);
  Point force = Point::Zero();
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  for (int i = 0; i < chords.count(); ++i) {
    EXPECT_NEAR(factors[i], 1, 5e-3);
    force += factors[i] * chords.surface_vector(i);
    moments += (factors[i] - 1) * chords.surface_vector(i) * chords.nodes[i].transpose();
  }
  EXPECT_LT(force.norm(), 1e-12);
  EXPECT_LT(moments.norm(), 1e-11);
  // Equal chords need none.
  for (const double factor : balancing_factors(make_chords({circle({1, 2}, 7.3, false)})))
    EXPECT_NEAR(factor, 1, 1e-12);
}

TEST(SurfaceBalance, keeps_the_load_of_every_edge) {
  const Chords chords = make_chords({polygon(wedge(75 * degree, 11.3))});
  const std::vector<double> factors = balancing_factors(chords);
  for (std::size_t p = 0; p + 1 < chords.piece_start.size(); ++p) {
    double kept = 0, whole = 0;
    for (int c = chords.piece_start[p]; c < chords.piece_start[p + 1]; ++c) {
      whole += chords.length(c);
      kept += 0.5 * chords.length(c) * (factors[chords.chords[c].first] + factors[chords.chords[c].second]);
    }
    EXPECT_NEAR(kept, whole, 1e-12 * whole);
  }
}

// A piece alone has the sums over a straight line that chords of one length have, whatever its own length.
TEST(SurfaceBalance, by_piece_leaves_nothing_to_carry_from_piece_to_piece) {
  const std::vector<Point> vertices{{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 17.3}, {0, 16.3}};
  const Chords chords = make_chords({polygon(vertices)});
  const std::vector<double> plain = balancing_factors(chords), careful = balancing_factors(chords, true);
  EXPECT_LT(imbalance(chords, careful), 1e-14);
  const auto squares = [&](int piece, const std::vector<double>& factors) {
    const int first = chords.piece_start[piece], end = chords.piece_start[piece + 1];
    double sum = 0, length = 0;
    for (int c = first; c < end; ++c) {
      const double half = 0.5 * chords.length(c);
      for (const int node : {chords.chords[c].first, chords.chords[c].second}) {
        const double along = (chords.nodes[node] - chords.nodes[first]).norm();
        sum += half * factors[node] * along * along;
      }
      length += chords.length(c);
    }
    return (sum - length * length * length / 3) * 6 / length;  // l^2 of chords that are alike
  };
  for (const int piece : {0, 1, 2, 3, 5}) {
    std::printf("piece %d: %.6f, by piece %.6f\n", piece, squares(piece, plain), squares(piece, careful));
    EXPECT_NEAR(squares(piece, careful), 1, 1e-3);
  }
  EXPECT_GT(std::abs(squares(3, plain) - 1), 5e-3);
}

TEST(ImpossibleCorner, is_one_below_60_degrees_or_with_unlike_chords) {
  const auto corner_of = [](double angle) {
    return find_impossible_corner(make_chords({polygon(wedge(angle * degree, 12))}));
  };
  ASSERT_TRUE(corner_of(59));
  EXPECT_NEAR(corner_of(59)->angle, 59 * degree, 1e-12);
  EXPECT_EQ(corner_of(59)->node, 0);
  EXPECT_FALSE(corner_of(61));
  // A right angle bears chords whose lengths differ by less than sqrt 3.
  EXPECT_FALSE(find_impossible_corner(make_chords({polygon(box(1.4, 5 * 0.85))})));
  EXPECT_TRUE(find_impossible_corner(make_chords({polygon(box(0.5, 5))})));
}

}  // namespace

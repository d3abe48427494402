#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <set>

#include "paper/uncorrected_network.hpp"
#include "paper/volume_damage.hpp"
#include "pd/deformation.hpp"
#include "unit/pd_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;
using bempd::paper::build_uncorrected_network;
using bempd::paper::volume_damage;

using Face = std::array<Point, 2>;

std::vector<Face> faces_of(const std::vector<Loop>& loops) {
  std::vector<Face> faces;
  for (const Loop& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k)
      faces.push_back({loop[k].cast<double>(), loop[(k + 1) % loop.size()].cast<double>()});
  return faces;
}

std::vector<double> full(const std::vector<Point>& points) { return std::vector<double>(points.size(), 1.0); }

// Cell-centred points, and one more at every lattice corner on the left face.
std::vector<Point> with_left_interface(const CellLattice& cells) {
  std::vector<Point> points = points_of(CellLattice::centres_of(cells), {0.5, 0.5});
  for (int y = cells.lower().y(); y <= cells.upper().y(); ++y) points.emplace_back(cells.lower().x(), y);
  return points;
}

// Elastic constants C_klmn = 1/2 sum k L^2 e_k e_l e_m e_n of an inner point, over thickness.
struct Constants {
  double c1111 = 0, c2222 = 0, c1122 = 0;
};
Constants constants_at(int point, const Network& network, double thickness) {
  Constants out;
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const Bond& bond = network.bonds[b];
    if (bond.first != point && bond.second != point) continue;
    const BondOffset& o = network.offsets[network.offset_of[b]];
    const double c = o.direction.x() * o.direction.x(), s = o.direction.y() * o.direction.y();
    const double k = 0.5 * bond.stiffness / thickness * o.length * o.length;
    out.c1111 += k * c * c, out.c2222 += k * s * s, out.c1122 += k * c * s;
  }
  return out;
}

// Ratios to the continuum from a separate summation of Eqs. 13 and 19 over the points of a square lattice.
TEST(UncorrectedNetwork, elastic_constants_miss_those_of_the_continuum_by_the_known_ratios) {
  const double expected[][2] = {
      {1.029521, 0.738541}, {1.009934, 0.893947}, {1.004396, 0.954652}, {1.003552, 0.978687}, {1.001185, 0.985550}};
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    const double young_modulus = 3e7, thickness = 0.02;
    const double c11 = young_modulus * (state == PlaneState::stress ? 9.0 / 8 : 6.0 / 5);
    for (int m = 2; m <= 6; ++m) {
      const CellLattice lattice({rectangle(0, 0, 2 * m, 2 * m)});
      const std::vector<Point> points = points_of(lattice);
      const Network network =
          build_uncorrected_network(points, full(points), {}, m, bond_based(young_modulus, state, thickness));
      const Constants c = constants_at(lattice.find_point({m, m}), network, thickness);
      const double longitudinal = c.c1111 / c11, lateral = c.c1122 / (c11 / 3);
      std::cout << "m " << m << ": C1111 " << longitudinal << " reference " << expected[m - 2][0] << " difference "
                << longitudinal - expected[m - 2][0] << "; C1122 " << lateral << " reference " << expected[m - 2][1]
                << " difference " << lateral - expected[m - 2][1] << '\n';
      EXPECT_NEAR(longitudinal, expected[m - 2][0], 5.1e-7);
      EXPECT_NEAR(lateral, expected[m - 2][1], 5.1e-7);
      EXPECT_NEAR(c.c2222, c.c1111, 1e-12 * c.c1111);
    }
  }
}

TEST(UncorrectedNetwork, a_bond_has_the_stiffness_of_the_formula) {
  const double thickness = 0.3, young_modulus = 7;
  const std::vector<Point> points = {{0, 0}, {0.5, 1.5}, {3.75, 0}};
  const std::vector<double> volumes = {1, 0.5, 0.25};
  const Network network =
      build_uncorrected_network(points, volumes, {}, 4, bond_based(young_modulus, PlaneState::stress, thickness));
  ASSERT_EQ(network.bonds.size(), 3u);
  const auto stiffness = [&](double length, double factor) {
    const double g = std::pow(1 - length * length / 16, 2);
    return 315 * young_modulus * thickness / (8 * M_PI * 64) * g / length * factor;
  };
  EXPECT_NEAR(network.bonds[0].stiffness / stiffness(std::sqrt(2.5), 0.5), 1, 1e-14);
  EXPECT_NEAR(network.bonds[1].stiffness / stiffness(3.75, 0.75 * 0.25), 1, 1e-14);  // the horizon cuts the cell
  EXPECT_NEAR(network.bonds[2].stiffness / stiffness(std::hypot(3.25, 1.5), 0.125 * (4.5 - std::hypot(3.25, 1.5))), 1,
              1e-14);
}

TEST(UncorrectedNetwork, has_all_pairs_closer_than_the_horizon_and_no_others) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-20, 3), y(100, 109);
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) points.emplace_back(x(random), y(random));
  for (const int m : {1, 3, 50}) {
    const Network network =
        build_uncorrected_network(points, full(points), {}, m, bond_based(1, PlaneState::strain, 1));
    std::size_t next = 0;
    for (int i = 0; i < 400; ++i) {
      for (int j = i + 1; j < 400; ++j) {
        if ((points[j] - points[i]).norm() >= m) continue;
        ASSERT_LT(next, network.bonds.size());
        EXPECT_EQ(network.bonds[next].first, i);
        EXPECT_EQ(network.bonds[next].second, j);
        ++next;
      }
    }
    EXPECT_EQ(next, network.bonds.size()) << m;
  }
  EXPECT_TRUE(build_uncorrected_network({}, {}, {}, 3, bond_based(1, PlaneState::stress, 1)).bonds.empty());
}

TEST(UncorrectedNetwork, bonds_of_exactly_the_horizon_are_left_out_wherever_the_lattice_lies) {
  for (const Point& shift : {Point(0, 0), Point(0.5, 0.5), Point(0.1, -1234.7)}) {
    for (int m = 2; m <= 5; ++m) {
      const CellLattice lattice({rectangle(0, 0, 2 * m, 2 * m)});
      const std::vector<Point> points = points_of(lattice, shift);
      const Network network =
          build_uncorrected_network(points, full(points), {}, m, bond_based(1, PlaneState::stress, 1));
      const int centre = lattice.find_point({m, m});
      const auto count = std::count_if(network.bonds.begin(), network.bonds.end(),
                                       [&](const Bond& b) { return b.first == centre || b.second == centre; });
      EXPECT_EQ(count, static_cast<long>(2 * bond_family(m).size())) << m;
    }
  }
}

TEST(UncorrectedNetwork, steps_that_differ_by_rounding_share_an_offset) {
  const CellLattice cells({rectangle(0, 0, 20, 12)});
  std::vector<Point> points = with_left_interface(cells);
  for (Point& p : points) p = (p * 0.1 + Point(0.7, 0.3)) / 0.1;
  const Network network = build_uncorrected_network(points, full(points), {}, 4, bond_based(1, PlaneState::stress, 1));
  std::set<std::pair<long, long>> steps;
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const Point step = points[network.bonds[b].second] - points[network.bonds[b].first];
    const BondOffset& offset = network.offsets[network.offset_of[b]];
    EXPECT_LT((offset.step - step).norm(), 1e-12);
    EXPECT_LT((offset.length * offset.direction - step).norm(), 1e-12);
    steps.emplace(std::lround(2 * step.x()), std::lround(2 * step.y()));
  }
  EXPECT_EQ(network.offsets.size(), steps.size());
}

// Whether a bond stays in the closed cells, by many places along it.
bool inside(const CellLattice& cells, const Point& from, const Point& to) {
  for (int k = 0; k <= 420; ++k) {
    const Point x = from + k / 420.0 * (to - from), low = x - Point(1e-9, 1e-9), high = x + Point(1e-9, 1e-9);
    bool in = false;
    for (const Point& p : {low, high, Point(low.x(), high.y()), Point(high.x(), low.y())})
      in = in || cells.has_cell(p.array().floor().matrix().cast<int>());
    if (!in) return false;
  }
  return true;
}

TEST(UncorrectedNetwork, bonds_that_leave_the_body_are_dropped_and_those_that_touch_its_faces_stay) {
  int dropped = 0;
  std::vector<Body> all = bodies();
  all.push_back({"hole that bonds cross from corner to corner", {rectangle(0, 0, 9, 9), hole(4, 4, 1, 1)}});
  for (const Body& body : all) {
    const CellLattice cells(body.loops);
    const std::vector<Point> points = points_of(CellLattice::centres_of(cells), {0.5, 0.5});
    const PlaneElasticity elasticity = bond_based(1, PlaneState::stress, 1);
    const Network network = build_uncorrected_network(points, full(points), faces_of(body.loops), 4, elasticity);
    std::set<std::pair<int, int>> bonds;
    for (const Bond& b : network.bonds) bonds.emplace(b.first, b.second);
    for (const Bond& b : build_uncorrected_network(points, full(points), {}, 4, elasticity).bonds) {
      const bool stays = inside(cells, points[b.first], points[b.second]);
      EXPECT_EQ(bonds.count({b.first, b.second}), stays ? 1u : 0u)
          << body.name << " from " << points[b.first].transpose() << " to " << points[b.second].transpose();
      dropped += !stays;
    }
  }
  EXPECT_GT(dropped, 100);
}

TEST(UncorrectedNetwork, a_face_cuts_the_same_bonds_in_one_piece_and_in_many) {
  const CellLattice cells({rectangle(0, 0, 20, 20)});
  const std::vector<Point> points = points_of(CellLattice::centres_of(cells), {0.5, 0.5});
  const PlaneElasticity elasticity = bond_based(1, PlaneState::stress, 1);
  std::vector<Face> pieces;
  for (int k = 4; k < 16; ++k) pieces.push_back({Point(10, k + 1), Point(10, k)});
  const Network whole = build_uncorrected_network(points, full(points), {{{{10, 4}, {10, 16}}}}, 4, elasticity);
  const Network many = build_uncorrected_network(points, full(points), pieces, 4, elasticity);
  ASSERT_EQ(whole.bonds.size(), many.bonds.size());
  for (std::size_t b = 0; b < whole.bonds.size(); ++b) {
    EXPECT_EQ(whole.bonds[b].first, many.bonds[b].first);
    EXPECT_EQ(whole.bonds[b].second, many.bonds[b].second);
  }
}

TEST(UncorrectedNetwork, a_linear_field_has_its_strain_with_interface_points_too) {
  const CellLattice cells({rectangle(3, -2, 9, 7)});
  const std::vector<Point> points = with_left_interface(cells);
  const Network network = build_uncorrected_network(points, full(points), faces_of({rectangle(3, -2, 9, 7)}), 4,
                                                    bond_based(1, PlaneState::stress, 1));
  Eigen::Matrix2d g;
  g << 0.3, -1.2, 0.7, 0.1;
  Eigen::VectorXd u(2 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) u.segment<2>(2 * static_cast<Eigen::Index>(i)) = g * points[i];
  const Eigen::Vector3d expected(0.3, 0.1, -0.25);
  for (const Eigen::Vector3d& strain : bond_strains(static_cast<int>(points.size()), network, {}, u))
    EXPECT_LT((strain - expected).norm(), 1e-12);
}

TEST(VolumeDamage, is_the_lost_part_of_the_volume_in_reach) {
  // Horizon 2: the volume factor is 1 up to 1.5 and 0.7 at 1.8.
  const std::vector<Point> points = {{0, 0}, {1, 0}, {1.8, 0}, {20, 0}};
  const std::vector<double> volumes = {1, 0.5, 2, 1};
  const Network network = build_uncorrected_network(points, volumes, {}, 2, bond_based(1, PlaneState::stress, 1));
  ASSERT_EQ(network.bonds.size(), 3u);  // 0-1, 0-2, 1-2
  EXPECT_EQ(volume_damage(network, volumes, 2, {}), (std::vector<double>{0, 0, 0, 0}));
  const std::vector<double> damage = volume_damage(network, volumes, 2, {0, 1, 0});
  EXPECT_NEAR(damage[0], 1.4 / 1.9, 1e-14);
  EXPECT_EQ(damage[1], 0);
  EXPECT_NEAR(damage[2], 0.7 / 1.2, 1e-14);
  EXPECT_EQ(damage[3], 0);
  EXPECT_EQ(volume_damage(network, volumes, 2, {1, 1, 1}), (std::vector<double>{1, 1, 1, 0}));
}

// Far from the ends of a crack midway between rows half of the volume is lost in the limit of a fine lattice.
TEST(VolumeDamage, next_to_a_long_crack_is_below_one_half_and_falls_with_the_distance) {
  const CellLattice lattice({rectangle(0, 0, 30, 30)});
  const std::vector<Point> points = points_of(lattice);
  const Network network = build_uncorrected_network(points, full(points), {}, 4, bond_based(1, PlaneState::stress, 1));
  std::vector<std::uint8_t> broken;
  for (const Bond& b : network.bonds) broken.push_back((points[b.first].y() < 15.5) != (points[b.second].y() < 15.5));
  const std::vector<double> damage = volume_damage(network, full(points), 4, broken);
  double last = 0.5;
  for (int y = 15; y >= 12; --y) {
    const double value = damage[lattice.find_point({15, y})];
    EXPECT_EQ(value, damage[lattice.find_point({15, 31 - y})]);
    EXPECT_LT(value, last);
    last = value;
  }
  EXPECT_GT(damage[lattice.find_point({15, 15})], 0.35);
  EXPECT_EQ(damage[lattice.find_point({15, 11})], 0);
}

}  // namespace

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "pd/crack.hpp"
#include "unit/pd_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

// Crack through the middle of a column of cells between half rows; touching bonds count.
TEST(Crack, centre_crack_cuts_the_known_number_of_bonds) {
  const CellLattice lattice({rectangle(0, 0, 17, 99)});
  const Network network = build_network(lattice, 4, bond_based(1, PlaneState::stress, 1));
  EXPECT_EQ(bonds_cut_by(points_of(lattice), network.bonds, {{8.5, 39.5}, {8.5, 59.5}}).size(), 730u);
  EXPECT_TRUE(points_on(points_of(lattice), {{8.5, 39.5}, {8.5, 59.5}}).empty());
}

TEST(Crack, touching_counts_as_cut) {
  const CellLattice lattice({rectangle(0, 0, 4, 4)});
  const std::vector<Bond> bonds = {{lattice.find_point({1, 1}), lattice.find_point({3, 1}), 1}};
  EXPECT_EQ(bonds_cut_by(points_of(lattice), bonds, {{2, 1}, {2, 3}}).size(), 1u);          // tip on the bond
  EXPECT_EQ(bonds_cut_by(points_of(lattice), bonds, {{2, 1 + 1e-10}, {2, 3}}).size(), 1u);  // within tolerance
  EXPECT_EQ(bonds_cut_by(points_of(lattice), bonds, {{2, 1 + 1e-8}, {2, 3}}).size(), 0u);
  EXPECT_EQ(bonds_cut_by(points_of(lattice), bonds, {{0, 1}, {1, 1}}).size(), 1u);    // collinear, end to end
  EXPECT_EQ(bonds_cut_by(points_of(lattice), bonds, {{0, 1}, {0.9, 1}}).size(), 0u);  // collinear, apart
  EXPECT_EQ(bonds_cut_by(points_of(lattice), bonds, {{0, 0.5}, {2, 0}, {2.1, 4}}).size(), 1u);
  EXPECT_EQ(points_on(points_of(lattice), {{0.5, 0.5}, {2.5, 2.5}}).size(), 2u);
}

// Test with a crack through material points at 45 degrees.
class Diagonal : public ::testing::Test {
 protected:
  bool cut(const Vector2i& p, const Vector2i& q, const std::vector<Point>& polyline, Touching touching) const {
    const std::vector<Bond> bonds = {{lattice.find_point(p), lattice.find_point(q), 1}};
    return !bonds_cut_by(points_of(lattice), bonds, polyline, touching).empty();
  }
  const CellLattice lattice{{rectangle(0, 0, 10, 10)}};
  const std::vector<Point> crack{{2, 2}, {6.5, 6.5}};
};

TEST_F(Diagonal, points_on_the_crack_stay_bonded_to_both_faces_if_wanted) {
  for (const Vector2i& other : {Vector2i(3, 5), Vector2i(5, 3), Vector2i(4, 6), Vector2i(7, 4)}) {
    EXPECT_FALSE(cut({4, 4}, other, crack, Touching::spares_bonds_ending_on_it)) << other.transpose();
    EXPECT_FALSE(cut(other, {4, 4}, crack, Touching::spares_bonds_ending_on_it)) << other.transpose();
    EXPECT_TRUE(cut({4, 4}, other, crack, Touching::cuts_all)) << other.transpose();
  }
}

TEST_F(Diagonal, bonds_along_the_crack_stay_with_the_points_on_it) {
  EXPECT_FALSE(cut({3, 3}, {4, 4}, crack, Touching::spares_bonds_ending_on_it));
  EXPECT_FALSE(cut({6, 6}, {7, 7}, crack, Touching::spares_bonds_ending_on_it));  // over the tip
  EXPECT_FALSE(cut({1, 1}, {2, 2}, crack, Touching::spares_bonds_ending_on_it));  // ends at the tip
  EXPECT_TRUE(cut({3, 3}, {4, 4}, crack, Touching::cuts_all));
  EXPECT_TRUE(cut({1, 1}, {2, 2}, crack, Touching::cuts_all));
}

TEST_F(Diagonal, bonds_between_points_off_the_crack_are_cut_by_touching) {
  for (const Touching touching : {Touching::cuts_all, Touching::spares_bonds_ending_on_it}) {
    EXPECT_TRUE(cut({3, 4}, {4, 3}, crack, touching));
    EXPECT_TRUE(cut({3, 5}, {5, 3}, crack, touching));                   // through a material point
    EXPECT_TRUE(cut({6, 7}, {7, 6}, crack, touching));                   // touches the tip
    EXPECT_TRUE(cut({0, 4}, {3, 4}, {{1, 4}, {1.5, 4}}, touching));      // a crack inside the bond
    EXPECT_FALSE(cut({7, 8}, {8, 7}, crack, touching));                  // ahead of the tip
    EXPECT_TRUE(cut({6, 7}, {7, 6}, {{5, 5.5}, {6.5, 6.5}}, touching));  // another direction, the same tip
    EXPECT_FALSE(cut({6, 7}, {7, 6}, {{5, 5.5}, {6.5, 6.49}}, touching));
  }
}

TEST_F(Diagonal, a_second_leg_of_the_crack_cuts_the_bonds_of_points_on_the_first) {
  const std::vector<Point> kinked{{2, 2}, {6, 6}, {6, 4.5}};
  EXPECT_TRUE(cut({5, 5}, {7, 5}, kinked, Touching::spares_bonds_ending_on_it));
  EXPECT_FALSE(cut({5, 5}, {5, 3}, kinked, Touching::spares_bonds_ending_on_it));
  // The tip of the second leg touches the bond between its ends.
  EXPECT_TRUE(cut({5, 5}, {7, 4}, kinked, Touching::spares_bonds_ending_on_it));
  EXPECT_TRUE(cut({5, 5}, {7, 5}, {{2, 2}, {5, 5}, {6, 4}, {6, 5}}, Touching::spares_bonds_ending_on_it));
}

// The segments of a polyline cut for themselves what it cuts.
TEST(Crack, polyline_cuts_what_its_segments_cut) {
  const CellLattice lattice({rectangle(0, 0, 30, 20)});
  const Network network = build_network(lattice, 3, bond_based(1, PlaneState::stress, 1));
  const std::vector<Point> points = points_of(lattice);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-5, 35), y(-5, 25);
  std::uniform_int_distribution<int> half(0, 40);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Point> polyline{{x(random), y(random)}};
    for (int k = 0; k < 25; ++k) {
      // Some vertices on points, bonds and lines of the lattice; and some legs that end far away.
      polyline.push_back(k % 3 == 0 ? Point(0.5 * half(random), 0.5 * half(random)) : Point(x(random), y(random)));
      if (k == 20) polyline.back() *= 1e6;
    }
    std::set<int> expected;
    for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
      for (const int b : bonds_cut_by(points, network.bonds, {polyline[k], polyline[k + 1]})) expected.insert(b);
    const std::vector<int> cut = bonds_cut_by(points, network.bonds, polyline);
    EXPECT_EQ(cut, std::vector<int>(expected.begin(), expected.end())) << trial;
    EXPECT_FALSE(cut.empty());
  }
}

// A search through all segments for every bond would take ten minutes.
TEST(Crack, fine_polyline_cuts_what_the_straight_line_cuts) {
  const CellLattice lattice({rectangle(0, 0, 200, 100)});
  const Network network = build_network(lattice, 4, bond_based(1, PlaneState::stress, 1));
  const std::vector<Point> points = points_of(lattice);
  const Point from(20.3, 30.1), to(170.7, 77.9);
  constexpr int count = 1000000;
  std::vector<Point> fine;
  for (int k = 0; k <= count; ++k) fine.push_back(from + (to - from) * k / count);
  const std::vector<int> cut = bonds_cut_by(points, network.bonds, fine, Touching::spares_bonds_ending_on_it);
  EXPECT_GT(cut.size(), 1000u);
  EXPECT_EQ(cut, bonds_cut_by(points, network.bonds, {from, to}, Touching::spares_bonds_ending_on_it));
}

}  // namespace

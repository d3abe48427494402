#include <gtest/gtest.h>

#include <limits>

#include "fracture/connectivity.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/freed_parts.hpp"

namespace fracture_test {
namespace {

using namespace bempd;
using namespace bempd::fracture;
using coupling::Affine;
using coupling::EquilibriumSystem;
using coupling::Terms;

// Nodes in a row, joined by bonds along x and, two apart, again.
Terms row_of_bonds(int nodes) {
  Terms bonds;
  const auto add = [&](int i, int j) {
    bonds.first.push_back(i);
    bonds.second.push_back(j);
    bonds.cosine.push_back(1);
    bonds.sine.push_back(0);
    bonds.length.push_back(j - i);
    bonds.stiffness.push_back(1);
  };
  for (int i = 0; i + 1 < nodes; ++i) add(i, i + 1);
  for (int i = 0; i + 2 < nodes; ++i) add(i, i + 2);
  return bonds;
}

TEST(StretchRatios, next_break_is_found_in_closed_form_both_ways) {
  const Terms bonds = row_of_bonds(3);
  StretchRatios ratios(bonds, {0.1, 0.1, 0.1});
  Affine u = Affine::Zero(6, 2);
  u(2, 1) = 0.01;                  // node 1 moves with the load factor
  u(4, 0) = 0.05, u(4, 1) = 0.04;  // node 2 also without load
  ratios.update(u);
  const std::vector<char> intact(3, 1);
  // bond 0: 0.01 f, bond 1: 0.05 + 0.03 f, bond 2: (0.05 + 0.04 f) / 2
  EXPECT_NEAR(*ratios.next_break(intact, 0, 100), 0.05 / 0.03, 1e-14);
  EXPECT_FALSE(ratios.next_break(intact, 0, 1));
  EXPECT_FALSE(ratios.next_break(intact, 0, -std::numeric_limits<double>::infinity()));
  EXPECT_EQ(*ratios.next_break(intact, 2, 100), 2);
  EXPECT_NEAR(*ratios.next_break({1, 0, 1}, 0, 100), 0.15 / 0.04, 1e-14);
  EXPECT_FALSE(ratios.next_break({0, 0, 0}, 0, 100));
}

TEST(StretchRatios, bonds_without_critical_stretch_never_break) {
  const Terms bonds = row_of_bonds(3);
  StretchRatios ratios(bonds, std::vector<double>(3, std::numeric_limits<double>::infinity()));
  Affine u = Affine::Zero(6, 2);
  u(4, 1) = 1;
  ratios.update(u);
  EXPECT_FALSE(ratios.next_break({1, 1, 1}, 0, 1e300));
}

TEST(StretchRatios, ties_within_the_band_break_together_in_bond_order) {
  const Terms bonds = row_of_bonds(4);
  StretchRatios ratios(bonds, std::vector<double>(5, 1.0));
  Affine u = Affine::Zero(8, 2);
  u(2, 1) = 1.0, u(4, 1) = 1.9, u(6, 1) = 2.9 - 1e-12;
  ratios.update(u);
  const std::vector<char> intact(5, 1);
  EXPECT_EQ(ratios.most_stretched(intact, 1, 1e-3, 0), (std::vector<int>{0, 2}));
  EXPECT_EQ(ratios.most_stretched(intact, 1, 0.2, 0), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(ratios.most_stretched(intact, 1, 0.2, 1), (std::vector<int>{0}));
}

TEST(Connectivity, pieces_follow_the_intact_bonds) {
  EquilibriumSystem system(5, {}, row_of_bonds(5), std::vector<char>(10, 0));
  const Connectivity connectivity(system);
  EXPECT_EQ(connectivity.pieces().size(), 1u);
  const std::vector<int> cut{1, 4, 5};  // 1-2, 0-2, 1-3
  system.stages().mark(system.stages().breaking(cut));
  EXPECT_FALSE(connectivity.still_joined(cut));
  EXPECT_EQ(connectivity.pieces(), (std::vector<std::vector<int>>{{0, 1}, {2, 3, 4}}));
}

TEST(Connectivity, a_bond_bridged_by_a_common_neighbour_leaves_the_pieces_alone) {
  EquilibriumSystem system(5, {}, row_of_bonds(5), std::vector<char>(10, 0));
  const Connectivity connectivity(system);
  const std::vector<int> cut{1};
  system.stages().mark(system.stages().breaking(cut));
  EXPECT_TRUE(connectivity.still_joined(cut));
}

TEST(FreedParts, a_point_whose_bonds_lie_on_one_line_is_held_across_it) {
  std::vector<char> prescribed(6, 0);
  prescribed[0] = prescribed[1] = prescribed[4] = prescribed[5] = 1;
  EquilibriumSystem system(3, {}, row_of_bonds(3), prescribed);
  const std::vector<Point> positions{{0, 0}, {1, 0}, {2, 0}};
  const FreedPartFinder finder(system, positions);
  const FreedParts found = finder.all_pieces(Eigen::VectorXd::Constant(6, 0.25));
  ASSERT_EQ(found.springs.size(), 1u);
  EXPECT_EQ(found.springs[0].node, 1);
  EXPECT_NEAR(std::abs(found.springs[0].sine), 1, 1e-12);
  EXPECT_NEAR(std::abs(found.springs[0].anchor), 0.25, 1e-12);
  EXPECT_EQ(found.fragments, 0);
}

TEST(FreedParts, an_isolated_point_is_a_fragment_and_loses_its_load) {
  EquilibriumSystem system(2, {}, Terms(row_of_bonds(2)), {1, 1, 0, 0});
  Affine force = Affine::Zero(4, 2);
  force(2, 1) = 1;
  system.set_load(force, Affine::Zero(4, 2));
  const std::vector<int> cut{0};
  system.stages().mark(system.stages().breaking(cut));
  const std::vector<Point> positions{{0, 0}, {1, 0}};
  const FreedParts found = FreedPartFinder(system, positions).after_break(cut, Eigen::VectorXd::Zero(4));
  EXPECT_EQ(found.fragments, 1);
  EXPECT_EQ(found.springs.size(), 2u);
  EXPECT_EQ(found.nodes_with_lost_loads, (std::vector<int>{1}));
}

}  // namespace
}  // namespace fracture_test

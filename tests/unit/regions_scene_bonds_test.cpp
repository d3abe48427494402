// Bonds of a region by their numbers in the scene: a row of three points whose last one has a bond to another region.
#include <gtest/gtest.h>

#include "regions/lattice/scene_bonds.hpp"

namespace regions_scene_bonds_test {
namespace {

using namespace bempd;
using regions::SceneBonds;

SceneBonds row_of_three() {
  SceneBonds bonds;
  pd::Network network;
  network.bonds = {{0, 1, 1.0}, {1, 2, 1.0}, {2, 3, 1.0}};
  bonds.network = std::make_shared<const pd::Network>(std::move(network));
  bonds.first = 5;
  bonds.listed = 2;
  bonds.of_scene = {5, 6, 1};
  bonds.far_nodes = {7};
  bonds.far_points = {Point(3, 0)};
  return bonds;
}

TEST(SceneBonds, have_consecutive_numbers_unless_a_list_gives_them) {
  SceneBonds bonds = row_of_three();
  EXPECT_EQ(bonds.number(2), 1u);
  bonds.of_scene.clear();
  EXPECT_EQ(bonds.number(0), 5u);
  EXPECT_EQ(bonds.number(2), 7u);
}

TEST(SceneBonds, count_lost_bonds_at_own_points_by_their_state_in_the_scene) {
  const SceneBonds bonds = row_of_three();
  std::vector<char> intact(8, 1);
  EXPECT_EQ(bonds.damage(intact, 3), std::vector<double>({0, 0, 0}));
  intact[1] = 0;  // the bond to the other region
  EXPECT_EQ(bonds.broken(intact), std::vector<std::uint8_t>({0, 0, 1}));
  EXPECT_EQ(bonds.damage(intact, 3), std::vector<double>({0, 0, 0.5}));
  intact[5] = 0;
  EXPECT_EQ(bonds.damage(intact, 3), std::vector<double>({1, 0.5, 0.5}));
}

}  // namespace
}  // namespace regions_scene_bonds_test

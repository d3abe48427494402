#include <gtest/gtest.h>

#include "geometry/boundary_mesh.hpp"

namespace {

using namespace bempd;

TEST(BoundaryMesh, square_has_shared_displacement_nodes_and_double_tractions_at_corners) {
  const Point corner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Panel> loop;
  for (int k = 0; k < 4; ++k) loop.push_back({corner[k], corner[(k + 1) % 4], element_stations(1, 0.5)});
  const BoundaryMesh mesh = mesh_boundary({loop});
  EXPECT_EQ(mesh.elements.size(), 8u);
  EXPECT_EQ(mesh.nodes.size(), 16u);
  EXPECT_EQ(mesh.traction_node_count, 4 * 5);
  EXPECT_EQ(mesh.elements.back().nodes[2], 0);
  EXPECT_EQ(mesh.elements[0].traction_nodes[2], mesh.elements[1].traction_nodes[0]);
  EXPECT_NE(mesh.elements[1].traction_nodes[2], mesh.elements[2].traction_nodes[0]);
}

TEST(BoundaryMesh, graded_stations_are_symmetric_and_finest_at_the_ends) {
  const auto s = element_stations(1.0, 0.1, 2.0);
  ASSERT_EQ(s.size(), 11u);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_NEAR(s[i] + s[s.size() - 1 - i], 1.0, 1e-15);
  EXPECT_NEAR((s[2] - s[1]) / (s[1] - s[0]), 2.0, 1e-12);
}

TEST(BoundaryMesh, a_length_that_divides_up_to_rounding_gains_no_element) {
  EXPECT_EQ(element_stations(0.3, 0.1).size(), 4u);
  EXPECT_EQ(element_stations(49.5, 5.0).size(), 11u);
}

}  // namespace

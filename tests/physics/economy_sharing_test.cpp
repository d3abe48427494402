// Regions that differ by a translation share what is dear to build; of lattices the spacing may differ too.
#include <gtest/gtest.h>

#include "regions/discretization.hpp"

namespace {

using namespace bempd;
using namespace bempd::model;

std::vector<Point> rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Material stiff(double young) { return {{young, 1.0 / 3, PlaneState::stress, 0.1}}; }

TEST(Sharing, lattices_of_equal_cells_horizon_and_material_have_one_network) {
  for (const char* scheme : {"symmetric", "paper"}) {
    Scene scene;
    const int id = scene.add_material(stiff(3e9)), other = scene.add_material(stiff(4e9));
    scene.add_lattice_region(id, rectangle(0.1, 0.2, 1, 0.6), 0.1, 3);
    scene.add_lattice_region(id, rectangle(1.3, 0.3, 1, 0.6), 0.1, 3);
    scene.add_lattice_region(id, rectangle(2.7, 0.3, 5, 3), 0.5, 3);
    scene.add_lattice_region(id, rectangle(0.1, 1.2, 1, 0.6), 0.1, 4);
    scene.add_lattice_region(id, rectangle(1.3, 1.2, 1, 0.7), 0.1, 3);
    scene.add_lattice_region(other, rectangle(0.1, 2.2, 1, 0.6), 0.1, 3);
    Options options;
    options.set_text("scheme", scheme);
    const Discretization d = discretize(scene, options);
    for (int same : {1, 2}) EXPECT_EQ(d.lattices[same].network, d.lattices[0].network) << same;
    for (int different : {3, 4, 5}) EXPECT_NE(d.lattices[different].network, d.lattices[0].network) << different;
    EXPECT_GT(d.lattices[1].first_bond, 0u);
    EXPECT_EQ(d.lattices[1].bonds().size(), d.lattices[2].first_bond - d.lattices[1].first_bond);
  }
}

TEST(Sharing, boundaries_of_equal_mesh_and_material_have_one_operator) {
  for (const char* scheme : {"symmetric", "paper"}) {
    Scene scene;
    const int id = scene.add_material(stiff(3e9)), other = scene.add_material(stiff(4e9));
    scene.add_boundary_region(id, rectangle(0.1, 0.2, 1, 0.6), 0.2);
    scene.add_boundary_region(id, rectangle(1.3, 0.3, 1, 0.6), 0.2);
    scene.add_boundary_region(id, rectangle(2.7, 0.3, 1, 0.6 + 1e-9), 0.2);
    scene.add_boundary_region(other, rectangle(0.1, 2.2, 1, 0.6), 0.2);
    Options options;
    options.set_text("scheme", scheme);
    const Discretization d = discretize(scene, options);
    EXPECT_EQ(d.boundaries[1].boundary_operator, d.boundaries[0].boundary_operator);
    for (int different : {2, 3})
      EXPECT_NE(d.boundaries[different].boundary_operator, d.boundaries[0].boundary_operator);
    EXPECT_EQ(d.kernel_evaluations(), d.boundaries[0].boundary_operator->kernel_evaluations() +
                                          d.boundaries[2].boundary_operator->kernel_evaluations() +
                                          d.boundaries[3].boundary_operator->kernel_evaluations());
  }
}

}  // namespace

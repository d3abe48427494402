// Regions that differ by a translation share what is dear to build; of lattices the spacing may differ too.
#include <gtest/gtest.h>

#include "regions/boundary/boundary_region.hpp"
#include "regions/discretization.hpp"
#include "regions/lattice/lattice_region.hpp"
#include "regions/scheme.hpp"

namespace economy_sharing_test {
namespace {

using namespace bempd;
using namespace bempd::regions;
using scene::Material;
using scene::Options;
using scene::Scene;

std::vector<Point> rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

const std::shared_ptr<const pd::Network>& network_of(const Discretization& d, int index) {
  return dynamic_cast<const LatticeRegion&>(*d.regions[index]).network();
}

const bem::BoundaryOperator* operator_of(const Discretization& d, int index) {
  return dynamic_cast<const BoundaryRegion&>(*d.regions[index]).operators()->whole();
}

Material stiff(double young) { return {{young, 1.0 / 3, PlaneState::stress, 0.1}}; }

TEST(Sharing, lattices_of_equal_cells_horizon_and_material_have_one_network) {
  for (const std::string& scheme : scheme_names()) {
    Scene scene;
    const int id = scene.add_material(stiff(3e9)), other = scene.add_material(stiff(4e9));
    add_peridynamic_region(scene, id, rectangle(0.1, 0.2, 1, 0.6), 0.1, 3);
    add_peridynamic_region(scene, id, rectangle(1.3, 0.3, 1, 0.6), 0.1, 3);
    add_peridynamic_region(scene, id, rectangle(2.7, 0.3, 5, 3), 0.5, 3);
    add_peridynamic_region(scene, id, rectangle(0.1, 1.2, 1, 0.6), 0.1, 4);
    add_peridynamic_region(scene, id, rectangle(1.3, 1.2, 1, 0.7), 0.1, 3);
    add_peridynamic_region(scene, other, rectangle(0.1, 2.2, 1, 0.6), 0.1, 3);
    Options options;
    options.set_text("scheme", scheme);
    const Discretization d = discretize(scene, options);
    for (int same : {1, 2}) EXPECT_EQ(network_of(d, same), network_of(d, 0)) << same;
    for (int different : {3, 4, 5}) EXPECT_NE(network_of(d, different), network_of(d, 0)) << different;
    EXPECT_GT(d.regions[1]->bonds()->first_bond(), 0u);
    EXPECT_EQ(d.regions[1]->bonds()->list().size(),
              d.regions[2]->bonds()->first_bond() - d.regions[1]->bonds()->first_bond());
  }
}

TEST(Sharing, boundaries_of_equal_mesh_and_material_have_one_operator) {
  for (const std::string& scheme : scheme_names()) {
    Scene scene;
    const int id = scene.add_material(stiff(3e9)), other = scene.add_material(stiff(4e9));
    add_boundary_region(scene, id, rectangle(0.1, 0.2, 1, 0.6), 0.2);
    add_boundary_region(scene, id, rectangle(1.3, 0.3, 1, 0.6), 0.2);
    add_boundary_region(scene, id, rectangle(2.7, 0.3, 1, 0.6 + 1e-9), 0.2);
    add_boundary_region(scene, other, rectangle(0.1, 2.2, 1, 0.6), 0.2);
    Options options;
    options.set_text("scheme", scheme);
    const Discretization d = discretize(scene, options);
    EXPECT_EQ(operator_of(d, 1), operator_of(d, 0));
    for (int different : {2, 3}) EXPECT_NE(operator_of(d, different), operator_of(d, 0));
    EXPECT_EQ(d.statistics().kernel_evaluations, operator_of(d, 0)->kernel_evaluations() +
                                                     operator_of(d, 2)->kernel_evaluations() +
                                                     operator_of(d, 3)->kernel_evaluations());
  }
}

}  // namespace
}  // namespace economy_sharing_test

// The coupled stiffness as a matrix: symmetric, positive semidefinite, rigid motions and nothing else without energy.
#include <gtest/gtest.h>

#include <cstdio>

#include "dense.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/discretization.hpp"
#include "regions/lattice/peridynamic_description.hpp"

namespace coupled_operator_test {
namespace {

using namespace bempd;
using namespace bempd::regions;
using scene::Material;
using scene::Options;
using scene::Scene;

std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Scene sandwich(PlaneState state, int horizon_ratio) {
  Scene scene;
  Material material;
  material.elasticity = {30e9, bond_based_poisson_ratio(state), state, 0.02};
  const int id = scene.add_material(material);
  add_boundary_region(scene, id, rectangle(0, 0, 4, 7), 2.0);
  add_peridynamic_region(scene, id, rectangle(4, 0, 16, 7), 1.0, horizon_ratio);
  add_boundary_region(scene, id, rectangle(16, 0, 20, 7), 2.0);
  return scene;
}

Scene box_in_plate(PlaneState state, int horizon_ratio) {
  Scene scene;
  Material material;
  material.elasticity = {30e9, bond_based_poisson_ratio(state), state, 0.02};
  const int id = scene.add_material(material);
  const int plate = add_boundary_region(scene, id, rectangle(0, 0, 24, 20), 4.0);
  scene.shape_of(plate).add_hole({{6, 5}, {6, 15}, {16, 15}, {16, 5}});
  add_peridynamic_region(scene, id, rectangle(6, 5, 16, 15), 1.0, horizon_ratio);
  return scene;
}

Eigen::MatrixXd assemble(const Discretization& d) {
  const auto size = 2 * static_cast<Eigen::Index>(d.positions.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (const coupling::DenseOperator& op : d.dense_operators()) {
    std::vector<int> dofs;
    for (int node : op.nodes) dofs.insert(dofs.end(), {2 * node, 2 * node + 1});
    matrix(dofs, dofs) += *op.stiffness;
  }
  const coupling::Terms& bonds = d.bonds;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const std::vector<int> dofs{2 * bonds.first[b], 2 * bonds.first[b] + 1, 2 * bonds.second[b],
                                2 * bonds.second[b] + 1};
    const Eigen::Vector4d direction(-bonds.cosine[b], -bonds.sine[b], bonds.cosine[b], bonds.sine[b]);
    matrix(dofs, dofs) += bonds.stiffness[b] * direction * direction.transpose();
  }
  return matrix;
}

struct Case {
  PlaneState state;
  int horizon_ratio;
  bool box;
};

class CoupledOperator : public testing::TestWithParam<Case> {};

TEST_P(CoupledOperator, is_symmetric_with_three_zero_energy_modes_and_positive_bonds) {
  const auto [state, horizon_ratio, box] = GetParam();
  const Scene scene = box ? box_in_plate(state, horizon_ratio) : sandwich(state, horizon_ratio);
  const Discretization d = discretize(scene, Options());
  for (double stiffness : d.bonds.stiffness) ASSERT_GT(stiffness, 0);

  const Eigen::MatrixXd matrix = assemble(d);
  const double scale = matrix.cwiseAbs().maxCoeff();
  const double asymmetry = (matrix - matrix.transpose()).cwiseAbs().maxCoeff() / scale;
  Eigen::VectorXd values = dense::eigenvalues(matrix);
  values /= values.maxCoeff();
  std::printf("asymmetry %.1e, eigenvalues over the largest %.1e %.1e %.1e | %.1e (reference: three zeros)\n",
              asymmetry, values[0], values[1], values[2], values[3]);
  EXPECT_LE(asymmetry, 1e-14);
  EXPECT_LE(std::abs(values[0]), 1e-12);
  EXPECT_LE(std::abs(values[2]), 1e-12);
  EXPECT_GE(values[3], 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CoupledOperator,
                         testing::Values(Case{PlaneState::stress, 3, false}, Case{PlaneState::stress, 4, false},
                                         Case{PlaneState::stress, 5, false}, Case{PlaneState::strain, 4, false},
                                         Case{PlaneState::stress, 3, true}, Case{PlaneState::strain, 4, true}));

}  // namespace
}  // namespace coupled_operator_test

// Subdomains of a boundary element body against one operator of the whole body: energy of the same displacements, with
// the order in which finer cuts converge.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "bem/galerkin_operator.hpp"
#include "physics/bem_bodies.hpp"
#include "regions/boundary/region_subdomains.hpp"

namespace bem_subdomains_test {
namespace {

using namespace bempd;
using namespace bempd::bem_test;

std::vector<Panel> round_hole(const Point& centre, double radius, int elements_of_quarter) {
  constexpr double quarter = std::numbers::pi / 2;
  const auto at = [&](int k) -> Point {
    return centre + radius * Point(std::cos(k * quarter), -std::sin(k * quarter));
  };
  std::vector<Panel> loop;
  for (int k = 0; k < 4; ++k)
    loop.push_back({at(k), at(k + 1), element_stations(1, 1.0 / elements_of_quarter), -quarter});
  return loop;
}

BoundaryMesh plate_with_holes(int refinement) {
  return mesh_boundary({rectangle(3, 2, 0.25 / refinement), round_hole({0.6, 0.7}, 0.3, 4 * refinement),
                        round_hole({1.6, 1.3}, 0.4, 4 * refinement), round_hole({2.4, 0.5}, 0.25, 4 * refinement)});
}

// Stiffness of all nodes, those on cuts included.
Eigen::MatrixXd assembled(const regions::RegionSubdomains& subdomains, const BoundaryMesh& whole) {
  const auto size = 2 * static_cast<Eigen::Index>(whole.nodes.size() + subdomains.cut_nodes().size());
  Eigen::SparseMatrix<double> trace(size, size);
  trace.setIdentity();
  std::vector<int> nodes(static_cast<std::size_t>(size) / 2);
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = static_cast<int>(i);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const coupling::DenseOperator& one : subdomains.dense_operators(nodes, trace, coupling::Affine(0, 2)))
    for (std::size_t i = 0; i < one.nodes.size(); ++i)
      for (std::size_t j = 0; j < one.nodes.size(); ++j)
        sum.block<2, 2>(2 * one.nodes[i], 2 * one.nodes[j]) +=
            one.stiffness->block<2, 2>(2 * static_cast<Eigen::Index>(i), 2 * static_cast<Eigen::Index>(j));
  return sum;
}

// Energy of the plate stretched along x at its two ends, all else free, from a stiffness whose first nodes are those of
// the mesh.
double energy_of(const Eigen::MatrixXd& stiffness, const BoundaryMesh& mesh) {
  std::vector<bool> fixed(static_cast<std::size_t>(stiffness.rows()), false);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(stiffness.rows());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double x = mesh.nodes[i].x();
    if (x > 0 && x < 3) continue;
    fixed[2 * i] = fixed[2 * i + 1] = true;
    values[2 * static_cast<Eigen::Index>(i)] = x;
  }
  const Eigen::VectorXd u = solve_supported(stiffness, Eigen::VectorXd::Zero(values.size()), fixed, values);
  return 0.5 * u.dot(stiffness * u);
}

TEST(Subdomains, cost_less_accuracy_than_the_elements_and_converge_with_them) {
  const PlaneElasticity elasticity{2, 0.3, PlaneState::stress, 1};
  const bem::AssemblyOptions assembly{1e-14, 1};
  std::vector<double> whole, cut;
  for (const int refinement : {1, 2, 3}) {
    const BoundaryMesh mesh = plate_with_holes(refinement);
    whole.push_back(energy_of(bem::GalerkinOperator(mesh, elasticity, assembly).stiffness(), mesh));
    if (refinement == 3) break;
    regions::RegionSubdomains subdomains(subdivide(mesh, 45), mesh);
    ASSERT_GE(subdomains.count(), 3U);
    subdomains.build(elasticity, assembly, {});
    cut.push_back(energy_of(assembled(subdomains, mesh), mesh));
    std::printf("%zu elements in %zu subdomains: energy %.10f, of one operator %.10f, %+.1e off\n",
                mesh.elements.size(), subdomains.count(), cut.back(), whole.back(), cut.back() / whole.back() - 1);
  }
  const auto error_of_cuts = [&](std::size_t i) { return std::abs(cut[i] - whole[i]); };
  for (const std::size_t i : {0, 1}) EXPECT_LE(error_of_cuts(i), std::abs(whole[i] - whole[2]) / 3);
  EXPECT_LE(error_of_cuts(1), error_of_cuts(0) / 8);
}

}  // namespace
}  // namespace bem_subdomains_test

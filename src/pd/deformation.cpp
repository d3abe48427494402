#include "pd/deformation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <numbers>

namespace bempd::pd {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Symmetric tensors as vectors (xx, yy, sqrt2 xy), whose products are those of the tensors.
Vector3d dyad(const Vector2d& e) { return {e.x() * e.x(), e.y() * e.y(), std::numbers::sqrt2 * e.x() * e.y()}; }

// Solves a x = b; what no bond resists (single rows of points) is not strained.
Vector3d solve_semidefinite(const Matrix3d& a, const Vector3d& b) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> modes(a);
  Vector3d x = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = modes.eigenvalues()[k];
    if (value > 1e-10 * modes.eigenvalues()[2])
      x += modes.eigenvectors().col(k).dot(b) / value * modes.eigenvectors().col(k);
  }
  return x;
}

}  // namespace

std::vector<Vector3d> bond_strains(int point_count, const Network& network, const std::vector<std::uint8_t>& broken,
                                   const Eigen::Ref<const Eigen::VectorXd>& displacements) {
  assert(broken.empty() || broken.size() == network.bonds.size());
  assert(displacements.size() == 2 * point_count);
  // Relative to the stiffest bond, so that units do not matter.
  double unit = 0;
  for (const Bond& bond : network.bonds) unit = std::max(unit, bond.stiffness);
  std::vector<Matrix3d> response(point_count, Matrix3d::Zero());
  std::vector<Vector3d> carried(point_count, Vector3d::Zero());
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const Bond& bond = network.bonds[b];
    const BondOffset& offset = network.offsets[network.offset_of[b]];
    const double stiffness = bond.stiffness / unit;
    const Vector3d direction = dyad(offset.direction);
    const Matrix3d resistance = stiffness * offset.length * offset.length * direction * direction.transpose();
    response[bond.first] += resistance, response[bond.second] += resistance;
    if (!broken.empty() && broken[b]) continue;
    const Vector2d difference = displacements.segment<2>(2 * bond.second) - displacements.segment<2>(2 * bond.first);
    const Vector3d moment = stiffness * offset.length * offset.direction.dot(difference) * direction;
    carried[bond.first] += moment, carried[bond.second] += moment;
  }
  std::vector<Vector3d> strains(point_count);
  for (int i = 0; i < point_count; ++i) {
    strains[i] = solve_semidefinite(response[i], carried[i]);
    strains[i].z() /= std::numbers::sqrt2;
  }
  return strains;
}

Vector3d stress_of(const Vector3d& strain, const PlaneElasticity& elasticity) {
  const double c11 = elasticity.c11(), c12 = elasticity.c12();
  return {c11 * strain.x() + c12 * strain.y(), c12 * strain.x() + c11 * strain.y(),
          2 * elasticity.shear_modulus() * strain.z()};
}

}  // namespace bempd::pd

#include "pd/deformation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cassert>

namespace bempd::pd {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// G minimises sum w |du - G xi|^2: G = (sum w du xi^T) (sum w xi xi^T)^-1.
Matrix2d fitted_gradient(const Matrix2d& shape, const Matrix2d& mixed) {
  const double trace = shape.trace();
  if (!(trace > 0)) return Matrix2d::Zero();
  // Bonds span the plane unless they are parallel; steps between lattice places are either exactly parallel or clearly
  // not.
  if (shape.determinant() > 1e-10 * trace * trace) return mixed * shape.inverse();
  const Vector2d along = Eigen::SelfAdjointEigenSolver<Matrix2d>(shape).eigenvectors().col(1);
  const Vector2d across(-along.y(), along.x()), moved = mixed * along / trace;
  return along.dot(moved) * along * along.transpose() +
         across.dot(moved) * (across * along.transpose() - along * across.transpose());
}

}  // namespace

std::vector<Matrix2d> displacement_gradients(int point_count, const Network& network,
                                             const std::vector<std::uint8_t>& broken,
                                             const Eigen::Ref<const Eigen::VectorXd>& displacements) {
  assert(broken.empty() || broken.size() == network.bonds.size());
  assert(displacements.size() == 2 * point_count);
  std::vector<Matrix2d> shape(point_count, Matrix2d::Zero()), mixed(point_count, Matrix2d::Zero());
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    if (!broken.empty() && broken[b]) continue;
    const Bond& bond = network.bonds[b];
    const BondOffset& offset = network.offsets[network.offset_of[b]];
    // Relative to the bulk, so that the units of stiffness do not matter.
    const double weight = offset.bulk_stiffness;
    const Vector2d& step = offset.step;
    const Vector2d difference = displacements.segment<2>(2 * bond.second) - displacements.segment<2>(2 * bond.first);
    const Matrix2d s = weight * step * step.transpose(), d = weight * difference * step.transpose();
    shape[bond.first] += s, shape[bond.second] += s;
    mixed[bond.first] += d, mixed[bond.second] += d;
  }
  std::vector<Matrix2d> gradients(point_count);
  for (int i = 0; i < point_count; ++i) gradients[i] = fitted_gradient(shape[i], mixed[i]);
  return gradients;
}

Eigen::Vector3d stress_of(const Matrix2d& gradient, const PlaneElasticity& elasticity) {
  const double xx = gradient(0, 0), yy = gradient(1, 1), c11 = elasticity.c11(), c12 = elasticity.c12();
  return {c11 * xx + c12 * yy, c12 * xx + c11 * yy, elasticity.shear_modulus() * (gradient(0, 1) + gradient(1, 0))};
}

}  // namespace bempd::pd

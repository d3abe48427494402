#include "pd/deformation.hpp"

#include <Eigen/Eigenvalues>

namespace bempd::pd {

namespace {

// Bonds that lie on one line up to this share do not tell the gradient across it.
constexpr double collinear = 1e-8;

Eigen::Matrix2d pseudo_inverse(const Eigen::Matrix2d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(symmetric);
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
  for (int k = 0; k < 2; ++k) {
    const double value = eigen.eigenvalues()[k];
    if (value <= collinear * eigen.eigenvalues()[1]) continue;
    inverse += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose() / value;
  }
  return inverse;
}

}  // namespace

std::vector<Eigen::Matrix2d> displacement_gradients(const CellLattice& lattice, const std::vector<Bond>& bonds,
                                                    const std::vector<char>& intact,
                                                    const Eigen::VectorXd& displacement) {
  const auto count = static_cast<std::size_t>(lattice.point_count());
  std::vector<Eigen::Matrix2d> moment(count, Eigen::Matrix2d::Zero()), change(count, Eigen::Matrix2d::Zero());
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (!intact[b]) continue;
    const int i = bonds[b].first, j = bonds[b].second;
    const Eigen::Vector2d step = (lattice.point(j) - lattice.point(i)).cast<double>();
    const Eigen::Vector2d weighted = step / step.squaredNorm();
    const Eigen::Vector2d relative = displacement.segment<2>(2 * j) - displacement.segment<2>(2 * i);
    for (int point : {i, j}) {
      moment[point] += step * weighted.transpose();
      change[point] += relative * weighted.transpose();
    }
  }
  std::vector<Eigen::Matrix2d> gradient(count);
  for (std::size_t p = 0; p < count; ++p) gradient[p] = change[p] * pseudo_inverse(moment[p]);
  return gradient;
}

Eigen::Matrix3Xd point_stresses(const CellLattice& lattice, const std::vector<Bond>& bonds,
                                const std::vector<char>& intact, const Eigen::VectorXd& displacement,
                                const PlaneElasticity& elasticity) {
  const auto gradient = displacement_gradients(lattice, bonds, intact, displacement);
  Eigen::Matrix3Xd stress(3, lattice.point_count());
  for (std::size_t p = 0; p < gradient.size(); ++p) {
    const Eigen::Matrix2d& g = gradient[p];
    stress.col(static_cast<Eigen::Index>(p)) << elasticity.c11() * g(0, 0) + elasticity.c12() * g(1, 1),
        elasticity.c12() * g(0, 0) + elasticity.c11() * g(1, 1), elasticity.shear_modulus() * (g(0, 1) + g(1, 0));
  }
  return stress;
}

}  // namespace bempd::pd

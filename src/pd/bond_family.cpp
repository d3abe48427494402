#include "pd/bond_family.hpp"

#include <Eigen/LU>
#include <cassert>
#include <cmath>

#include "pd/micromodulus.hpp"

namespace bempd::pd {

namespace {

std::vector<BondOffset> half_family(int m) {
  std::vector<BondOffset> family;
  for (int b = 0; b < m; ++b) {
    for (int a = b == 0 ? 1 : 1 - m; a < m; ++a) {
      const int square = a * a + b * b;
      if (square >= m * m) continue;
      BondOffset offset;
      offset.step = {a, b};
      offset.length = std::sqrt(static_cast<double>(square));
      offset.direction = offset.step / offset.length;
      offset.moment = Eigen::Vector4d(a * a * a, a * a * b, a * b * b, b * b * b) / square;
      family.push_back(offset);
    }
  }
  return family;
}

double kernel_weight(const BondKernel& kernel, double length, double horizon) {
  return kernel.micromodulus(length, horizon) * volume_factor(length, horizon);
}

// Contribution of a bond with the weight 1 to the elastic constants C1111, C2222 and C1122.
Eigen::Vector3d constants_of(const BondOffset& offset) {
  const double c = offset.direction.x() * offset.direction.x(), s = offset.direction.y() * offset.direction.y();
  return offset.length * Eigen::Vector3d(c * c, s * s, c * s);
}

}  // namespace

double kernel_stiffness(const BondKernel& kernel, double length, double horizon) {
  return kernel_weight(kernel, length, horizon) / length;
}

std::vector<BondOffset> bond_family(int horizon_ratio, const BondKernel& kernel) {
  assert(horizon_ratio >= 2);
  std::vector<BondOffset> family = half_family(horizon_ratio);
  // The weights w of the bonds are changed to w + diag(w) R^T mu. The columns of R are the bonds' contributions to the
  // elastic constants (constants_of()); the three numbers mu are chosen so that the new weights give the constants
  // required.
  Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
  Eigen::Vector3d missing(1, 1, 1.0 / 3);
  for (const BondOffset& offset : family) {
    const Eigen::Vector3d row = constants_of(offset);
    const double weight = kernel_weight(kernel, offset.length, horizon_ratio);
    system += weight * row * row.transpose();
    missing -= weight * row;
  }
  // Full pivoting is needed: with only two kinds of bonds, in the shortest family, C1111 = C2222 always, so the
  // equations are consistent but singular.
  const Eigen::Vector3d mu = system.fullPivLu().solve(missing);
  for (BondOffset& offset : family) {
    const double weight = kernel_weight(kernel, offset.length, horizon_ratio) * (1 + constants_of(offset).dot(mu));
    offset.bulk_stiffness = weight / offset.length;
  }
  return family;
}

}  // namespace bempd::pd

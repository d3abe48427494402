#include "pd/deformation.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <optional>

#include "geometry/elongation.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::pd {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;

// Symmetric tensor e e^T as a vector (xx, yy, sqrt2 xy), so that scalar products of vectors are those of the tensors.
Vector3d dyad(const Vector2d& e) { return {e.x() * e.x(), e.y() * e.y(), std::numbers::sqrt2 * e.x() * e.y()}; }

// Solves a x = b for positive semidefinite a; strains that no bond resists (as in single rows of points) become 0.
Vector3d solve_semidefinite(const Matrix3d& a, const Vector3d& b) {
  const linalg::SymmetricModes modes = linalg::symmetric_modes(a);
  Vector3d x = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = modes.values[k];
    if (value <= 1e-10 * modes.values[2]) continue;
    x += modes.vectors.col(k).dot(b) / value * modes.vectors.col(k);
  }
  return x;
}

// Sums over the bonds of a point, from which the strain at the point follows: `response` is the sum of the bonds'
// stiffness tensors, `carried` that of their forces times their directions.
struct PointBonds {
  Matrix3d response = Matrix3d::Zero();
  Vector3d carried = Vector3d::Zero();
  Vector2d side = Vector2d::Zero();  // weighted sum of bond vectors; 0 if bonds lie evenly on all sides
  bool whole = true;                 // whether no bond is broken or softened

  bool one_sided() const { return side.norm() > 1e-6 * response.trace(); }
};

// Linear fit of the strain around a point, with seven unknowns: three components of the strain at the point, and four
// of the strain's gradient. The strain that a bond measures, at its middle, depends only on that part of the gradient
// which is symmetric in all three indices and has four components.
struct LinearFit {
  Matrix7d response = Matrix7d::Zero();
  Vector7d carried = Vector7d::Zero();

  // Adds a bond; `moment` is its length times the third power (components 111, 112, 122, 222) of its direction as seen
  // from the point.
  void add(const Vector3d& direction, const Eigen::Vector4d& moment, double weight, double stretch) {
    Vector7d row;
    row << direction, moment;
    response += weight * row * row.transpose();
    carried += weight * stretch * row;
  }
  // Strain at the point; empty if there are too few bonds for the fit.
  std::optional<Vector3d> strain() const {
    const linalg::SymmetricModes modes = linalg::symmetric_modes(response);
    if (modes.values[0] < 1e-4 * modes.values[6]) return {};
    const Vector7d parts = modes.vectors.transpose() * carried;
    return (modes.vectors * parts.cwiseQuotient(modes.values)).head<3>();
  }
};

// Bonds of a network with their stretches under a displacement.
class BondStretches {
 public:
  BondStretches(const Network& network, const BondStates& states,
                const Eigen::Ref<const Eigen::VectorXd>& displacements)
      : network_(network), states_(states), displacements_(displacements) {
    for (const Bond& bond : network.bonds) stiffest_ = std::max(stiffest_, bond.stiffness);
  }

  std::size_t size() const { return network_.bonds.size(); }
  const Bond& bond(std::size_t b) const { return network_.bonds[b]; }
  const BondOffset& offset(std::size_t b) const { return network_.offsets[network_.offset_of[b]]; }
  double share(std::size_t b) const { return states_.share.empty() ? 1 : states_.share[b]; }
  // Stretch at which the bond `b` would carry the same force as now if it were intact and had no rest stretch.
  double stretch(std::size_t b) const {
    const Vector2d difference =
        displacements_.segment<2>(2 * bond(b).second) - displacements_.segment<2>(2 * bond(b).first);
    const Vector2d& direction = offset(b).direction;
    const double rest = states_.rest_stretch.empty() ? 0 : states_.rest_stretch[b];
    const double length = offset(b).length;
    return share(b) * (elongation_along(direction.x(), direction.y(), difference.x(), difference.y()) / length - rest);
  }
  // Weight of a bond: stiffness times squared length, with the stiffness relative to that of the stiffest bond, so that
  // units do not matter.
  double weight(std::size_t b) const { return bond(b).stiffness / stiffest_ * offset(b).length * offset(b).length; }

 private:
  const Network& network_;
  const BondStates& states_;
  Eigen::Ref<const Eigen::VectorXd> displacements_;
  double stiffest_ = 0;
};

std::vector<PointBonds> collect(int point_count, const BondStretches& bonds) {
  std::vector<PointBonds> points(point_count);
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    PointBonds &first = points[bonds.bond(b).first], &second = points[bonds.bond(b).second];
    const Vector3d direction = dyad(bonds.offset(b).direction);
    const Matrix3d response = bonds.weight(b) * direction * direction.transpose();
    first.response += response, second.response += response;
    const Vector2d side = bonds.weight(b) * bonds.offset(b).step;
    first.side += side, second.side -= side;
    if (bonds.share(b) < 1) first.whole = second.whole = false;
    if (bonds.share(b) == 0) continue;
    const Vector3d carried = bonds.weight(b) * bonds.stretch(b) * direction;
    first.carried += carried, second.carried += carried;
  }
  return points;
}

// Replaces the strains of points whose bonds lie on one side, as at faces, by the strains of a fit in which the strain
// varies linearly around the point.
void refine_at_faces(const std::vector<PointBonds>& points, const BondStretches& bonds,
                     std::vector<Vector3d>& strains) {
  std::vector<int> fit_of(points.size(), -1);
  std::vector<LinearFit> fits;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].whole || !points[i].one_sided()) continue;
    fit_of[i] = static_cast<int>(fits.size());
    fits.emplace_back();
  }
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const int first = fit_of[bonds.bond(b).first], second = fit_of[bonds.bond(b).second];
    if (first < 0 && second < 0) continue;
    const Vector3d direction = dyad(bonds.offset(b).direction);
    const Eigen::Vector4d& moment = bonds.offset(b).moment;
    const double weight = bonds.weight(b), stretch = bonds.stretch(b);
    if (first >= 0) fits[first].add(direction, moment, weight, stretch);
    if (second >= 0) fits[second].add(direction, -moment, weight, stretch);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (fit_of[i] < 0) continue;
    if (const auto strain = fits[fit_of[i]].strain()) strains[i] = *strain;
  }
}

}  // namespace

std::vector<Vector3d> bond_strains(int point_count, const Network& network, const BondStates& states,
                                   const Eigen::Ref<const Eigen::VectorXd>& displacements) {
  assert(states.share.empty() || states.share.size() == network.bonds.size());
  assert(states.rest_stretch.empty() || states.rest_stretch.size() == network.bonds.size());
  assert(displacements.size() == 2 * point_count);
  const BondStretches bonds(network, states, displacements);
  const std::vector<PointBonds> points = collect(point_count, bonds);
  std::vector<Vector3d> strains;
  strains.reserve(points.size());
  for (const PointBonds& point : points) strains.push_back(solve_semidefinite(point.response, point.carried));
  refine_at_faces(points, bonds, strains);
  for (Vector3d& strain : strains) strain.z() /= std::numbers::sqrt2;
  return strains;
}

Vector3d stress_of(const Vector3d& strain, const PlaneElasticity& elasticity) {
  const double c11 = elasticity.c11(), c12 = elasticity.c12();
  return {c11 * strain.x() + c12 * strain.y(), c12 * strain.x() + c11 * strain.y(),
          2 * elasticity.shear_modulus() * strain.z()};
}

}  // namespace bempd::pd

#include "fracture/line/tip_stress.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "linalg/least_squares.hpp"

namespace bempd::fracture {

namespace {

// Measured on lattices in the field of stress intensity factors, for horizons of 3 and 4 spacings and any angle of the
// rows within 1 % (docs/directions.md): means of the stress within the reach and the cone, times the root of the reach.
constexpr double near_reach = 1.5, near_cosine = 0.5;  // in horizons
constexpr double near_opening = 0.79, near_shear = 0.482;

// Where the first terms of Williams' series are fitted, and how many: with three terms, or farther out, the load at
// which an inclined crack first grows comes out too small (docs/directions.md).
constexpr double inner_reach = 1, outer_reach = 2, fitted_cosine = 0;
constexpr int fitted_terms = 5, amplitudes_fitted = 2 * fitted_terms;

// Share of the sum of forces on a point from which on they do not balance.
constexpr double outline_pull = 0.1;

// Stress of the terms r^(-1/2), 1, r^(1/2) and so on of both modes for amplitudes of one (Williams, J. Appl. Mech. 24,
// 1957).
Eigen::Matrix<double, 3, amplitudes_fitted> williams_stress(double r, double t) {
  Eigen::Matrix<double, 3, amplitudes_fitted> stress;
  for (int n = 1; n <= fitted_terms; ++n) {
    const double h = n / 2.0, sign = n % 2 == 0 ? 1 : -1, scale = h * std::pow(r, h - 1);
    const double c1 = std::cos((h - 1) * t), c3 = std::cos((h - 3) * t);
    const double s1 = std::sin((h - 1) * t), s3 = std::sin((h - 3) * t);
    stress.col(2 * n - 2) << (2 + h + sign) * c1 - (h - 1) * c3, (2 - h - sign) * c1 + (h - 1) * c3,
        (h - 1) * s3 - (h + sign) * s1;
    stress.col(2 * n - 1) << (h - 1) * s3 - (2 + h - sign) * s1, (-2 + h - sign) * s1 - (h - 1) * s3,
        (h - 1) * c3 - (h - sign) * c1;
    stress.middleCols<2>(2 * n - 2) *= scale;
  }
  return stress;
}

// Of the area that a point inside has: the bonds of one on the outline pull it inwards under constant stress, as those
// of a point inside do not.
std::vector<double> shares_of_area(const coupling::Terms& terms, std::size_t nodes) {
  std::vector<Point> pull(nodes, Point(0, 0));
  std::vector<double> sum(nodes, 0);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (terms.is_wide(t)) continue;
    const double size = terms.stiffness[t] * terms.length[t];
    const Point along = size * Point(terms.cosine[t], terms.sine[t]);
    const auto first = static_cast<std::size_t>(terms.first[t]), second = static_cast<std::size_t>(terms.second[t]);
    pull[first] += along, pull[second] -= along;
    sum[first] += size, sum[second] += size;
  }
  std::vector<double> share(nodes, 1);
  for (std::size_t node = 0; node < nodes; ++node)
    if (pull[node].norm() > outline_pull * sum[node]) share[node] = 0.5;
  return share;
}

}  // namespace

TipStress::TipStress(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions)
    : system_(system),
      positions_(positions),
      near_(positions),
      bonds_at_(linalg::make_adjacency(positions.size(),
                                       [&](const auto& add) {
                                         const coupling::Terms& terms = system.terms();
                                         for (std::size_t t = 0; t < terms.size(); ++t) {
                                           if (terms.is_wide(t)) continue;
                                           add(terms.first[t], static_cast<int>(t));
                                           add(terms.second[t], static_cast<int>(t));
                                         }
                                       })),
      wide_at_(linalg::make_adjacency(positions.size(),
                                      [&](const auto& add) {
                                        const coupling::Terms& terms = system.terms();
                                        for (const int t : terms.wide.term)
                                          terms.for_each_node(static_cast<std::size_t>(t),
                                                              [&](int node) { add(node, t); });
                                      })),
      share_(shares_of_area(system.terms(), positions.size())) {}

Eigen::RowVector2d TipStress::tension(std::size_t term, const coupling::Affine& displacement) const {
  const coupling::Terms& terms = system_.terms();
  Eigen::RowVector2d parts;
  for (int part = 0; part < 2; ++part) {
    parts[part] =
        system_.present_stiffness()[term] * terms.elastic_elongation_part(term, displacement.col(part).data(), part) +
        terms.constant(term, part);
  }
  return parts;
}

TipStress::Stress TipStress::stress(int node, const Point& direction, const pd::TipLaw& law,
                                    const coupling::Affine& displacement) const {
  const coupling::Terms& terms = system_.terms();
  Stress sum = Stress::Zero();
  for_each_bond(node, [&](int bond) {
    const auto b = static_cast<std::size_t>(bond);
    const Point e(terms.cosine[b], terms.sine[b]);
    const double along = e.dot(direction), across = cross(direction, e);
    const Eigen::Vector3d dyad(along * along, across * across, along * across);
    const Eigen::RowVector2d force = tension(b, displacement);
    for (int part = 0; part < 2; ++part) sum.col(part) += force[part] * terms.length[b] / 2 * dyad;
  });
  for (const int t : wide_at_.of(node)) {
    const auto wide = static_cast<std::size_t>(t);
    if (!system_.intact()[wide]) continue;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    int nodes = 0;
    terms.for_each_entry(wide, [&](int at, double x, double y) {
      const Point pull(x, y),
          arm = positions_[static_cast<std::size_t>(at)] - positions_[static_cast<std::size_t>(node)];
      const double along = pull.dot(direction), across = cross(direction, pull);
      const double arm_along = arm.dot(direction), arm_across = cross(direction, arm);
      moment += Eigen::Vector3d(along * arm_along, across * arm_across, (along * arm_across + across * arm_along) / 2);
      ++nodes;
    });
    sum += moment / nodes * tension(wide, displacement);
  }
  return sum / (law.spacing * law.spacing * law.thickness * share_[static_cast<std::size_t>(node)]);
}

Point TipStress::across_tension(int bond, const pd::TipLaw& law, const coupling::Affine& displacement,
                                double load_factor) const {
  const coupling::Terms& terms = system_.terms();
  const auto b = static_cast<std::size_t>(bond);
  const Point axis(1, 0);
  const Eigen::Vector3d s =
      (stress(terms.first[b], axis, law, displacement) + stress(terms.second[b], axis, law, displacement)) *
      Eigen::Vector2d(1, load_factor);
  const double angle = std::atan2(2 * s[2], s[0] - s[1]) / 2;  // of the principal direction
  return {-std::sin(angle), std::cos(angle)};
}

void TipStress::add_nodes_asked(const GrowingTip& tip, const pd::TipLaw& law, std::vector<int>& nodes) const {
  for (const int node : near_.about(tip.place, outer_reach * law.horizon)) {
    nodes.push_back(node);
    for_each_bond(node, [&](int bond) {
      const auto b = static_cast<std::size_t>(bond);
      const coupling::Terms& terms = system_.terms();
      nodes.push_back(terms.first[b] == node ? terms.second[b] : terms.first[b]);
    });
    for (const int wide : wide_at_.of(node))
      system_.terms().for_each_node(static_cast<std::size_t>(wide), [&](int other) { nodes.push_back(other); });
  }
}

TipIntensity TipStress::at(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                           const Eigen::RowVector2d& pressure) const {
  Eigen::RowVector2d opening(0, 0), shear(0, 0);
  double total = 0;
  using Square = Eigen::Matrix<double, amplitudes_fitted, amplitudes_fitted>;
  using Parts = Eigen::Matrix<double, amplitudes_fitted, 2>;
  Square normal = Square::Zero();
  Parts right = Parts::Zero();
  for (const int number : near_.about(tip.place, outer_reach * law.horizon)) {
    const auto node = static_cast<std::size_t>(number);
    const Point step = (positions_[node] - tip.place) / law.horizon;
    const double r = step.norm(), ahead = step.dot(tip.direction);
    if (r >= outer_reach || ahead < fitted_cosine * r || bonds_at_.of(static_cast<int>(node)).empty()) continue;
    Stress s = stress(static_cast<int>(node), tip.direction, law, displacement);
    s.topRows<2>().rowwise() += pressure;
    if (r < near_reach && ahead >= near_cosine * r) {
      const double bump = 1 - r * r / (near_reach * near_reach), weight = bump * bump;
      opening += weight * s.row(1);
      shear += weight * s.row(2);
      total += weight;
    }
    if (r < inner_reach) continue;
    const double across = cross(tip.direction, step);
    const Eigen::Matrix<double, 3, amplitudes_fitted> terms = williams_stress(r, std::atan2(across, ahead));
    normal += r * terms.transpose() * terms;
    right += r * terms.transpose() * s;
  }
  TipIntensity found;
  if (total > 0) {
    const double root = std::sqrt(near_reach * law.horizon) / total;
    found.near = {opening * root / near_opening, shear * root / near_shear};
  }
  // The second term has no shear of its own: the decomposition leaves it out.
  const Parts amplitudes = linalg::LeastSquares(normal).solve(right);
  const double root = std::sqrt(2 * std::numbers::pi * law.horizon);
  found.fitted = {amplitudes.row(0) * root, -amplitudes.row(1) * root};
  return found;
}

}  // namespace bempd::fracture

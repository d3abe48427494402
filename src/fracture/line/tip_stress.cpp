#include "fracture/line/tip_stress.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "fracture/line/on_limits.hpp"
#include "fracture/line/point_moments.hpp"

namespace bempd::fracture {

namespace {

// Limits for the points to which Williams' series is fitted: least distance from the tip in horizons, away from
// surfaces (inner_reach) and beside one (inner_reach_beside), and least cosine of the angle to the tip's direction.
// With three terms, or points farther out, the load factor of an inclined crack's first growth is too small; nearer to
// the tip the lattice smooths the stress by a few percent. Beside a surface nearer points are used, because it disturbs
// the stress more (docs/directions.md).
constexpr double inner_reach = 1, fitted_cosine = 0, inner_reach_beside = 0.5;
constexpr double beside_surface = 1, away_from_surfaces = 3;

// Limits for the points whose mean stress closely ahead of a tip is used, for cracks that have begun in the run:
// largest distance from the tip, and least cosine of the angle to the tip's direction.
constexpr double near_reach = 1.5, near_cosine = 0.5;  // in horizons
// Ratios of the mean stress closely ahead of a tip to the singular field, for K_I (opening) and K_II (shear): measured
// for horizons of 3 and 4 spacings, valid within 1 % for any angle of the rows (docs/directions.md).
constexpr double near_opening = 0.79, near_shear = 0.482;

constexpr int fitted_terms = WilliamsFit::most_terms;
// Number of terms of Williams' series that are fitted near the face of another crack, where there are fewer points:
// four within three horizons of the face, two within one horizon (docs/directions.md).
constexpr int terms_near_face = 4, terms_at_face = 2;
constexpr double at_face = 1;
// Least number of stress points for a fit near the face of another crack. With fewer points, the points nearest to the
// tip are used too.
constexpr std::size_t enough_points = 6;
// Largest length of a bond between neighbours, in spacings.
constexpr double longest_short_bond = 1.3;

int terms_beside(double face, double horizon) {
  if (face >= away_from_surfaces * horizon) return fitted_terms;
  return face < (at_face - rounding_of_places) * horizon ? terms_at_face : terms_near_face;
}

}  // namespace

TipStress::TipStress(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                     const pd::TipLaws& laws)
    : system_(system),
      positions_(positions),
      laws_(laws),
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
      outline_(system.terms(), positions, laws),
      joints_(positions, near_, laws) {}

double TipStress::nearest_outline(const Point& place, double at_most) const {
  for (const int number : near_.about(place, at_most)) {
    const auto node = static_cast<std::size_t>(number);
    if (outline_.has(number)) at_most = std::min(at_most, (positions_[node] - place).norm());
  }
  return at_most;
}

// Distance from a tip to the nearest outline that disturbs the field ahead, at most three horizons [m]. A border with
// boundary elements of the same material counts only if it lies ahead of the tip, and as one horizon farther away,
// because points are missing there only within two horizons.
double TipStress::nearest_disturbance(const GrowingTip& tip, const pd::TipLaw& law) const {
  double nearest = away_from_surfaces * law.horizon;
  for (const int node : near_.about(tip.place, nearest)) {
    if (!outline_.has(node)) continue;
    const Point step = positions_[static_cast<std::size_t>(node)] - tip.place;
    const bool joined = laws_.is_joined(node);
    if (joined && step.dot(tip.direction) <= rounding_of_places * law.spacing) continue;
    nearest = std::min(nearest, step.norm() + (joined ? (away_from_surfaces - outer_reach) * law.horizon : 0));
  }
  return nearest;
}

TipStress::Reach TipStress::reach_at(double nearest_surface, double horizon) const {
  const double away = std::max(nearest_surface / horizon - beside_surface, 0.0) / (away_from_surfaces - beside_surface);
  return {std::lerp(inner_reach_beside, inner_reach, away), std::lerp(outer_reach_beside, outer_reach, away)};
}

TipSight TipStress::sight_of(const GrowingTip& tip, const pd::TipLaw& law) const {
  const coupling::Terms& terms = system_.terms();
  const double reach = away_from_surfaces * law.horizon;
  TipSight sight(tip.place, tip.direction, law.spacing);
  for (const int node : near_.about(tip.place, reach + longest_short_bond * law.spacing)) {
    for (const int bond : bonds_at_.of(node)) {
      const auto b = static_cast<std::size_t>(bond);
      if (terms.first[b] != node || system_.stages().intact()[b] || terms.length[b] > longest_short_bond * law.spacing)
        continue;
      const Point along(terms.cosine[b], terms.sine[b]);
      const Point middle = positions_[static_cast<std::size_t>(node)] + terms.length[b] / 2 * along;
      if ((middle - tip.place).norm() < reach * (1 - rounding_of_places)) sight.add_broken_bond(middle, along);
    }
  }
  return sight;
}

Eigen::RowVector2d TipStress::tension(std::size_t term, const coupling::Affine& displacement) const {
  const coupling::Terms& terms = system_.terms();
  Eigen::RowVector2d parts;
  for (int part = 0; part < 2; ++part)
    parts[part] =
        system_.stages().stiffness()[term] * terms.elastic_elongation_part(term, displacement.col(part).data(), part);
  return parts;
}

// Stress at a point: the components (xx, yy, xy), with x along `direction` and y to the left of it.
TipStress::Stress TipStress::stress(int node, const Point& direction, const pd::TipLaw& law,
                                    const coupling::Affine& displacement) const {
  const Eigen::Matrix3d* stress_of_moments = outline_.has(node) ? outline_.stress_of_moments(node) : nullptr;
  if (!stress_of_moments) return stress_times_volume(node, direction, displacement) / volume_of(node, law);
  const double c = direction.x(), s = direction.y();
  Eigen::Matrix3d turn;  // turns (xx, yy, xy) into the axes along and across `direction`
  turn << c * c, s * s, 2 * c * s, s * s, c * c, -2 * c * s, -c * s, c * s, c * c - s * s;
  return turn * *stress_of_moments * stress_times_volume(node, {1, 0}, displacement);
}

TipStress::Stress TipStress::stress_times_volume(int node, const Point& direction,
                                                 const coupling::Affine& displacement) const {
  Stress sum = Stress::Zero();
  for_each_term(node, [&](std::size_t t) {
    sum += moment_at(system_.terms(), positions_, t, node, direction) * tension(t, displacement);
  });
  return sum;
}

double TipStress::volume_of(int node, const pd::TipLaw& law) const {
  const auto n = static_cast<std::size_t>(node);
  const int number = n < laws_.of_node.size() ? laws_.of_node[n] : -1;
  const pd::TipLaw& own = number < 0 ? law : laws_.laws[static_cast<std::size_t>(number)];
  return own.spacing * own.spacing * own.thickness * outline_.share_of(node);
}

Point TipStress::across_tension(int bond, const pd::TipLaw& law, const coupling::Affine& displacement,
                                double load_factor) const {
  const coupling::Terms& terms = system_.terms();
  const auto b = static_cast<std::size_t>(bond);
  const auto stress_of = [&](int node) -> Stress {
    const Eigen::Matrix3d* stress_of_moments = outline_.stress_of_moments(node);
    if (!stress_of_moments) return stress(node, {1, 0}, law, displacement);
    return *stress_of_moments * stress_times_volume(node, {1, 0}, displacement);
  };
  const Eigen::Vector3d s = (stress_of(terms.first[b]) + stress_of(terms.second[b])) * Eigen::Vector2d(1, load_factor);
  // If both principal stresses are equal, rounding would decide their directions, so the result is perpendicular to the
  // bond.
  if (std::hypot(s[0] - s[1], 2 * s[2]) <= rounding_of_places * (std::abs(s[0]) + std::abs(s[1])))
    return {-terms.sine[b], terms.cosine[b]};
  const double angle = std::atan2(2 * s[2], s[0] - s[1]) / 2;  // of the principal direction
  return {-std::sin(angle), std::cos(angle)};
}

GrowingTip TipStress::as_fitted(GrowingTip tip) const {
  tip.place = tip.acts_at();
  return tip;
}

// Fit of stresses at a tip: number of terms and stress points, which are chosen around GrowingTip::acts_at().
TipStress::Fit TipStress::fit_of(const GrowingTip& growing, const pd::TipLaw& law) const {
  const GrowingTip tip = as_fitted(growing);
  const TipSight sight = sight_of(tip, law);
  const double face = sight.nearest_face();
  Reach reach = reach_at(std::min(face, nearest_disturbance(tip, law)), law.horizon);
  Fit fit{terms_beside(face, law.horizon), stress_points(tip, law, reach, fitted_cosine, sight)};
  std::vector<StressPoint> away_from_joints = fit.stress_points;
  std::erase_if(away_from_joints, [&](const StressPoint& s) { return joints_.are_beside(s.node); });
  if (away_from_joints.size() >= enough_points) {
    fit.stress_points = std::move(away_from_joints);
  } else if (away_from_joints.size() < fit.stress_points.size()) {
    reach = reach_at(std::min(face, nearest_outline(tip.place, away_from_surfaces * law.horizon)), law.horizon);
    fit.stress_points = stress_points(tip, law, reach, fitted_cosine, sight);
  }
  if (fit.terms < fitted_terms && fit.stress_points.size() < enough_points) {
    reach.inner = 2 * rounding_of_places;  // at the tip itself the stress is infinite
    fit.stress_points = stress_points(tip, law, reach, fitted_cosine, sight);
  }
  return fit;
}

// An edge behind the tip, as at the mouth of its crack, is not counted, because it disturbs the energy of a step more
// than the fit. A border with boundary elements of the same material is no edge, because the field of the tip continues
// beyond the border.
bool TipStress::is_crowded(const GrowingTip& tip, const pd::TipLaw& law, double reach) const {
  return is_beside_face(tip, law, reach) || std::ranges::any_of(near_.about(tip.place, reach), [&](int node) {
           const Point step = positions_[static_cast<std::size_t>(node)] - tip.place;
           return outline_.has(node) && !laws_.is_joined(node) && step.norm() < reach &&
                  step.dot(tip.direction) > rounding_of_places * reach;
         });
}

// Only the modulus distinguishes materials here: another fracture energy does not change the field around a tip.
bool TipStress::meets_other_material(const GrowingTip& tip, const pd::TipLaw& law, double reach) const {
  return std::ranges::any_of(near_.about(tip.place, reach), [&](int node) {
    const auto n = static_cast<std::size_t>(node);
    const int number = n < laws_.of_node.size() ? laws_.of_node[n] : -1;
    if (number < 0 || (positions_[n] - tip.place).norm() >= reach) return false;
    const pd::TipLaw& its = laws_.laws[static_cast<std::size_t>(number)];
    return its.modulus != law.modulus;
  });
}

// Points within a horizon of a border with boundary elements have other bonds than inner points. A border along the
// crack (at a slope below 1/4) is not counted, because it disturbs the fit less.
bool TipStress::lacks_points(const GrowingTip& tip, const pd::TipLaw& law) const {
  const double reach = away_from_surfaces * law.horizon;
  std::array<Eigen::AlignedBox2d, 2> sides;  // nodes of the border to the right and left of the crack: ahead and across
  for (const int node : near_.about(tip.place, reach)) {
    const Point step = positions_[static_cast<std::size_t>(node)] - tip.place;
    if (!laws_.is_joined(node) || step.norm() >= reach) continue;
    const double across = cross(tip.direction, step);
    sides[across > 0 ? 1 : 0].extend(Eigen::Vector2d(step.dot(tip.direction), across));
  }
  const auto is_oblique = [](const auto& side) { return !side.isEmpty() && side.sizes().y() > side.sizes().x() / 4; };
  return std::ranges::any_of(sides, is_oblique);
}

std::vector<TipStress::StressPoint> TipStress::points_closely_ahead(const GrowingTip& tip,
                                                                    const pd::TipLaw& law) const {
  return stress_points(tip, law, {0, near_reach}, near_cosine, sight_of(tip, law));
}

// Stress points; points without bonds have no stress and are left out.
std::vector<TipStress::StressPoint> TipStress::stress_points(const GrowingTip& tip, const pd::TipLaw& law,
                                                             const Reach& reach, double least_cosine,
                                                             const TipSight& sight) const {
  std::vector<StressPoint> found;
  for (const int node : near_.about(tip.place, reach.outer * law.horizon)) {
    const Point& point = positions_[static_cast<std::size_t>(node)];
    const Point step = (point - tip.place) / law.horizon;
    const StressPoint s{node, step.norm(), step.dot(tip.direction), cross(tip.direction, step)};
    if (s.distance < reach.inner - rounding_of_places || s.distance >= reach.outer - rounding_of_places) continue;
    if (s.ahead < least_cosine * s.distance - rounding_of_places || bonds_at_.of(node).empty()) continue;
    if (sight.sees(point)) found.push_back(s);
  }
  return found;
}

void TipStress::add_nodes_asked(const GrowingTip& tip, const pd::TipLaw& law, bool closely_ahead,
                                std::vector<int>& nodes) const {
  std::vector<StressPoint> asked = fit_of(tip, law).stress_points;
  if (closely_ahead) {
    const std::vector<StressPoint> near = points_closely_ahead(tip, law);
    asked.insert(asked.end(), near.begin(), near.end());
  }
  for (const StressPoint& s : asked)
    for_each_term(s.node, [&](std::size_t term) {
      system_.terms().for_each_node(term, [&](int node) { nodes.push_back(node); });
    });
}

WilliamsFit TipStress::fitted(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                              const Eigen::RowVector2d& pressure) const {
  const Fit fit = fit_of(tip, law);
  WilliamsFit series(fit.terms);
  for (const auto& [node, r, ahead, across] : fit.stress_points) {
    Stress s = stress(node, tip.direction, law, displacement);
    s.topRows<2>().rowwise() += pressure;
    series.add(r, std::atan2(across, ahead), s);
  }
  return series;
}

AffineIntensity TipStress::closely_ahead_of(const GrowingTip& tip, const pd::TipLaw& law,
                                            const coupling::Affine& displacement,
                                            const Eigen::RowVector2d& pressure) const {
  AffineIntensity sum;
  double total = 0;
  for (const StressPoint& point : points_closely_ahead(tip, law)) {
    const Stress s = stress(point.node, tip.direction, law, displacement);
    const double r = point.distance, bump = 1 - r * r / (near_reach * near_reach), weight = bump * bump;
    sum.one += weight * (s.row(1) + pressure);
    sum.two += weight * s.row(2);
    total += weight;
  }
  if (total == 0) return sum;
  const double root = std::sqrt(near_reach * law.horizon) / total;
  return {sum.one * root / near_opening, sum.two * root / near_shear};
}

}  // namespace bempd::fracture

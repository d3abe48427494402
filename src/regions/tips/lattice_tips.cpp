#include "regions/tips/lattice_tips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "cancellation.hpp"
#include "coupling/pressed_faces.hpp"
#include "elasticity/griffith.hpp"
#include "number_range.hpp"

namespace bempd::regions {

namespace {

// Outer radii of the rings around a tip, relative to the outer radius of the largest ring.
constexpr std::array parts{1.0, 0.8, 0.6};

// Inner radius of a ring, relative to its outer radius. The weight q of the ring (TipRings) falls from 1 to 0 between
// these radii.
constexpr double inner_part = 0.5;

// Limits on the radius of the largest ring, in horizons. A smaller ring is affected by the lattice; a larger one gives
// nothing new and takes longer.
constexpr double least_horizons = 2, most_horizons = 10;
constexpr double almost_one = 1 - 1e-9;  // so that rounding does not decide about equal lengths

// Radius of the largest ring, relative to the radius of a circle that contains only this tip and the crack behind it.
constexpr double part_of_clear = 0.9;

Point factors_of(const TipRings::Expansion& expansion) {
  return std::sqrt(2 * std::numbers::pi) * Point(expansion.opening.real(), -expansion.opening.imag());
}

// Distance of the effective tip ahead of the described tip. Displacements in terms of the distance r from the effective
// tip have no term with r^(-1/2). Seen from another origin, their term with r^(1/2) causes such a term, from which the
// distance of this origin from the effective tip follows.
double felt_ahead(const TipRings& rings, double radius, double horizon, const Eigen::VectorXd& displacement) {
  double ahead = 0;
  for (int i = 0; i < 3; ++i) {
    const TipRings::Expansion seen = rings.expansion(rings.about(ahead), inner_part * radius, radius, displacement);
    const double size = std::norm(seen.opening);
    if (size > 0) ahead += -2 * (seen.shift * std::conj(seen.opening)).real() / size;
    // The shift is limited to a horizon: a larger one does not come from the field of a crack tip.
    ahead = std::clamp(ahead, -horizon, horizon);
  }
  return ahead;
}

TipValues without_contours(const LatticeTip& tip) {
  TipValues values;
  values.crack = tip.crack, values.end = tip.end;
  values.place = tip.axes.place, values.direction = tip.axes.direction;
  values.method = TipMethod::contours;
  values.felt_ahead = TipValues::unknown;
  values.grown = tip.grown, values.branched = tip.branched;
  return values;
}

// Fluid pressure in the crack of a tip, constant and proportional part [Pa]; zero if the crack has no pressure.
Eigen::RowVector2d pressure_in(const BondedBody& body, const LatticeTip& tip) {
  const auto found = body.pressures.find(tip.crack);
  return found == body.pressures.end() ? Eigen::RowVector2d::Zero() : found->second;
}

// Displacements that cause no stress intensity: those of free swelling, and those of a uniform pressure in the body
// equal to the fluid pressure in the crack. Without them the crack's faces are free of load. Empty if swelling causes
// stress.
std::optional<coupling::Affine> free_displacement(const BondedBody& body, const LatticeTip& tip) {
  const PlaneElasticity& elasticity = tip.axes.elasticity;
  const Eigen::RowVector2d strain = -pressure_in(body, tip) / (elasticity.c11() + elasticity.c12());
  const std::vector<Point>& positions = body.discretization.positions;
  const RegionSwelling* swelling = body.discretization.region(tip.region).swelling();
  coupling::Affine free(2 * static_cast<Eigen::Index>(positions.size()), 2);
  for (std::size_t node = 0; node < positions.size(); ++node) {
    const auto at = swelling ? swelling->free_displacement(positions[node]) : Eigen::Matrix2d(Eigen::Matrix2d::Zero());
    if (!at) return std::nullopt;
    free.middleRows<2>(2 * static_cast<Eigen::Index>(node)) = *at + (positions[node] - tip.axes.place) * strain;
  }
  return free;
}

// Whether crack faces press on each other at a tip. The rings attribute the pressure between the faces to K_I.
bool is_shut(const BondedBody& body, const LatticeTip& tip, const TipValues& values) {
  return values.factors.x() <= 0 &&
         coupling::faces_press_at(body.constraints, body.discretization.positions, tip.axes.place, tip.horizon);
}

TipValues values_of(const BondedBody& body, const LatticeTip& tip, double toughness, const Solution& solution) {
  TipValues values = without_contours(tip);
  if (tip.clear < almost_one * least_horizons * tip.horizon) return values;
  const std::optional<coupling::Affine> free = free_displacement(body, tip);
  if (!free) return values;
  const double radius = std::min(part_of_clear * tip.clear, most_horizons * tip.horizon);
  const TipRings rings(body, tip.axes, radius + tip.horizon);
  const Eigen::VectorXd constant = rings.around(solution.parts->col(0) - free->col(0));
  const Eigen::VectorXd proportional = rings.around(solution.parts->col(1) - free->col(1));
  const Eigen::VectorXd whole = constant + solution.load_factor * proportional;
  // The effective tip is found from the present displacement or, if that is zero, from that of the proportional loads.
  const bool loaded = whole.squaredNorm() > 0;
  values.felt_ahead = felt_ahead(rings, radius, tip.horizon, loaded ? whole : proportional);
  const TipRings::View view = rings.about(values.felt_ahead);
  const auto seen = [&](const Eigen::VectorXd& displacement, double part) {
    return rings.expansion(view, inner_part * part * radius, part * radius, displacement);
  };
  const TipRings::Expansion largest = seen(whole, 1);
  values.factors = factors_of(largest);
  values.stress_along = largest.uniform - pressure_in(body, tip).dot(Eigen::RowVector2d(1, solution.load_factor));
  values.error = 0;
  for (const double part : parts)
    values.error = std::max(values.error, (factors_of(seen(whole, part)) - values.factors).norm());
  values.contours = static_cast<int>(parts.size());
  values.contour_radius = radius;
  values.constant_factors = constant.isZero(0) ? Point(0, 0) : factors_of(seen(constant, 1));
  values.proportional_factors = factors_of(seen(proportional, 1));
  values.closed = is_shut(body, tip, values);
  if (values.closed) values.factors.x() = values.constant_factors.x() = values.proportional_factors.x() = 0;
  values.plane_modulus = plane_modulus(tip.axes.elasticity);
  values.toughness = toughness;
  values.energy_release_rate = in_range(values.factors.squaredNorm() / values.plane_modulus);
  // Results are unknown for bodies so small that the squares of their lengths underflow (below 1e-154 m).
  const bool known = values.factors.allFinite() && std::isfinite(values.stress_along) && std::isfinite(values.error) &&
                     std::isfinite(values.felt_ahead);
  return known ? values : without_contours(tip);
}

}  // namespace

std::vector<TipValues> lattice_tips(const BondedBody& body, const std::vector<LatticeTip>& tips,
                                    const Solution& solution, const scene::Options& options) {
  std::vector<TipValues> values;
  for (const LatticeTip& tip : tips) {
    check_cancelled();
    const RegionBonds* bonds = tip.region > 0 ? body.discretization.region(tip.region).bonds() : nullptr;
    const std::optional<pd::TipLaw> law = bonds ? bonds->tip_law(options) : std::nullopt;
    values.push_back(values_of(body, tip, law ? law->at(tip.axes.place, 0).toughness : 0, solution));
  }
  return values;
}

}  // namespace bempd::regions

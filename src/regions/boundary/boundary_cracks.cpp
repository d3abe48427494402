#include "regions/boundary/boundary_cracks.hpp"

#include <algorithm>
#include <cmath>

#include "bem/coarse_level.hpp"
#include "crack/growth_law.hpp"
#include "elasticity/griffith.hpp"
#include "number_range.hpp"

namespace bempd::regions {

namespace {

// Ratio of the error of the finer of two discretizations to the difference of the results of both, for error estimates.
// The measured difference is 4 to 30 times the error. It is less where most of the error comes from tip elements, which
// are the same in both discretizations.
constexpr double error_of_difference = 1.0 / 3;

// Share of the stress intensity factors that is added to the error estimate of a tip in a subdomain, because this
// estimate considers only the subdomain's own elements. The value is the largest measured effect of the cuts between
// subdomains and of the elements of other subdomains, with 10 to 16 elements on each hole
// (tests/differential/tip_errors.py).
constexpr double error_of_others = 2e-4;

double stress_along(const LinearBodyForce& particular, const bem::CrackTip& tip) {
  return tip.direction.dot(traction_of(particular, tip.place, tip.direction));
}

// T-stress of each tip under the constant part and under the proportional part of the loads, which are the first two
// entries of `states`. Empty unless a function of the host gives the material's fracture energy.
std::vector<Point> parts_of_t_stress(const bem::CrackedOperator& cracked, const std::vector<bem::CrackedState>& states,
                                     const scene::Material& material) {
  if (!material.resistance.function) return {};
  const std::vector<double> constant = bem::stresses_along_crack(cracked, states[0]);
  const std::vector<double> proportional = bem::stresses_along_crack(cracked, states[1]);
  std::vector<Point> parts;
  for (std::size_t t = 0; t < constant.size(); ++t) parts.emplace_back(constant[t], proportional[t]);
  return parts;
}

// Sets the toughness that a tip meets. `share` is the fracture energy at the tip's place relative to that of the
// material, `grown` the length by which the tip has grown. A function of the host for the fracture energy is stored in
// `value` and called later.
void set_resistance(TipValues& value, const scene::Material& material, double share, double grown,
                    const Point& t_stress) {
  const crack::Resistance& resistance = material.resistance;
  const double grown_share = resistance.curve ? resistance.curve->share(grown) : 1;
  value.toughness = crack::toughness_of(material.fracture_energy * share * grown_share, value.plane_modulus);
  value.directions = resistance.directions.get();
  if (resistance.function) value.asking = {resistance.function.get(), value.id(), value.place, grown, t_stress};
}

double length_of(const Point& vector) {
  const int far = far_exponent(vector.lpNorm<Eigen::Infinity>());
  return far == 0 ? vector.norm() : std::ldexp((vector * std::ldexp(1, -far)).norm(), far);
}

// Appends the tips of a part with cracks to `values`. `of_loads` has three states: under the constant part of the
// loads, under the proportional part, and under the present loads.
void append_tips(const CrackedPart& part, const std::vector<bem::CrackedState>& of_loads, const Region& region,
                 const LinearBodyForce& particular, TipDetail detail, std::vector<TipValues>& values) {
  const bem::CrackedOperator& cracked = *part.body;
  std::vector<bem::CrackedState> states = of_loads;
  if (detail == TipDetail::everything) states.push_back(bem::coarse_state(cracked, states.back()));
  const auto factors = bem::stress_intensities(cracked, states);
  std::vector<double> along(factors.size(), 0);
  if (detail == TipDetail::everything) along = bem::stresses_along_crack(cracked, states[2]);
  const std::vector<Point> parts_along = parts_of_t_stress(cracked, states, region.material());
  const double modulus = plane_modulus(region.elasticity());
  for (std::size_t t = 0; t < factors.size(); ++t) {
    const bem::CrackTip& tip = part.elements().tips[t];
    along[t] += stress_along(particular, tip);
    const bem::StressIntensity &constant = factors[t][0], &proportional = factors[t][1], &present = factors[t][2];
    TipValues value;
    value.crack = part.cracks->id_of(tip), value.end = tip.end == bem::TipEnd::end ? 1 : 0;
    value.place = tip.place, value.direction = tip.direction;
    value.factors = present.factors, value.energy_release_rate = present.energy_release_rate;
    value.stress_along = along[t];
    value.error = error_of_difference * length_of(present.factors - factors[t].back().factors);
    if (!part.nodes.empty()) value.error += error_of_others * length_of(present.factors);
    value.constant_factors = constant.factors, value.proportional_factors = proportional.factors;
    value.plane_modulus = modulus;
    set_resistance(value, region.material(), region.toughness().share(tip.place), part.cracks->grown_of(tip),
                   parts_along.empty() ? Point(0, 0) : parts_along[t]);
    values.push_back(value);
  }
}

}  // namespace

bool BoundaryCracks::lie_inside(int crack) const {
  return std::any_of(parts_.cracked().begin(), parts_.cracked().end(),
                     [&](const CrackedPart& part) { return part.cracks->has_inside(crack); });
}

void BoundaryCracks::add_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const {
  Eigen::VectorXd on_places = Eigen::VectorXd::Zero(mesh_.trace().rows());
  for (const CrackedPart& cracked : parts_.cracked()) {
    const auto traction = cracked.cracks->traction({load}, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
    if (traction) cracked.add(cracked.on_boundary(traction), on_places);
  }
  region_.scatter(mesh_.trace().transpose() * on_places, force);
}

coupling::Affine BoundaryCracks::face_offsets(const std::array<BodyForce, 2>& body_force,
                                              const std::vector<CrackLoad>& crack_loads) const {
  std::size_t count = 0;
  for (const CrackedPart& part : parts_.cracked()) count += part.constraints();
  coupling::Affine all = coupling::Affine::Zero(static_cast<Eigen::Index>(count), 2);
  Eigen::Index first = 0;
  for (const CrackedPart& part : parts_.cracked()) {
    if (!part.closing) continue;
    const CrackedPart::Particulars particular = particulars_.in_part(body_force, part);
    const Eigen::MatrixX2d forces = part.forces_of(crack_loads) - particular.face_forces;
    all.middleRows(first, static_cast<Eigen::Index>(part.constraints())) = part.gaps(-particular.displacements, forces);
    first += static_cast<Eigen::Index>(part.constraints());
  }
  return all;
}

std::vector<TipValues> BoundaryCracks::tips(const Solution& solution, TipDetail detail) const {
  const auto has_none = [](const CrackedPart& part) { return part.elements().tips.empty(); };
  if (std::all_of(parts_.cracked().begin(), parts_.cracked().end(), has_none)) return {};
  const std::vector<bem::CrackedState> constant = states_.of_cracked_parts(solution.parts->col(0), solution, 1, 0);
  const std::vector<bem::CrackedState> proportional = states_.of_cracked_parts(solution.parts->col(1), solution, 0, 1);
  const std::vector<bem::CrackedState> present = states_.of_cracked_parts(solution);
  const LinearBodyForce particular = particulars_.of(solution);
  std::vector<TipValues> values;
  for (std::size_t k = 0; k < parts_.cracked().size(); ++k)
    if (!parts_.cracked()[k].elements().tips.empty())
      append_tips(parts_.cracked()[k], {constant[k], proportional[k], present[k]}, region_, particular, detail, values);
  std::stable_sort(values.begin(), values.end(),
                   [](const TipValues& a, const TipValues& b) { return a.crack < b.crack; });
  return values;
}

std::vector<Point> BoundaryCracks::openings(int crack, const std::vector<double>& fractions,
                                            const Solution& solution) const {
  const std::vector<bem::CrackedState> states = states_.of_cracked_parts(solution);
  std::vector<Point> values;
  for (std::size_t k = 0; k < parts_.cracked().size(); ++k) {
    if (!parts_.cracked()[k].cracks->has(crack)) continue;
    for (const double fraction : fractions)
      values.push_back(parts_.cracked()[k].cracks->opening_at(crack, fraction, states[k]));
    break;  // lines of a crack that meet all lie in one part
  }
  return values;
}

std::vector<CrackPicture> BoundaryCracks::pictures(const Solution& solution) const {
  if (!parts_.cracks()) return {};
  const std::vector<bem::CrackedState> states = states_.of_cracked_parts(solution);
  std::vector<CrackPicture> pictures;
  for (std::size_t k = 0; k < parts_.cracked().size(); ++k)
    for (CrackPicture& picture : parts_.cracked()[k].cracks->pictures(states[k]))
      pictures.push_back(std::move(picture));
  std::stable_sort(pictures.begin(), pictures.end(), [](const auto& a, const auto& b) { return a.crack < b.crack; });
  const LinearBodyForce particular = particulars_.of(solution);
  const InteriorOfPieces rest = states_.inside(particular, solution);
  for (CrackPicture& picture : pictures) {
    for (std::size_t k = 0; k < picture.places.size(); ++k) {
      const Point& place = picture.places[k];
      const Point left = rest.displacement_at(place) + particular.displacement(place);
      picture.displacements.emplace_back(left - 0.5 * picture.openings[k]);
    }
  }
  return pictures;
}

std::optional<Overlap> BoundaryCracks::overlap(const Solution& solution) const {
  if (!parts_.cracks() || parts_.cracked().front().closing) return std::nullopt;
  std::optional<Overlap> worst;
  const std::vector<bem::CrackedState> states = states_.of_cracked_parts(solution);
  for (std::size_t k = 0; k < parts_.cracked().size(); ++k) {
    const std::optional<Overlap> own = parts_.cracked()[k].cracks->overlap(states[k]);
    if (own && (!worst || own->depth > worst->depth)) worst = own;
  }
  return worst;
}

}  // namespace bempd::regions

#include <algorithm>
#include <cmath>
#include <optional>

#include "bem/coarse_level.hpp"
#include "crack/growth_law.hpp"
#include "elasticity/griffith.hpp"
#include "number_range.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/boundary/region_subdomains.hpp"
#include "regions/boundary_conditions.hpp"

namespace bempd::regions {

namespace {

// Ratio for estimating errors: error of the finer of two discretizations over the difference between both. The measured
// difference is 4 to 30 times the error, less where the error comes mostly from tip elements, which both share.
constexpr double error_of_difference = 1.0 / 3;

// Share of stress intensity factors that is added to the error in a subdomain, because the difference is that of its
// own elements alone: the largest effect of cuts and of the other elements that was measured, with 10 to 16 elements on
// each hole (tests/differential/tip_errors.py).
constexpr double error_of_others = 2e-4;

double stress_along(const LinearBodyForce& particular, const bem::CrackTip& tip) {
  return tip.direction.dot(traction_of(particular, tip.place, tip.direction));
}

bem::FaceTraction without(const bem::FaceTraction& traction, const LinearBodyForce& particular) {
  return [=](int line, const Point& x, const Point& normal) -> Point {
    const Point own = -traction_of(particular, x, normal);
    return traction ? Point(traction(line, x, normal) + own) : own;
  };
}

// T of each tip by the constant and by the proportional part of the loads (the first two states), for a material whose
// fracture energy a function of the host gives; else empty.
std::vector<Point> parts_of_t_stress(const bem::CrackedOperator& cracked, const std::vector<bem::CrackedState>& states,
                                     const scene::Material& material) {
  if (!material.resistance.function) return {};
  const std::vector<double> constant = bem::stresses_along_crack(cracked, states[0]);
  const std::vector<double> proportional = bem::stresses_along_crack(cracked, states[1]);
  std::vector<Point> parts;
  for (std::size_t t = 0; t < constant.size(); ++t) parts.emplace_back(constant[t], proportional[t]);
  return parts;
}

// Sets the toughness that a tip meets: `share` of the material's fracture energy is that of its place.
void set_resistance(TipValues& value, const scene::Material& material, double share, double grown,
                    const Point& t_stress) {
  const crack::Resistance& resistance = material.resistance;
  const double grown_share = resistance.curve ? resistance.curve->share(grown) : 1;
  value.toughness = crack::toughness_of(material.fracture_energy * share * grown_share, value.plane_modulus);
  value.directions = resistance.directions.get();
  if (resistance.function)
    value.asking = {resistance.function.get(), {value.crack, value.end}, value.place, grown, t_stress};
}

double length_of(const Point& vector) {
  const int far = far_exponent(vector.lpNorm<Eigen::Infinity>());
  return far == 0 ? vector.norm() : std::ldexp((vector * std::ldexp(1, -far)).norm(), far);
}

// Appends the tips of a part. `states` are those of the constant and of the proportional part of the loads, and the
// present one.
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

const std::vector<CrackLoad>& loads_of(const Solution& solution) {
  static const std::vector<CrackLoad> none;
  return solution.crack_loads ? *solution.crack_loads : none;
}

}  // namespace

// States of the cracked parts without the particular solution of a body force. That solution has tractions on the crack
// faces too, which are subtracted from the loads there.
std::vector<bem::CrackedState> BoundaryRegion::cracked_states(const Eigen::VectorXd& displacement,
                                                              const Solution& solution, double constant,
                                                              double proportional) const {
  std::vector<bem::CrackedState> states;
  if (cracked_.empty()) return states;
  Eigen::VectorXd all = elastic(displacement, constant, proportional);
  std::optional<LinearBodyForce> particular;
  if (solution.body_force_parts) {
    const BodyForce body_force = body_force_of(*solution.body_force_parts, id(), {constant, proportional});
    if (!body_force.is_zero()) {
      particular.emplace(this->particular(body_force));
      all -= displacement_of(*particular);
    }
  }
  const std::vector<char>& closed_faces = solution.closed_faces_of(id());
  auto first = closed_faces.begin();
  for (const CrackedPart& part : cracked_) {
    bem::FaceTraction traction = part.cracks->traction(loads_of(solution), constant, proportional);
    if (particular) traction = without(traction, *particular);
    std::vector<char> closed;
    if (part.closing && !closed_faces.empty()) {
      closed.assign(first, first + static_cast<std::ptrdiff_t>(part.constraints()));
      first += static_cast<std::ptrdiff_t>(part.constraints());
    }
    states.push_back(part.state(all, std::move(traction), closed));
  }
  return states;
}

std::vector<bem::CrackedState> BoundaryRegion::cracked_states(const Solution& solution) const {
  std::vector<bem::CrackedState> states = cracked_states(solution.displacement, solution, 1, solution.load_factor);
  for (std::size_t k = 0; k < states.size(); ++k) states[k].faces_press = cracked_[k].closing != nullptr;
  return states;
}

Eigen::VectorXd BoundaryRegion::tractions_under(const Eigen::VectorXd& displacement, const Solution& solution) const {
  if (subdomains_) return subdomains_->tractions(displacement, cracked_, cracked_states(solution));
  return cracks_ ? cracked_states(solution).front().tractions : Eigen::VectorXd(operator_->tractions(displacement));
}

void BoundaryRegion::add_crack_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const {
  Eigen::VectorXd on_places = Eigen::VectorXd::Zero(trace_.rows());
  for (const CrackedPart& cracked : cracked_) {
    const auto traction = cracked.cracks->traction({load}, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
    if (traction) cracked.add(cracked.on_boundary(traction), on_places);
  }
  scatter(trace_.transpose() * on_places, force);
}

coupling::Affine BoundaryRegion::face_offsets(const std::array<BodyForce, 2>& body_force,
                                              const std::vector<CrackLoad>& crack_loads) const {
  std::size_t count = 0;
  for (const CrackedPart& part : cracked_) count += part.constraints();
  coupling::Affine all = coupling::Affine::Zero(static_cast<Eigen::Index>(count), 2);
  Eigen::Index first = 0;
  for (const CrackedPart& part : cracked_) {
    if (!part.closing) continue;
    const CrackedPart::Particulars particular = particulars(body_force, part);
    const Eigen::MatrixX2d forces = part.forces_of(crack_loads) - particular.face_forces;
    all.middleRows(first, static_cast<Eigen::Index>(part.constraints())) = part.gaps(-particular.displacements, forces);
    first += static_cast<Eigen::Index>(part.constraints());
  }
  return all;
}

CrackedPart::Particulars BoundaryRegion::particulars(const std::array<BodyForce, 2>& body_force,
                                                     const CrackedPart& part) const {
  CrackedPart::Particulars all{Eigen::MatrixX2d::Zero(2 * static_cast<Eigen::Index>(part.body->mesh().nodes.size()), 2),
                               Eigen::MatrixX2d::Zero(part.openings(), 2)};
  for (int column = 0; column < 2; ++column) {
    if (body_force[column].is_zero()) continue;
    const LinearBodyForce particular = this->particular(body_force[column]);
    all.displacements.col(column) = part.own(displacement_of(particular));
    all.face_forces.col(column) = part.forces_of(particular);
  }
  return all;
}

std::vector<TipValues> BoundaryRegion::tips(const Solution& solution, TipDetail detail) const {
  const auto has_none = [](const CrackedPart& part) { return part.elements().tips.empty(); };
  if (std::all_of(cracked_.begin(), cracked_.end(), has_none)) return {};
  const std::vector<bem::CrackedState> constant = cracked_states(solution.parts->col(0), solution, 1, 0);
  const std::vector<bem::CrackedState> proportional = cracked_states(solution.parts->col(1), solution, 0, 1);
  const std::vector<bem::CrackedState> present = cracked_states(solution);
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  std::vector<TipValues> values;
  for (std::size_t k = 0; k < cracked_.size(); ++k)
    if (!cracked_[k].elements().tips.empty())
      append_tips(cracked_[k], {constant[k], proportional[k], present[k]}, *this, particular, detail, values);
  std::stable_sort(values.begin(), values.end(),
                   [](const TipValues& a, const TipValues& b) { return a.crack < b.crack; });
  return values;
}

std::vector<Point> BoundaryRegion::crack_openings(int crack, const std::vector<double>& fractions,
                                                  const Solution& solution) const {
  const std::vector<bem::CrackedState> states = cracked_states(solution);
  std::vector<Point> values;
  for (std::size_t k = 0; k < cracked_.size(); ++k) {
    if (!cracked_[k].cracks->has(crack)) continue;
    for (const double fraction : fractions)
      values.push_back(cracked_[k].cracks->opening_at(crack, fraction, states[k]));
    break;  // all of a crack's lines that meet lie in one part
  }
  return values;
}

std::vector<CrackPicture> BoundaryRegion::crack_pictures(const Solution& solution) const {
  if (!cracks_) return {};
  const std::vector<bem::CrackedState> states = cracked_states(solution);
  std::vector<CrackPicture> pictures;
  for (std::size_t k = 0; k < cracked_.size(); ++k)
    for (CrackPicture& picture : cracked_[k].cracks->pictures(states[k])) pictures.push_back(std::move(picture));
  std::stable_sort(pictures.begin(), pictures.end(), [](const auto& a, const auto& b) { return a.crack < b.crack; });
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  const InteriorOfPieces rest = inside_without(particular, solution);
  for (CrackPicture& picture : pictures) {
    for (std::size_t k = 0; k < picture.places.size(); ++k) {
      const Point& place = picture.places[k];
      const Point left = rest.displacement_at(place) + particular.displacement(place);
      picture.displacements.emplace_back(left - 0.5 * picture.openings[k]);
    }
  }
  return pictures;
}

}  // namespace bempd::regions

#include <cmath>

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

Point traction_of(const LinearBodyForce& particular, const Point& x, const Point& normal) {
  const Eigen::Vector3d s = particular.stress(x);
  return {s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y()};
}

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

const std::vector<CrackLoad>& loads_of(const Solution& solution) {
  static const std::vector<CrackLoad> none;
  return solution.crack_loads ? *solution.crack_loads : none;
}

}  // namespace

const bem::CrackedOperator& BoundaryRegion::cracked() const {
  return static_cast<const bem::CrackedOperator&>(*operator_);
}

// State of the cracked body without the particular solution of a body force. That solution has tractions on the crack
// faces too, which are subtracted from the loads there.
bem::CrackedState BoundaryRegion::cracked_state(const Eigen::VectorXd& displacement, const Solution& solution,
                                                double constant, double proportional) const {
  bem::CrackedState state;
  state.displacements = elastic(displacement, constant, proportional);
  state.face_traction = cracks_->traction(loads_of(solution), constant, proportional);
  if (solution.body_force_parts) {
    const BodyForce body_force = body_force_of(*solution.body_force_parts, id(), {constant, proportional});
    if (!body_force.is_zero()) {
      const LinearBodyForce particular = this->particular(body_force);
      state.displacements -= displacement_of(particular);
      state.face_traction = without(state.face_traction, particular);
    }
  }
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(cracks_->elements().nodes.size()));
  if (state.face_traction) forces = bem::crack_forces(cracks_->elements(), state.face_traction, elasticity().thickness);
  state.openings = cracked().openings(state.displacements, forces);
  if (closing_) {
    const std::vector<char>& closed = solution.closed_faces_of(id());
    state.closed = closing_->closed_nodes(closed);
    if (!closed.empty()) state.openings = closing_->held_shut(state.openings, closed);
  }
  state.tractions = cracked().tractions(state.displacements, state.openings);
  return state;
}

bem::CrackedState BoundaryRegion::cracked_state(const Solution& solution) const {
  bem::CrackedState state = cracked_state(solution.displacement, solution, 1, solution.load_factor);
  state.faces_press = closing_ != nullptr;
  return state;
}

Eigen::VectorXd BoundaryRegion::tractions_under(const Eigen::VectorXd& displacement, const Solution& solution) const {
  if (subdomains_) return subdomains_->tractions(displacement);
  return cracks_ ? cracked_state(solution).tractions : Eigen::VectorXd(operator_->tractions(displacement));
}

void BoundaryRegion::add_crack_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const {
  const auto traction = cracks_->traction({load}, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
  const Eigen::VectorXd forces = bem::crack_forces(cracks_->elements(), traction, elasticity().thickness);
  Eigen::VectorXd on_boundary = cracked().forces_on_boundary(forces);
  bem::add_forces_on_cuts(mesh_, cracks_->elements(), traction, elasticity().thickness, on_boundary);
  scatter(trace_.transpose() * on_boundary, force);
}

// Nodal forces of loads on the openings of all cracks: constant part (column 0) and proportional part (column 1).
Eigen::MatrixX2d BoundaryRegion::forces_on_cracks(const std::vector<CrackLoad>& loads) const {
  const Eigen::Index size = 2 * static_cast<Eigen::Index>(cracks_->elements().nodes.size());
  Eigen::MatrixX2d forces = Eigen::MatrixX2d::Zero(size, 2);
  for (int part = 0; part < 2; ++part) {
    const auto traction = cracks_->traction(loads, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
    if (traction) forces.col(part) = bem::crack_forces(cracks_->elements(), traction, elasticity().thickness);
  }
  return forces;
}

std::shared_ptr<const coupling::ExactConstraints> BoundaryRegion::exact_constraints() const {
  if (!closing_) return nullptr;
  return std::make_shared<const coupling::ExactConstraints>(
      coupling::ExactConstraints{closing_->of_displacements() * trace_, closing_->of_forces()});
}

coupling::Affine BoundaryRegion::face_offsets(const std::array<BodyForce, 2>& body_force,
                                              const std::vector<CrackLoad>& crack_loads) const {
  if (!closing_) return coupling::Affine(0, 2);
  coupling::Affine gaps = coupling::Affine::Zero(static_cast<Eigen::Index>(closing_->size()), 2);
  const Particulars particular = particulars(body_force);
  const Eigen::MatrixX2d forces = forces_on_cracks(crack_loads) - particular.face_forces;
  if (forces.isZero(0) && particular.displacements.isZero(0)) return gaps;
  const Eigen::MatrixXd openings = cracked().openings(-particular.displacements, forces);
  for (int part = 0; part < 2; ++part) gaps.col(part) = closing_->gaps(openings.col(part));
  return gaps;
}

Eigen::VectorXd BoundaryRegion::face_forces_of(const LinearBodyForce& particular) const {
  const auto traction = [&](int, const Point& x, const Point& normal) { return traction_of(particular, x, normal); };
  return bem::crack_forces(cracks_->elements(), traction, elasticity().thickness);
}

BoundaryRegion::Particulars BoundaryRegion::particulars(const std::array<BodyForce, 2>& body_force) const {
  Particulars all{Eigen::MatrixX2d::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()), 2),
                  Eigen::MatrixX2d::Zero(2 * static_cast<Eigen::Index>(cracks_->elements().nodes.size()), 2)};
  for (int part = 0; part < 2; ++part) {
    if (body_force[part].is_zero()) continue;
    const LinearBodyForce particular = this->particular(body_force[part]);
    all.displacements.col(part) = displacement_of(particular);
    all.face_forces.col(part) = face_forces_of(particular);
  }
  return all;
}

// Work of loads inside the body that nodal forces do not include. The stiffness K couples the boundary's displacements
// u and the openings  w = K_ww^-1 (f - K_wu u)  due to forces f on crack faces. These do the work f.w, of which the
// nodal forces contain the part that depends on u.
// A body force has a particular solution u_p with forces f_p on the faces; u and f are then without these. By Betti's
// theorem a force f does the additional work -v.f, with v = K_ww^-1 (f_p - K_wu u_p).
Eigen::Matrix2d BoundaryRegion::work_within_cracks(const std::array<BodyForce, 2>& body_force,
                                                   const std::vector<CrackLoad>& loads) const {
  const Eigen::MatrixX2d forces = forces_on_cracks(loads);
  Eigen::Matrix2d work = Eigen::Matrix2d::Zero();
  if (!forces.isZero(0)) {
    const Eigen::MatrixXd held = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()), 2);
    work = forces.transpose() * cracked().openings(held, forces);
  }
  if (body_force[0].is_zero() && body_force[1].is_zero()) return work;
  const Particulars own = particulars(body_force);
  const Eigen::MatrixXd openings = cracked().openings(own.displacements, own.face_forces);
  const Eigen::Matrix2d mixed = forces.transpose() * openings;
  return work + openings.transpose() * own.face_forces - mixed - mixed.transpose();
}

std::vector<TipValues> BoundaryRegion::tips(const Solution& solution, TipDetail detail) const {
  if (!cracks_ || cracks_->elements().tips.empty()) return {};
  std::vector<bem::CrackedState> states{cracked_state(solution.parts->col(0), solution, 1, 0),
                                        cracked_state(solution.parts->col(1), solution, 0, 1), cracked_state(solution)};
  if (detail == TipDetail::everything) states.push_back(bem::coarse_state(cracked(), states.back()));
  const auto factors = bem::stress_intensities(cracked(), states);
  std::vector<double> along(factors.size(), 0);
  if (detail == TipDetail::everything) along = bem::stresses_along_crack(cracked(), states[2]);
  const std::vector<Point> parts_along = parts_of_t_stress(cracked(), states, material());
  const LinearBodyForce particular = this->particular(solution.body_force(id()));
  const double modulus = plane_modulus(elasticity());
  std::vector<TipValues> values;
  for (std::size_t t = 0; t < factors.size(); ++t) {
    const bem::CrackTip& tip = cracks_->elements().tips[t];
    along[t] += stress_along(particular, tip);
    const bem::StressIntensity &constant = factors[t][0], &proportional = factors[t][1], &present = factors[t][2];
    TipValues value;
    value.crack = cracks_->id_of(tip), value.end = tip.end == bem::TipEnd::end ? 1 : 0;
    value.place = tip.place, value.direction = tip.direction;
    value.factors = present.factors, value.energy_release_rate = present.energy_release_rate;
    value.stress_along = along[t];
    value.error = error_of_difference * length_of(present.factors - factors[t].back().factors);
    value.constant_factors = constant.factors, value.proportional_factors = proportional.factors;
    value.plane_modulus = modulus;
    set_resistance(value, material(), toughness().share(tip.place), cracks_->grown_of(tip),
                   parts_along.empty() ? Point(0, 0) : parts_along[t]);
    values.push_back(value);
  }
  return values;
}

std::vector<Point> BoundaryRegion::crack_openings(int crack, const std::vector<double>& fractions,
                                                  const Solution& solution) const {
  const bem::CrackedState state = cracked_state(solution);
  std::vector<Point> values;
  values.reserve(fractions.size());
  for (const double fraction : fractions) values.push_back(cracks_->opening_at(crack, fraction, state));
  return values;
}

std::vector<CrackPicture> BoundaryRegion::crack_pictures(const Solution& solution) const {
  if (!cracks_) return {};
  std::vector<CrackPicture> pictures = cracks_->pictures(cracked_state(solution));
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

const CrackLines* BoundaryRegion::crack_lines() const { return cracks_ ? &cracks_->lines() : nullptr; }

std::optional<Overlap> BoundaryRegion::overlap(const Solution& solution) const {
  if (!cracks_ || closing_) return std::nullopt;
  return cracks_->overlap(cracked_state(solution));
}

}  // namespace bempd::regions

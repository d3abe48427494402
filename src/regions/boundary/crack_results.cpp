#include <cmath>

#include "bem/coarse_level.hpp"
#include "elasticity/griffith.hpp"
#include "elasticity/kinked_tip.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/boundary/region_cracks.hpp"

namespace bempd::regions {

namespace {

// Levels differ by more than the finer one is off (measured: 4 to 30 times that, less where the elements at tips count
// most, which both levels have).
constexpr double error_of_difference = 1.0 / 3;

const std::vector<CrackLoad>& loads_of(const Solution& solution) {
  static const std::vector<CrackLoad> none;
  return solution.crack_loads ? *solution.crack_loads : none;
}

}  // namespace

const bem::CrackedOperator& BoundaryRegion::cracked() const {
  return static_cast<const bem::CrackedOperator&>(*operator_);
}

bem::CrackedState BoundaryRegion::cracked_state(const Eigen::VectorXd& displacement, const Solution& solution,
                                                double constant, double proportional) const {
  bem::CrackedState state;
  state.displacements = elastic(displacement, constant, proportional);
  state.face_traction = cracks_->traction(loads_of(solution), constant, proportional);
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
  return cracks_ ? cracked_state(solution).tractions : Eigen::VectorXd(operator_->tractions(displacement));
}

void BoundaryRegion::add_crack_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const {
  const auto traction = cracks_->traction({load}, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
  const Eigen::VectorXd forces = bem::crack_forces(cracks_->elements(), traction, elasticity().thickness);
  scatter(trace_.transpose() * cracked().forces_on_boundary(forces), force);
}

// Constant and proportional ones, on all openings.
Eigen::MatrixX2d BoundaryRegion::forces_on_cracks(const std::vector<CrackLoad>& loads) const {
  const Eigen::Index size = 2 * static_cast<Eigen::Index>(cracks_->elements().nodes.size());
  Eigen::MatrixX2d forces = Eigen::MatrixX2d::Zero(size, 2);
  for (int part = 0; part < 2; ++part) {
    const auto traction = cracks_->traction(loads, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
    if (traction) forces.col(part) = bem::crack_forces(cracks_->elements(), traction, elasticity().thickness);
  }
  return forces;
}

std::shared_ptr<const coupling::FaceOpenings> BoundaryRegion::face_openings() const {
  if (!closing_) return nullptr;
  return std::make_shared<const coupling::FaceOpenings>(
      coupling::FaceOpenings{closing_->of_displacements() * trace_, closing_->of_forces()});
}

coupling::Affine BoundaryRegion::face_offsets(const std::array<Point, 2>& /*body_force*/,
                                              const std::vector<CrackLoad>& crack_loads) const {
  if (!closing_) return coupling::Affine(0, 2);
  coupling::Affine gaps = coupling::Affine::Zero(static_cast<Eigen::Index>(closing_->size()), 2);
  const Eigen::MatrixX2d forces = forces_on_cracks(crack_loads);
  if (forces.isZero(0)) return gaps;
  const Eigen::MatrixXd held = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()), 2);
  const Eigen::MatrixXd openings = cracked().openings(held, forces);
  for (int part = 0; part < 2; ++part) gaps.col(part) = closing_->gaps(openings.col(part));
  return gaps;
}

// With K of boundary and openings, openings are  w = K_ww^-1 (f - K_wu u): f does the work f.w, of which the nodes know
// the part that depends on u.
Eigen::Matrix2d BoundaryRegion::work_within_cracks(const std::vector<CrackLoad>& loads) const {
  const Eigen::MatrixX2d forces = forces_on_cracks(loads);
  if (forces.isZero(0)) return Eigen::Matrix2d::Zero();
  const Eigen::MatrixXd held = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()), 2);
  return forces.transpose() * cracked().openings(held, forces);
}

std::vector<TipValues> BoundaryRegion::tips(const Solution& solution, TipDetail detail) const {
  if (!cracks_ || cracks_->elements().tips.empty()) return {};
  std::vector<bem::CrackedState> states{cracked_state(solution.parts->col(0), solution, 1, 0),
                                        cracked_state(solution.parts->col(1), solution, 0, 1), cracked_state(solution)};
  if (detail == TipDetail::everything) states.push_back(bem::coarse_state(cracked(), states.back()));
  const auto factors = bem::stress_intensities(cracked(), states);
  std::vector<double> along(factors.size(), 0);
  if (detail == TipDetail::everything) along = bem::stresses_along_crack(cracked(), states[2]);
  const double modulus = plane_modulus(elasticity()), toughness = std::sqrt(modulus * material().fracture_energy);
  std::vector<TipValues> values;
  for (std::size_t t = 0; t < factors.size(); ++t) {
    const bem::CrackTip& tip = cracks_->elements().tips[t];
    const bem::StressIntensity &constant = factors[t][0], &proportional = factors[t][1], &present = factors[t][2];
    values.push_back({cracks_->id_of(tip), tip.end == bem::TipEnd::end ? 1 : 0, tip.place, tip.direction,
                      present.factors, present.energy_release_rate, along[t],
                      error_of_difference * (present.factors - factors[t].back().factors).norm(),
                      kink_of(present.factors).angle,
                      critical_load_factor(constant.factors, proportional.factors, toughness), constant.factors,
                      proportional.factors, toughness, modulus});
  }
  return values;
}

std::vector<Point> BoundaryRegion::crack_openings(int crack, const std::vector<double>& fractions,
                                                  const Solution& solution) const {
  const Eigen::VectorXd openings = cracked_state(solution).openings;
  std::vector<Point> values;
  values.reserve(fractions.size());
  for (const double fraction : fractions) values.push_back(cracks_->opening_at(crack, fraction, openings));
  return values;
}

std::vector<CrackPicture> BoundaryRegion::crack_pictures(const Solution& solution) const {
  if (!cracks_) return {};
  std::vector<CrackPicture> pictures = cracks_->pictures(cracked_state(solution).openings);
  const UniformBodyForce particular = this->particular(solution.body_force(id()));
  const bem::InteriorEvaluator rest = interior_without(particular, solution);
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
  return cracks_->overlap(cracked_state(solution).openings);
}

}  // namespace bempd::regions

#include <cmath>
#include <limits>

#include "bem/coarse_level.hpp"
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

// The smallest load factor > 0 at which |constant + factor * proportional|^2 is `square`.
double critical_factor(const Point& constant, const Point& proportional, double square) {
  const double a = proportional.squaredNorm(), b = constant.dot(proportional), c = constant.squaredNorm() - square;
  const double root = b * b - a * c;
  constexpr double never = std::numeric_limits<double>::infinity();
  if (!(square > 0) || c >= 0) return square > 0 ? 0.0 : never;
  // Between the two roots, which have different signs, the crack stands still.
  return a > 0 ? (std::sqrt(root) - b) / a : never;
}

// The smallest load factor >= 0 at which the mode I factor that is worth constant + factor * proportional reaches the
// toughness. As the largest hoop stress it is a convex function of the load factor.
double growth_factor(const Point& constant, const Point& proportional, double toughness) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (!(toughness > 0)) return never;
  const auto excess = [&](double factor) {
    return bem::kink_of(constant + factor * proportional).equivalent_factor - toughness;
  };
  if (excess(0) >= 0) return 0;
  const double slope = bem::kink_of(proportional).equivalent_factor;
  if (!(slope > 0)) return never;
  // It lies above the factor times `slope` less what the constant part can take away.
  double low = 0, high = 2 * (toughness + 2 * constant.norm()) / slope;
  for (int i = 0; i < 100; ++i) (excess(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
  return high;
}

}  // namespace

const bem::CrackedOperator& BoundaryRegion::cracked() const {
  return static_cast<const bem::CrackedOperator&>(*operator_);
}

bem::CrackedState BoundaryRegion::cracked_state(const Eigen::VectorXd& displacement, const Solution& solution,
                                                double constant, double proportional) const {
  bem::CrackedState state;
  state.displacements = trace_ * gather(displacement);
  state.face_traction = cracks_->traction(loads_of(solution), constant, proportional);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(cracks_->elements().nodes.size()));
  if (state.face_traction) forces = bem::crack_forces(cracks_->elements(), state.face_traction, elasticity().thickness);
  state.openings = cracked().openings(state.displacements, forces);
  state.tractions = cracked().tractions(state.displacements, state.openings);
  return state;
}

bem::CrackedState BoundaryRegion::cracked_state(const Solution& solution) const {
  return cracked_state(solution.displacement, solution, 1, solution.load_factor);
}

Eigen::VectorXd BoundaryRegion::tractions_under(const Eigen::VectorXd& displacement, const Solution& solution) const {
  return cracks_ ? cracked_state(solution).tractions : Eigen::VectorXd(operator_->tractions(displacement));
}

void BoundaryRegion::add_crack_load(const CrackLoad& load, int part, Eigen::Ref<Eigen::VectorXd> force) const {
  const auto traction = cracks_->traction({load}, part == 0 ? 1 : 0, part == 0 ? 0 : 1);
  const Eigen::VectorXd forces = bem::crack_forces(cracks_->elements(), traction, elasticity().thickness);
  scatter(trace_.transpose() * cracked().forces_on_boundary(forces), force);
}

std::vector<TipValues> BoundaryRegion::tips(const Solution& solution) const {
  if (!cracks_ || cracks_->elements().tips.empty()) return {};
  const bem::CrackedState whole = cracked_state(solution);
  const auto factors = bem::stress_intensities(
      cracked(), {whole, bem::coarse_state(cracked(), whole), cracked_state(solution.parts->col(0), solution, 1, 0),
                  cracked_state(solution.parts->col(1), solution, 0, 1)});
  const std::vector<double> along = bem::stresses_along_crack(cracked(), whole);
  const double toughness = std::sqrt(bem::plane_modulus(elasticity()) * material().fracture_energy);
  std::vector<TipValues> values;
  for (std::size_t t = 0; t < factors.size(); ++t) {
    const bem::CrackTip& tip = cracks_->elements().tips[t];
    const auto& [present, coarse, constant, proportional] =
        std::tie(factors[t][0], factors[t][1], factors[t][2], factors[t][3]);
    const double growth = growth_factor(constant.factors, proportional.factors, toughness);
    const Point at_growth =
        std::isfinite(growth) ? Point(constant.factors + growth * proportional.factors) : present.factors;
    values.push_back({cracks_->id_of(tip), tip.end == bem::TipEnd::end ? 1 : 0, tip.place, tip.direction,
                      present.factors, present.energy_release_rate, along[t],
                      error_of_difference * (present.factors - coarse.factors).norm(),
                      bem::kink_of(present.factors).angle, growth, bem::kink_of(at_growth).angle,
                      critical_factor(constant.factors, proportional.factors, toughness * toughness)});
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
  return cracks_->pictures(cracked_state(solution).openings);
}

std::optional<Overlap> BoundaryRegion::overlap(const Solution& solution) const {
  if (!cracks_) return std::nullopt;
  return cracks_->overlap(cracked_state(solution).openings);
}

}  // namespace bempd::regions

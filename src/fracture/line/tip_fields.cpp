#include "fracture/line/tip_fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/pressed_faces.hpp"
#include "elasticity/kinked_tip.hpp"
#include "fracture/line/line_load.hpp"

namespace bempd::fracture {

namespace {

// Least ratio of the stress closely ahead of a tip to the stress around the tip. With a smaller ratio the stress
// closely ahead is only rounding.
constexpr double least_stress = 1e-8;

// Least ratio of the K_II of a shut crack to the size of its fitted K_I, which is negative under pressure across the
// crack. A smaller K_II is an error of the lattice under pressure alone, under which a crack never grows.
constexpr double least_shear_of_shut = 0.1;

}  // namespace

crack::GrowthLaw TipFields::growth_law(const pd::TipLaw& there, const GrowingTip& tip, const Point& place) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {there.toughness,           there.modulus,
          laws_.criterion,           there.directions,
          heading_of(tip.direction), {there.function, tip.id, place, tip.grown, {unknown, unknown}}};
}

// Whether the crack of a tip has begun during the run. Such a crack is short at first, and Williams' series does not
// contain the field of its other tip closely behind.
bool TipFields::has_begun(const GrowingTip& tip) const {
  return static_cast<std::size_t>(tip.id.crack) > laws_.of_crack.size();
}

// Stress intensity factors that give the turn of a tip whose crack has begun during the run, from the stress closely
// ahead. They are 0 (no turn) if that stress is only rounding.
AffineIntensity TipFields::factors_for_turn(const GrowingTip& tip, const AffineIntensity& by_fit,
                                            const coupling::Affine& displacement, double present) const {
  const pd::TipLaw law = law_of(tip).at(tip.acts_at(), tip.grown);
  AffineIntensity ahead = stress_.closely_ahead_of(tip, law, displacement, body_.loads().pressure_in(tip.id.crack));
  const auto size = [](const AffineIntensity& one, int part) { return std::hypot(one.one[part], one.two[part]); };
  const std::optional<double> critical = load_ratio(law.toughness, size(by_fit, 1));
  const double load_factor = std::max(std::abs(present), critical.value_or(0));
  const double around = std::max(size(by_fit, 0), load_factor * size(by_fit, 1));
  for (int part = 0; part < (critical ? 2 : 1); ++part)
    if ((part == 0 ? 1 : load_factor) * size(ahead, part) < least_stress * around)
      ahead.one[part] = ahead.two[part] = 0;
  return ahead;
}

bool TipFields::faces_press_at(const GrowingTip& tip) const {
  return coupling::faces_press_at(body_.system().constraints(), body_.positions(), tip.place, law_of(tip).horizon);
}

// Whether a tip is shut: the fit of stresses has K_I <= 0, and the crack faces press on each other. The tip of a kink
// beside pressed faces may be open; in that case the fit has K_I > 0.
bool TipFields::is_shut(const GrowingTip& tip, const WilliamsFit& fit) const {
  const AffineIntensity found = fit.factors(law_of(tip).horizon);
  return found.one.dot(Eigen::Vector2d(1, body_.state().load_factor)) <= 0 && faces_press_at(tip);
}

AffineIntensity TipFields::intensity_of(const GrowingTip& tip, const WilliamsFit& fit) const {
  AffineIntensity found = stress_.corrected_factors(fit.factors(law_of(tip).horizon));
  if (!laws_.loads_by_energy || !is_shut(tip, fit)) return found;
  const Eigen::Vector2d at(1, body_.state().load_factor);
  if (std::abs(found.two.dot(at)) < least_shear_of_shut * std::abs(found.one.dot(at))) found.two.setZero();
  found.one.setZero();
  return found;
}

AffineIntensity TipFields::intensity_for_load(const GrowingTip& tip, const WilliamsFit& fit) const {
  return laws_.loads_by_energy && is_shut(tip, fit) ? intensity_of(tip, fit)
                                                    : stress_.factors_for_load(fit, law_of(tip).horizon);
}

AffineIntensity TipFields::intensity_at(const GrowingTip& tip, const coupling::Affine& displacement) const {
  return intensity_of(tip, fitted(tip, law_of(tip), displacement));
}

bool TipFields::is_closed(const GrowingTip& tip, const coupling::Affine& displacement) const {
  return is_shut(tip, fitted(tip, law_of(tip), displacement));
}

double TipFields::kink_at(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const {
  const AffineIntensity fit = intensity_at(tip, displacement);
  const AffineIntensity turn_factors = has_begun(tip) ? factors_for_turn(tip, fit, displacement, load_factor) : fit;
  const Eigen::Vector2d at(1, load_factor);
  const Point factors(turn_factors.one.dot(at), turn_factors.two.dot(at));
  return law_of(tip).directions ? growth_law(tip, tip.place).kink(factors).angle : kink_of(factors).angle;
}

std::vector<int> TipFields::nodes_asked(const std::vector<GrowingTip>& tips) const {
  std::vector<int> nodes;
  for (const GrowingTip& tip : tips)
    if (!tip.has_ended()) stress_.add_nodes_asked(tip, law_of(tip), has_begun(tip), nodes);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace bempd::fracture

// Choice of the method that gives a tip's critical load: the fit of stresses, or the energy of a trial step where that
// fit does not hold.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coupling/pressed_faces.hpp"
#include "elasticity/kinked_tip.hpp"
#include "fracture/line/line_steps.hpp"
#include "fracture/line/on_limits.hpp"
#include "geometry/turning.hpp"

namespace bempd::fracture {

namespace {

// Largest residual of a fit that holds, as a share of the stress; it is larger for horizons of few spacings. There the
// field is rough, and the energy of a step, which cuts fewer bonds, gives loads within 5 % only (with four spacings
// within 2.5 %). Behind kinks the error of loads by the fit is about 1.8 * residual - 5 %.
constexpr double least_limit = 0.035, limit_of_residual = 0.7;  // the latter over the square of the spacings
// Largest residual of a fit whose direction a crack still follows.
constexpr double residual_without_direction = 0.2;
// Residual up to which a fit fully determines how the energy release rate begins behind a kink; from here to
// residual_without_direction its influence fades out.
constexpr double residual_with_shape = 0.1;
// T stress by which the rate behind a kink changes, over that of the fit. In a lattice a kink acts longer than the
// bonds that it cuts: with this value first loads by energy are those of boundary elements for any T stress, in the
// mean.
constexpr double t_stress_at_kinks = 1.2;
// Largest K_II / K_I for which the fit holds. With more shear K_II dominates, which the fit gives less accurately.
constexpr double largest_shear = 0.7;
// Least K_II of a shut crack over the K_I that the fit takes from the pressure across the crack. A smaller K_II is an
// error of the lattice under pressure alone, by which a crack never grows.
constexpr double least_shear_of_shut = 0.1;
// Distances in horizons that a fit needs: to any edge, face or other tip, and as length of its own crack.
constexpr double clear_horizons = 2, shortest_crack = 3;

// Factor by which the load of a fit that does not hold is too high at most, except where its direction does not hold
// either and where the tip seems shut: a step beyond this multiple of the smallest load cannot come first.
constexpr double most_by_fit = 4;

// Largest relative error of factors by sums around a tip that are taken. It is that of the smallest sum, which the
// mouth of a crack at the border disturbs; the largest one is right to 0.3 %.
constexpr double largest_error_around = 0.1;

// Relative errors of loads: by a fit that holds, their growth with the residual beyond least_residual, and by the
// energy.
constexpr double error_of_fit = 0.02, error_by_residual = 1.8, least_residual = 0.025, error_by_energy = 0.025;
// Relative error of a sheared tip's load by the fit: at no shear, its growth with the share of K_II^2, with the
// residual, and beside an edge or a face.
constexpr double error_of_sheared = 0.01, error_by_shear = 0.03, error_of_sheared_by_residual = 0.5,
                 error_of_crowded = 0.02;

// Relative error of a fit with another crack's face within a horizon of the tip, which leaves few points to it: neither
// its load nor its direction holds. Loads were up to 12 times too high there; those by the energy are up to 2.5 times
// those of boundary elements.
constexpr double error_beside_face = 1, error_by_energy_beside_face = 0.65;

bool direction_holds(const LineStep& step) {
  return step.residual <= residual_without_direction && step.error < error_beside_face;
}

double largest_residual(const pd::TipLaw& law) {
  return std::max(least_limit, limit_of_residual * std::pow(law.spacing / law.horizon, 2));
}

// Whether an edge lies within a horizon to a side of a tip. Factors by sums turn the tip towards it.
bool runs_along_edge(const GrowingTip& tip, const pd::TipLaw& law, const LineWay& way) {
  const int spacings = static_cast<int>(std::floor(law.horizon / law.spacing + rounding_of_places));
  const Point left = left_of(tip.direction);
  return way.clear_spacings(tip.place, left, law, spacings) < spacings ||
         way.clear_spacings(tip.place, -left, law, spacings) < spacings;
}

// Shape of the energy release rate behind a kink as the fit gives it, with less weight the larger the residual is. For
// pressed faces there is none, because the series is that of free faces.
KinkShape shape_of(const WilliamsFit& fit, const TipStress& stress, double horizon, const LineStep& step) {
  const double share = std::clamp(
      (residual_without_direction - step.residual) / (residual_without_direction - residual_with_shape), 0.0, 1.0);
  if (share == 0 || step.is_shut) return {};
  return {stress.as_read(fit.factors(horizon)), share * t_stress_at_kinks * fit.t_stress(), step.angle};
}

// Relative error of a sheared tip's load by the fit.
double sheared_error(double one, double two, const LineStep& step, bool is_crowded) {
  return error_of_sheared + error_by_shear * two * two / (one * one + two * two) +
         error_of_sheared_by_residual * std::max(step.residual - least_residual, 0.0) +
         (is_crowded ? error_of_crowded : 0);
}

// Replaces factors, load and turn of a step's fit by those of sums around its tip. `correction` is that of the fit.
void set_by_factors(const TipFactors& found, const LineLoad& load, const LoadWay& way, double correction,
                    LineStep& step) {
  const double load_factor = way.ahead(load.load_factor);
  const double by_fit = step.ratio_at(load_factor) / correction;
  const double by_factors = load.constant + load.load_factor * load.growing;
  const AffineIntensity& intensity = found.intensity;
  step.by_factors = true, step.error = found.error;
  step.rate_over_fit = by_fit > 0 ? std::pow(by_factors / by_fit, 2) : 1;
  step.factors = {{intensity.one[0], intensity.two[0]}, {intensity.one[1], intensity.two[1]}};
  step.load_factor = load_factor, step.constant = load.constant, step.growing = way.ahead(load.growing);
  step.angle = load.angle;
}

// Direction of a step by energy where that of its fit does not hold: among directions beside that of the fit. With a
// face within a horizon the fit may point to where the step would close; then directions up to 65 degrees off straight
// ahead are tried.
Point direction_by_energy(const GrowingTip& tip, const pd::TipLaw& law, const LineStep& step, const TrialSteps& trials,
                          const coupling::Affine& displacement, TrialBody& body) {
  const auto best_about = [&](const Point& middle) {
    return trials.best_direction(tip, law, middle, step.load_factor, displacement, body);
  };
  if (step.residual > residual_without_direction) return best_about(step.direction);
  const std::optional<TrialGrowth> own = trials.along(tip, law, step.direction, displacement, body);
  if (own && own->opens(step.load_factor)) return step.direction;
  Point best = step.direction;
  double largest = 0;
  for (const double aside : {0.0, 45.0, -45.0}) {
    const Point direction = best_about(turned(tip.direction, aside * std::numbers::pi / 180));
    const std::optional<TrialGrowth> growth = trials.along(tip, law, direction, displacement, body);
    const double ratio = growth ? growth->mean_ratio(step.load_factor) : 0;
    if (ratio > (1 + ratio_rounding) * largest) largest = ratio, best = direction;
  }
  return best;
}

// Takes the load by the energy, with its relative error; for a sheared tip the mean of both loads, weighted by the
// squares of their errors. The fit's load of such a tip depends less on its place between points, that of the energy
// less on what lies around (docs/cracks.md).
void blend(const LineLoad& by_energy, double error, LineStep& step) {
  const double share = step.blends ? error * error / (error * error + step.error * step.error) : 0;
  const double constant = std::lerp(by_energy.constant, step.constant, share);
  const double growing = std::lerp(by_energy.growing, step.growing, share);
  const std::optional<double> root = load_ratio(1 - constant, growing);
  const bool is_same_way = root && *root * by_energy.load_factor > 0;
  step.constant = is_same_way ? constant : by_energy.constant;
  step.growing = is_same_way ? growing : by_energy.growing;
  step.load_factor = is_same_way ? *root : by_energy.load_factor;
  step.error = std::sqrt(1 - share) * error;
}

}  // namespace

bool LineSteps::faces_press_at(const GrowingTip& tip) const {
  return coupling::faces_press_at(system_.constraints(), body_.positions(), tip.place, law_of(tip).horizon);
}

// Whether a tip is shut: its fit has no opening (K_I <= 0) and its faces press on each other. A kink beside pressed
// faces may be open; its fit then has K_I > 0.
bool LineSteps::is_shut(const GrowingTip& tip, const WilliamsFit& fit) const {
  const AffineIntensity found = fit.factors(law_of(tip).horizon);
  return found.one.dot(Eigen::Vector2d(1, body_.state().load_factor)) <= 0 && faces_press_at(tip);
}

AffineIntensity LineSteps::intensity_of(const GrowingTip& tip, const WilliamsFit& fit) const {
  AffineIntensity found = stress_.as_read(fit.factors(law_of(tip).horizon));
  if (!laws_.loads_by_energy || !is_shut(tip, fit)) return found;
  const Eigen::Vector2d at(1, body_.state().load_factor);
  if (std::abs(found.two.dot(at)) < least_shear_of_shut * std::abs(found.one.dot(at))) found.two.setZero();
  found.one.setZero();
  return found;
}

AffineIntensity LineSteps::intensity_for_load(const GrowingTip& tip, const WilliamsFit& fit) const {
  return laws_.loads_by_energy && is_shut(tip, fit) ? intensity_of(tip, fit)
                                                    : stress_.for_load(fit, law_of(tip).horizon);
}

AffineIntensity LineSteps::intensity_at(const GrowingTip& tip, const coupling::Affine& displacement) const {
  return intensity_of(tip, stress_.fitted(tip, law_of(tip), displacement, body_.pressure_in(tip.id.crack)));
}

bool LineSteps::is_closed(const GrowingTip& tip, const coupling::Affine& displacement) const {
  return is_shut(tip, stress_.fitted(tip, law_of(tip), displacement, body_.pressure_in(tip.id.crack)));
}

void LineSteps::judge_fit(const std::vector<GrowingTip>& tips, const WilliamsFit& fit, LineStep& step) const {
  step.fit_holds = true;
  step.residual = fit.residual(step.load_factor);
  step.error = error_of_fit + error_by_residual * std::max(step.residual - least_residual, 0.0);
  const GrowingTip& tip = tips[step.tip];
  const pd::TipLaw& law = law_of(tip);
  // A weak direction turns a tip far more sharply than its field does, and the counted lengths of such a turn say
  // little.
  if (!laws_.loads_by_energy || law.directions) return;
  step.is_shut = is_shut(tip, fit);
  const bool press = faces_press_at(tip),
             beside_face = stress_.is_beside_face(tip, law, (1 - rounding_of_places) * law.horizon);
  // Sums around the tip serve first loads only: farther on they cost a solution of the whole body at each step.
  const bool has_own_field =
      tip.grown == 0 && !has_begun(tip) && !step.is_shut && !press && !beside_face && !runs_along_edge(tip, law, way_);
  if (law.function) {  // it needs factors
    step.asks_around = has_own_field;
    step.fit_holds = !has_own_field;
    return;
  }
  const Eigen::Vector2d at(1, step.load_factor);
  const AffineIntensity factors = stress_.as_read(fit.factors(law.horizon));
  const bool is_sheared = std::abs(factors.two.dot(at)) > largest_shear * std::abs(factors.one.dot(at));
  // The distances are reduced by rounding, so that an equal distance counts as clear in whatever direction the scene is
  // turned.
  const double horizon = (1 - rounding_of_places) * law.horizon, clear = clear_horizons * horizon;
  const bool beside_tip = std::ranges::any_of(tips, [&](const GrowingTip& other) {
    const double reach = other.id.crack == tip.id.crack ? shortest_crack * horizon : clear;
    return &other != &tip && (other.place - tip.place).norm() < reach;
  });
  // An initial crack with all bonds across it cut acts longer than it is, unless the end of its cut is placed. Beside
  // an edge this affects the energy more than the fit, most of all under shear.
  const bool acts_longer = tip.energy_ratios.empty() && !tip.even_ahead;
  const bool is_crowded = (!acts_longer || is_sheared) && stress_.is_crowded(tip, law, clear);
  const bool is_told = is_sheared ? acts_longer && is_crowded && step.residual < residual_with_shape
                                  : !is_crowded && step.residual < largest_residual(law);
  const bool is_alone = !beside_tip && !press && !stress_.meets_other_material(tip, law, clear);
  const bool by_hoop = laws_.criterion == KinkCriterion::hoop_stress;
  step.at_border = is_alone && stress_.lacks_points(tip, law);
  step.fit_would_hold = by_hoop && is_told && is_alone;
  step.asks_around = step.at_border || has_own_field;
  step.factors_suffice = step.at_border || (by_hoop && !(is_sheared && is_crowded));
  step.fit_holds = step.fit_would_hold && !step.asks_around;
  if (beside_face) step.error = std::max(step.error, error_beside_face);
  step.blends = is_sheared && is_alone && step.residual < residual_with_shape && step.error < error_beside_face;
  if (step.blends) step.error = sheared_error(factors.one.dot(at), factors.two.dot(at), step, is_crowded);
}

bool need_body(const std::vector<LineStep>& steps, const LoadWay& way) {
  double first = std::numeric_limits<double>::infinity();
  for (const LineStep& step : steps) first = std::min(first, std::abs(way.place_of(step.load_factor)));
  return std::ranges::any_of(steps, [&](const LineStep& step) {
    const bool is_bounded = !step.is_shut && direction_holds(step);
    return !step.fit_holds && (!is_bounded || std::abs(way.place_of(step.load_factor)) <= most_by_fit * first);
  });
}

bool LineSteps::take_factors(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way,
                             TrialBody& body, LineStep& step) const {
  const std::optional<TipFactors> found = body.factors_around(tip, displacement);
  if (!found || !(found->error < largest_error_around)) return false;
  const pd::TipLaw law = law_of(tip).at(tip.acts_at(), tip.grown);
  const AffineIntensity intensity = on_way(found->intensity, way);
  LineCriterion criterion{growth_law(law, tip, tip.acts_at()), 1, way.ahead(way.present), way.control};
  const Point t_stress = law.function ? t_stress_at(tip, displacement) : Point(0, 0);
  if (law.function) criterion.law.asking.t_stress = {t_stress.x(), way.ahead(t_stress.y())};
  const std::optional<LineLoad> load = load_of_growth(intensity, intensity, criterion);
  const Point direction = load ? turned(tip.direction, load->angle) : tip.direction;
  const LineWay::Step its = way_.next(tip.place, direction, law);
  if (!load || its.bonds.empty()) return false;
  set_by_factors(*found, *load, way, correction_of(tip), step);
  step.direction = direction, step.way = its;
  // The load is that of the energy alone by the energy criterion; beside an edge the mean of both for a sheared tip.
  step.blends = !step.factors_suffice && laws_.criterion == KinkCriterion::hoop_stress;
  if (step.blends) step.error += error_of_crowded;
  if (law.function)
    step.toughness = criterion.law.toughness;
  else if (!step.at_border)
    step.taken_energy = trials_.energy_of_step(tip, law, direction);
  return true;
}

// Replaces the load by the fit by that of sums around the tip, or of a trial step's energy. Cracks under fluid pressure
// have none by energy: fluid would follow into the step, which the energy does not contain.
void LineSteps::try_step(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way,
                         TrialBody& body, LineStep& step) const {
  const bool around = step.asks_around && take_factors(tip, displacement, way, body, step);
  if (around ? step.factors_suffice : step.fit_would_hold) return;
  if (!body_.pressure_in(tip.id.crack).isZero(0) || body_.has_fluid()) return;
  const pd::TipLaw& law = law_of(tip);
  if (!around && !direction_holds(step) && !has_begun(tip)) {
    const Point better = direction_by_energy(tip, law, step, trials_, displacement, body);
    const LineWay::Step its = way_.next(tip.place, better, law);
    if (!its.bonds.empty()) {
      step.angle += std::atan2(cross(step.direction, better), step.direction.dot(better));
      step.direction = better, step.way = its;
    }
  }
  std::optional<TrialGrowth> growth = trials_.along(tip, law, step.direction, displacement, body);
  if (!growth) return;
  const WilliamsFit fit = stress_.fitted(tip, law, displacement, body_.pressure_in(tip.id.crack));
  growth->shape(shape_of(fit, stress_, law.horizon, step));
  const std::optional<LineLoad> load = growth->load(step.load_factor, way.sense(), displacement.col(0).isZero(0));
  if (!load) return;
  // A tip whose faces are shut grows by shear alone, as the fit has it: the rate behind its kink falls too fast to
  // extrapolate. Behind a turn it only seems shut, because the fit reads the field of the tip before the turn; there
  // the energy gives the load, which is the smaller one.
  if (step.is_shut && tip.grown == 0 && step.residual < residual_without_direction &&
      way.ahead(load->load_factor) > way.ahead(step.load_factor))
    return;
  step.by_energy = true, step.by_factors = false, step.taken_energy = growth->first_energy();
  // A tip that is overloaded at the start of the path is due there, even if a smaller load would suffice further on.
  const bool is_due = way.control == Control::load && way.ahead(load->load_factor) > way.ahead(way.present) &&
                      growth->opens(way.present) && growth->ratio(way.present) >= 1 + ratio_rounding;
  step.after_step = growth->ratio_after(load->load_factor) / growth->ratio(load->load_factor);
  const double least_error = step.error < error_beside_face ? 0 : error_by_energy_beside_face;
  blend(*load, std::max(error_by_energy + growth->error(load->load_factor), least_error), step);
  if (is_due) step.load_factor = way.present;
}

}  // namespace bempd::fracture

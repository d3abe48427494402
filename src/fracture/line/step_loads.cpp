#include "fracture/line/step_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "elasticity/kinked_tip.hpp"
#include "fracture/line/line_growth.hpp"
#include "fracture/line/on_limits.hpp"
#include "geometry/turning.hpp"

namespace bempd::fracture {

namespace {

// Largest residual with which a fit of stresses holds, as a share of the stress: least_limit, or limit_of_residual over
// the square of the horizon in spacings, if that is larger. With few spacings in a horizon the stress field is rough,
// and the energy of a step, which cuts few bonds, gives load factors within 5 % only (with four spacings within 2.5 %).
// Behind kinks the relative error of load factors by the fit is about 1.8 * residual - 5 %.
constexpr double least_limit = 0.035, limit_of_residual = 0.7;
// Largest residual with which a fit of stresses gives the direction of a step.
constexpr double residual_without_direction = 0.2;
// Largest residual with which the T-stress of the fit counts fully for the energy release rate at the beginning of a
// kink. With larger residuals the T-stress counts less, and with residual_without_direction not at all.
constexpr double residual_with_shape = 0.1;
// Factor on the T-stress of the fit, by which the energy release rate changes behind a kink. The factor is above 1
// because in a lattice a kink acts longer than the bonds that it cuts. It is measured so that load factors of first
// growth by energy are in the mean those of boundary elements, for any T-stress.
constexpr double t_stress_at_kinks = 1.2;
// Largest K_II / K_I for which the fit of stresses gives the load factor. Under more shear K_II dominates, which the
// fit gives less accurately.
constexpr double largest_shear = 0.7;
// Distances in horizons that a fit of stresses needs: from the tip to any edge, face or other tip (clear_horizons), and
// between the two tips of the tip's own crack (shortest_crack).
constexpr double clear_horizons = 2, shortest_crack = 3;

// Largest ratio of the load factor by a fit that does not hold to the correct load factor. A step whose load factor
// exceeds the smallest one by more than this ratio cannot come first. There is no such bound if the fit's direction
// does not hold either, or if the tip seems shut.
constexpr double most_by_fit = 4;

// Largest relative error with which stress intensity factors by sums around a tip are used. The error is that of the
// smallest path, which the mouth of a crack (where it meets an edge) disturbs; the largest path is right to 0.3 %.
constexpr double largest_error_around = 0.1;

// Relative errors of load factors: by a fit with a residual up to least_residual (error_of_fit), its increase per
// residual beyond least_residual (error_by_residual), and by the energy of a trial step (error_by_energy).
constexpr double error_of_fit = 0.02, error_by_residual = 1.8, least_residual = 0.025, error_by_energy = 0.025;
// Relative error of the load factor by the fit for a tip under shear, as a sum: of error_of_sheared, error_by_shear
// times K_II^2 / (K_I^2 + K_II^2), error_of_sheared_by_residual times the residual beyond least_residual, and, beside
// an edge or a face, error_of_crowded.
constexpr double error_of_sheared = 0.01, error_by_shear = 0.03, error_of_sheared_by_residual = 0.5,
                 error_of_crowded = 0.02;

// Relative errors of load factors by the fit (error_beside_face) and by the energy (error_by_energy_beside_face), with
// another crack's face within a horizon of the tip. The fit has few points there, so neither its load factor nor its
// direction holds. Load factors by the fit were up to 12 times too high; those by the energy are up to 2.5 times those
// of boundary elements.
constexpr double error_beside_face = 1, error_by_energy_beside_face = 0.65;

bool direction_holds(const LineStep& step) {
  return step.residual <= residual_without_direction && step.error < error_beside_face;
}

double largest_residual(const pd::TipLaw& law) {
  return std::max(least_limit, limit_of_residual * std::pow(law.spacing / law.horizon, 2));
}

// Whether an edge lies within a horizon to the left or right of a tip. Such an edge falsifies the stress intensity
// factors that sums over the bonds around the tip give: they turn the tip towards the edge.
bool runs_along_edge(const GrowingTip& tip, const pd::TipLaw& law, const LinePath& path) {
  const int spacings = static_cast<int>(std::floor(law.horizon / law.spacing + rounding_of_places));
  const Point left = left_of(tip.direction);
  return path.clear_spacings(tip.place, left, law, spacings) < spacings ||
         path.clear_spacings(tip.place, -left, law, spacings) < spacings;
}

// Change of the energy release rate along a kink, by the stress intensity factors and the T-stress of the fit. The
// larger the residual of the fit, the less its T-stress counts. The rate is constant if the residual is too large, or
// if crack faces press on each other, because Williams' series is that of free faces.
KinkShape shape_of(const WilliamsFit& fit, const TipStress& stress, double horizon, const LineStep& step) {
  const double share = std::clamp(
      (residual_without_direction - step.residual) / (residual_without_direction - residual_with_shape), 0.0, 1.0);
  if (share == 0 || step.is_shut) return {};
  return {stress.corrected_factors(fit.factors(horizon)), share * t_stress_at_kinks * fit.t_stress(), step.angle};
}

// Relative error of the load factor that the fit gives for a tip under shear with K_I = `one` and K_II = `two`.
double sheared_error(double one, double two, const LineStep& step, bool is_crowded) {
  return error_of_sheared + error_by_shear * two * two / (one * one + two * two) +
         error_of_sheared_by_residual * std::max(step.residual - least_residual, 0.0) +
         (is_crowded ? error_of_crowded : 0);
}

// Replaces the stress intensity factors, load factor and angle of a step, which come from the fit, by those of sums
// around the tip. `correction` is the factor by which the fit is corrected (LineGrowth::correction_of()).
void set_by_factors(const TipFactors& found, const LineLoad& load, const LoadWay& way, double correction,
                    LineStep& step) {
  const double load_factor = way.ahead(load.load_factor);
  const double by_fit = step.ratio_at(load_factor) / correction;
  const double by_factors = load.constant + load.load_factor * load.growing;
  const AffineIntensity& intensity = found.intensity;
  step.load_by_sums = true, step.error = found.error;
  step.rate_over_fit = by_fit > 0 ? std::pow(by_factors / by_fit, 2) : 1;
  step.factors = {{intensity.one[0], intensity.two[0]}, {intensity.one[1], intensity.two[1]}};
  step.load_factor = load_factor, step.constant = load.constant, step.growing = way.ahead(load.growing);
  step.angle = load.angle;
}

// Direction of a step by the energies of trial steps, used if the direction of the fit does not hold. If the residual
// of the fit is too large, it is the best direction near that of the fit. Otherwise another crack's face lies within a
// horizon: the direction of the fit stays if a step in it opens the crack; if not, directions up to 65 degrees off
// straight ahead are tried.
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

// Sets a step's load factor and its relative error by the energy of a trial step. For a tip under shear the load factor
// is the mean of those by the energy and by the fit, with weights inverse to the squares of their errors: that by the
// fit depends less on the tip's place between points, that by the energy less on what lies around (docs/cracks.md).
void average_loads(const LineLoad& by_energy, double error, LineStep& step) {
  const double share = step.averages_loads ? error * error / (error * error + step.error * step.error) : 0;
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

AffineIntensity along_load_path(AffineIntensity intensity, const LoadWay& way) {
  intensity.one[1] *= way.sense(), intensity.two[1] *= way.sense();
  return intensity;
}

void StepLoads::judge_fit(const std::vector<GrowingTip>& tips, const WilliamsFit& fit, LineStep& step) const {
  step.fit_holds = true;
  step.residual = fit.residual(step.load_factor);
  step.error = error_of_fit + error_by_residual * std::max(step.residual - least_residual, 0.0);
  const GrowingTip& tip = tips[step.tip];
  const pd::TipLaw& law = fields_.law_of(tip);
  // A direction with little fracture energy turns a tip far more sharply than the stress field does. The stiffness that
  // such a turn cuts says little of its length, so that the load factor by the fit is kept.
  if (!fields_.laws().loads_by_energy || law.directions) return;
  step.is_shut = fields_.is_shut(tip, fit);
  const bool press = fields_.faces_press_at(tip),
             beside_face = fields_.stress().is_beside_face(tip, law, (1 - rounding_of_places) * law.horizon);
  const bool may_sum =
      !fields_.has_begun(tip) && !step.is_shut && !press && !beside_face && !runs_along_edge(tip, law, path_);
  // Stress intensity factors by sums over the bonds around the tip give the load factors of first steps, and of steps
  // towards an edge. At other steps they are not used, because each sum needs a solution of the whole body.
  const bool has_own_field = may_sum && tip.grown == 0;
  if (law.function) {  // the function of the host needs stress intensity factors
    step.asks_for_sums = has_own_field;
    step.fit_holds = !has_own_field;
    return;
  }
  const Eigen::Vector2d at(1, step.load_factor);
  const AffineIntensity factors = fields_.stress().corrected_factors(fit.factors(law.horizon));
  const bool is_sheared = std::abs(factors.two.dot(at)) > largest_shear * std::abs(factors.one.dot(at));
  // Required distances are reduced by rounding, so that a distance equal to the limit counts as clear in whatever
  // direction the scene is turned.
  const double horizon = (1 - rounding_of_places) * law.horizon, clear = clear_horizons * horizon;
  const bool beside_tip = std::ranges::any_of(tips, [&](const GrowingTip& other) {
    const double reach = other.id.crack == tip.id.crack ? shortest_crack * horizon : clear;
    return &other != &tip && (other.place - tip.place).norm() < reach;
  });
  // An initial crack with all bonds across it cut acts as if it were longer, unless its cut was chosen so that the
  // effective tip lies where the crack was described to end (even_ahead). Beside an edge the extra length affects the
  // energy of a trial step more than the fit, most of all under shear.
  const bool acts_longer = tip.energy_ratios.empty() && !tip.even_ahead;
  const bool is_crowded = (!acts_longer || is_sheared) && fields_.stress().is_crowded(tip, law, clear);
  const bool is_told = is_sheared ? acts_longer && is_crowded && step.residual < residual_with_shape
                                  : !is_crowded && step.residual < largest_residual(law);
  const bool is_alone = !beside_tip && !press && !fields_.stress().meets_other_material(tip, law, clear);
  const bool by_hoop = fields_.laws().criterion == KinkCriterion::hoop_stress;
  step.at_border = is_alone && fields_.stress().lacks_points(tip, law);
  step.fit_holds_without_sums = by_hoop && is_told && is_alone;
  step.asks_for_sums = step.at_border || has_own_field || (may_sum && is_alone && is_crowded && !is_sheared);
  step.sums_suffice = step.at_border || (by_hoop && !(is_sheared && is_crowded));
  step.fit_holds = step.fit_holds_without_sums && !step.asks_for_sums;
  if (beside_face) step.error = std::max(step.error, error_beside_face);
  step.averages_loads = is_sheared && is_alone && step.residual < residual_with_shape && step.error < error_beside_face;
  if (step.averages_loads) step.error = sheared_error(factors.one.dot(at), factors.two.dot(at), step, is_crowded);
}

bool needs_trial_step(const std::vector<LineStep>& steps, const LoadWay& way) {
  double first = std::numeric_limits<double>::infinity();
  for (const LineStep& step : steps) first = std::min(first, std::abs(way.place_of(step.load_factor)));
  return std::ranges::any_of(steps, [&](const LineStep& step) {
    const bool is_bounded = !step.is_shut && direction_holds(step);
    return !step.fit_holds && (!is_bounded || std::abs(way.place_of(step.load_factor)) <= most_by_fit * first);
  });
}

bool StepLoads::take_factors(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way,
                             TrialBody& body, LineStep& step) const {
  const std::optional<TipFactors> found = body.factors_around(tip, displacement);
  if (!found || !(found->error < largest_error_around)) return false;
  const pd::TipLaw law = fields_.law_of(tip).at(tip.acts_at(), tip.grown);
  const AffineIntensity intensity = along_load_path(found->intensity, way);
  LineCriterion criterion{fields_.growth_law(law, tip, tip.acts_at()), 1, way.ahead(way.present), way.control};
  const Point t_stress = law.function ? fields_.t_stress_at(tip, displacement) : Point(0, 0);
  if (law.function) criterion.law.asking.t_stress = {t_stress.x(), way.ahead(t_stress.y())};
  const std::optional<LineLoad> load = load_of_growth(intensity, intensity, criterion);
  const Point direction = load ? turned(tip.direction, load->angle) : tip.direction;
  const LinePath::Step its = path_.next(tip.place, direction, law);
  if (!load || its.bonds.empty()) return false;
  set_by_factors(*found, *load, way, LineGrowth::correction_of(tip), step);
  step.direction = direction, step.path = its;
  // If the stress intensity factors by the sums do not suffice, a trial step's energy gives the load factor: alone if
  // growth is by the energy criterion; otherwise (for a tip under shear beside an edge) in the mean with that by the
  // sums.
  step.averages_loads = !step.sums_suffice && fields_.laws().criterion == KinkCriterion::hoop_stress;
  if (step.averages_loads) step.error += error_of_crowded;
  if (law.function)
    step.toughness = criterion.law.toughness;
  else if (!step.at_border)
    step.taken_energy = trials_.energy_of_step(tip, law, direction);
  return true;
}

// Replaces the load factor by the fit by that of sums around the tip, or of a trial step's energy. Cracks under fluid
// pressure get no load factor by a trial step, because the fluid would follow into the step, and the step's energy does
// not contain the work of the fluid.
void StepLoads::replace(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way,
                        TrialBody& body, LineStep& step) const {
  const bool around = step.asks_for_sums && take_factors(tip, displacement, way, body, step);
  if (around ? step.sums_suffice : step.fit_holds_without_sums) return;
  if (!body_.loads().pressure_in(tip.id.crack).isZero(0) || body_.loads().has_fluid()) return;
  const pd::TipLaw& law = fields_.law_of(tip);
  if (!around && !direction_holds(step) && !fields_.has_begun(tip)) {
    const Point better = direction_by_energy(tip, law, step, trials_, displacement, body);
    const LinePath::Step its = path_.next(tip.place, better, law);
    if (!its.bonds.empty()) {
      step.angle += std::atan2(cross(step.direction, better), step.direction.dot(better));
      step.direction = better, step.path = its;
    }
  }
  std::optional<TrialGrowth> growth = trials_.along(tip, law, step.direction, displacement, body);
  if (!growth) return;
  const WilliamsFit fit = fields_.fitted(tip, law, displacement);
  growth->shape(shape_of(fit, fields_.stress(), law.horizon, step));
  const std::optional<LineLoad> load = growth->load(step.load_factor, way.sense(), displacement.col(0).isZero(0));
  if (!load) return;
  // A tip whose faces are shut grows by shear alone, and the fit gives its load factor: the energy release rate behind
  // its kink falls too fast to be extrapolated. Behind a turn a tip only seems shut, because the fit shows the stress
  // field of the tip before the turn; in that case the energy gives the load factor, which is the smaller one.
  if (step.is_shut && tip.grown == 0 && step.residual < residual_without_direction &&
      way.ahead(load->load_factor) > way.ahead(step.load_factor))
    return;
  step.load_by_trial = true, step.load_by_sums = false, step.taken_energy = growth->first_energy();
  // A tip that is overloaded at the start of the path grows at once, even if the search finds a load factor farther on.
  const bool is_due = way.control == Control::load && way.ahead(load->load_factor) > way.ahead(way.present) &&
                      growth->opens(way.present) && growth->ratio(way.present) >= 1 + ratio_rounding;
  step.after_step = growth->ratio_after(load->load_factor) / growth->ratio(load->load_factor);
  const double least_error = step.error < error_beside_face ? 0 : error_by_energy_beside_face;
  average_loads(*load, std::max(error_by_energy + growth->error(load->load_factor), least_error), step);
  if (is_due) step.load_factor = way.present;
}

}  // namespace bempd::fracture

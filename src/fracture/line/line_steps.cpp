#include "fracture/line/line_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "crack/order.hpp"
#include "elasticity/kinked_tip.hpp"
#include "fracture/line/on_limits.hpp"
#include "geometry/turning.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

namespace {

// Number of last steps whose energies correct the load factor, and number of additional steps that count as exact,
// which dampen the correction.
constexpr std::size_t remembered_steps = 8;
constexpr double steps_taken_exact = 2;

// Limits on the ratio of released to expected energy of a step, by which the loads of later steps are corrected. A step
// behind a sharp kink or beside an edge releases little at first.
constexpr double least_ratio = 0.5, largest_ratio = 2;

// Distance from a tip, in horizons, within which no bond breaks by itself.
constexpr double guarded_reach = 3;
// Distance from an unloading tip, in horizons, within which overloaded bonds do not break.
constexpr double relaxing_reach = 1;

// Critical load factor of a tip over that of the event considered, beyond which the tip's intensity is only rounding,
// as in a part without stress.
constexpr double farthest_load = 1e6;
// Stress closely ahead of a tip over the stress around it below which it counts as zero.
constexpr double least_stress = 1e-8;

double distance_to(const std::vector<Edge>& edges, const Point& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) nearest = std::min(nearest, distance(edge, place));
  return nearest;
}

Point middle_of(const coupling::Terms& terms, int term, const std::vector<Point>& positions) {
  const auto t = static_cast<std::size_t>(term);
  return (positions[static_cast<std::size_t>(terms.first[t])] + positions[static_cast<std::size_t>(terms.second[t])]) /
         2;
}

// Law of the region in which the nearest material point ahead of a tip lies; the tip's present law if there is no point
// near.
int law_ahead_of(const GrowingTip& tip, const pd::TipLaws& laws, const NearPoints& near,
                 const std::vector<Point>& positions) {
  const pd::TipLaw& law = laws.laws[static_cast<std::size_t>(tip.law)];
  double nearest = law.horizon;
  int found = tip.law;
  for (const int node : near.about(tip.place, law.horizon)) {
    const int number = laws.of_node[static_cast<std::size_t>(node)];
    const Point way = positions[static_cast<std::size_t>(node)] - tip.place;
    if (number < 0 || way.dot(tip.direction) <= rounding_of_places * law.spacing) continue;
    if (way.norm() >= nearest - rounding_of_places * law.spacing) continue;
    nearest = way.norm(), found = number;
  }
  return found;
}

}  // namespace

AffineIntensity LineSteps::on_way(AffineIntensity intensity, const LoadWay& way) {
  intensity.one[1] *= way.sense(), intensity.two[1] *= way.sense();
  return intensity;
}

double LineSteps::correction_of(const GrowingTip& tip) {
  const double sum = std::accumulate(tip.energy_ratios.begin(), tip.energy_ratios.end(), steps_taken_exact);
  return std::sqrt(sum / (steps_taken_exact + static_cast<double>(tip.energy_ratios.size())));
}

LineSteps::LineSteps(LoadedBody& body, pd::TipLaws laws)
    : body_(body),
      system_(body.system()),
      laws_(std::move(laws)),
      stress_(body.system(), body.positions(), laws_),
      way_(body.system(), body.positions(), stress_),
      trials_(body.system(), laws_, way_) {}

// Whether the tip's crack began in the run. Its other tip is then closely behind at first, which the fitted series does
// not take into account.
bool LineSteps::has_begun(const GrowingTip& tip) const {
  return static_cast<std::size_t>(tip.id.crack) > laws_.of_crack.size();
}

// Stress intensity factors for the turn of a tip whose crack began in the run: from the stress closely ahead. They are
// 0 (no turn) if that stress is only rounding.
AffineIntensity LineSteps::turning_of(const GrowingTip& tip, const AffineIntensity& by_fit,
                                      const coupling::Affine& displacement, double present) const {
  const pd::TipLaw law = law_of(tip).at(tip.acts_at(), tip.grown);
  AffineIntensity ahead = stress_.closely_ahead_of(tip, law, displacement, body_.pressure_in(tip.id.crack));
  const auto size = [](const AffineIntensity& one, int part) { return std::hypot(one.one[part], one.two[part]); };
  const std::optional<double> critical = load_ratio(law.toughness, size(by_fit, 1));
  const double load_factor = std::max(std::abs(present), critical.value_or(0));
  const double around = std::max(size(by_fit, 0), load_factor * size(by_fit, 1));
  for (int part = 0; part < (critical ? 2 : 1); ++part)
    if ((part == 0 ? 1 : load_factor) * size(ahead, part) < least_stress * around)
      ahead.one[part] = ahead.two[part] = 0;
  return ahead;
}

std::optional<LineStep> LineSteps::next(const std::vector<GrowingTip>& tips, std::size_t number,
                                        const coupling::Affine& displacement, const LoadWay& load_way) const {
  const GrowingTip& tip = tips[number];
  const pd::TipLaw law = law_of(tip).at(tip.acts_at(), tip.grown);
  if (std::isinf(law.toughness)) return std::nullopt;
  const WilliamsFit fit = stress_.fitted(tip, law, displacement, body_.pressure_in(tip.id.crack));
  const AffineIntensity by_fit = intensity_of(tip, fit);
  const double present = load_way.ahead(load_way.present);
  const AffineIntensity intensity = on_way(intensity_for_load(tip, fit), load_way);
  const AffineIntensity turning =
      on_way(has_begun(tip) ? turning_of(tip, by_fit, displacement, present) : by_fit, load_way);
  LineCriterion criterion{growth_law(law, tip, tip.acts_at()), correction_of(tip), present, load_way.control};
  if (law.function) criterion.law.asking.t_stress = {fit.t_stress()[0], load_way.ahead(fit.t_stress()[1])};
  const std::optional<LineLoad> load = load_of_growth(intensity, turning, criterion);
  if (!load) return std::nullopt;
  LineStep step;
  if (law.function) step.toughness = criterion.law.toughness;
  step.tip = number, step.id = tip.id, step.law = tip.law, step.angle = load->angle,
  step.direction = turned(tip.direction, load->angle);
  step.factors = {{by_fit.one[0], by_fit.two[0]}, {by_fit.one[1], by_fit.two[1]}};
  step.load_factor = load_way.ahead(load->load_factor);
  step.constant = load->constant, step.growing = load_way.ahead(load->growing);
  step.way = way_.next(tip.place, step.direction, law);
  if (step.way.bonds.empty()) return std::nullopt;
  judge_fit(tips, fit, step);
  return step;
}

std::vector<LineStep> LineSteps::all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                                     const LoadWay& way, TrialBody* body, bool with_frozen) const {
  std::vector<LineStep> steps;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    if (has_ended(tips[k]) || (!with_frozen && rests(tips[k]))) continue;
    if (std::optional<LineStep> step = next(tips, k, displacement, way)) steps.push_back(std::move(*step));
  }
  if (body && need_body(steps, way))
    for (LineStep& step : steps)
      if (!step.fit_holds) try_step(tips[step.tip], displacement, way, *body, step);
  return steps;
}

std::vector<crack::Candidate> LineSteps::candidates(const std::vector<LineStep>& steps, const LoadWay& way) {
  std::vector<crack::Candidate> all;
  for (const LineStep& step : steps)
    all.push_back(crack::candidate(step.id, step.load_factor, step.ratio_at(way.present), way));
  return all;
}

bool LineSteps::is_driven(const LineStep& step, const LoadWay& way, double load_factor) {
  return way.ahead(step.load_factor) <= farthest_load * std::abs(load_factor);
}

LineSteps::Choice LineSteps::choose(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                                    const LoadWay& way, TrialBody* body) const {
  Choice choice{all(tips, displacement, way, body), std::nullopt, way.end()};
  choice.needs_body = !body && need_body(choice.steps, way);
  const std::optional<crack::FirstToGrow> first = crack::first_to_grow(candidates(choice.steps, way), way.upwards);
  if (!first) return choice;
  choice.first = choice.steps[first->index], choice.ties = first->ties;
  choice.load_factor = way.place_of(choice.first->load_factor);
  return choice;
}

Event LineSteps::event_of(const LineStep& step, double load_factor) const {
  Event event{load_factor, step.ratio_at(load_factor), step.load_factor, {}};
  event.tip = step.id;
  if (!step.way.arrives()) event.taken_energy = step.taken_energy;
  for (const int bond : step.way.bonds) event.changes.push_back(system_.terms().breaking(bond));
  return event;
}

std::vector<GrowingTip> LineSteps::guarded(const std::vector<LineStep>& steps, const std::vector<GrowingTip>& tips,
                                           const LoadWay& way, double load_factor) const {
  std::vector<GrowingTip> found;
  for (const LineStep& step : steps)
    if (is_driven(step, way, load_factor)) found.push_back(tips[step.tip]);
  for (const GrowingTip& tip : tips)
    if (rests(tip)) found.push_back(tip);
  return found;
}

// Ratio of the equivalent factor to the toughness after a step. In a region with another modulus it is scaled so that
// its square gives the energy release rate.
double LineSteps::ratio_after(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                              double load_factor) const {
  const Eigen::Vector2d at(1, load_factor);
  const AffineIntensity found = intensity_at(tip, displacement);
  const double factor = kink_of({found.one.dot(at), found.two.dot(at)}, laws_.criterion).equivalent_factor;
  const double modulus = law_of(tip).modulus;
  return factor / law.toughness * (modulus == law.modulus ? 1 : std::sqrt(law.modulus / modulus));
}

void LineSteps::move(const LineStep& step, std::vector<GrowingTip>& tips) const {
  GrowingTip& tip = tips[step.tip];
  tip.place += step.way.length * step.direction;
  tip.grown += step.way.length;
  tip.even_ahead.reset();
  tip.direction = step.direction;
  if (laws_.laws.size() > 1) tip.law = law_ahead_of(tip, laws_, stress_.near(), body_.positions());
}

crack::TipState LineSteps::state_at_edge(const Point& place) const {
  const bool at_hole = distance_to(laws_.hole_edges, place) < distance_to(laws_.outer_edges, place);
  return at_hole ? crack::TipState::at_hole : crack::TipState::at_edge;
}

crack::Extension LineSteps::take(const LineStep& step, const Event& event, double released_energy,
                                 const DisplacementAt& displacement_at, std::vector<GrowingTip>& tips) const {
  move(step, tips);
  return remember(step, event.ratio, released_energy, displacement_at(tips), event.load_factor, tips);
}

crack::Extension LineSteps::remember(const LineStep& step, double ratio, double released_energy,
                                     const coupling::Affine& displacement, double load_factor,
                                     std::vector<GrowingTip>& tips) const {
  GrowingTip& tip = tips[step.tip];
  const Point from = tip.place - step.way.length * step.direction;
  const double grown_before = tip.grown - step.way.length;
  pd::TipLaw law = laws_.laws[static_cast<std::size_t>(step.law)].at(from, grown_before);
  const double share_of_direction = law.directions ? law.directions->share(heading_of(step.direction)) : 1;
  if (law.directions) law.toughness *= std::sqrt(share_of_direction);
  if (step.toughness > 0) law.toughness = step.toughness;
  // The event's ratio contains the correction by earlier steps, which must not enter the remembered ratios.
  const double before = step.by_energy || step.by_factors ? ratio : ratio / correction_of(tip);
  // The expected energy is the mean of the rates at both ends of the step: the rate changes by up to a half within a
  // spacing behind a kink or near an edge.
  const bool arrives = step.way.arrives();
  const double after = arrives          ? before
                       : step.by_energy ? before * step.after_step
                                        : std::sqrt(step.rate_over_fit) *
                                              std::max(ratio_after(tip, law, displacement, load_factor), 0.0);
  const double fracture_energy = law.toughness * law.toughness / law.modulus;
  const double rate = fracture_energy * (before * before + after * after) / 2;
  const double expected = rate * law.thickness * step.way.length;
  const double released = step.by_factors ? step.rate_over_fit : expected > 0 ? released_energy / expected : 1;
  // The energy of the first step depends on where the crack was described to end between the points, so it is not used.
  // A load by an energy says nothing of the fit, whose correction then stays as it is.
  const bool is_first = tip.energy_ratios.empty();
  if (is_first || !step.by_energy)
    tip.energy_ratios.push_back(is_first ? 1 : std::clamp(released, least_ratio, largest_ratio));
  if (tip.energy_ratios.size() > remembered_steps) tip.energy_ratios.erase(tip.energy_ratios.begin());
  tip.state = step.way.ends_as == crack::TipState::at_edge ? state_at_edge(tip.place) : step.way.ends_as;
  crack::Extension extension =
      crack::begin_extension(tip.id, from, step.angle, load_factor, step.factors, fracture_energy);
  crack::arrive(extension, tip.place, step.way.length, tip.state);
  const pd::TipLaw there = laws_.laws[static_cast<std::size_t>(step.law)].at(tip.place, tip.grown);
  const double energy_there =
      law.function ? fracture_energy : there.toughness * there.toughness / there.modulus * share_of_direction;
  const double mean_energy = (fracture_energy + energy_there) / 2;
  extension.surface_energy = mean_energy * law.thickness * step.way.length;
  extension.rate_before = step.is_loaded ? in_range(fracture_energy * before * before) : 0;
  extension.rate_after = arrives || !step.is_loaded ? 0 : in_range(fracture_energy * after * after);
  return extension;
}

std::vector<int> LineSteps::nodes_asked(const std::vector<GrowingTip>& tips) const {
  std::vector<int> nodes;
  for (const GrowingTip& tip : tips)
    if (!has_ended(tip)) stress_.add_nodes_asked(tip, law_of(tip), has_begun(tip), nodes);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Whether a term is guarded by a tip. The middle of the term decides, so that the order of its ends does not matter.
bool LineSteps::is_spared(int term, const GrowingTip& tip) const {
  const Point middle = middle_of(system_.terms(), term, body_.positions());
  return (middle - tip.place).norm() < (1 - rounding_of_places) * guarded_reach * law_of(tip).horizon;
}

void LineSteps::spare(const GrowingTip& tip, std::vector<char>& intact, std::optional<double> overloaded_at) const {
  // Only overloaded bonds closest to an unloading tip are exempt; the overload of others has another cause.
  const auto bears = [&](int term) {
    return overloaded_at && (!(body_.ratios().at(static_cast<std::size_t>(term), *overloaded_at) > 1) ||
                             (middle_of(system_.terms(), term, body_.positions()) - tip.place).norm() >
                                 relaxing_reach * law_of(tip).horizon);
  };
  for (const int node : stress_.near().about(tip.place, (guarded_reach + 1) * law_of(tip).horizon)) {
    for (const int term : way_.terms_from().of(node))
      if (is_spared(term, tip) && !bears(term)) intact[static_cast<std::size_t>(term)] = 0;
  }
}

}  // namespace bempd::fracture

#include "fracture/line/line_steps.hpp"

#include <cmath>

#include "crack/order.hpp"
#include "geometry/turning.hpp"

namespace bempd::fracture {

namespace {

// Ratio of a tip's critical load factor to the load factor of the next event, beyond which only rounding loads the tip,
// as in a part without stress.
constexpr double farthest_load = 1e6;

}  // namespace

LineSteps::LineSteps(LoadedBody& body, pd::TipLaws laws)
    : system_(body.system()),
      laws_(std::move(laws)),
      fields_(body, laws_),
      path_(body.system(), body.positions(), fields_.stress()),
      growth_(body.positions(), fields_, path_),
      guard_(body, fields_, path_),
      loads_(body, fields_, path_) {}

std::optional<LineStep> LineSteps::next(const std::vector<GrowingTip>& tips, std::size_t number,
                                        const coupling::Affine& displacement, const LoadWay& load_way) const {
  const GrowingTip& tip = tips[number];
  const pd::TipLaw law = fields_.law_of(tip).at(tip.acts_at(), tip.grown);
  if (std::isinf(law.toughness)) return std::nullopt;
  const WilliamsFit fit = fields_.fitted(tip, law, displacement);
  const AffineIntensity by_fit = fields_.intensity_of(tip, fit);
  const double present = load_way.ahead(load_way.present);
  const AffineIntensity intensity = along_load_path(fields_.intensity_for_load(tip, fit), load_way);
  const AffineIntensity turn_factors = along_load_path(
      fields_.has_begun(tip) ? fields_.factors_for_turn(tip, by_fit, displacement, present) : by_fit, load_way);
  LineCriterion criterion{fields_.growth_law(law, tip, tip.acts_at()), LineGrowth::correction_of(tip), present,
                          load_way.control};
  if (law.function) criterion.law.asking.t_stress = {fit.t_stress()[0], load_way.ahead(fit.t_stress()[1])};
  const std::optional<LineLoad> load = load_of_growth(intensity, turn_factors, criterion);
  if (!load) return std::nullopt;
  LineStep step;
  if (law.function) step.toughness = criterion.law.toughness;
  step.tip = number, step.id = tip.id, step.law = tip.law, step.angle = load->angle,
  step.direction = turned(tip.direction, load->angle);
  step.factors = {{by_fit.one[0], by_fit.two[0]}, {by_fit.one[1], by_fit.two[1]}};
  step.load_factor = load_way.ahead(load->load_factor);
  step.constant = load->constant, step.growing = load_way.ahead(load->growing);
  step.path = path_.next(tip.place, step.direction, law);
  if (step.path.bonds.empty()) return std::nullopt;
  loads_.judge_fit(tips, fit, step);
  return step;
}

std::vector<LineStep> LineSteps::all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                                     const LoadWay& way, TrialBody* body, bool with_frozen) const {
  std::vector<LineStep> steps;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    if (tips[k].has_ended() || (!with_frozen && does_not_grow(tips[k]))) continue;
    if (std::optional<LineStep> step = next(tips, k, displacement, way)) steps.push_back(std::move(*step));
  }
  if (body && needs_trial_step(steps, way))
    for (LineStep& step : steps)
      if (!step.fit_holds) loads_.replace(tips[step.tip], displacement, way, *body, step);
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
  choice.needs_trial_step = !body && needs_trial_step(choice.steps, way);
  const std::optional<crack::FirstToGrow> first = crack::first_to_grow(candidates(choice.steps, way), way.upwards);
  if (!first) return choice;
  choice.first = choice.steps[first->index], choice.ties = first->ties;
  choice.load_factor = way.place_of(choice.first->load_factor);
  return choice;
}

Event LineSteps::event_of(const LineStep& step, double load_factor) const {
  Event event{load_factor, step.ratio_at(load_factor), step.load_factor, {}};
  event.tip = step.id;
  if (!step.path.arrives()) event.taken_energy = step.taken_energy;
  for (const int bond : step.path.bonds) event.changes.push_back(system_.terms().breaking(bond));
  return event;
}

std::vector<GrowingTip> LineSteps::guarded(const std::vector<LineStep>& steps, const std::vector<GrowingTip>& tips,
                                           const LoadWay& way, double load_factor) const {
  std::vector<GrowingTip> found;
  for (const LineStep& step : steps)
    if (is_driven(step, way, load_factor)) found.push_back(tips[step.tip]);
  for (const GrowingTip& tip : tips)
    if (does_not_grow(tip)) found.push_back(tip);
  return found;
}

}  // namespace bempd::fracture

#include "fracture/line/line_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "elasticity/kinked_tip.hpp"
#include "fracture/event_source.hpp"
#include "fracture/line/on_limits.hpp"
#include "geometry/turning.hpp"

namespace bempd::fracture {

namespace {

// The last steps whose energies correct the load factor, and as many besides that are taken to be exact.
constexpr std::size_t remembered_steps = 8;
constexpr double steps_taken_exact = 2;

// What a step may have released of what was expected, for the correction: a sharp kink, or one beside an edge, releases
// little at first.
constexpr double least_ratio = 0.5, largest_ratio = 2;

// Within this many horizons of a tip no bond breaks by itself.
constexpr double guarded_reach = 3;

constexpr int rounds_for_kink = 8;

double correction(const GrowingTip& tip) {
  const double sum = std::accumulate(tip.energy_ratios.begin(), tip.energy_ratios.end(), steps_taken_exact);
  return std::sqrt(sum / (steps_taken_exact + static_cast<double>(tip.energy_ratios.size())));
}

// A tip that has run into a face keeps its law as the number before -1 that stands for it.
int ended(int law) { return -1 - law; }

// Its other tip lies closely behind it at first, which the fitted series does not know.
bool has_begun(const pd::TipLaw& law) { return law.crack == 0; }

// A tip that does not grow before so many times the load factor at which something else happens feels rounding, as one
// in a part that bears nothing does.
constexpr double farthest_load = 1e6;
// Likewise a stress closely ahead that is this share of the one around.
constexpr double least_stress = 1e-8;

// A load factor beyond the one at which a tip reaches its toughness, if a larger one drives it more at all.
double beyond_toughness(const AffineIntensity& intensity, const pd::TipLaw& law) {
  const double slope = kink_of({intensity.one[1], intensity.two[1]}).equivalent_factor;
  return slope > 0 ? 4 * (law.toughness + std::hypot(intensity.one[0], intensity.two[0])) / slope : 0;
}

}  // namespace

LineSteps::LineSteps(LoadedBody& body, pd::TipLaws laws)
    : body_(body),
      system_(body.system()),
      stress_(body.system(), body.positions()),
      way_(body.system(), body.positions(), stress_),
      laws_(std::move(laws)) {}

// Where nothing lies ahead, a tip goes straight on.
AffineIntensity LineSteps::turning_of(const GrowingTip& tip, const AffineIntensity& by_fit,
                                      const coupling::Affine& displacement, double present) const {
  const pd::TipLaw& law = law_of(tip);
  AffineIntensity ahead = stress_.closely_ahead_of(tip, law, displacement, body_.pressure_in(law.crack));
  const auto size = [](const AffineIntensity& one, int part) { return std::hypot(one.one[part], one.two[part]); };
  const double load_factor = std::max(std::abs(present), law.toughness / size(by_fit, 1));
  const double around = std::max(size(by_fit, 0), load_factor * size(by_fit, 1));
  for (int part = 0; part < 2; ++part)
    if ((part == 0 ? 1 : load_factor) * size(ahead, part) < least_stress * around)
      ahead.one[part] = ahead.two[part] = 0;
  return ahead;
}

std::optional<LineStep> LineSteps::next(const std::vector<GrowingTip>& tips, std::size_t number,
                                        const coupling::Affine& displacement, double present, bool path) const {
  const GrowingTip& tip = tips[number];
  const pd::TipLaw& law = law_of(tip);
  const AffineIntensity intensity = stress_.at(tip, law, displacement, body_.pressure_in(law.crack));
  const AffineIntensity turning = has_begun(law) ? turning_of(tip, intensity, displacement, present) : intensity;
  LineStep step{number, tip.direction, {}, present, 0, 0};
  const auto kink_at = [](const AffineIntensity& of, double load_factor) {
    const Eigen::Vector2d at(1, load_factor);
    return kink_of({of.one.dot(at), of.two.dot(at)});
  };
  const auto aim = [&](double load_factor) {
    const double kink = kink_at(intensity, load_factor).angle, turn = kink_at(turning, load_factor).angle;
    const auto share = [&](int part) {
      return hoop_factor({intensity.one[part], intensity.two[part]}, kink) * correction(tip) / law.toughness;
    };
    step.constant = share(0), step.growing = share(1), step.direction = turned(tip.direction, turn);
    step.load_factor = (1 - step.constant) / step.growing;
    return step.growing > 0;
  };
  // Without constant loads the kink does not depend on the load factor. Else what drives the tip is convex in it, and
  // has these tangents: where they rise they lead to its larger root.
  const bool proportional =
      turning.one[0] == 0 && turning.two[0] == 0 && intensity.one[0] == 0 && intensity.two[0] == 0;
  bool grows =
      aim(proportional || present <= 0 ? 1 : present) || (!proportional && aim(beyond_toughness(intensity, law)));
  for (int round = 1; grows && !proportional && round < rounds_for_kink; ++round) grows = aim(step.load_factor);
  const bool is_due = !proportional && !path && (!grows || step.load_factor > present) &&
                      kink_at(intensity, present).equivalent_factor * correction(tip) >= law.toughness;
  if (is_due) {
    aim(present);
    step.load_factor = present;
  } else if (!grows) {
    return std::nullopt;
  }
  step.way = way_.next(tip.place, step.direction, law);
  return step.way.bonds.empty() ? std::nullopt : std::optional(std::move(step));
}

std::vector<LineStep> LineSteps::all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                                     double load_factor, Control control) const {
  std::vector<LineStep> steps;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    if (has_ended(tips[k])) continue;
    if (std::optional<LineStep> step = next(tips, k, displacement, load_factor, control == Control::path))
      steps.push_back(std::move(*step));
  }
  return steps;
}

const LineStep* LineSteps::first_of(const std::vector<LineStep>& steps) {
  const LineStep* found = nullptr;
  for (const LineStep& step : steps)
    if (!found || step.load_factor < found->load_factor - ratio_rounding * std::abs(found->load_factor)) found = &step;
  return found;
}

bool LineSteps::is_driven(const LineStep& step, double load_factor) {
  return step.load_factor <= farthest_load * std::abs(load_factor);
}

double LineSteps::hoop_ratio(const GrowingTip& tip, const coupling::Affine& displacement, double load_factor) const {
  const pd::TipLaw& law = law_of(tip);
  const Eigen::Vector2d at(1, load_factor);
  const AffineIntensity found = stress_.at(tip, law, displacement, body_.pressure_in(law.crack));
  return kink_of({found.one.dot(at), found.two.dot(at)}).equivalent_factor / law.toughness;
}

void LineSteps::move(const LineStep& step, std::vector<GrowingTip>& tips) {
  GrowingTip& tip = tips[step.tip];
  tip.place += step.way.length * step.direction;
  tip.direction = step.direction;
}

void LineSteps::remember(const LineStep& step, double ratio, double released_energy,
                         const coupling::Affine& displacement, double load_factor,
                         std::vector<GrowingTip>& tips) const {
  GrowingTip& tip = tips[step.tip];
  const pd::TipLaw& law = law_of(tip);
  // The ratio of the event holds the correction that was made; what is remembered must not.
  const double before = ratio / correction(tip);
  // Behind a kink, or as an edge comes or goes, the energy release rate changes within a spacing by up to a half: what
  // is expected is the mean of the rates at both ends of the step.
  const double after = step.way.arrives ? before : std::max(hoop_ratio(tip, displacement, load_factor), 0.0);
  const double rate = law.toughness * law.toughness / law.modulus * (before * before + after * after) / 2;
  const double released = released_energy / (rate * law.thickness * step.way.length);
  // The first step releases more or less by where among the points the crack was described to end.
  const bool is_first = tip.energy_ratios.empty();
  tip.energy_ratios.push_back(is_first ? 1 : std::clamp(released, least_ratio, largest_ratio));
  if (tip.energy_ratios.size() > remembered_steps) tip.energy_ratios.erase(tip.energy_ratios.begin());
  if (step.way.arrives) tip.law = ended(tip.law);
}

std::vector<int> LineSteps::nodes_asked(const std::vector<GrowingTip>& tips) const {
  std::vector<int> nodes;
  for (const GrowingTip& tip : tips)
    if (!has_ended(tip)) stress_.add_nodes_asked(tip, law_of(tip), has_begun(law_of(tip)), nodes);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// By its middle, so that it does not matter which of its ends is the first.
bool LineSteps::is_spared(int term, const GrowingTip& tip) const {
  const coupling::Terms& terms = body_.system().terms();
  const std::vector<Point>& positions = body_.positions();
  const auto t = static_cast<std::size_t>(term);
  const Point middle =
      (positions[static_cast<std::size_t>(terms.first[t])] + positions[static_cast<std::size_t>(terms.second[t])]) / 2;
  return (middle - tip.place).norm() < (1 - rounding_of_places) * guarded_reach * law_of(tip).horizon;
}

void LineSteps::spare(const GrowingTip& tip, std::vector<char>& intact) const {
  for (const int node : stress_.near().about(tip.place, (guarded_reach + 1) * law_of(tip).horizon)) {
    for (const int term : way_.terms_from().of(node))
      if (is_spared(term, tip)) intact[static_cast<std::size_t>(term)] = 0;
  }
}

}  // namespace bempd::fracture

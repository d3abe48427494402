#include "fracture/line/line_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "elasticity/kinked_tip.hpp"
#include "fracture/line/on_limits.hpp"
#include "geometry/turning.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

namespace {

// Number of last steps of a tip whose released energies correct its next load factors.
constexpr std::size_t remembered_steps = 8;
// Number of imagined steps with the ratio 1 of released to expected energy, which dampen the correction.
constexpr double steps_taken_exact = 2;

// Limits on the ratio of released to expected energy of a step, by which the load factors of later steps are corrected.
// A step behind a sharp kink or beside an edge releases little at first.
constexpr double least_energy_ratio = 0.5, largest_energy_ratio = 2;

double distance_to(const std::vector<Edge>& edges, const Point& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) nearest = std::min(nearest, distance(edge, place));
  return nearest;
}

// Number of the tip law of the region in which the nearest material point ahead of a tip lies; the tip's present law if
// no point is near.
int law_ahead_of(const GrowingTip& tip, const pd::TipLaws& laws, const NearPoints& near,
                 const std::vector<Point>& positions) {
  const pd::TipLaw& law = laws.laws[static_cast<std::size_t>(tip.law)];
  double nearest = law.horizon;
  int found = tip.law;
  for (const int node : near.about(tip.place, law.horizon)) {
    const int number = laws.of_node[static_cast<std::size_t>(node)];
    const Point to_point = positions[static_cast<std::size_t>(node)] - tip.place;
    if (number < 0 || to_point.dot(tip.direction) <= rounding_of_places * law.spacing) continue;
    if (to_point.norm() >= nearest - rounding_of_places * law.spacing) continue;
    nearest = to_point.norm(), found = number;
  }
  return found;
}

}  // namespace

double LineGrowth::correction_of(const GrowingTip& tip) {
  const double sum = std::accumulate(tip.energy_ratios.begin(), tip.energy_ratios.end(), steps_taken_exact);
  return std::sqrt(sum / (steps_taken_exact + static_cast<double>(tip.energy_ratios.size())));
}

// Ratio of a tip's equivalent stress intensity factor after a step to the toughness of `law`. If the tip has entered a
// region with another modulus, the ratio is scaled so that its square is energy release rate over fracture energy.
double LineGrowth::ratio_after(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                               double load_factor) const {
  const Eigen::Vector2d at(1, load_factor);
  const AffineIntensity found = fields_.intensity_at(tip, displacement);
  const double factor = kink_of({found.one.dot(at), found.two.dot(at)}, fields_.laws().criterion).equivalent_factor;
  const double modulus = fields_.law_of(tip).modulus;
  return factor / law.toughness * (modulus == law.modulus ? 1 : std::sqrt(law.modulus / modulus));
}

crack::TipState LineGrowth::state_of_begun(const GrowingTip& tip) const {
  const bool leaves = path_.leaves_body(tip.place, tip.direction, fields_.law_of(tip));
  return leaves ? state_at_edge(tip.place) : crack::TipState::grows;
}

void LineGrowth::move(const LineStep& step, std::vector<GrowingTip>& tips) const {
  GrowingTip& tip = tips[step.tip];
  tip.place += step.path.length * step.direction;
  tip.grown += step.path.length;
  tip.even_ahead.reset();
  tip.direction = step.direction;
  if (fields_.laws().laws.size() > 1) tip.law = law_ahead_of(tip, fields_.laws(), fields_.stress().near(), positions_);
}

crack::TipState LineGrowth::state_at_edge(const Point& place) const {
  const bool at_hole = distance_to(fields_.laws().hole_edges, place) < distance_to(fields_.laws().outer_edges, place);
  return at_hole ? crack::TipState::at_hole : crack::TipState::at_edge;
}

crack::Extension LineGrowth::complete_step(const LineStep& step, const Event& event, double released_energy,
                                           const DisplacementAt& displacement_at, std::vector<GrowingTip>& tips) const {
  move(step, tips);
  return remember(step, event.ratio, released_energy, displacement_at(tips), event.load_factor, tips);
}

crack::Extension LineGrowth::remember(const LineStep& step, double ratio, double released_energy,
                                      const coupling::Affine& displacement, double load_factor,
                                      std::vector<GrowingTip>& tips) const {
  GrowingTip& tip = tips[step.tip];
  const Point from = tip.place - step.path.length * step.direction;
  const double grown_before = tip.grown - step.path.length;
  pd::TipLaw law = fields_.laws().laws[static_cast<std::size_t>(step.law)].at(from, grown_before);
  const double share_of_direction = law.directions ? law.directions->share(heading_of(step.direction)) : 1;
  if (law.directions) law.toughness *= std::sqrt(share_of_direction);
  if (step.toughness > 0) law.toughness = step.toughness;
  // The event's ratio of intensity to toughness contains the correction by earlier steps, which must not enter the
  // remembered ratios of released to expected energy.
  const double before = step.load_by_trial || step.load_by_sums ? ratio : ratio / correction_of(tip);
  // The expected energy follows from the mean of the energy release rates at both ends of the step, because this rate
  // changes by up to a half within a spacing behind a kink or near an edge.
  const bool arrives = step.path.arrives();
  const double after = arrives              ? before
                       : step.load_by_trial ? before * step.after_step
                                            : std::sqrt(step.rate_over_fit) *
                                                  std::max(ratio_after(tip, law, displacement, load_factor), 0.0);
  const double fracture_energy = law.toughness * law.toughness / law.modulus;
  const double rate = fracture_energy * (before * before + after * after) / 2;
  const double expected = rate * law.thickness * step.path.length;
  const double released = step.load_by_sums ? step.rate_over_fit : expected > 0 ? released_energy / expected : 1;
  // The first step counts with the ratio 1, because its energy depends on where between material points the described
  // crack ends. A step whose load comes from a trial step says nothing of the fit, so that the correction stays
  // unchanged.
  const bool is_first = tip.energy_ratios.empty();
  if (is_first || !step.load_by_trial)
    tip.energy_ratios.push_back(is_first ? 1 : std::clamp(released, least_energy_ratio, largest_energy_ratio));
  if (tip.energy_ratios.size() > remembered_steps) tip.energy_ratios.erase(tip.energy_ratios.begin());
  tip.state = step.path.ends_as == crack::TipState::at_edge ? state_at_edge(tip.place) : step.path.ends_as;
  crack::Extension extension =
      crack::begin_extension(tip.id, from, step.angle, load_factor, step.factors, fracture_energy);
  crack::arrive(extension, tip.place, step.path.length, tip.state);
  const pd::TipLaw there = fields_.laws().laws[static_cast<std::size_t>(step.law)].at(tip.place, tip.grown);
  const double energy_there =
      law.function ? fracture_energy : there.toughness * there.toughness / there.modulus * share_of_direction;
  const double mean_energy = (fracture_energy + energy_there) / 2;
  extension.surface_energy = mean_energy * law.thickness * step.path.length;
  extension.rate_before = step.is_loaded ? in_range(fracture_energy * before * before) : 0;
  extension.rate_after = arrives || !step.is_loaded ? 0 : in_range(fracture_energy * after * after);
  return extension;
}

}  // namespace bempd::fracture

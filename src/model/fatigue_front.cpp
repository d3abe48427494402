#include "model/fatigue_front.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "elasticity/kinked_tip.hpp"
#include "geometry/turning.hpp"
#include "model/extension_end.hpp"
#include "model/growth_options.hpp"
#include "model/level_factors.hpp"
#include "model/net_section.hpp"
#include "regions/boundary/boundary_description.hpp"

namespace bempd::model {

namespace {

// Equivalent stress intensity factor (mode I) of growth in the direction `angle`, by the growth criterion.
double equivalent_in(const Point& factors, double angle, KinkCriterion criterion) {
  return criterion == KinkCriterion::hoop_stress ? hoop_factor(factors, angle) : kinked_factors(factors, angle).x();
}

// Number of parts of a step at whose ends a fracture energy that varies from place to place is read.
constexpr int parts_of_step = 16;

// Outline of a region. If the region is a lattice patch of a body, or if patches are cut out of the region, the outline
// of the whole body.
const Outline& whole_outline(const scene::Scene& scene, int region) {
  const int part_of = scene.region(region).part_of();
  const scene::Region& body = scene.region(part_of > 0 ? part_of : region);
  const auto* elements = dynamic_cast<const regions::BoundaryDescription*>(&body);
  return elements ? elements->whole_outline() : body.outline();
}

}  // namespace

const crack::RateParameters* FrontReader::parameters_of(int region) const {
  return region == 0 ? nullptr : model_.fatigue().rate_of(model_.scene().region(region).material());
}

const crack::RateLaw* FrontReader::law_in(int region) {
  const crack::RateParameters* parameters = parameters_of(region);
  if (!parameters) return nullptr;
  const int material = model_.scene().region(region).material();
  std::unique_ptr<crack::RateLaw>& law = laws_[material];
  if (!law)
    law = crack::make_rate_law(*parameters, model_.scene().material(material).elasticity.state == PlaneState::strain);
  return law.get();
}

// Sets the direction in which a tip grows: that of the load with the largest equivalent stress intensity factor, out of
// the highest and the lowest load factor, or out of all combinations of load cases.
void FrontReader::set_direction(FrontTip& tip) const {
  const KinkCriterion criterion = growth_criterion(model_.options());
  crack::GrowthLaw law = law_of(tip.values, model_.options());
  tip.high = levels_.highest(), tip.low = levels_.lowest();
  // Load cases: a crack line without room for a contour (ring) around its tip turns by the stress ahead of the
  // tip.
  const bool by_stress = tip.values.method == regions::TipMethod::stress_ahead && levels_.combine_cases();
  const auto kink_at = [&](std::size_t level) {
    Kink kink = law.kink(tip.levels[level].factors);
    if (by_stress) kink.angle = tip.levels[level].turn;
    return kink;
  };
  Kink most = kink_at(tip.high);
  for (std::size_t level = 0; level < tip.levels.size(); ++level) {
    if (!levels_.combine_cases() && level != tip.low) continue;
    const Kink kink = kink_at(level);
    if (kink.equivalent_factor > most.equivalent_factor) most = kink;
  }
  tip.angle = most.angle;
  for (crack::LevelFactors& at : tip.levels) at.equivalent = equivalent_in(at.factors, tip.angle, criterion);
  if (levels_.combine_cases()) {
    const auto less = [](const auto& a, const auto& b) { return a.equivalent < b.equivalent; };
    const auto [low, high] = std::minmax_element(tip.levels.begin(), tip.levels.end(), less);
    tip.low = static_cast<std::size_t>(low - tip.levels.begin());
    tip.high = static_cast<std::size_t>(high - tip.levels.begin());
  }
  law = law.with_host_toughness(tip.levels[tip.high].factors, tip.levels[tip.high].t_stress);
  double toughness = law.directions ? law.toughness * std::sqrt(law.share_in(tip.angle)) : law.toughness;
  if (!(toughness > 0)) toughness = FatigueOptions::unlimited;
  tip.critical = crack::critical_of(*parameters_of(tip.region), toughness);
}

Front FrontReader::front(const std::vector<regions::TipValues>& tips, LongerCracks* longer) {
  PreparedScene& scene = longer ? lengthening_.scene_of(*longer) : lengthening_.scene();
  Front front;
  bool with_t_stress = false, with_sections = false;
  for (const regions::TipValues& values : tips) {
    FrontTip tip;
    tip.values = values, tip.region = lengthening_.region_of(values, scene);
    tip.law = law_in(tip.region);
    if (!tip.law) continue;
    const crack::RateParameters& parameters = *parameters_of(tip.region);
    with_t_stress |= parameters.kind == crack::RateParameters::Kind::host || values.asking.function;
    with_sections |= parameters.flow_stress > 0;
    front.push_back(std::move(tip));
  }
  std::vector<regions::TipValues> growing;
  for (const FrontTip& tip : front) growing.push_back(tip.values);
  FactorsOfTips factors = LevelSolver(model_, lengthening_, levels_, longer).factors(growing, with_t_stress);
  for (std::size_t t = 0; t < front.size(); ++t) {
    front[t].levels = std::move(factors[t]);
    set_direction(front[t]);
    // Load cases: the place of the effective tip follows from the combination with the highest equivalent stress
    // intensity factor, not from the present loads.
    if (levels_.combine_cases()) front[t].values.felt_ahead = front[t].levels[front[t].high].felt_ahead;
    front[t].effective_tip_ahead = lengthening_.effective_tip_ahead(front[t].values, scene);
  }
  if (with_sections) add_net_sections(front, longer);
  return front;
}

void FrontReader::add_net_sections(Front& front, LongerCracks* longer) {
  std::vector<scene::Crack> cracks;
  lengthening_.in_scene_of(longer, [&] { cracks = lengthening_.cracks(); });
  const PreparedScene& scene = longer ? lengthening_.scene_of(*longer) : lengthening_.scene();
  std::vector<SpreadTip> spread;  // the radius of tips with elements is 0
  for (const FrontTip& tip : front) spread.push_back({tip.values.place, lengthening_.spread(tip.values, scene)});
  std::vector<std::optional<NetSection>> sections;
  for (const FrontTip& tip : front) {
    sections.emplace_back();
    if (parameters_of(tip.region)->flow_stress > 0)
      sections.back().emplace(whole_outline(model_.scene(), tip.region), cracks, tip.values.crack, tip.values.place,
                              turned(tip.values.direction, tip.angle), spread);
  }
  LevelSolver(model_, lengthening_, levels_, longer).under_each([&](std::size_t level) {
    std::vector<double> factors;
    for (const FrontTip& tip : front) factors.push_back(tip.levels[level].equivalent);
    for (std::size_t t = 0; t < front.size(); ++t)
      if (sections[t])
        front[t].levels[level].net_section = sections[t]->share(model_.results().evaluate(sections[t]->places(), true),
                                                                parameters_of(front[t].region)->flow_stress, factors);
  });
}

// Stress intensity factors at which a tip breaks, at equally spaced places of a step. They change linearly from the
// beginning of the step to its end, except for a fracture energy that varies from place to place, which is read along
// the step.
std::vector<double> FrontReader::critical_along(const FrontTip& before, const FrontTip* after, const Point& to) const {
  const pd::VariedEnergy* energies = lengthening_.scene().discretization.region(before.region).toughness().if_any();
  const bool is_stated = parameters_of(before.region)->critical > 0;
  if (!energies || is_stated || std::isinf(before.critical))
    return {before.critical, after ? after->critical : before.critical};
  const Point from = before.values.place;
  const auto share = [&](const Point& place) { return std::sqrt(energies->share(place)); };
  const double first = before.critical / share(from), last = after ? after->critical / share(to) : first;
  std::vector<double> all;
  for (int k = 0; k <= parts_of_step; ++k) {
    const double way = static_cast<double>(k) / parts_of_step;
    all.push_back(((1 - way) * first + way * last) * share(from + way * (to - from)));
  }
  return all;
}

void warn_of_short_lines(const Front& front, const std::vector<scene::Crack>& cracks,
                         const CrackLengthening& lengthening) {
  constexpr double enough = 8;  // spacings
  std::set<int> told;
  for (const FrontTip& tip : front) {
    const int crack = tip.values.crack;
    const double spacing = lengthening.growth_increment(tip.values);
    if (!(spacing > 0) || !told.insert(crack).second) continue;
    const double spacings = length_of(cracks[static_cast<std::size_t>(crack) - 1]) / spacing;
    if (spacings < enough)
      lengthening.tell(
          text("crack ", crack, " is ", spacings, " spacings of its lattice long; with fewer than ", enough,
               " lives come out too short, by 10 % with 6 and 39 % with 2 spacings of a middle crack: use a "
               "smaller spacing, or boundary elements"));
  }
}

}  // namespace bempd::model

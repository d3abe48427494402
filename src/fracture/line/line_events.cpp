#include "fracture/line/line_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/event_choice.hpp"
#include "fracture/line/on_limits.hpp"

namespace bempd::fracture {

namespace {

// Distance from any crack tip, in horizons, within which no new crack begins.
constexpr double reach_of_other_tip = 1;

// Relative difference of two energies up to which they count as equal.
constexpr double rounding_of_energies = 1e-9;

// Sum of stiffness times the square of the elongation of some bonds [J]: twice their energy.
double energy_of(const std::vector<int>& bonds, const LoadedBody& body, const coupling::Affine& displacement,
                 double load_factor) {
  const coupling::EquilibriumSystem& system = body.system();
  double sum = 0;
  for (const int bond : bonds) {
    const auto b = static_cast<std::size_t>(bond);
    const auto part = [&](int k) { return system.terms().elastic_elongation_part(b, displacement.col(k).data(), k); };
    const double elongation = part(0) + load_factor * part(1);
    sum += system.stages().stiffness()[b] * elongation * elongation;
  }
  return sum;
}

}  // namespace

LineEvents::LineEvents(LoadedBody& body, WholeBodyEvents& whole_body, pd::TipLaws laws, FactorsAround factors)
    : body_(body), whole_body_(whole_body), steps_(body, std::move(laws)), trials_(body.system(), std::move(factors)) {}

Point LineEvents::middle_of(int bond) const {
  const coupling::Terms& terms = body_.system().terms();
  const auto b = static_cast<std::size_t>(bond);
  return (body_.positions()[static_cast<std::size_t>(terms.first[b])] +
          body_.positions()[static_cast<std::size_t>(terms.second[b])]) /
         2;
}

// New crack that begins at a bond at a load factor. Empty at cell squares, at bonds with an end outside the lattices of
// crack lines, and close to a tip.
std::optional<LineEvents::Birth> LineEvents::birth_at(int bond, double load_factor) const {
  const coupling::Terms& terms = body_.system().terms();
  const auto b = static_cast<std::size_t>(bond);
  if (terms.is_wide(b)) return std::nullopt;
  const auto first = static_cast<std::size_t>(terms.first[b]), second = static_cast<std::size_t>(terms.second[b]);
  const int number = laws().of_node[first];
  if (number < 0 || laws().of_node[second] < 0) return std::nullopt;
  const pd::TipLaw& law = laws().laws[static_cast<std::size_t>(number)];
  const Point middle = middle_of(bond);
  for (const GrowingTip& tip : body_.state().tips)
    if ((tip.place - middle).norm() < reach_of_other_tip * law.horizon) return std::nullopt;
  const Point direction = steps_.fields().stress().across_tension(bond, law, body_.state().displacement, load_factor);
  if (!direction.allFinite()) return std::nullopt;  // stresses beyond the range of numbers
  return Birth{middle, direction, number};
}

// Bonds that a new crack cuts. If its path runs through a material point, such as the middle of a bond of two spacings,
// it may pass the point on either side. It takes the side on which the cut bonds store the larger energy; this choice
// does not depend on how the body is mirrored or turned. `is_tie` tells whether the energies are equal.
std::vector<int> LineEvents::cut_by(const Birth& birth, double load_factor, bool& is_tie) const {
  const pd::TipLaw& law = laws().laws[static_cast<std::size_t>(birth.law)];
  const Point half = law.spacing / 2 * birth.direction;
  const auto across = [&](LinePath::PointsOnPath side) {
    return steps_.path().across(birth.middle - half, birth.middle + half, law.horizon, side);
  };
  std::vector<int> right = across(LinePath::PointsOnPath::right), left = across(LinePath::PointsOnPath::left);
  is_tie = false;
  if (right == left) return right;
  const auto energy = [&](const std::vector<int>& bonds) {
    return energy_of(bonds, body_, body_.state().displacement, load_factor);
  };
  const double on_right = energy(right), on_left = energy(left);
  is_tie = std::abs(on_right - on_left) <= rounding_of_energies * std::max(on_right, on_left);
  return !is_tie && on_left > on_right ? left : right;
}

// Whether a crack that begins at a bond would lie at another place than `birth`.
bool LineEvents::is_elsewhere(int bond, const Birth& birth) const {
  const double spacing = laws().laws[static_cast<std::size_t>(birth.law)].spacing;
  return (middle_of(bond) - birth.middle).norm() > rounding_of_places * spacing;
}

// Prepares the event at which a crack begins at `bond`, one of the most stretched bonds. Null if the crack would not
// cut that bond.
const Event* LineEvents::prepare_birth(int bond, const std::vector<int>& most, const Birth& birth, double load_factor) {
  bool sides_tie = false;
  const std::vector<int> bonds = cut_by(birth, load_factor, sides_tie);
  const auto is_cut = [&](int b) { return std::binary_search(bonds.begin(), bonds.end(), b); };
  if (!is_cut(bond)) return nullptr;
  ties_ = static_cast<int>(std::ranges::count_if(most, [&](int b) { return !is_cut(b) || is_elsewhere(b, birth); }) +
                           (sides_tie ? 1 : 0));
  event_ = {load_factor, 0, load_factor, {}};
  event_.reach(body_.response().ratios().at(static_cast<std::size_t>(bond), load_factor),
               body_.response().ratios().critical_load_factor(static_cast<std::size_t>(bond), load_factor));
  for (const int b : bonds) event_.changes.push_back(body_.system().terms().breaking(b));
  event_.changes = body_.system().stages().with_followers(std::move(event_.changes));
  birth_ = birth;
  return &event_;
}

const Event* LineEvents::prepare_breaks(const std::vector<char>& intact, double load_factor,
                                        const SteppingOptions& options) {
  const BondList bonds{body_.response().ratios(), intact};
  const std::vector<int> most = most_critical(bonds, load_factor, options.tie_band, options.max_breaks_per_solve);
  event_ = break_of(bonds, most, load_factor, body_.system());
  event_.changes = body_.system().stages().with_followers(std::move(event_.changes));
  return &event_;
}

// Prepares the event at which a crack begins at one of the most stretched bonds, `most`: the bond with the smallest
// number that a crack through its middle would cut. Null if no crack begins.
const Event* LineEvents::prepare_birth(const std::vector<int>& most, double load_factor) {
  for (const int bond : most) {
    const std::optional<Birth> birth = birth_at(bond, load_factor);
    if (!birth) return nullptr;
    if (const Event* born = prepare_birth(bond, most, *birth, load_factor)) return born;
  }
  return nullptr;
}

// Flags of the terms (bonds and cell squares) that can break by themselves: all intact terms, except those near tips
// that the load drives or that do not grow at any load.
std::vector<char> LineEvents::free_to_break(const LineSteps::Choice& choice, const LoadWay& way) const {
  const BodyState& state = body_.state();
  std::vector<char> intact = body_.system().stages().intact();
  double first = std::abs(state.load_factor), at = choice.load_factor;
  const auto is_driven = [&](const LineStep& step) { return LineSteps::is_driven(step, way, first); };
  if (!std::all_of(choice.steps.begin(), choice.steps.end(), is_driven)) {
    const std::optional<double> bonds = next_critical({body_.response().ratios(), intact}, way);
    if (bonds && way.ahead(*bonds) < way.ahead(at)) at = *bonds;
    if (std::isfinite(at)) first = std::max(first, std::abs(at));
  }
  for (const GrowingTip& tip : steps_.guarded(choice.steps, state.tips, way, first)) steps_.guard().exempt(tip, intact);
  if (way.control == Control::load) exempt_unloading(way, intact);
  return intact;
}

// Exempts overloaded bonds close to a tip that unloads from breaking. Before, such bonds exceeded their critical
// stretch without breaking, because bonds near a tip are cut by its growth only; they do not break while the load
// decreases either.
void LineEvents::exempt_unloading(const LoadWay& way, std::vector<char>& intact) const {
  const BodyState& state = body_.state();
  for (const LineStep& step : steps_.all(state.tips, state.displacement, way.back()))
    if (step.ratio_at(way.present) > 0) steps_.guard().exempt(state.tips[step.tip], intact, way.present);
}

std::vector<crack::Candidate> LineEvents::candidates(const crack::LoadWay& way) {
  const BodyState& state = body_.state();
  return LineSteps::candidates(steps_.all(state.tips, state.displacement, way, &trials_), way);
}

const Event* LineEvents::next(double target, const SteppingOptions& options) {
  step_.reset();
  birth_.reset();
  ties_ = 0;
  trials_.use_separate_factor(false);
  const BodyState& state = body_.state();
  const LoadWay way = body_.response().load_path_to(target, options.control);
  const LineSteps::Choice choice = steps_.choose(state.tips, state.displacement, way, &trials_);
  std::vector<char> intact;
  std::optional<double> bonds;
  if (laws().more_begin) {
    intact = free_to_break(choice, way);
    bonds = next_critical({body_.response().ratios(), intact}, way);
  }
  if (bonds && way.is_before(*bonds, choice.load_factor)) {
    const std::vector<int> most =
        most_critical({body_.response().ratios(), intact}, *bonds, 0, 0);  // equal up to rounding
    const Event* born = prepare_birth(most, *bonds);
    return born ? born : prepare_breaks(intact, *bonds, options);
  }
  if (!choice.first) return nullptr;
  step_ = choice.first, ties_ = choice.ties;
  event_ = steps_.event_of(*step_, choice.load_factor);
  event_.changes = body_.system().stages().with_followers(std::move(event_.changes));
  return &event_;
}

const Event* LineEvents::step_of(const crack::TipId& tip, const std::optional<Point>& direction) {
  step_.reset();
  birth_.reset();
  ties_ = 0;
  trials_.use_separate_factor(false);
  const BodyState& state = body_.state();
  const LoadWay way{state.load_factor, true, Control::path};
  for (const LineStep& step : steps_.all(state.tips, state.displacement, way, &trials_, true))
    if (step.id == tip) step_ = step;
  if (direction) step_ = step_towards(*direction, tip, steps_, state, step_);
  if (!step_) return nullptr;
  event_ = steps_.event_of(*step_, state.load_factor);
  event_.changes = body_.system().stages().with_followers(std::move(event_.changes));
  return &event_;
}

Outcome LineEvents::perform() {
  Outcome outcome = whole_body_.perform(event_);
  outcome.ties = ties_;
  if (birth_) begin_crack(outcome);
  if (step_) {
    BodyState& state = body_.state();
    const auto displacement = [&](const auto&) -> const coupling::Affine& { return state.displacement; };
    outcome.extensions = {
        steps_.growth().complete_step(*step_, event_, outcome.released_energy, displacement, state.tips)};
  }
  return outcome;
}

// Adds the two tips of the new crack to the state, and their extensions to the outcome. The id of the crack is the next
// one after all existing cracks.
void LineEvents::begin_crack(Outcome& outcome) {
  std::vector<GrowingTip>& tips = body_.state().tips;
  int id = static_cast<int>(laws().of_crack.size());
  for (const GrowingTip& tip : tips) id = std::max(id, tip.id.crack);
  const pd::TipLaw& law = laws().laws[static_cast<std::size_t>(birth_->law)];
  for (const int end : {0, 1}) {
    const Point direction = (end == 0 ? 1 : -1) * birth_->direction;
    tips.push_back({birth_->middle + law.spacing / 2 * direction, direction, birth_->law, {id + 1, end}});
    const double resistance = steps_.fields().growth_law(tips.back(), birth_->middle).resistance();
    tips.back().grown = law.spacing / 2;
    tips.back().state = steps_.growth().state_of_begun(tips.back());
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    crack::Extension extension = crack::begin_extension(tips.back().id, birth_->middle, 0, body_.state().load_factor,
                                                        {{unknown, unknown}, {unknown, unknown}}, resistance);
    crack::arrive(extension, tips.back().place, law.spacing / 2, tips.back().state);
    extension.rate_before = extension.rate_after = unknown;
    extension.surface_energy = outcome.bond_energy;  // RunRecords shares it between both tips
    outcome.extensions.push_back(extension);
  }
}

}  // namespace bempd::fracture

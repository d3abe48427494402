#include "fracture/line/line_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "elasticity/kinked_tip.hpp"
#include "geometry/turning.hpp"

namespace bempd::fracture {

namespace {

// A tip whose way meets no bond within this many spacings has arrived at an edge or a crack.
constexpr int most_empty_steps = 2;

// The last steps whose energies correct the load factor, and as many besides that are taken to be exact.
constexpr std::size_t remembered_steps = 8;
constexpr double steps_taken_exact = 2;

// What a step may have released of what was expected, for the correction: a sharp kink, or one beside an edge, releases
// little at first.
constexpr double least_ratio = 0.5, largest_ratio = 2;

// Within this many horizons of a tip no bond breaks by itself, and of one that does not grow no crack begins.
constexpr double guarded_reach = 3, reach_of_resting_tip = 1;

constexpr int rounds_for_kink = 8;

double correction(const GrowingTip& tip) {
  const double sum = std::accumulate(tip.energy_ratios.begin(), tip.energy_ratios.end(), steps_taken_exact);
  return std::sqrt(sum / (steps_taken_exact + static_cast<double>(tip.energy_ratios.size())));
}

// Positive where c lies to the left of the way from a to b.
double side(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

// A tip that has run into a face keeps its law as the number before -1 that stands for it.
bool has_ended(const GrowingTip& tip) { return tip.law < 0; }
int ended(int law) { return -1 - law; }

// Stations a spacing on the way are asked at, bonds within this many spacings beside it, as steep to it at most.
constexpr int stations = 10;
constexpr double beside = 1, least_cosine = 0.8;
constexpr int enough_bonds = 2;

// How far from a tip its way meets the face of a crack: there all bonds along the way are gone.
std::optional<double> face_ahead(const LoadedBody& body, const coupling::EquilibriumSystem& system, const Point& tip,
                                 const Point& way, const pd::TipLaw& law) {
  const coupling::Terms& terms = system.terms();
  std::array<int, stations> present{}, left{};
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Point from = body.positions()[static_cast<std::size_t>(terms.first[t])] - tip;
    if (terms.is_wide(t) || from.norm() > law.horizon + law.spacing) continue;
    const Point bond = terms.length[t] * Point(terms.cosine[t], terms.sine[t]);
    if (std::abs(bond.dot(way)) < least_cosine * terms.length[t]) continue;
    for (int k = 0; k < stations; ++k) {
      const double at = (k + 1) * law.spacing / stations, part = (at - from.dot(way)) / bond.dot(way);
      if (part <= 0 || part >= 1 || std::abs(cross(way, from + part * bond)) > beside * law.spacing) continue;
      ++present[static_cast<std::size_t>(k)];
      left[static_cast<std::size_t>(k)] += system.intact()[t] != 0 ? 1 : 0;
    }
  }
  for (std::size_t k = 0; k < stations; ++k)
    if (present[k] >= enough_bonds && left[k] == 0) return static_cast<double>(k + 1) * law.spacing / stations;
  return std::nullopt;
}

}  // namespace

LineEvents::LineEvents(LoadedBody& body, WholeBodyEvents& whole_body, pd::TipLaws laws)
    : body_(body), whole_body_(whole_body), stress_(body.system(), body.positions()), laws_(std::move(laws)) {}

// A point that lies on the way belongs to one of its sides, so that none is left hanging between.
std::vector<int> LineEvents::across(const Point& from, const Point& to, double horizon) const {
  const std::vector<Point>& positions = body_.positions();
  const coupling::Terms& terms = body_.system().terms();
  std::vector<int> found;
  for (std::size_t node = 0; node < positions.size(); ++node) {
    if ((positions[node] - from).norm() > horizon + (to - from).norm()) continue;
    stress_.for_each_bond(static_cast<int>(node), [&](int bond) {
      const auto b = static_cast<std::size_t>(bond);
      if (terms.first[b] != static_cast<int>(node)) return;
      const Point &p = positions[node], &q = positions[static_cast<std::size_t>(terms.second[b])];
      if ((side(from, to, p) > 0) != (side(from, to, q) > 0) && (side(p, q, from) > 0) != (side(p, q, to) > 0))
        found.push_back(bond);
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<LineEvents::Step> LineEvents::step_of(std::size_t number) const {
  const BodyState& state = body_.state();
  const GrowingTip& tip = state.tips[number];
  const pd::TipLaw& law = law_of(tip);
  const AffineIntensity intensity = stress_.at(tip, law, state.displacement, body_.pressure_in(law.crack));
  const AffineIntensity turning =
      is_short(tip) ? stress_.closely_ahead_of(tip, law, state.displacement, body_.pressure_in(law.crack)) : intensity;
  Step step{number, tip.direction, 0, state.load_factor, 0, 0, {}};
  // Without constant loads the kink does not depend on the load factor.
  const bool proportional = turning.one[0] == 0 && turning.two[0] == 0;
  double load_factor = proportional || state.load_factor <= 0 ? 1 : state.load_factor;
  for (int round = 0; round < (proportional ? 1 : rounds_for_kink); ++round) {
    const Eigen::Vector2d at(1, load_factor);
    const double kink = kink_of({intensity.one.dot(at), intensity.two.dot(at)}).angle;
    const double turn = kink_of({turning.one.dot(at), turning.two.dot(at)}).angle;
    const auto share = [&](int part) {
      return hoop_factor({intensity.one[part], intensity.two[part]}, kink) * correction(tip) / law.toughness;
    };
    step.constant = share(0), step.growing = share(1), step.direction = turned(tip.direction, turn);
    if (!(step.growing > 0)) return std::nullopt;
    load_factor = (1 - step.constant) / step.growing;
  }
  step.load_factor = load_factor;
  const std::optional<double> face = face_ahead(body_, body_.system(), tip.place, step.direction, law);
  if (face) {
    // As far as the row of points behind the face may lie.
    step.length = *face + law.spacing / 2;
    step.bonds = across(tip.place, tip.place + step.length * step.direction, law.horizon);
  }
  for (int k = 1; !face && k <= most_empty_steps && step.bonds.empty(); ++k) {
    step.length = k * law.spacing;
    step.bonds = across(tip.place, tip.place + step.length * step.direction, law.horizon);
  }
  if (step.bonds.empty()) return std::nullopt;
  return step;
}

std::vector<char> LineEvents::intact_away_from_tips(const std::vector<char>& growing) const {
  std::vector<char> intact = body_.system().intact();
  const coupling::Terms& terms = body_.system().terms();
  const std::vector<GrowingTip>& tips = body_.state().tips;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    if (!growing[k]) continue;
    const double reach = guarded_reach * law_of(tips[k]).horizon;
    for (std::size_t b = 0; b < terms.size(); ++b)
      if ((body_.positions()[static_cast<std::size_t>(terms.first[b])] - tips[k].place).norm() < reach) intact[b] = 0;
  }
  return intact;
}

// None where two parts of other materials meet, and beside a tip that rests.
std::optional<LineEvents::Birth> LineEvents::birth_at(int bond, double load_factor) const {
  const coupling::Terms& terms = body_.system().terms();
  const auto b = static_cast<std::size_t>(bond);
  if (terms.is_wide(b)) return std::nullopt;
  const auto first = static_cast<std::size_t>(terms.first[b]), second = static_cast<std::size_t>(terms.second[b]);
  const int number = laws_.of_node[first];
  if (number < 0 || laws_.of_node[second] < 0) return std::nullopt;
  const pd::TipLaw& law = laws_.laws[static_cast<std::size_t>(number)];
  const Point middle = (body_.positions()[first] + body_.positions()[second]) / 2;
  for (const GrowingTip& tip : body_.state().tips)
    if ((tip.place - middle).norm() < reach_of_resting_tip * law.horizon) return std::nullopt;
  return Birth{middle, stress_.across_tension(bond, law, body_.state().displacement, load_factor), number};
}

const Event* LineEvents::tell_birth(int bond, const Birth& birth, double load_factor) {
  const pd::TipLaw& law = laws_.laws[static_cast<std::size_t>(birth.law)];
  const Point half = law.spacing / 2 * birth.direction;
  std::vector<int> bonds = across(birth.middle - half, birth.middle + half, law.horizon);
  if (!std::binary_search(bonds.begin(), bonds.end(), bond)) return nullptr;
  event_ = {load_factor, 0, load_factor, {}};
  event_.reach(body_.ratios().at(static_cast<std::size_t>(bond), load_factor),
               body_.ratios().critical_load_factor(static_cast<std::size_t>(bond), load_factor));
  for (const int b : bonds)
    event_.changes.push_back({b, body_.system().terms().law_of(static_cast<std::size_t>(b)).gone()});
  event_.changes = body_.system().with_followers(std::move(event_.changes));
  birth_ = birth;
  return &event_;
}

const Event* LineEvents::tell_bonds(const std::vector<char>& intact, double load_factor,
                                    const SteppingOptions& options) {
  event_ = {load_factor, 0, load_factor, {}};
  for (const int t :
       body_.ratios().most_stretched(intact, load_factor, options.tie_band, options.max_breaks_per_solve)) {
    event_.changes.push_back(body_.system().after_critical(t));
    const auto bond = static_cast<std::size_t>(t);
    event_.reach(body_.ratios().at(bond, load_factor), body_.ratios().critical_load_factor(bond, load_factor));
  }
  event_.changes = body_.system().with_followers(std::move(event_.changes));
  return &event_;
}

const Event* LineEvents::next(double target, const SteppingOptions& options) {
  step_.reset();
  birth_.reset();
  const BodyState& state = body_.state();
  if (target < state.load_factor) return nullptr;
  const bool path = options.control == Control::path;
  std::vector<char> growing(state.tips.size(), 0);
  for (std::size_t k = 0; k < state.tips.size(); ++k) {
    if (has_ended(state.tips[k])) continue;
    std::optional<Step> step = step_of(k);
    growing[k] = step.has_value();
    if (step && (!step_ || step->load_factor < step_->load_factor)) step_ = std::move(step);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  double at = infinity;
  if (step_) at = path ? step_->load_factor : std::max(step_->load_factor, state.load_factor);
  const std::vector<char> intact = laws_.of_node.empty() ? std::vector<char>() : intact_away_from_tips(growing);
  const std::optional<double> bonds = laws_.of_node.empty() ? std::nullopt
                                      : path                ? body_.ratios().admissible(intact).next(true)
                                             : body_.ratios().next_break(intact, state.load_factor, infinity);
  if (bonds && *bonds < at) {
    step_.reset();
    const std::vector<int> most = body_.ratios().most_stretched(intact, *bonds, 0, 1);
    const std::optional<Birth> birth = most.empty() ? std::nullopt : birth_at(most.front(), *bonds);
    const Event* born = birth ? tell_birth(most.front(), *birth, *bonds) : nullptr;
    return born ? born : tell_bonds(intact, *bonds, options);
  }
  if (!step_) return nullptr;
  event_ = {at, step_->constant + at * step_->growing, step_->load_factor, {}};
  for (const int bond : step_->bonds)
    event_.changes.push_back({bond, body_.system().terms().law_of(static_cast<std::size_t>(bond)).gone()});
  event_.changes = body_.system().with_followers(std::move(event_.changes));
  return &event_;
}

// Of a crack that has begun in the run, as long as it is shorter than the steps that are remembered.
bool LineEvents::is_short(const GrowingTip& tip) const {
  return law_of(tip).crack == 0 && tip.energy_ratios.size() < remembered_steps;
}

double LineEvents::hoop_ratio(const GrowingTip& tip) const {
  const pd::TipLaw& law = law_of(tip);
  const Eigen::Vector2d at(1, body_.state().load_factor);
  const AffineIntensity found = stress_.at(tip, law, body_.state().displacement, body_.pressure_in(law.crack));
  return kink_of({found.one.dot(at), found.two.dot(at)}).equivalent_factor / law.toughness;
}

Outcome LineEvents::perform() {
  bool arrives = false;
  if (step_) {
    const GrowingTip& tip = body_.state().tips[step_->tip];
    arrives = face_ahead(body_, body_.system(), tip.place, step_->direction, law_of(tip)).has_value();
  }
  const Outcome outcome = whole_body_.perform(event_);
  std::vector<GrowingTip>& tips = body_.state().tips;
  if (birth_) {
    const Point half = laws_.laws[static_cast<std::size_t>(birth_->law)].spacing / 2 * birth_->direction;
    tips.push_back({birth_->middle + half, birth_->direction, birth_->law, {}});
    tips.push_back({birth_->middle - half, -birth_->direction, birth_->law, {}});
  }
  if (!step_) return outcome;
  GrowingTip& tip = tips[step_->tip];
  const pd::TipLaw& law = law_of(tip);
  // The ratio of the event holds the correction that was made; what is remembered must not.
  const double before = event_.ratio / correction(tip);
  tip.place += step_->length * step_->direction;
  tip.direction = step_->direction;
  // Behind a kink, or as an edge comes or goes, the energy release rate changes within a spacing by up to a half: what
  // is expected is the mean of the rates at both ends of the step.
  const double after = arrives ? before : std::max(hoop_ratio(tip), 0.0);
  const double rate = law.toughness * law.toughness / law.modulus * (before * before + after * after) / 2;
  const double ratio = outcome.released_energy / (rate * law.thickness * step_->length);
  // The first step releases more or less by where among the points the crack was described to end.
  const bool is_first = tip.energy_ratios.empty();
  tip.energy_ratios.push_back(is_first ? 1 : std::clamp(ratio, least_ratio, largest_ratio));
  if (tip.energy_ratios.size() > remembered_steps) tip.energy_ratios.erase(tip.energy_ratios.begin());
  if (arrives) tip.law = ended(tip.law);
  return outcome;
}

}  // namespace bempd::fracture

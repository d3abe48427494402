#include "fracture/whole_body_events.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/balance.hpp"
#include "fracture/contact/gap_rule.hpp"
#include "fracture/free_motions.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// A term that lengthens by this factor when it goes was the last resistance to some motion.
constexpr double runaway_elongation = 1e8;

// What elongations may have of the displacements that they are differences of.
constexpr double elongation_rounding = 1e-16;

// An increment that has begun by less than this share of its size has not begun.
constexpr double increment_rounding = 1e-9;

}  // namespace

using coupling::evaluate;

const Event* WholeBodyEvents::next(double target, const SteppingOptions& options) {
  const std::optional<double> load_factor = next_load_factor(target, options);
  if (!load_factor) return nullptr;
  event_ = {};
  event_.load_factor = event_.critical_load_factor = *load_factor;
  const bool upwards = target >= body_.state().load_factor;
  if (upwards ? *load_factor <= target : *load_factor >= target) choose_terms(options);
  return &event_;
}

std::optional<double> WholeBodyEvents::next_load_factor(double target, const SteppingOptions& options) {
  const LoadWay way = body_.way_to(target, options.control);
  const std::optional<double> next = body_.next_critical(way);
  if (!next || way.control == Control::path || options.mode == SteppingMode::events) return next;
  const Stopwatch watch(body_.seconds_search());
  if (const std::optional<double> increment = next_increment(target, options.increment)) return increment;
  // Without a break up to the target there is one beyond it.
  return way.end();
}

std::optional<double> WholeBodyEvents::next_increment(double target, double increment) const {
  // Increments end at multiples of their size and at the target.
  const double present = body_.state().load_factor, direction = target >= present ? 1 : -1;
  const auto number = [&](double load_factor) { return load_factor * direction / increment; };
  const double first = std::floor(number(present) + increment_rounding) + 1;
  double from = present;
  for (;;) {
    const std::optional<double> next = body_.ratios().next_break(system_.intact(), from, target);
    if (!next || (target - from) * direction <= 0) return std::nullopt;
    const double end = std::max(first, std::ceil(number(*next) - increment_rounding)) * increment;
    const double load_factor = direction * std::min(end, target * direction);
    if (!body_.ratios().overstretched(system_.intact(), load_factor).empty()) return load_factor;
    from = load_factor;  // what exceeded its critical stretch here has been relieved by then
  }
}

void WholeBodyEvents::choose_terms(const SteppingOptions& options) {
  const Stopwatch watch(body_.seconds_search());
  const double f = event_.load_factor;
  const BondList bonds = body_.bonds();
  const std::vector<int> chosen = options.mode == SteppingMode::increments
                                      ? body_.ratios().overstretched(system_.intact(), f)
                                      : most_critical(bonds, f, options.tie_band, options.max_breaks_per_solve);
  event_ = break_of(bonds, chosen, f, system_);
  event_.changes = system_.with_followers(std::move(event_.changes));
}

bool WholeBodyEvents::runs_away() {
  const double f = body_.state().load_factor;
  const Eigen::VectorXd after = evaluate(body_.state().displacement, f);
  // What follows, or a step of a line cuts besides, may have had no elongation of its own, where nothing is carried
  // none of them.
  const double displacement = body_.state().total_displacement.lpNorm<Eigen::Infinity>();
  double largest = elongation_rounding * displacement;
  for (const Changing& one : changing_) largest = std::max(largest, std::abs(one.elastic));
  // A body that loses its loads goes back from a part that is held where it was, and no further.
  const double most = std::max(runaway_elongation * largest, 2 * displacement);
  for (std::size_t i = 0; i < changing_.size(); ++i) {
    const auto term = static_cast<std::size_t>(event_.changes[i].term);
    const double now = std::abs(system_.terms().elastic_elongation(term, after.data(), f));
    if (!(now <= most)) return true;
  }
  return false;
}

WholeBodyEvents::Changing WholeBodyEvents::changing(const coupling::StageChange& change) const {
  const coupling::Terms& terms = system_.terms();
  const BodyState& state = body_.state();
  const auto term = static_cast<std::size_t>(change.term);
  const double* u = state.total_displacement.data();
  const bool breaks = terms.is_broken(term, change.stage);
  return {system_.present_stiffness()[term] - system_.stiffness_after(change),
          breaks ? terms.constant(term, 0) + state.load_factor * terms.constant(term, 1) : 0, terms.elongation(term, u),
          terms.elastic_elongation(term, u, state.load_factor)};
}

// Potential energy lost. It is a quadratic function of the displacements that is least in equilibrium: where a
// stiffness k and a constant force q of a term are lost, whose elastic elongation grows from e to e' with its
// elongation growing from c.u to c.u', it falls by k e e' / 2 + q (c.u + c.u') / 2.
double WholeBodyEvents::released_energy() const {
  const coupling::Terms& terms = system_.terms();
  const BodyState& state = body_.state();
  const double* u = state.total_displacement.data();
  double sum = 0;
  for (std::size_t i = 0; i < changing_.size(); ++i) {
    const auto term = static_cast<std::size_t>(event_.changes[i].term);
    const auto& [stiffness, force, elongation, elastic] = changing_[i];
    sum += 0.5 * stiffness * elastic * terms.elastic_elongation(term, u, state.load_factor);
    if (force != 0) sum += 0.5 * force * (elongation + terms.elongation(term, u));
  }
  return sum;
}

// The same with the places that have lost or gained their stiffness.
double WholeBodyEvents::released_by_contacts(const Eigen::VectorXd& before) const {
  const coupling::Contacts& contacts = system_.contacts();
  const double* after = body_.state().total_displacement.data();
  double sum = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const bool was_closed = i < closed_before_.size() && closed_before_[i] != 0;
    if (was_closed == contacts.is_closed(i)) continue;
    sum += released_by_switch(contacts[i], was_closed, contacts[i].gap(before.data()), contacts[i].gap(after));
  }
  return sum;
}

// By forces that shut places as if these were stiff: the limit of the above, gaps being those without them.
double WholeBodyEvents::released_by_faces() const {
  if (system_.closed_face_count() == 0 && forces_before_.isZero(0)) return 0;
  const BodyState& state = body_.state();
  const Eigen::VectorXd forces = system_.face_forces(state.total_displacement, state.load_factor);
  const Eigen::VectorXd gaps = system_.open_gaps(state.total_displacement, state.load_factor);
  return 0.5 * (forces.dot(gaps_before_) - forces_before_.dot(gaps));
}

Outcome WholeBodyEvents::perform(Event event) {
  event_ = std::move(event);
  return perform();
}

void WholeBodyEvents::remember_faces() {
  closed_before_ = system_.contacts().closed();
  if (system_.face_count() == 0) return;
  const BodyState& state = body_.state();
  forces_before_ = system_.face_forces(state.total_displacement, state.load_factor);
  gaps_before_ = system_.open_gaps(state.total_displacement, state.load_factor);
}

Outcome WholeBodyEvents::perform() {
  Outcome outcome;
  BodyState& state = body_.state();
  outcome.work_before = body_.move_to(event_.load_factor);
  outcome.reactions_before = body_.reactions();
  outcome.resistance_before = body_.resistance(outcome.reactions_before);
  const std::vector<coupling::StageChange>& changes = event_.changes;
  const Eigen::VectorXd before = state.total_displacement;
  const double unbalanced_before = body_.unbalanced_share();
  outcome.stored_energy_before = body_.stored_energy();
  remember_faces();
  FreedParts freed;
  std::vector<int> broken;
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(before.size());  // force of the fluid that comes in
  {
    const Stopwatch watch(body_.seconds_search());
    changing_.clear();
    for (const coupling::StageChange& change : changes) changing_.push_back(changing(change));
    broken = system_.terms().broken_by(changes);
    outcome.broken = system_.count_broken(changes);
    system_.mark(changes);
    if (body_.has_fluid()) flow = body_.let_flow();
    freed = body_.freed_parts().after_break(broken, before);
  }
  system_.commit(changes, freed.springs);
  body_.faces().note_broken(broken, state.faces);
  body_.update_faces();
  outcome.fragments = freed.fragments;
  if (!freed.nodes_with_lost_loads.empty()) body_.drop_loads(freed.nodes_with_lost_loads);
  const HeldMotions held = solve_and_hold(body_, broken, before, [&] { return runs_away(); });
  outcome.fragments += held.fragments;
  const bool pushed = body_.unload_pushed_parts();
  const LoadedBody::Settled settled = body_.settle_contacts(0);
  outcome.switches = settled.switched;
  outcome.fragments += settled.fragments;
  body_.keep_held_parts_dry();
  const bool loads_lost = held.loads_lost || pushed || settled.fragments > 0 || !freed.nodes_with_lost_loads.empty();
  if (loads_lost) outcome.lost_balance = {unbalanced_before, body_.unbalanced_share()};
  body_.update_ratios();
  outcome.work = body_.absorb(event_.load_factor);
  add_energies(before, flow, loads_lost, outcome);
  state.stages = system_.stages();
  state.springs = system_.springs();
  tell_of_body(outcome);
  return outcome;
}

// Of the event, from displacements before it; `flow` is the force of the fluid that has come in. Lost loads take their
// part along with the piece.
void WholeBodyEvents::add_energies(const Eigen::VectorXd& before, const Eigen::VectorXd& flow, bool loads_lost,
                                   Outcome& outcome) const {
  // All of that force is there while the points give way, of which nodal forces before and after show the half; and it
  // fills what the bonds had stretched before they broke.
  const double by_fluid = 0.5 * flow.dot(body_.state().total_displacement + before);
  outcome.work += by_fluid;
  outcome.stored_energy = body_.stored_energy();
  const double released = released_energy() + released_by_contacts(before) + released_by_faces() + by_fluid;
  outcome.released_energy = loads_lost ? outcome.work + outcome.stored_energy_before - outcome.stored_energy : released;
  outcome.bond_energy = released / (event_.ratio * event_.ratio);
}

void WholeBodyEvents::tell_of_body(Outcome& outcome) {
  outcome.critical_stored_energy = body_.stored_energy_at(event_.critical_load_factor);
  outcome.unit_energy = body_.unit_energy();
  outcome.residual = body_.residual();
  outcome.energy_scale = least_energy_scale(system_, event_.load_factor);
  outcome.reactions = body_.reactions();
  outcome.resistance = body_.resistance(outcome.reactions);
}

}  // namespace bempd::fracture

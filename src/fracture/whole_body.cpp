#include "fracture/whole_body.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/contact/gap_rule.hpp"
#include "fracture/part_holder.hpp"
#include "stopwatch.hpp"

namespace bempd::fracture {

namespace {

// Largest ratio of a term's elongation after its break to the scale of elongations before the break. A larger ratio
// means that the term was the last resistance to some motion.
constexpr double runaway_elongation = 1e8;

// Rounding error of an elongation, as a share of the displacements whose difference it is.
constexpr double elongation_rounding = 1e-16;

}  // namespace

using coupling::evaluate;

Elongation WholeBody::elongation(int term, double load_factor) const {
  const coupling::Terms& terms = system_.terms();
  const double* u = body_.state().total_displacement.data();
  const auto t = static_cast<std::size_t>(term);
  return {terms.elongation(t, u), terms.elastic_elongation(t, u, load_factor)};
}

bool WholeBody::loses_resistance(std::span<const ChangingTerm> terms) const {
  const double f = body_.state().load_factor;
  const Eigen::VectorXd after = evaluate(body_.state().displacement, f);
  // The scale of elongations is the largest elastic elongation of all changing terms, because a follower (cell square),
  // or a bond that the step of a crack line cuts, may have had no elongation. For events without load, the scale is at
  // least the rounding error.
  const double displacement = body_.state().total_displacement.lpNorm<Eigen::Infinity>();
  double largest = elongation_rounding * displacement;
  for (const ChangingTerm& one : terms) largest = std::max(largest, std::abs(one.before.elastic));
  // A body that loses its loads moves back by at most its displacement, which changes the elongation of a term between
  // two parts by at most twice as much.
  const double most = std::max(runaway_elongation * largest, 2 * displacement);
  const auto is_within = [&](const ChangingTerm& one) {
    const auto term = static_cast<std::size_t>(one.term);
    return std::abs(system_.terms().elastic_elongation(term, after.data(), f)) <= most;
  };
  return !std::all_of(terms.begin(), terms.end(), is_within);
}

// Energies [J] that constraints have released by opening or closing at the event: the sum for constraints with a
// penalty, then, if an exact constraint has a multiplier (contact force), the sum for exact constraints. The formula
// for exact constraints is the limit of the formula with penalties for large penalties; the gaps in it are those that
// the displacements would leave without multipliers.
std::vector<double> WholeBody::released_by_constraints(const Eigen::VectorXd& before) const {
  const coupling::Constraints& constraints = system_.constraints();
  const Eigen::VectorXd& after = body_.state().total_displacement;
  double by_penalties = 0;
  for (std::size_t i = constraints.exact_count(); i < constraints.size(); ++i) {
    const coupling::Constraint& one = constraints[i];
    const bool was_closed = i < closed_before_.size() && closed_before_[i] != 0;
    if (was_closed == constraints.is_closed(i)) continue;
    by_penalties += released_by_switch(one, was_closed, one.gap(before.data()), one.gap(after.data()));
  }
  if (constraints.closed_exact_count() == 0 && multipliers_before_.isZero(0)) return {by_penalties};
  const double f = body_.state().load_factor;
  const coupling::CondensedOperators& exact = system_.operators();
  const double gained = exact.multipliers(after, f).dot(exact.gaps_without_multipliers(before, f));
  const double lost = multipliers_before_.dot(exact.gaps_without_multipliers(after, f));
  return {by_penalties, 0.5 * (gained - lost)};
}

void WholeBody::remember_constraints() {
  const BodyState& state = body_.state();
  closed_before_ = system_.constraints().closed();
  multipliers_before_ = system_.operators().multipliers(state.total_displacement, state.load_factor);
}

std::optional<BodyChange> WholeBody::change(const Event& event, std::span<const ChangingTerm> terms, Outcome& outcome) {
  BodyState& state = body_.state();
  const std::vector<coupling::StageChange>& changes = event.changes;
  const std::vector<int> broken = system_.terms().broken_by(changes);
  const Eigen::VectorXd before = state.total_displacement;
  const double unbalanced_before = body_.loads().unbalanced_share();
  remember_constraints();
  FreedParts freed;
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(before.size());  // forces of the fluid that enters
  {
    const Stopwatch watch(body_.response().seconds_search());
    system_.stages().mark(changes);
    if (body_.loads().has_fluid()) flow = body_.loads().spread_fluid();
    freed = body_.freed_parts().after_break(broken, before);
  }
  system_.commit(changes, freed.springs);
  body_.faces().note_broken(broken, state.faces);
  body_.contact().update_faces();
  outcome.fragments = freed.fragments;
  if (!freed.nodes_with_lost_loads.empty()) body_.loads().drop(freed.nodes_with_lost_loads);
  const HeldMotions held = body_.holder().solve(broken, before, [&] { return loses_resistance(terms); });
  outcome.fragments += held.fragments;
  const bool pushed = body_.holder().unload_pushed();
  const BodyContact::Settled settled = body_.contact().settle(0);
  outcome.switches = settled.switched;
  outcome.fragments += settled.fragments;
  body_.holder().exclude_from_fluid();
  BodyChange change;
  change.takes_loads_along = held.loads_lost || pushed || settled.fragments > 0 || !freed.nodes_with_lost_loads.empty();
  if (change.takes_loads_along) outcome.lost_balance = {unbalanced_before, body_.loads().unbalanced_share()};
  body_.response().update_ratios();
  change.work = body_.response().absorb(event.load_factor);
  // The whole force of the entering fluid acts while the points move. absorb() takes the mean of the nodal forces
  // before and after, which contains half of this force, so the other half is added. The fluid also fills the opening
  // that the bonds had before they broke.
  const double by_fluid = 0.5 * flow.dot(state.total_displacement + before);
  change.work += by_fluid;
  change.released_after_terms = released_by_constraints(before);
  change.released_after_terms.push_back(by_fluid);
  state.stages = system_.stages().numbers();
  state.springs = system_.springs();
  return change;
}

}  // namespace bempd::fracture

#include "fracture/contact/body_contact.hpp"

#include <algorithm>
#include <utility>

#include "cancellation.hpp"
#include "error.hpp"
#include "fracture/contact/gap_rule.hpp"
#include "fracture/contact/newton_rounds.hpp"

namespace bempd::fracture {

using coupling::evaluate;

namespace {

// Limits on the number of rounds in which contact constraints are switched. Newton's method takes 1 to 6 rounds
// (newton_rounds); switching one constraint at a time may switch each constraint several times (rounds_per_constraint).
constexpr std::int64_t newton_rounds = 64, rounds_per_constraint = 16;

// Number of rounds without agreement after which gaps are evaluated slightly farther along the load path. Faces may
// part or meet all at once, as under a pressure that just vanishes. In that case rounding may decide which constraints
// are open, so that no set of closed constraints agrees with all gaps.
constexpr std::int64_t rounds_at_rounding = 256;
// Distances along the load path at which gaps are evaluated after rounds_at_rounding, as shares of the load factor: the
// first and the largest share. The share grows tenfold at each attempt.
constexpr double farther_at_first = 1e-8, farthest_ahead = 1e-6;

// Constraint to be switched alone, out of those whose gaps are wrong: the first constraint with a penalty, else the
// first exact constraint.
int first_of(const std::vector<int>& wrong, const coupling::Constraints& constraints) {
  const auto has_penalty = [&](int i) { return !constraints[static_cast<std::size_t>(i)].is_exact(); };
  const auto found = std::find_if(wrong.begin(), wrong.end(), has_penalty);
  return found == wrong.end() ? wrong.front() : *found;
}

}  // namespace

// Bars the contact constraints of parts that only springs hold from closing, because a closed constraint would push
// such a part away.
void BodyContact::bar_held_parts() {
  const coupling::Constraints& constraints = system_.constraints();
  const std::size_t exact = constraints.exact_count(), count = constraints.size() - exact;
  const std::size_t springs = system_.springs().size();
  if (constraints.size() == 0 || springs == 0) return system_.contact().bar({});
  // Held parts only change when terms break or springs are added, and both numbers never decrease. So an unchanged sum
  // of the two numbers tells that the barred constraints are still up to date.
  const auto broken = std::count(system_.stages().intact().begin(), system_.stages().intact().end(), 0);
  const std::size_t changes = springs + static_cast<std::size_t>(broken);
  const bool is_known = constraints.barred().size() == count && constraints.barred_exact().size() == exact;
  if (is_known && changes_that_bar_ == changes) return;
  changes_that_bar_ = changes;
  const HeldParts parts = holder_.held_parts();
  const std::vector<char> held = parts.all_nodes();
  std::vector<char> barred;
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<coupling::TermEntry>& pull = constraints[exact + k].pull;
    const auto is_held = [&](const coupling::TermEntry& e) { return held[e.node] != 0; };
    barred.push_back(std::any_of(pull.begin(), pull.end(), is_held) ? 1 : 0);
  }
  system_.contact().bar(std::move(barred), exact_constraints_that_push(system_, positions_, parts));
}

void BodyContact::bar(std::vector<char> barred, std::size_t changes) {
  system_.contact().bar(std::move(barred));
  changes_that_bar_ = changes;
}

// Load factor farther along `direction` by a share of its size. The size is the present load factor plus the load
// factor at which the constant and the proportional part of the displacement are equally large, so that it does not
// vanish at 0.
double BodyContact::farther_on(double share, double direction) const {
  const double f = state_.load_factor, proportional = state_.displacement.col(1).lpNorm<Eigen::Infinity>();
  if (share == 0 || proportional == 0) return f;
  const double size = std::abs(f) + state_.displacement.col(0).lpNorm<Eigen::Infinity>() / proportional;
  return f + (direction < 0 ? -1 : 1) * share * size;
}

double BodyContact::settled_until(double direction) const {
  const double f = state_.load_factor;
  return settled_at_ == f && (settled_farther_on_ - f) * direction > 0 ? settled_farther_on_ : f;
}

bool BodyContact::switches_at_once(double direction) const {
  const double f = state_.load_factor;
  const coupling::Affine& u = state_.displacement;
  const coupling::Constraints& constraints = system_.constraints();
  if (constraints.size() == 0 || settled_until(direction) != f) return false;
  return !wrong_constraints(constraints, system_.contact().gaps(u), u, f, direction).empty();
}

void BodyContact::look_ahead(double direction) {
  const double settled_at = settled_at_, settled_farther_on = settled_farther_on_;
  settle(direction);
  settled_at_ = settled_at, settled_farther_on_ = settled_farther_on;
  response_.update_ratios();
  // Displacements without a constant part are proportional to the load factor, of which only the sign matters in that
  // case.
  const double at = farther_on(farthest_ahead, direction);
  state_.load_factor = at != state_.load_factor ? at : state_.load_factor + direction;
}

BodyContact::Settled BodyContact::settle(double direction) {
  // Newton's method converges here, because the energy is a convex function of the displacements with a continuous
  // gradient.
  Settled result;
  NewtonRounds rounds;
  double farther = 0;
  const coupling::Constraints& constraints = system_.constraints();
  const std::int64_t most = newton_rounds + rounds_per_constraint * static_cast<std::int64_t>(constraints.size());
  for (std::int64_t round = 0;; ++round) {
    if (round > 0 && round % rounds_at_rounding == 0 && farther < farthest_ahead) {
      farther = farther == 0 ? farther_at_first : 10 * farther;
      rounds = NewtonRounds();
    }
    const double at = farther_on(farther, direction);
    bar_held_parts();
    const coupling::Affine& u = state_.displacement;
    std::vector<int> wrong = wrong_constraints(constraints, system_.contact().gaps(u), u, at, direction);
    if (wrong.empty()) break;
    check_cancelled();
    if (round == most) fail(Failure::convergence, "faces of cracks open and close without an end");
    if (!rounds.takes_all(wrong.size(), constraints.closed())) wrong = {first_of(wrong, constraints)};
    const bool some_open = std::any_of(wrong.begin(), wrong.end(), [&](int i) { return constraints.is_closed(i); });
    system_.contact().switch_over(wrong);
    result.switched += static_cast<std::int64_t>(wrong.size());
    if (!some_open) {
      response_.solve();
      continue;
    }
    // Opening faces may free a part that only closed faces held.
    const Eigen::VectorXd before = state_.total_displacement;
    HeldMotions held = holder_.solve({}, before, [&] { return !response_.is_balanced(); });
    result.held.insert(result.held.end(), held.nodes.begin(), held.nodes.end());
    result.fragments += held.fragments;
  }
  settled_at_ = state_.load_factor, settled_farther_on_ = farther_on(farther, direction);
  state_.faces.closed = constraints.closed();
  state_.springs = system_.springs();
  return result;
}

}  // namespace bempd::fracture

// Contact of the whole body at its load factor: which faces of its cracks press on each other (the active set).
#include <algorithm>
#include <utility>

#include "cancellation.hpp"
#include "error.hpp"
#include "fracture/contact/gap_rule.hpp"
#include "fracture/contact/held_parts.hpp"
#include "fracture/contact/newton_rounds.hpp"
#include "fracture/free_motions.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

using coupling::evaluate;

namespace {

// Limits on rounds. Newton's method takes 1 to 6; switching one constraint at a time may meet each constraint several
// times.
constexpr std::int64_t newton_rounds = 64, rounds_per_constraint = 16;

// Faces may part or meet all at once, as under a pressure that just vanishes. Rounding may then decide which
// constraints are open, and there is no solution. After this many rounds gaps are evaluated a little farther along the
// load path: by a share of the load factor that grows tenfold at each attempt.
constexpr std::int64_t rounds_at_rounding = 256;
constexpr double farther_at_first = 1e-8, farthest_ahead = 1e-6;

// Displacement over the largest one of a held motion below which a node counts as not moving.
constexpr double taken_along = 1e-6;

// Force of a spring over the largest nodal force below which it is rounding.
constexpr double pushed_share = 1e-9;

// Constraint to be switched alone: the first of the wrong ones with a penalty, or else the first of the exact ones.
int first_of(const std::vector<int>& wrong, const coupling::Constraints& constraints) {
  const auto has_penalty = [&](int i) { return !constraints[static_cast<std::size_t>(i)].is_exact(); };
  const auto found = std::find_if(wrong.begin(), wrong.end(), has_penalty);
  return found == wrong.end() ? wrong.front() : *found;
}

void hold_what_moves(const Eigen::VectorXd& motion, std::vector<char>& nodes) {
  const double limit = taken_along * motion.lpNorm<Eigen::Infinity>();
  for (std::size_t node = 0; node < nodes.size(); ++node)
    if (motion.segment<2>(2 * static_cast<Eigen::Index>(node)).norm() > limit) nodes[node] = 1;
}

}  // namespace

HeldParts LoadedBody::held_parts() const {
  FreedPartFinder::Held held = freed_parts_.held_parts();
  HeldParts parts{std::move(held.nodes), {}};
  // Closed faces do not count as connections here, so that the set of barred constraints does not depend on them.
  if (!held.others.empty()) parts.motions = system_.motions_held_by(held.others);
  return parts;
}

std::vector<char> LoadedBody::nodes_of_held_parts() const {
  HeldParts held = held_parts();
  for (const Eigen::VectorXd& motion : held.motions) hold_what_moves(motion, held.nodes);
  return std::move(held.nodes);
}

// Keeps parts held by springs out of the fluid: they would be pushed away if it reached them later.
void LoadedBody::keep_held_parts_dry() {
  if (!has_fluid() || system_.springs().empty()) return;
  const std::vector<char> held = nodes_of_held_parts();
  for (int node = 0; node < system_.node_count(); ++node)
    if (held[node] && system_.force().middleRows<2>(2 * node).isZero(0)) state_.unloaded[node] = 1;
}

// Removes the loads of parts that the fluid pushes although only springs hold them, and solves again. Returns whether
// there were any.
bool LoadedBody::unload_pushed_parts() {
  if (!has_fluid() || system_.springs().empty()) return false;
  const double f = state_.load_factor;
  const Eigen::VectorXd u = evaluate(state_.displacement, f);
  double largest = 0;
  for (const coupling::HoldingSpring& s : system_.springs()) {
    const double moved = s.cosine * u[2 * s.node] + s.sine * u[2 * s.node + 1] - s.anchor;
    largest = std::max(largest, std::abs(s.stiffness * moved));
  }
  if (largest <= pushed_share * evaluate(system_.force(), f).lpNorm<Eigen::Infinity>()) return false;
  const std::vector<char> held = nodes_of_held_parts();
  std::vector<int> nodes;
  for (int node = 0; node < system_.node_count(); ++node)
    if (held[node]) nodes.push_back(node);
  drop_loads(nodes);
  solve();
  return true;
}

// Bars the constraints of parts that only springs hold: a constraint that closes on such a part would push it away.
void LoadedBody::bar_constraints_of_held_parts() {
  const coupling::Constraints& constraints = system_.constraints();
  const std::size_t exact = constraints.exact_count(), count = constraints.size() - exact;
  const std::size_t springs = system_.springs().size();
  if (constraints.size() == 0 || springs == 0) return system_.bar_constraints({});
  // The numbers of springs and of broken terms tell whether the barred constraints are still up to date, because
  // neither ever decreases, and held parts only change when terms break.
  const auto broken = std::count(system_.intact().begin(), system_.intact().end(), 0);
  const std::size_t changes = springs + static_cast<std::size_t>(broken);
  const bool is_known = constraints.barred().size() == count && constraints.barred_exact().size() == exact;
  if (is_known && changes_that_bar_ == changes) return;
  changes_that_bar_ = changes;
  const HeldParts parts = held_parts();
  std::vector<char> held = parts.nodes;
  for (const Eigen::VectorXd& motion : parts.motions) hold_what_moves(motion, held);
  std::vector<char> barred;
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<coupling::TermEntry>& pull = constraints[exact + k].pull;
    const auto is_held = [&](const coupling::TermEntry& e) { return held[e.node] != 0; };
    barred.push_back(std::any_of(pull.begin(), pull.end(), is_held) ? 1 : 0);
  }
  system_.bar_constraints(std::move(barred), exact_ones_that_push(system_, positions_, parts));
}

void LoadedBody::bar_constraints(std::vector<char> barred, std::size_t changes) {
  system_.bar_constraints(std::move(barred));
  changes_that_bar_ = changes;
}

// Load factor farther along `direction`: by a share of the present one, or near zero by a share of the one at which
// both parts of the displacement are equally large.
double LoadedBody::farther_on(double share, double direction) const {
  const double f = state_.load_factor, proportional = state_.displacement.col(1).lpNorm<Eigen::Infinity>();
  if (share == 0 || proportional == 0) return f;
  const double size = std::abs(f) + state_.displacement.col(0).lpNorm<Eigen::Infinity>() / proportional;
  return f + (direction < 0 ? -1 : 1) * share * size;
}

double LoadedBody::settled_until(double direction) const {
  const double f = state_.load_factor;
  return settled_at_ == f && (settled_farther_on_ - f) * direction > 0 ? settled_farther_on_ : f;
}

bool LoadedBody::switches_at_once(double direction) const {
  const double f = state_.load_factor;
  const coupling::Affine& u = state_.displacement;
  const coupling::Constraints& constraints = system_.constraints();
  if (constraints.size() == 0 || settled_until(direction) != f) return false;
  return !wrong_constraints(constraints, system_.gaps(u), u, f, direction).empty();
}

void LoadedBody::look_ahead(double direction) {
  const double settled_at = settled_at_, settled_farther_on = settled_farther_on_;
  settle_constraints(direction);
  settled_at_ = settled_at, settled_farther_on_ = settled_farther_on;
  update_ratios();
  // Displacements without constant parts are in proportion to the load factor, of which only the sign matters.
  const double at = farther_on(farthest_ahead, direction);
  state_.load_factor = at != state_.load_factor ? at : state_.load_factor + direction;
}

LoadedBody::Settled LoadedBody::settle_constraints(double direction) {
  // Newton's method converges, because the energy is convex and once differentiable.
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
    bar_constraints_of_held_parts();
    const coupling::Affine& u = state_.displacement;
    std::vector<int> wrong = wrong_constraints(constraints, system_.gaps(u), u, at, direction);
    if (wrong.empty()) break;
    check_cancelled();
    if (round == most) fail(Failure::convergence, "faces of cracks open and close without an end");
    if (!rounds.takes_all(wrong.size(), constraints.closed())) wrong = {first_of(wrong, constraints)};
    const bool some_open = std::any_of(wrong.begin(), wrong.end(), [&](int i) { return constraints.is_closed(i); });
    system_.switch_constraints(wrong);
    result.switched += static_cast<std::int64_t>(wrong.size());
    if (!some_open) {
      solve();
      continue;
    }
    // A part may come free that only closed faces held.
    const Eigen::VectorXd before = state_.total_displacement;
    HeldMotions held = solve_and_hold(*this, {}, before, [&] { return !is_balanced(); });
    result.held.insert(result.held.end(), held.nodes.begin(), held.nodes.end());
    result.fragments += held.fragments;
  }
  settled_at_ = state_.load_factor, settled_farther_on_ = farther_on(farther, direction);
  state_.faces.closed = constraints.closed();
  state_.springs = system_.springs();
  return result;
}

}  // namespace bempd::fracture

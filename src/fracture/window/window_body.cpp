#include "fracture/window/window_body.hpp"

#include <algorithm>

#include "fracture/contact/gap_rule.hpp"
#include "fracture/contact/newton_rounds.hpp"

namespace bempd::fracture {

Elongation WindowBody::elongation(int term, double load_factor) const {
  const double whole = window_.elongation(window_.place_of(term), load_factor);
  return {whole, whole};
}

std::optional<BodyChange> WindowBody::change(const Event& event, std::span<const ChangingTerm> /*terms*/,
                                             Outcome& outcome) {
  const double f = event.load_factor;
  std::vector<coupling::StageChange> back;
  for (const coupling::StageChange& c : event.changes) back.push_back({c.term, system_.stages().numbers()[c.term]});
  const WindowFunctions::Values before = window_.rows().functions();
  const coupling::Affine kept_before = body_.faces().are_none() ? coupling::Affine(0, 2) : window_.state().displacement;
  if (!change_terms(event) || !settle_constraints(event, outcome)) {
    system_.stages().enter(back);
    return std::nullopt;
  }
  BodyChange change;
  change.work = WindowFunctions::work(before, window_.rows().functions(), f);
  if (outcome.switches == 0) return change;
  switched_faces_ = face_forecast_.last_state();
  change.released_before_terms = released_by_constraints(kept_before, f);
  return change;
}

// Changes the damage stages of the event's terms in the system and in the window. False if this frees a part of the
// body, or if the window cannot perform the change.
bool WindowBody::change_terms(const Event& event) {
  std::vector<coupling::StageChange> here;  // with places in the window as numbers of terms
  for (const coupling::StageChange& c : event.changes) here.push_back({window_.place_of(c.term), c.stage});
  system_.stages().enter(event.changes);
  const std::vector<int> broken = system_.terms().broken_by(event.changes);
  return body_.freed_parts().frees_nothing(broken, displacement_) && window_.change(here);
}

std::vector<std::size_t> WindowBody::wrong_constraints(double f) const {
  std::vector<std::size_t> wrong;
  const double largest = window_.rows().largest_displacement(f);
  for (const std::size_t i : face_forecast_.last()) {
    const WatchedConstraint& one = face_forecast_.constraints()[i];
    if (!window_.rows().follows(one.constraint)) continue;
    if (is_wrong(one.constraint, one.closed, window_.rows().gap(one.constraint, f), largest)) wrong.push_back(i);
  }
  return wrong;
}

// Whether a closed contact constraint touches a part that springs hold. The whole body might bar such a constraint from
// closing, because the held part may become larger as terms break.
bool WindowBody::presses_on_held_parts() const {
  std::vector<std::size_t> closed = face_forecast_.last();
  std::erase_if(closed, [&](std::size_t i) { return !face_forecast_.constraints()[i].closed; });
  if (closed.empty()) return false;
  const FreedPartFinder::PartsOnSprings held = body_.freed_parts().held_parts();
  if (!held.springs_in_supported_pieces.empty()) return true;
  return std::any_of(closed.begin(), closed.end(), [&](std::size_t i) {
    const std::vector<coupling::TermEntry>& pull = face_forecast_.constraints()[i].constraint.pull;
    return std::any_of(pull.begin(), pull.end(), [&](const coupling::TermEntry& e) { return held.nodes[e.node] != 0; });
  });
}

// Closes and opens constraints after an event until they agree with their gaps, by the same Newton's method as in the
// whole body. False if the window cannot perform a switch.
bool WindowBody::settle_constraints(const Event& event, Outcome& outcome) {
  if (body_.faces().are_none()) return true;
  face_forecast_.follow(coupling::terms_of(event.changes), state_);
  if (!system_.springs().empty()) return !presses_on_held_parts();  // springs may bar constraints
  watched_before_ = face_forecast_.last();
  NewtonRounds rounds;
  for (;;) {
    const std::vector<std::size_t> wrong = wrong_constraints(event.load_factor);
    if (wrong.empty()) return true;
    rounds.takes_all(wrong.size(), face_forecast_.last_state().closed);
    if (rounds.comes_back()) return false;
    std::vector<WindowSolver::Switch> switches;
    for (const std::size_t i : wrong) {
      const WatchedConstraint& one = face_forecast_.constraints()[i];
      switches.push_back({one.constraint, !one.closed});
    }
    if (!window_.switch_constraints(switches)) return false;
    for (const std::size_t i : wrong) face_forecast_.switch_constraint(i, state_);
    outcome.switches += static_cast<std::int64_t>(wrong.size());
  }
}

double WindowBody::released_by_constraints(const coupling::Affine& kept_before, double f) const {
  const std::vector<std::size_t> after = face_forecast_.last();
  double sum = 0;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const WatchedConstraint &was = face_forecast_.constraints()[watched_before_[k]],
                            &is = face_forecast_.constraints()[after[k]];
    if (was.closed == is.closed) continue;
    sum += released_by_switch(is.constraint, was.closed, window_.rows().gap(is.constraint, f, kept_before),
                              window_.rows().gap(is.constraint, f));
  }
  return sum;
}

}  // namespace bempd::fracture

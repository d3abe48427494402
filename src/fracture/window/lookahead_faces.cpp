// Faces of cracks that close or open at the events of a window.
#include <algorithm>

#include "fracture/contact/gap_rule.hpp"
#include "fracture/contact/newton_rounds.hpp"
#include "fracture/window/lookahead.hpp"

namespace bempd::fracture {

std::vector<std::size_t> Lookahead::wrong_places(double f) const {
  std::vector<std::size_t> wrong;
  const double zero = gap_rounding(window_->largest_displacement(f));
  for (const std::size_t i : ahead_->last()) {
    const WatchedPlace& place = ahead_->places()[i];
    if (!window_->follows(place.contact)) continue;
    const double gap = window_->gap(place.contact, f);
    if (passed_zero(place.closed, gap) > zero) wrong.push_back(i);
  }
  return wrong;
}

// Whether places are closed that the whole body may find barred: what springs hold may grow as terms break.
bool Lookahead::presses_on_held_parts() const {
  std::vector<std::size_t> closed = ahead_->last();
  std::erase_if(closed, [&](std::size_t i) { return !ahead_->places()[i].closed; });
  if (closed.empty()) return false;
  const FreedPartFinder::Held held = freed_parts_.held_parts();
  if (!held.others.empty()) return true;
  return std::any_of(closed.begin(), closed.end(), [&](std::size_t i) {
    const std::vector<coupling::TermEntry>& pull = ahead_->places()[i].contact.pull;
    return std::any_of(pull.begin(), pull.end(), [&](const coupling::TermEntry& e) { return held.nodes[e.node] != 0; });
  });
}

// Newton's method, as in the whole body.
bool Lookahead::settle_faces(ForeseenEvent& foreseen) {
  if (!ahead_) return true;
  const int state = static_cast<int>(events_.size()) + 1;
  const double f = foreseen.event.load_factor;
  ahead_->follow(coupling::terms_of(foreseen.event.changes), state);
  if (!system_.springs().empty()) return !presses_on_held_parts();  // which may bar places
  const std::vector<std::size_t> before = ahead_->last();
  NewtonRounds rounds;
  for (;;) {
    const std::vector<std::size_t> wrong = wrong_places(f);
    if (wrong.empty()) break;
    rounds.takes_all(wrong.size(), {ahead_->last_state().closed, {}});
    if (rounds.comes_back()) return false;
    std::vector<ActiveWindow::FaceSwitch> switches;
    for (const std::size_t i : wrong) switches.push_back({ahead_->places()[i].contact, !ahead_->places()[i].closed});
    if (!window_->switch_faces(switches)) return false;
    for (const std::size_t i : wrong) ahead_->switch_place(i, state);
    foreseen.switches += static_cast<std::int64_t>(wrong.size());
  }
  if (foreseen.switches == 0) return true;
  foreseen.faces = ahead_->last_state();
  foreseen.released += released_by_faces(before, f);
  return true;
}

double Lookahead::released_by_faces(const std::vector<std::size_t>& before, double f) const {
  const std::vector<std::size_t> after = ahead_->last();
  double sum = 0;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const WatchedPlace &was = ahead_->places()[before[k]], &is = ahead_->places()[after[k]];
    if (was.closed == is.closed) continue;
    const double gap_before = window_->gap(is.contact, f, foreseen_.back().displacement);
    sum += released_by_switch(is.contact, was.closed, gap_before, window_->gap(is.contact, f));
  }
  return sum;
}

}  // namespace bempd::fracture

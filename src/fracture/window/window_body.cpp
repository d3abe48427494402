#include "fracture/window/window_body.hpp"

#include <algorithm>
#include <utility>

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
  for (const coupling::StageChange& c : event.changes) back.push_back({c.term, system_.stages()[c.term]});
  const WindowFunctions::Values before = window_.function_values();
  const coupling::Affine kept_before = face_forecast_ ? window_.state().displacement : coupling::Affine(0, 2);
  if (!change_terms(event) || !settle_faces(event, outcome)) {
    system_.set_stages(back);
    return std::nullopt;
  }
  BodyChange change;
  change.work = WindowFunctions::work(before, window_.function_values(), f);
  if (outcome.switches == 0) return change;
  switched_faces_ = face_forecast_->last_state();
  change.released_first = released_by_faces(places_before_, kept_before, f);
  return change;
}

// Puts the event's terms into their stages in the system and in the window.
bool WindowBody::change_terms(const Event& event) {
  std::vector<coupling::StageChange> here;  // by places in the window
  for (const coupling::StageChange& c : event.changes) here.push_back({window_.place_of(c.term), c.stage});
  system_.set_stages(event.changes);
  const std::vector<int> broken = system_.terms().broken_by(event.changes);
  return body_.freed_parts().frees_nothing(broken, displacement_) && window_.change(here);
}

std::vector<std::size_t> WindowBody::wrong_places(double f) const {
  std::vector<std::size_t> wrong;
  const double zero = gap_rounding(window_.largest_displacement(f));
  for (const std::size_t i : face_forecast_->last()) {
    const WatchedPlace& place = face_forecast_->places()[i];
    if (!window_.follows(place.contact)) continue;
    const double gap = window_.gap(place.contact, f);
    if (passed_zero(place.closed, gap) > zero) wrong.push_back(i);
  }
  return wrong;
}

// Whether places are closed that the whole body may find barred: what springs hold may grow as terms break.
bool WindowBody::presses_on_held_parts() const {
  std::vector<std::size_t> closed = face_forecast_->last();
  std::erase_if(closed, [&](std::size_t i) { return !face_forecast_->places()[i].closed; });
  if (closed.empty()) return false;
  const FreedPartFinder::Held held = body_.freed_parts().held_parts();
  if (!held.others.empty()) return true;
  return std::any_of(closed.begin(), closed.end(), [&](std::size_t i) {
    const std::vector<coupling::TermEntry>& pull = face_forecast_->places()[i].contact.pull;
    return std::any_of(pull.begin(), pull.end(), [&](const coupling::TermEntry& e) { return held.nodes[e.node] != 0; });
  });
}

// Newton's method, as in the whole body.
bool WindowBody::settle_faces(const Event& event, Outcome& outcome) {
  if (!face_forecast_) return true;
  face_forecast_->follow(coupling::terms_of(event.changes), state_);
  if (!system_.springs().empty()) return !presses_on_held_parts();  // which may bar places
  places_before_ = face_forecast_->last();
  NewtonRounds rounds;
  for (;;) {
    const std::vector<std::size_t> wrong = wrong_places(event.load_factor);
    if (wrong.empty()) return true;
    rounds.takes_all(wrong.size(), {face_forecast_->last_state().closed, {}});
    if (rounds.comes_back()) return false;
    std::vector<WindowSolver::FaceSwitch> switches;
    for (const std::size_t i : wrong)
      switches.push_back({face_forecast_->places()[i].contact, !face_forecast_->places()[i].closed});
    if (!window_.switch_faces(switches)) return false;
    for (const std::size_t i : wrong) face_forecast_->switch_place(i, state_);
    outcome.switches += static_cast<std::int64_t>(wrong.size());
  }
}

double WindowBody::released_by_faces(const std::vector<std::size_t>& places_before, const coupling::Affine& kept_before,
                                     double f) const {
  const std::vector<std::size_t> after = face_forecast_->last();
  double sum = 0;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const WatchedPlace &was = face_forecast_->places()[places_before[k]], &is = face_forecast_->places()[after[k]];
    if (was.closed == is.closed) continue;
    sum +=
        released_by_switch(is.contact, was.closed, window_.gap(is.contact, f, kept_before), window_.gap(is.contact, f));
  }
  return sum;
}

}  // namespace bempd::fracture

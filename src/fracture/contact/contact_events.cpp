#include "fracture/contact/contact_events.hpp"

namespace bempd::fracture {

std::optional<double> ContactEvents::switch_before(double load_factor) {
  const BodyState& state = body_.state();
  const double from = body_.settled_until(load_factor > state.load_factor ? 1 : -1);
  if ((load_factor - from) * (load_factor - state.load_factor) <= 0 && from != state.load_factor) return std::nullopt;
  std::optional<double> first;
  if (!body_.faces().are_none()) {
    body_.refresh_faces();
    first = next_switch(body_.faces().places(), state.displacement, from, load_factor);
  }
  if (body_.system().face_count() == 0) return first;
  const std::optional<double> inside =
      next_face_switch(body_.system(), state.displacement, from, first.value_or(load_factor));
  return inside ? inside : first;
}

bool ContactEvents::is_before(double load_factor) { return switch_before(load_factor).has_value(); }

const Event* ContactEvents::before(const Event* event, double target) {
  const double present = body_.state().load_factor;
  const bool upwards = target >= present;
  double limit = target;
  if (event && (upwards ? event->load_factor < target : event->load_factor > target)) limit = event->load_factor;
  const std::optional<double> load_factor = switch_before(limit);
  if (!load_factor) return nullptr;
  direction_ = limit > present ? 1 : -1;
  event_ = {*load_factor, 0, *load_factor, {}, true, direction_ < 0};
  return &event_;
}

const Event* ContactEvents::next(double target, const SteppingOptions& /*options*/) { return before(nullptr, target); }

Outcome ContactEvents::perform() {
  Outcome outcome;
  outcome.work_before = body_.move_to(event_.load_factor);
  const double stored_before = body_.stored_energy(), unbalanced_before = body_.unbalanced_share();
  const LoadedBody::Settled settled = body_.settle_contacts(direction_);
  outcome.switches = settled.switched;
  outcome.fragments = settled.fragments;
  body_.update_ratios();
  if (settled.fragments > 0) outcome.lost_balance = {unbalanced_before, body_.unbalanced_share()};
  outcome.comes_free = !settled.held.empty();
  if (!outcome.comes_free) return outcome;
  // A fragment that only closed faces held takes its loads along, and the faces that pressed on it open at once.
  outcome.work = body_.absorb(event_.load_factor);
  outcome.released_energy = outcome.work + stored_before - body_.stored_energy();
  outcome.unit_energy = body_.unit_energy();
  return outcome;
}

}  // namespace bempd::fracture

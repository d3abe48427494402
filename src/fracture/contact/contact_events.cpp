#include "fracture/contact/contact_events.hpp"

#include "fracture/contact/gap_rule.hpp"

namespace bempd::fracture {

std::optional<double> ContactEvents::switch_before(double load_factor) {
  const BodyState& state = body_.state();
  const double from = body_.contact().settled_until(load_factor > state.load_factor ? 1 : -1);
  if ((load_factor - from) * (load_factor - state.load_factor) <= 0 && from != state.load_factor) return std::nullopt;
  body_.contact().refresh_faces();
  const coupling::EquilibriumSystem& system = body_.system();
  return next_switch(system.constraints(), system.contact().gaps(state.displacement), state.displacement, from,
                     load_factor);
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
  outcome.work_before = body_.response().move_to(event_.load_factor);
  const double stored_before = body_.response().stored_energy(), unbalanced_before = body_.loads().unbalanced_share();
  const BodyContact::Settled settled = body_.contact().settle(direction_);
  outcome.switches = settled.switched;
  outcome.fragments = settled.fragments;
  body_.response().update_ratios();
  if (settled.fragments > 0) outcome.lost_balance = {unbalanced_before, body_.loads().unbalanced_share()};
  outcome.comes_free = !settled.held.empty();
  if (!outcome.comes_free) return outcome;
  // A fragment that only closed faces held loses its loads, and the faces that pressed on it open at the same time.
  outcome.work = body_.response().absorb(event_.load_factor);
  outcome.released_energy = outcome.work + stored_before - body_.response().stored_energy();
  outcome.unit_energy = body_.response().unit_energy();
  return outcome;
}

}  // namespace bempd::fracture

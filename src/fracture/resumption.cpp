#include "fracture/resumption.hpp"

#include <algorithm>

#include "coupling/affine.hpp"
#include "error.hpp"

namespace bempd::fracture {

Continuation Resumption::present() const {
  if (awaited_) return *awaited_;
  coupling::EquilibriumSystem& system = body_.system();
  Continuation result;
  result.whole_body_events = patience_.events();
  result.patience = patience_.patience();
  result.most_events = window_.most_events();
  result.place = window_.place_of_last();
  result.places_met = system.matrix().places_met();
  result.barred = system.constraints().barred();
  result.changes_that_bar = body_.contact().changes_that_bar();
  result.factor = system.factor().origin();
  if (window_.is_open()) result.window = window_.origin();
  return result;
}

void Resumption::remember(const Continuation& continuation) {
  patience_.set(continuation.whole_body_events, continuation.patience);
  window_.remember(continuation.place, continuation.most_events);
  body_.system().matrix().set_places_met(continuation.places_met);
  body_.contact().bar(continuation.barred, continuation.changes_that_bar);
  if (continuation.factor) body_.system().factor().set_origin(*continuation.factor);
}

void Resumption::recall() {
  if (!awaited_) return;
  remember(*awaited_);
  if (!awaited_->window) return awaited_.reset();
  if (!body_.state().in_equilibrium) close();  // the host has changed the loads
}

bool Resumption::reopen() {
  if (!awaited_) return true;
  const BodyState present = body_.state();
  const Continuation continuation = *awaited_;
  bool is_repeated = false;
  try {
    is_repeated = open_again(continuation);
  } catch (const Error& error) {
    body_.state() = present;
    if (error.failure() != Failure::unsolvable) throw;
  } catch (...) {
    body_.state() = present;
    throw;
  }
  const bool is_there = is_repeated && body_.system().stages().numbers() == present.stages;
  body_.state() = present;
  awaited_.reset();
  if (is_there) body_.response().update_ratios();
  return is_there;
}

// Opens the saved window again from the state in which it was first opened.
bool Resumption::open_again(const Continuation& continuation) {
  const WindowOrigin& window = *continuation.window;
  BodyState& state = body_.state();
  state.load_factor = window.load_factor;
  state.displacement = window.displacement;
  state.tips = window.tips;
  state.total_displacement = coupling::evaluate(state.displacement, state.load_factor);
  for (const coupling::StageChange& c : continuation.factor->stages)
    state.stages[c.term] = static_cast<std::uint8_t>(c.stage);
  std::vector<std::vector<int>>& pending = state.faces.pending;
  if (window.faces) {
    state.faces = *window.faces;
  } else if (!body_.faces().are_none()) {
    pending.resize(pending.size() - std::min(pending.size(), static_cast<std::size_t>(window.events_performed)));
  }
  body_.restore();
  Continuation then = continuation;
  then.factor->stages.clear();
  remember(then);
  return window_.open_again(window);
}

void Resumption::close() {
  if (!awaited_) return;
  if (awaited_->window->has_changed_terms) body_.system().factor().forget();
  if (awaited_->window->needs_whole_body) body_.system().factor().keep_last({});
  awaited_.reset();
}

}  // namespace bempd::fracture

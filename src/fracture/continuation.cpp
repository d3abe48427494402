// State of the event sources that is needed to continue a run, beside the body's state.
#include "fracture/continuation.hpp"

#include <algorithm>
#include <utility>

#include "coupling/affine.hpp"
#include "error.hpp"
#include "fracture/event_sources.hpp"

namespace bempd::fracture {

Continuation EventSources::continuation() const {
  if (awaited_) return *awaited_;
  const coupling::EquilibriumSystem& system = body_.system();
  Continuation result;
  result.whole_body_events = whole_body_events_;
  result.patience = patience_;
  result.most_events = window_.most_events();
  result.place = window_.place_of_last();
  result.places_met = system.places_met();
  result.barred = system.constraints().barred();
  result.changes_that_bar = body_.changes_that_bar();
  result.factor = system.factor_origin();
  if (window_.is_open()) result.window = window_.origin();
  return result;
}

void EventSources::remember(const Continuation& continuation) {
  whole_body_events_ = continuation.whole_body_events;
  patience_ = continuation.patience;
  window_.remember(continuation.place, continuation.most_events);
  body_.system().set_places_met(continuation.places_met);
  body_.bar_constraints(continuation.barred, continuation.changes_that_bar);
  if (continuation.factor) body_.system().set_factor_origin(*continuation.factor);
}

void EventSources::go_on() {
  if (!awaited_) return;
  const BodyState present = body_.state();
  const Continuation continuation = *awaited_;
  bool is_repeated = false;
  try {
    is_repeated = open_again(continuation);
  } catch (const Error& error) {
    body_.state() = present;
    is_stale_ = true;
    if (error.failure() != Failure::unsolvable) throw;
  } catch (...) {
    body_.state() = present;
    is_stale_ = true;
    throw;
  }
  const bool is_there = is_repeated && body_.system().stages() == present.stages;
  body_.state() = present;
  awaited_.reset();
  if (is_there) {
    body_.update_ratios();
  } else {  // on a processor that rounds otherwise
    abandon();
    refresh();
  }
}

// Opens the saved window again from the state in which it was first opened.
bool EventSources::open_again(const Continuation& continuation) {
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

// Does to the system's factor what settle() would do with an open window, for a window that is saved but not opened
// again. The state's displacements are already those of its last event.
void EventSources::close_awaited() {
  if (!awaited_) return;
  if (awaited_->window->has_changed_terms) body_.system().forget_factor();
  if (awaited_->window->needs_whole_body) body_.system().keep_last({});
  awaited_.reset();
}

}  // namespace bempd::fracture

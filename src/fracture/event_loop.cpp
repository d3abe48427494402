#include "fracture/event_loop.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "crack/cannot_grow.hpp"
#include "error.hpp"
#include "fracture/resistance.hpp"

namespace bempd::fracture {

namespace {

// Largest number of contact events at one load factor. Each event leaves all faces in agreement with their gaps, so
// that more events than this mean that faces open and close without end.
constexpr int most_events = 1000;

// Duration of an event above which the next event can be interrupted at the host's request. For that the state of the
// body is copied, which would cost 2 % of the time of shorter events.
constexpr std::chrono::milliseconds long_event(100);

void require_fewer_events(std::int64_t events, std::int64_t most) {
  if (events < most) return;
  fail(Failure::convergence, most,
       " events happened in this step, as many as the option stepping.max_events allows; raise it to go on");
}

}  // namespace

bool PathReversals::pass(const Event& event) {
  const bool here = event.load_factor == load_factor_;
  events_ = here ? events_ + 1 : 1;
  if (events_ > most_events) fail(Failure::convergence, "faces of cracks open and close without an end");
  reversals_ = here ? reversals_ + (event.goes_down != down_ ? 1 : 0) : 0;
  load_factor_ = event.load_factor, down_ = event.goes_down;
  return reversals_ < 2;
}

StopReason EventLoop::run() {
  CrackEvolution& first = *body_;
  first.events().begin(options_);
  const RunRecords::Start start = first.records().start();
  events_before_ = start.sums.events;
  try {
    if (!first.progress().in_equilibrium) {
      first.sources().return_point().mark();
      const CancellationScope scope({CancellationScope::current().cancel, options_.stop});
      first.loads().find_equilibrium();
    }
    const StopReason reason = go_on();
    const Sums& sums = body_->progress();
    const bool changed = sums.events != start.sums.events || sums.contact_switches != start.sums.contact_switches;
    if (options_.leaves_fresh && changed) body_->synchronize();
    if (on_end_) on_end_();
    body_->sources().return_point().drop();
    return reason;
  } catch (...) {
    first.events().return_to(start);
    throw;
  }
}

// Performs events one after another, until a reason to stop comes up or no event is left before the target.
StopReason EventLoop::go_on() {
  for (;;) {
    if (!std::exchange(has_begun_, true)) body_->events().begin(options_);
    const EvolutionState& state = body_->progress();
    if (goal_ == Goal::separation && state.separated) return StopReason::separated;
    if (options_.stop && options_.stop->load(std::memory_order_relaxed)) return end_with(StopReason::requested);
    time_event();
    const Event* next = nullptr;
    if (!done_unless_stopped([&] { next = body_->events().next(target_, options_); }))
      return end_with(StopReason::requested);
    if (has_come_apart(next) && goal_ != Goal::load_factor) return StopReason::separated;
    if (const std::optional<StopReason> reason = next ? std::nullopt : reason_without_event()) return end_with(*reason);
    const bool upwards = target_ >= state.load_factor;
    if (!next || (upwards ? next->load_factor > target_ : next->load_factor < target_)) break;
    require_fewer_events(state.events - events_before_, options_.max_events);
    body_->sources().return_point().mark();
    if (const std::optional<StopReason> reason = perform(*next)) return *reason;
  }
  body_->sources().return_point().mark();
  body_->sources().bring_up_to_date();
  body_->events().move_to(target_);
  return end_with(body_->progress().separated ? StopReason::separated : StopReason::load_factor);
}

// Measures whether the last event took long: only then can the next event be given up at the host's request.
void EventLoop::time_event() {
  const auto now = std::chrono::steady_clock::now();
  events_are_long_ = now - last_event_ > long_event;
  last_event_ = now;
  before_event_.reset();
}

// Calls `work`, which finds or performs an event. If the host asks for the end of the run meanwhile and events are
// long, the event is given up: the body is as it was before, and the result is false. Short events and events from a
// window are completed.
template <class Work>
bool EventLoop::done_unless_stopped(const Work& work) {
  if (options_.stop && events_are_long_ && !before_event_) before_event_ = body_->events().before();
  if (!before_event_) {
    work();
    return true;
  }
  try {
    const CancellationScope scope({CancellationScope::current().cancel, options_.stop});
    work();
    return true;
  } catch (const EventGivenUp&) {
    body_->events().give_up(std::move(*before_event_));
    return false;
  }
}

// Performs the next event. Returns the reason if the run ends with it.
std::optional<StopReason> EventLoop::perform(const Event& event) {
  if (event.is_contact) {
    if (!reversals_.pass(event)) return end_with(StopReason::no_admissible_load);
    if (!done_unless_stopped([&] { body_->events().perform_contact(); })) return end_with(StopReason::requested);
    return std::nullopt;
  }
  reversals_ = {};
  const bool increments = options_.mode == SteppingMode::increments;
  if (event.is_growth) return advance(*options_.elements, event);
  if (event.tip.crack > 0 && !increments) return advance(*body_->lines(), event);
  bool is_possible = true;
  const std::vector<coupling::StageChange> broken = event.changes;
  const bool is_done = done_unless_stopped([&] {
    if (increments && body_->progress().events > events_before_)
      is_possible = body_->events().perform_if_possible(event);
    else
      body_->events().perform(event);
  });
  if (!is_done) return end_with(StopReason::requested);
  return is_possible ? after_event(false, broken) : std::optional(end_with(StopReason::no_equilibrium));
}

std::optional<StopReason> EventLoop::advance(crack::Carrier& carrier, const Event& event) {
  crack::Advance done;
  try {
    const bool is_done = done_unless_stopped([&] {
      if (event.is_growth) {
        body_->events().move_to(event.load_factor);
        body_->records().measure_work();
      }
      done = carrier.advance({event.tip, event.ties});
    });
    if (!is_done) return end_with(StopReason::requested);
  } catch (const crack::FreesLoadedPart&) {
    return separated_before_growth();
  }
  follow_body();
  if (done.extensions.empty()) return end_with(StopReason::crack_stopped);
  return after_event(done.has_stopped, {});
}

// Reports an event to the host, enlarges lattice patches around the bonds `broken` near their borders, and lets crack
// lines that have reached boundary elements continue there. Returns the reason if the run ends.
std::optional<StopReason> EventLoop::after_event(bool crack_has_stopped,
                                                 const std::vector<coupling::StageChange>& broken) {
  if (on_event_) on_event_(body_->progress());
  const bool is_separated = body_->progress().separated && goal_ != Goal::load_factor;
  if (options_.elements) {
    try {
      if (!is_separated) crack_has_stopped |= options_.elements->follow_breaks(broken);
      crack_has_stopped |= options_.elements->take_over_lines(is_separated);
    } catch (const crack::FreesLoadedPart&) {
      return separated_before_growth();
    }
    follow_body();
  }
  if (is_separated) return StopReason::separated;
  if (goal_ == Goal::next_event) return crack_has_stopped ? StopReason::crack_stopped : StopReason::event;
  return crack_has_stopped ? std::optional(end_with(StopReason::crack_stopped)) : std::nullopt;
}

// Ends a run just before a growth that leaves no equilibrium. The body counts as separated; a step whose goal is a load
// factor ends without equilibrium, because it has not reached its target.
StopReason EventLoop::separated_before_growth() {
  follow_body();
  body_->records().set_separated();
  return end_with(goal_ == Goal::load_factor ? StopReason::no_equilibrium : StopReason::separated);
}

// Reason for the end of a step if no event is left; empty if the step moves on to its target load factor without
// events.
std::optional<StopReason> EventLoop::reason_without_event() {
  if (options_.control == Control::path) {
    body_->sources().bring_up_to_date();
    const bool elements_rest = !options_.elements || !crack::common_range(options_.elements->tips()).is_empty();
    if (!elements_rest || body_->body().response().admissible().is_empty()) return StopReason::no_admissible_load;
  }
  return goal_ == Goal::load_factor ? std::nullopt : std::optional(StopReason::no_further_event);
}

// Whether the body has come apart; marks it as separated in that case. The connection that carried the load has lost
// its resistance, and what remains breaks only under larger loads, if at all.
bool EventLoop::has_come_apart(const Event* next) {
  const EvolutionState& state = body_->progress();
  if (state.separated || !is_lost(state.resistance, options_.separation_share)) return false;
  // Bonds that exceed their critical stretch after an increment break in the next one. Only after that increment it can
  // be judged whether the body has come apart.
  if (options_.mode == SteppingMode::increments &&
      !body_->body()
           .response()
           .ratios()
           .overstretched(body_->body().system().stages().intact(), state.load_factor)
           .empty()) {
    return false;
  }
  if (next) {
    const double direction = target_ >= state.load_factor ? 1 : -1;
    double farthest = direction * state.load_factor;
    // The body counts as separated only if the next event lies beyond the farthest load factor so far, which on an
    // equilibrium path may be one of the history.
    if (options_.control == Control::path) {
      for (const HistoryEntry& line : state.history) farthest = std::max(farthest, direction * line.load_factor);
    }
    if (direction * next->load_factor <= farthest) return false;
  }
  body_->records().set_separated();
  return true;
}

StopReason EventLoop::end_with(StopReason reason) {
  body_->sources().bring_up_to_date();
  body_->records().end_step();
  return reason;
}

void EventLoop::follow_body() {
  if (!options_.elements || options_.elements->bodies_before() == bodies_before_) return;
  bodies_before_ = options_.elements->bodies_before();
  body_ = &options_.elements->body();
  has_begun_ = false;
  reversals_ = {};
}

}  // namespace bempd::fracture

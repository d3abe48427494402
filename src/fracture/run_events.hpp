#pragma once

#include <optional>
#include <vector>

#include "fracture/event_sources.hpp"
#include "fracture/inner_work.hpp"
#include "fracture/run_records.hpp"

namespace bempd::fracture {

// Events of a run in one body: finds the next event, performs and records it, and takes back an event that cannot be
// completed.
class RunEvents {
 public:
  RunEvents(EvolutionState& state, LoadedBody& body, EventSources& sources, const InnerWork& inner_work,
            RunRecords& records)
      : state_(state), body_(body), sources_(sources), inner_work_(inner_work), records_(records) {}

  // Begins a part of the run in this body: applies the options, and opens a saved window again.
  void begin(const SteppingOptions& options);

  // Next event on the way to a target; null if there is none. last_found() is the event that next() returned last since
  // begin().
  const Event* next(double target, const SteppingOptions& options);
  const Event* last_found() const { return next_; }

  void move_to(double load_factor);
  void perform(const Event& event);
  // Performs an event. Returns false if no equilibrium exists after the event; in that case the state before the event
  // is restored.
  bool perform_if_possible(const Event& event);
  void perform_contact() { records_.book_contact(sources_.perform()); }

  // Body and records before an event, to which give_up() returns.
  struct Before {
    BodyState body;
    RunRecords::Start start;
  };
  // Body before the next event; empty while events come from a window, which are too short to be given up.
  std::optional<Before> before();
  void give_up(Before before);
  // Returns to the start of a call that has failed.
  void return_to(const RunRecords::Start& start) noexcept;

  // Performs a step of the tip of a crack line as an event at the present load factor, whatever the load on the tip, if
  // a bond lies ahead of it. The step has the given direction, or that of its criterion. After a failure the caller
  // restores an earlier state.
  void extend_line(const crack::TipId& tip, const std::optional<Point>& direction);
  // Stops the tip of a crack line that has come to an interface, or whose crack continues in boundary elements.
  void stop_line(const crack::TipId& tip, crack::TipState state = crack::TipState::at_interface);
  // Stops tips in boundary elements that cannot grow.
  void stop(const std::vector<crack::TipId>& tips);

 private:
  EvolutionState& state_;
  LoadedBody& body_;
  EventSources& sources_;
  const InnerWork& inner_work_;
  RunRecords& records_;
  const Event* next_ = nullptr;
};

}  // namespace bempd::fracture

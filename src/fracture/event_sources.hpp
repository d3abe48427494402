#pragma once

#include <optional>
#include <set>
#include <vector>

#include "fracture/contact/contact_events.hpp"
#include "fracture/line/line_events.hpp"
#include "fracture/resumption.hpp"
#include "fracture/return_point.hpp"
#include "fracture/whole_body_events.hpp"
#include "fracture/window/window_events.hpp"

namespace bempd::fracture {

// Sources of the events of a run. The next event comes from a window (region around crack tips that is solved alone)
// where that saves time, else from the whole body.
class EventSources {
 public:
  // The bonds `cut` are broken from the start.
  EventSources(LoadedBody& body, const std::vector<int>& cut);
  EventSources(const EventSources&) = delete;
  EventSources& operator=(const EventSources&) = delete;

  // Lets cracks grow as crack lines (in a lattice, by steps of a spacing) from now on, starting from the tips in the
  // body's state.
  void grow_lines(pd::TipLaws laws, FactorsAround factors);

  // Sets the tips that the host has frozen, until the next call.
  void freeze(const std::set<crack::TipId>& tips);

  // Next event on the way to a target, which may lie beyond the target; null if no event is left in that direction.
  const Event* next(double target, const SteppingOptions& options);
  Outcome perform();
  // Event at which the tip of a crack line takes a step (LineEvents::step_of()).
  const Event* line_step(const crack::TipId& tip, const std::optional<Point>& direction) {
    if (!lines_) return nullptr;
    source_of_next_ = &*lines_;
    return lines_->step_of(tip, direction);
  }

  // Source of the steps of crack lines, for a state that update_for_reader() has brought up to date; null if cracks
  // grow bond by bond.
  LineEvents* lines() {
    if (!lines_) return nullptr;
    lines_->prepare_trials(window_.is_open());
    return &*lines_;
  }

  const LineSteps* line_steps() const { return lines_ ? &lines_->steps() : nullptr; }

  // Brings displacements and forces in the body's state up to date, which they are not while events come from a window.
  void bring_up_to_date() { window_.bring_up_to_date(); }
  // Brings displacements and forces up to date for a reader only: later results do not depend on this call.
  void update_for_reader() {
    refresh();
    window_.update_for_reader();
  }
  void settle();  // brings the state up to date and closes the window, because loads may change
  void forget();  // forgets the window: the run continues as a fresh run from the present state

  // Notes that the body's state has been replaced. The next refresh(), which has to come before any other call, adapts
  // window, system and stretch ratios to the state.
  void abandon() noexcept;
  void refresh();

  // Data that a run needs beside the body's state to go on as if it had not been interrupted; abandon() forgets these
  // data. Before the run continues, go_on() opens a saved window again.
  Resumption& resumption() { return resumption_; }
  void go_on();
  // Notes that an event is given up that was begun or sought while no window was open. The caller then sets the body's
  // state to `before`, the state before the event.
  void give_up_event(const BodyState& before);

  // State of the body to return to if a call fails.
  ReturnPoint& return_point() { return return_point_; }
  void return_to_mark() noexcept;

  // Whether events come from a window at present.
  bool is_in_window() const { return window_.is_open(); }

 private:
  bool may_use_window(double target, const SteppingOptions& options) const;
  void open_window(double target, const SteppingOptions& options);
  std::optional<double> next_in_window(double target, const SteppingOptions& options);
  EventSource& source_without_window();  // source of events while no window is open
  const Event* first_with(crack::Carrier& elements, const Event* event, const crack::LoadWay& way);
  const Event* first_of(EventSource& source, const Event* event, double target);

  LoadedBody& body_;
  WholeBodyEvents whole_body_;
  ContactEvents contact_;
  WindowEvents window_;
  std::optional<LineEvents> lines_;
  EventSource* source_of_next_ = nullptr;  // source that has found the next event
  Event growth_;                           // growth of a tip in boundary elements, if it is the next event
  bool is_stale_ = false;                  // the state has been replaced since the last refresh()
  WindowPatience patience_;
  Resumption resumption_;
  ReturnPoint return_point_;
};

}  // namespace bempd::fracture

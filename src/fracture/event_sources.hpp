#pragma once

#include <optional>
#include <set>
#include <vector>

#include "fracture/contact/contact_events.hpp"
#include "fracture/continuation.hpp"
#include "fracture/line/line_events.hpp"
#include "fracture/whole_body_events.hpp"
#include "fracture/window/window_events.hpp"

namespace bempd::fracture {

// Chooses the source of the next event: a window where that saves time, else the whole body. After a window without
// use, the next one is tried later, each time after twice as many events.
class EventSources {
 public:
  // The bonds `cut` are broken from the start.
  EventSources(LoadedBody& body, const std::vector<int>& cut);
  EventSources(const EventSources&) = delete;
  EventSources& operator=(const EventSources&) = delete;

  // Lets cracks grow as lines from now on, starting from the tips in the body's state.
  void grow_lines(pd::TipLaws laws, FactorsAround factors);

  // Sets the tips that the host has frozen, until the next call.
  void freeze(const std::set<crack::TipId>& tips);

  // Next event on the way to a target; null if none is left in that direction. It may lie beyond the target.
  const Event* next(double target, const SteppingOptions& options);
  Outcome perform();
  // Event at which the tip of a crack line takes a step, as LineEvents::step_of() has it.
  const Event* line_step(const crack::TipId& tip, const std::optional<Point>& direction) {
    if (!lines_) return nullptr;
    told_ = &*lines_;
    return lines_->step_of(tip, direction);
  }

  // Source of the steps of crack lines, for a state that is up to date; null if cracks grow bond by bond.
  LineEvents* lines() {
    if (!lines_) return nullptr;
    lines_->look(window_.is_open());
    return &*lines_;
  }

  const LineSteps* line_steps() const { return lines_ ? &lines_->steps() : nullptr; }

  // Brings displacements and forces in the body's state up to date; they are not while events come from a window.
  void bring_up_to_date() { window_.bring_up_to_date(); }
  void show() { window_.show(); }  // for someone who looks: nothing later depends on it
  void settle();                   // brings up to date and leaves the window: loads may change
  void forget();                   // what comes next is what it would be in a fresh run from the present state

  // Notes that the body's state has been replaced. Window, system and ratios are adapted by the next refresh(), which
  // has to come before anything else.
  void abandon() noexcept;
  void refresh();

  // Saves what is known beside the body's state, and sets it again after abandon(). A saved window is opened again by
  // go_on(), before the run continues.
  Continuation continuation() const;
  void continue_with(Continuation continuation) noexcept { awaited_ = std::move(continuation); }
  // Notes that an event that had begun or was looked for outside a window is given up. The body's state `before` is to
  // be set.
  void give_up_event(const BodyState& before);
  void go_on();

  // One state of the body to return to: the first one marked since the last drop_mark(). If begin_call() was called
  // before, what is known beside the state is restored as well.
  void begin_call();
  void mark();
  void drop_mark();
  void return_to_mark() noexcept;

  // Whether events come from a window at present.
  bool is_in_window() const { return window_.is_open(); }

 private:
  // Marked state. In an open window a position in it replaces the large parts of the state.
  struct Mark {
    BodyState state;
    std::optional<WindowEvents::Place> place;
  };

  bool may_use_window(double target, const SteppingOptions& options) const;
  void open_window(double target, const SteppingOptions& options);
  std::optional<double> next_in_window(double target, const SteppingOptions& options);
  EventSource& everywhere();  // where no window is open
  const Event* first_with(crack::Carrier& elements, const Event* event, const crack::LoadWay& way);
  const Event* first_of(EventSource& source, const Event* event, double target);
  void be_patient();
  void keep_present();
  void complete_mark();
  void keep_way_on();
  void remember(const Continuation& continuation);
  bool open_again(const Continuation& continuation);
  void close_awaited();

  // Data for the case that a call fails: what was known beside the state when it began, kept when it is about to
  // change.
  struct Call {
    std::optional<Continuation> way_on;
  };

  LoadedBody& body_;
  WholeBodyEvents whole_body_;
  ContactEvents contact_;
  WindowEvents window_;
  std::optional<LineEvents> lines_;
  EventSource* told_ = nullptr;  // the next event
  Event growth_;                 // of a tip with boundary elements, that was told
  std::optional<Mark> mark_;
  std::optional<Call> call_;
  std::optional<Continuation> awaited_;  // after refresh(): only what has an open window
  bool is_stale_ = false;
  int whole_body_events_ = 0;  // to come before the next window is tried
  int patience_ = 1;           // how many, doubled where a window finds nothing to do
};

}  // namespace bempd::fracture

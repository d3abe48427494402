#pragma once

#include <optional>

#include "fracture/loaded_body.hpp"
#include "fracture/resumption.hpp"
#include "fracture/window/window_events.hpp"

namespace bempd::fracture {

// State of the body to return to if a call fails: the state at the first mark() since the last drop(). After
// begin_call(), the data of the run beside that state (Continuation) are kept as well.
class ReturnPoint {
 public:
  ReturnPoint(LoadedBody& body, WindowEvents& window, const Resumption& resumption)
      : body_(body), window_(window), resumption_(resumption) {}

  // Begins a call that can be taken back. Without an open window, the Continuation is copied at once, because the first
  // search for an event may change the system's factor. With an open window, it is copied at the first mark(), because
  // it does not change before.
  void begin_call();
  void mark();
  void drop() noexcept { mark_.reset(), call_.reset(); }
  // Prepares for the closing of the window: copies the Continuation of the run, and if the marked state is stored as a
  // position among the window's events, computes and stores the state itself.
  void keep() { keep_continuation(), complete(); }
  // If the marked state is stored as a position among the window's events, computes and stores the state itself.
  // Computed only on return, its displacements would have other rounding errors.
  void complete();
  // If the marked state is stored as a position among the window's events, stores `state` instead: the state in which
  // the window was opened, when none of its events had been performed.
  void replace_place(const BodyState& state);

  // Result of go_back(). If `is_in_window` is set, the open window stays valid. Otherwise only the body's state is
  // restored, all other data may be half changed, and `continuation` has the Continuation of the run at the beginning
  // of the call.
  struct Back {
    bool is_in_window;
    std::optional<Continuation> continuation;
  };
  // Returns to the marked state and drops the mark.
  Back go_back() noexcept;

 private:
  // Marked state of the body. While a window is open, `place` (a position among the window's events) is stored instead
  // of `state`, which is large.
  struct Mark {
    BodyState state;
    std::optional<WindowEvents::Place> place;
  };
  // Call that can be taken back: the data of the run beside the body's state (Continuation) at its beginning, copied
  // just before they change.
  struct Call {
    std::optional<Continuation> continuation;
  };
  void keep_continuation();

  LoadedBody& body_;
  WindowEvents& window_;
  const Resumption& resumption_;
  std::optional<Mark> mark_;
  std::optional<Call> call_;
};

}  // namespace bempd::fracture

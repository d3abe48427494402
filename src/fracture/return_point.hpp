#pragma once

#include <optional>

#include "fracture/loaded_body.hpp"
#include "fracture/resumption.hpp"
#include "fracture/window/window_events.hpp"

namespace bempd::fracture {

// State of the body to return to if a call fails: the state that was marked first since the last drop(). After
// begin_call(), the data of the run beside that state (Continuation) are kept as well.
class ReturnPoint {
 public:
  ReturnPoint(LoadedBody& body, WindowEvents& window, const Resumption& resumption)
      : body_(body), window_(window), resumption_(resumption) {}

  // Begins a call that can be taken back. Without an open window the Continuation is kept at once, because the first
  // search for an event may change the system's factor. With an open window it does not change before the first mark().
  void begin_call();
  void mark();
  void drop() noexcept { mark_.reset(), call_.reset(); }
  // Makes the return point independent of the window, which is about to be closed: keeps the Continuation of the run,
  // and turns a mark that is a position in the window into a state.
  void keep() { keep_continuation(), complete(); }
  // Replaces a mark that is a position in a window by the state at this position. Displacements that are computed only
  // on return would have other rounding errors.
  void complete();
  // Replaces a mark that is a position in a window by `state`, in which the window was opened: none of its events has
  // been performed.
  void replace_place(const BodyState& state);

  // Result of go_back(). If `is_in_window` is set, the open window stays valid. Otherwise only the body's state is
  // restored, all other data may be half changed, and `continuation` has the run's data at the beginning of the call.
  struct Back {
    bool is_in_window;
    std::optional<Continuation> continuation;
  };
  // Returns to the marked state and drops the mark.
  Back go_back() noexcept;

 private:
  // Marked state of the body. While a window is open, `place` (a position among its events) is stored instead of
  // `state`, which is large.
  struct Mark {
    BodyState state;
    std::optional<WindowEvents::Place> place;
  };
  // Data of the run beside the body's state (Continuation) at the beginning of a call, copied just before they change.
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

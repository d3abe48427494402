#pragma once

#include <optional>

#include "fracture/loaded_body.hpp"
#include "fracture/resumption.hpp"
#include "fracture/window/window_events.hpp"

namespace bempd::fracture {

// One state of the body to return to if a call fails: the first one marked since the last drop(). If begin_call() was
// called before, the data of the run beside this state (Continuation) are kept as well.
class ReturnPoint {
 public:
  ReturnPoint(LoadedBody& body, WindowEvents& window, const Resumption& resumption)
      : body_(body), window_(window), resumption_(resumption) {}

  // Begins a call that can be taken back. What is known beside the state is kept at once only if no window is open,
  // because the first search for an event may then change the system's factor. With an open window nothing changes
  // before the first mark.
  void begin_call();
  void mark();
  void drop() noexcept { mark_.reset(), call_.reset(); }
  // Makes the return point independent of the window, which is about to be left: keeps what the run knows beside the
  // state (its Continuation), and turns a mark that is a position in the window into a state.
  void keep() { keep_continuation(), complete(); }
  // Replaces the mark, if it is a position in a window, by the state at this position. Displacements that were computed
  // again only on return would have other rounding errors.
  void complete();
  // Replaces the mark, if it is a position in a window, by this state: the window has only been opened since then.
  void replace_place(const BodyState& state);

  // Returns to the mark, which is dropped. If `is_in_window`, the open window stays valid. If not, only the body's
  // state is restored: all else may be half changed, and `continuation` is what was known beside the state when the
  // call began.
  struct Back {
    bool is_in_window;
    std::optional<Continuation> continuation;
  };
  Back go_back() noexcept;

 private:
  // Marked state. In an open window a position in it replaces the large parts of the state.
  struct Mark {
    BodyState state;
    std::optional<WindowEvents::Place> place;
  };
  // Data of the run beside the body's state (Continuation) at the start of the call, copied when they are about to
  // change.
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

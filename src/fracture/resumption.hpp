#pragma once

#include <optional>
#include <utility>

#include "fracture/continuation.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/window_events.hpp"
#include "fracture/window/window_patience.hpp"

namespace bempd::fracture {

// Saves the data of a run beside the body's state (Continuation), and sets them again after the state has been
// replaced. A saved window is opened again before the run goes on, and only then.
class Resumption {
 public:
  Resumption(LoadedBody& body, WindowEvents& window, WindowPatience& patience)
      : body_(body), window_(window), patience_(patience) {}

  Continuation present() const;

  // Sets the continuation that recall() and reopen() restore; await_nothing() takes it away.
  void await(Continuation continuation) noexcept { awaited_ = std::move(continuation); }
  void await_nothing() noexcept { awaited_.reset(); }
  // Restores all but an open window, for the body's state, in which system and ratios are. Only what has an open window
  // is still awaited then.
  void recall();
  // Opens the window again that was open when the awaited continuation was saved. Returns false if it differs from what
  // was saved, as on a processor that rounds otherwise. The body's state is then as it was before the call, but system
  // and ratios are not; likewise after a failure.
  bool reopen();
  // Ends a saved window that is not opened again: drops the system's factor, or its order of elimination, where closing
  // an open window would (EventSources::settle()). The state's displacements are already those of its last event.
  void close();

 private:
  void remember(const Continuation& continuation);
  bool open_again(const Continuation& continuation);

  LoadedBody& body_;
  WindowEvents& window_;
  WindowPatience& patience_;
  std::optional<Continuation> awaited_;
};

}  // namespace bempd::fracture

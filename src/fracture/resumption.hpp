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

  // Sets the awaited continuation, which recall() and reopen() restore; await_nothing() clears it.
  void await(Continuation continuation) noexcept { awaited_ = std::move(continuation); }
  void await_nothing() noexcept { awaited_.reset(); }
  // Restores the awaited data except an open window. System and ratios must be those of the body's state. The
  // continuation stays awaited only if it has an open window.
  void recall();
  // Opens the window again that was open when the awaited continuation was saved. Returns false if the result differs
  // from the saved one, as on a processor that rounds otherwise. After that, or after a failure, the body's state is as
  // it was before the call, but system and ratios are not.
  bool reopen();
  // Closes a saved window without opening it: drops the system's factor, or the order of elimination of the factor,
  // where closing the open window would (EventSources::settle()). The displacements of the state are already those
  // after the window's last event.
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

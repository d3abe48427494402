#pragma once

#include <optional>
#include <utility>

#include "fracture/continuation.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/window_events.hpp"
#include "fracture/window/window_patience.hpp"

namespace bempd::fracture {

// Saves the data of a run beside the body's state (Continuation), and sets them again after the state has been
// replaced. A saved window (region around crack tips that is solved alone) is opened again before the run goes on, and
// only then.
class Resumption {
 public:
  Resumption(LoadedBody& body, WindowEvents& window, WindowPatience& patience)
      : body_(body), window_(window), patience_(patience) {}

  Continuation present() const;

  // Sets the saved data that recall() and reopen() shall restore later; await_nothing() clears them.
  void await(Continuation continuation) noexcept { awaited_ = std::move(continuation); }
  void await_nothing() noexcept { awaited_.reset(); }
  // Restores the awaited data except an open window. The system and the stretch ratios must already be those of the
  // body's state. If the data contain an open window, they stay awaited for reopen().
  void recall();
  // Opens the window again that was open when the awaited data were saved. Returns false if the result differs from the
  // saved window, as on a processor that rounds otherwise. After that, or after a failure, the body's state is as it
  // was before the call, but the system and the stretch ratios are not.
  bool reopen();
  // Forgets a saved window without opening it. The system's factor, or its order of elimination, is dropped in the same
  // cases as at the closing of an open window (EventSources::settle()). The displacements of the state are already
  // those after the window's last event.
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

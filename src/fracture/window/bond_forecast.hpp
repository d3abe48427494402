#pragma once

#include <memory>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/computed_events.hpp"
#include "fracture/window/window_certificate.hpp"
#include "fracture/window/window_origin.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Breaks of bonds that a window (region around crack tips or bonds close to breaking that is solved alone) computes
// ahead where cracks grow bond by bond: chooses the bonds that break next, and proves that no bond outside the window
// breaks before them.
class BondForecast {
 public:
  explicit BondForecast(LoadedBody& body) : body_(body) {}

  // Sets the window whose events are computed. `proportional` says that the window's displacements are proportional to
  // the load factor.
  void begin_window(const coupling::Condensation& condensation, const WindowSolver& window, bool proportional);
  void end_window() noexcept { certificate_.reset(), window_ = nullptr; }

  // Begins a series of events that are computed together: drops the checks of the previous series.
  void begin() { checks_.clear(); }
  // Puts the next break, at a load factor of `from` or more, into `foreseen`; false if the window cannot determine that
  // break.
  bool choose(double from, const WindowOptions& options, ForecastEvent& foreseen) const;
  // Adds the checks for an event that follows in state number `state` at the load factor `from`: no bond outside the
  // window may break before the event, or together with it.
  void note(int state, double from, const Event& event, const WindowOptions& options);
  // Drops the checks of all events but the first `count` events.
  void keep_first(int count);

  // Number of events, from the first on, before which no bond breaks that the window has stopped watching (narrowing).
  int proven_in_window(const std::vector<coupling::Affine>& states) const;
  // Number of events, from the first on, for which it is proven that no bond outside the window breaks before them.
  // `whole` are the displacements of the whole body in state 0.
  int proven(const std::vector<coupling::Affine>& states, const std::vector<ForecastEvent>& events,
             const coupling::Affine& whole);
  // Displacements of the whole body in one of the states of the last call of proven().
  coupling::Affine displacement(int state) const { return certificate_->last_displacement(state); }

 private:
  LoadedBody& body_;
  const WindowSolver* window_ = nullptr;  // present window
  std::unique_ptr<WindowCertificate> certificate_;
  bool proportional_ = false;
  std::vector<OutsideCheck> checks_;
};

}  // namespace bempd::fracture

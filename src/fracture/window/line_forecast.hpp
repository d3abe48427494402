#pragma once

#include <optional>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/line/line_steps.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/computed_events.hpp"
#include "fracture/window/line_certificate.hpp"
#include "fracture/window/window_locator.hpp"
#include "fracture/window/window_narrowing.hpp"
#include "fracture/window/window_origin.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Steps of crack lines (cracks that grow in a lattice by steps) that a window (region around crack tips or bonds close
// to breaking that is solved alone) computes ahead: chooses the location of the window and the next step, and proves
// that no bond away from the tips breaks before the step.
class LineForecast {
 public:
  LineForecast(LoadedBody& body, const LineSteps& lines) : body_(body), lines_(lines) {}

  // Chooses the location of a window that is large enough for the next steps of the crack tips. Returns false if there
  // is no such window.
  bool choose_place(WindowLocator& locator, const WindowOptions& options, const BodyState& state,
                    double load_factor) const;

  // Begins to compute events in a window, from the tips `tips`.
  void begin(const coupling::Condensation& condensation, const WindowSolver& window,
             const std::vector<GrowingTip>& tips);
  void end_window() noexcept { certificate_.reset(), condensation_ = nullptr, window_ = nullptr; }
  // Next step of a tip at a load factor of `from` or more, whose event is put into `foreseen`; empty if the window
  // cannot determine the step.
  std::optional<LineSteps::Choice> choose(double from, Control control, ForecastEvent& foreseen) const;
  // Moves the tip of a crack line after the window has performed its step.
  void complete_step(const LineSteps::Choice& line, ForecastEvent& foreseen);
  // Takes the displacements around the tips from the window again, after it has corrected them.
  void note_displacement();
  // Places of the tips, with the distances behind them that the window must continue to follow.
  std::vector<WindowNarrowing::Reach> reaches() const;

  // Number of computed events, from the first on, before which no bond away from the tips breaks; the number of all
  // events if no new crack may begin.
  int steps_as_foreseen(const std::vector<ForecastEvent>& events, const std::vector<coupling::Affine>& states) const;

 private:
  coupling::Affine displacement_near(const std::vector<GrowingTip>& tips) const;

  LoadedBody& body_;
  const LineSteps& lines_;
  const coupling::Condensation* condensation_ = nullptr;  // condensation of the present window
  const WindowSolver* window_ = nullptr;                  // present window
  std::optional<LineCertificate> certificate_;
  std::vector<GrowingTip> tips_;  // after the last computed step
  coupling::Affine near_tips_;    // displacements after that step, known around the tips
};

}  // namespace bempd::fracture

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

// Steps of crack lines that a window computes ahead: where the window has to be, which step comes next, and the proof
// that nothing else breaks before it.
class LineForecast {
 public:
  LineForecast(LoadedBody& body, const LineSteps& lines) : body_(body), lines_(lines) {}

  // Chooses a window that is large enough for the next steps of the crack tips. Returns false if there is none.
  bool choose_place(WindowLocator& locator, const WindowOptions& options, const BodyState& state,
                    double load_factor) const;

  // Begins to compute events in a window, from these tips.
  void begin(const coupling::Condensation& condensation, const WindowSolver& window,
             const std::vector<GrowingTip>& tips);
  void end_window() noexcept { certificate_.reset(), condensation_ = nullptr, window_ = nullptr; }
  // Next step at a load factor from `from` on, whose event is put into `foreseen`; empty if the window cannot tell it.
  std::optional<LineSteps::Choice> choose(double from, Control control, ForecastEvent& foreseen) const;
  // Moves the tip of a line after its step has been performed in the window.
  void complete_step(const LineSteps::Choice& line, ForecastEvent& foreseen);
  // Takes the displacements around the tips from the window again, after they have been corrected there.
  void note_displacement();
  // Reaches of the tips, for which the window is needed.
  std::vector<WindowNarrowing::Reach> reaches() const;

  // Number of computed events before which no bond away from the tips breaks; all of them if no crack can begin.
  int steps_as_foreseen(const std::vector<ForecastEvent>& events, const std::vector<coupling::Affine>& states) const;

 private:
  coupling::Affine displacement_near(const std::vector<GrowingTip>& tips) const;

  LoadedBody& body_;
  const LineSteps& lines_;
  const coupling::Condensation* condensation_ = nullptr;  // of the present window
  const WindowSolver* window_ = nullptr;                  // likewise
  std::optional<LineCertificate> certificate_;
  std::vector<GrowingTip> tips_;  // in the state foreseen last
  coupling::Affine near_tips_;    // displacements there, where the tips ask
};

}  // namespace bempd::fracture

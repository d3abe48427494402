#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fracture/contact/face_forecast.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/bond_forecast.hpp"
#include "fracture/window/computed_events.hpp"
#include "fracture/window/forecast_balance.hpp"
#include "fracture/window/line_forecast.hpp"
#include "fracture/window/outside_gaps.hpp"
#include "fracture/window/window_functions.hpp"
#include "fracture/window/window_locator.hpp"
#include "fracture/window/window_narrowing.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Computation of events ahead in a window (region around crack tips or bonds close to breaking that is solved alone),
// by condensed equations. Only those events are kept for which it is proven that the whole body would break in the same
// way. The window ends before an event that it cannot perform: a break near its rim or outside, or an event that frees
// a part of the body or removes the last resistance to a motion.
class EventForecast {
 public:
  using Options = WindowOptions;

  explicit EventForecast(LoadedBody& body);

  // Announces, before the first factorization, where windows are to be expected: at the ends of the initial cracks that
  // have broken the bonds `cut`.
  void expect_cracks(const std::vector<int>& cut) { locator_.expect_cracks(cut); }

  // Switches to crack lines (cracks that grow in a lattice by steps). From this call on, the computed events are steps
  // of crack lines.
  void grow_lines(const LineSteps& lines) { lines_.emplace(body_, lines); }

  // Opens a window around the bonds or crack tips that are close to critical at the load factor of the next event.
  // Returns false if no window would be smaller than the problem.
  bool open(const BodyState& state, double load_factor, const Options& options);
  // Opens a window again at the location of the last window.
  void open_again(const BodyState& state, const Options& options);
  bool is_open() const { return window_ != nullptr; }
  void close() noexcept;
  // Closes the window and forgets its location, so that the next window is placed as in a run that has just begun.
  void forget();

  const Options& options() const { return options_; }
  WindowLocation place() const { return locator_.memory(); }
  int most_events() const { return most_events_; }
  void remember(WindowLocation place, int most_events);

  // Events that the window has computed, with the number of those that the run has performed.
  ComputedEvents& events() { return events_; }
  const ComputedEvents& events() const { return events_; }

  // Whether the run has performed all computed events and the window can compute more.
  bool must_compute() const { return events_.are_all_taken() && !has_ended_; }
  // Computes more events with rising load factor, from `state`, the state of the body after the events performed so
  // far.
  void compute(const BodyState& state);

  // Whether the window has ended before an event that only the whole body can perform, or because faces of cracks open
  // or close after its last event.
  bool needs_whole_body() const { return needs_whole_body_ || faces_move_; }
  // Whether the window has ended before an event that only the whole body can perform, because a motion may come free.
  bool frees_a_motion() const { return needs_whole_body_; }
  // Whether the window has ended because faces of cracks open or close after its last event.
  bool ended_at_faces() const { return faces_move_; }

  // Displacements of the whole body after the first `position` events of the window.
  coupling::Affine displacement(int position) const;
  // Residual of the whole body after the last of the events computed together or, if that is larger, the largest
  // imbalance that was corrected in the window. This residual stands for all of these events.
  double residual() const { return balance_.residual(); }

 private:
  void open_here(const BodyState& state);
  void build_window(const BodyState& state);
  bool forecast_next(double from, const BodyState& start);
  bool choose_place(const BodyState& state, double load_factor);
  void narrow(double load_factor);
  coupling::Affine whole_in(int state) const;
  bool perform_in_window(ForecastEvent& foreseen);
  bool forecast_events(const BodyState& start);
  bool is_balanced();
  void certify(double from);
  void keep_first(int count);  // keeps the first `count` computed events

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  FaceForecast* face_forecast_ = nullptr;  // while events are computed
  WindowLocator locator_;
  BondForecast bonds_;
  std::optional<LineForecast> lines_;  // empty: cracks grow bond by bond
  WindowFunctions functions_;
  WindowNarrowing narrowing_;
  Options options_{};
  std::unique_ptr<coupling::Condensation> condensation_;
  std::unique_ptr<WindowSolver> window_;
  OutsideGaps outside_gaps_;
  Eigen::VectorXd any_displacement_;
  bool proportional_ = false;
  bool has_ended_ = false;
  bool needs_whole_body_ = false, faces_move_ = false;
  int most_events_;  // largest number to compute at once

  ComputedEvents events_;
  ForecastBalance balance_;
  std::vector<coupling::Affine> states_;
  std::vector<DroppedDofs::State> foreseen_;  // states after each event, while events are computed
  int balanced_events_ = 0;                   // number of events up to the last check of the balance of forces
};

}  // namespace bempd::fracture

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fracture/contact/face_forecast.hpp"
#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/line/line_steps.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/line_certificate.hpp"
#include "fracture/window/outside_gaps.hpp"
#include "fracture/window/window_certificate.hpp"
#include "fracture/window/window_functions.hpp"
#include "fracture/window/window_locator.hpp"
#include "fracture/window/window_narrowing.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Event that a window has computed ahead, with its outcome once it is performed.
struct ForecastEvent {
  Event event;
  Outcome outcome;                          // but for the work before it and the residual
  std::vector<coupling::StageChange> back;  // undoes its changes
  EnergyForm before;                        // stored energy before it
  double largest_force = 0;                 // internal nodal force that is known to be reached until then
  std::optional<FaceState> faces;           // after it, where some close or open
  std::vector<GrowingTip> tips;             // after it, where cracks grow as lines
  std::vector<GrowingTip> growing;          // before it, those that have a way
};

// Computes events ahead: a window around the bonds close to breaking runs through them on condensed equations. Only
// events are kept for which it is proven that the whole body would break in the same way.
// The window ends before an event that it cannot perform: near its rim or outside, or one that frees a part of the body
// or removes the last resistance to a motion.
class EventForecast {
 public:
  using Options = WindowOptions;

  explicit EventForecast(LoadedBody& body);

  // Announces, before the first factorization, where windows are to be expected: at the ends of the initial cracks that
  // have broken the bonds `cut`.
  void expect_cracks(const std::vector<int>& cut) { locator_.expect_cracks(cut); }

  // Switches to growth of crack lines: events are steps of lines from now on.
  void follow(const LineSteps& lines) { lines_ = &lines; }

  // Opens a window around the bonds that are close to breaking at the load factor of the next event. Returns false if
  // no window would be smaller than the problem.
  bool open(const BodyState& state, double load_factor, const Options& options);
  // Opens the last window again at the same location.
  void open_again(const BodyState& state, const Options& options);
  bool is_open() const { return window_ != nullptr; }
  void close() noexcept;
  void forget();  // and where the window was: a new one is what it would be in a fresh run

  const Options& options() const { return options_; }
  WindowLocation place() const { return locator_.memory(); }
  int most_events() const { return most_events_; }
  void remember(WindowLocation place, int most_events);
  bool has_changed_terms() const { return system_has_changed_; }

  // Whether all computed events have been taken and more can be computed.
  bool must_compute() const { return position_ == static_cast<int>(events_.size()) && !has_ended_; }
  // Computes more events with rising load factor, from `state`, which must be the state at the present position.
  void compute(const BodyState& state);

  // Next of the computed events; null if there is none.
  const ForecastEvent* next() const;
  void take();  // the system's terms change
  // Whether the window has ended before an event that only the whole body can perform, or because faces of cracks open
  // or close after its last event.
  bool needs_whole_body() const { return needs_whole_body_ || faces_move_; }
  bool frees_a_motion() const { return needs_whole_body_; }
  bool ended_at_faces() const { return faces_move_; }

  // Number of events taken since the last call of compute(). Only the states at positions 0 up to this one can be asked
  // for or returned to.
  int position() const { return position_; }
  void return_to(int position) noexcept;
  coupling::Affine displacement(int position) const;
  std::vector<std::uint8_t> stages(int position) const;
  // Residual of the whole body after the last of the events computed together, or the largest imbalance that was
  // corrected in the window if that is larger. It stands for all of these events.
  double residual() const { return residual_; }

 private:
  void open_here(const BodyState& state);
  void build_window(const BodyState& state);
  bool forecast_next(double from, const BodyState& start);
  bool choose_breaks(double from, ForecastEvent& foreseen) const;
  bool choose_place(const BodyState& state, double load_factor);
  bool choose_place_of_lines(const BodyState& state, double load_factor);
  void begin_steps(const BodyState& state);
  std::optional<LineSteps::Choice> choose_step(double from, ForecastEvent& foreseen) const;
  void take_step(const LineSteps::Choice& line, ForecastEvent& foreseen);
  coupling::Affine displacement_near(const std::vector<GrowingTip>& tips) const;
  const std::vector<GrowingTip>& last_tips() const { return events_.empty() ? tips_ : events_.back().tips; }
  void narrow(double load_factor);
  int steps_as_foreseen() const;
  coupling::Affine whole_in(int state) const;
  double largest_force_before(double load_factor, const BodyState& start) const;
  bool perform_in_window(ForecastEvent& foreseen);
  Eigen::VectorXd internal_force_after_all(double load_factor);
  void take_back(int count);  // of the events computed all but the first ones, from the system
  bool forecast_events(const BodyState& start);
  bool is_balanced();
  void add_checks(double from, const Event& event);
  void certify(double from);
  void check_whole_body();
  void keep_first(int count);  // of the events computed

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  FaceForecast* face_forecast_ = nullptr;  // while events are computed
  WindowLocator locator_;
  WindowFunctions functions_;
  WindowNarrowing narrowing_;
  Options options_{};
  const LineSteps* lines_ = nullptr;
  std::vector<GrowingTip> tips_;  // in the state 0
  coupling::Affine near_tips_;    // displacements in the state foreseen last, where its tips ask

  std::unique_ptr<coupling::Condensation> condensation_;
  std::unique_ptr<WindowSolver> window_;
  std::unique_ptr<WindowCertificate> certificate_;  // or, of lines:
  std::unique_ptr<LineCertificate> line_certificate_;
  OutsideGaps outside_gaps_;
  Eigen::VectorXd any_displacement_;
  coupling::Affine whole_;  // displacements of the whole body in the last state
  bool proportional_ = false;
  bool has_ended_ = false;
  bool needs_whole_body_ = false, faces_move_ = false;
  int most_events_;  // to compute at once

  std::vector<ForecastEvent> events_;
  std::vector<coupling::Affine> states_;
  std::vector<DroppedDofs::State> foreseen_;  // the states, while events are computed
  std::vector<OutsideCheck> checks_;
  int balanced_events_ = 0;  // of those, before forces were in balance last
  double unbalanced_ = 0;    // what was off then and before at most, of the largest force
  int position_ = 0;
  bool system_has_changed_ = false;
  double residual_ = 0;
};

}  // namespace bempd::fracture

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

// An event computed ahead, and what it will do once it happens.
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

// Computes events ahead of time: a window around the hot bonds runs through them on condensed equations, and only those
// are kept of which it is proven that the whole body would break in the same way. It stops before an event that it
// cannot perform: one near its rim or outside, one that frees a part of the body or takes away the last resistance to a
// motion.
class EventForecast {
 public:
  using Options = WindowOptions;

  explicit EventForecast(LoadedBody& body);

  // Says before the first factorization where windows are expected: at the ends of initial cracks, given by the bonds
  // they cut.
  void expect_cracks(const std::vector<int>& cut) { locator_.expect_cracks(cut); }

  // Makes events steps of lines from now on.
  void follow(const LineSteps& lines) { lines_ = &lines; }

  // Opens a window around the bonds that are hot at the load factor of the next event. False if there is no window that
  // would be smaller than the problem.
  bool open(const BodyState& state, double load_factor, const Options& options);
  // Opens the window again where the last one was.
  void open_again(const BodyState& state, const Options& options);
  bool is_open() const { return window_ != nullptr; }
  void close() noexcept;
  void forget();  // and where the window was: a new one is what it would be in a fresh run

  const Options& options() const { return options_; }
  WindowLocation place() const { return locator_.memory(); }
  int most_events() const { return most_events_; }
  void remember(WindowLocation place, int most_events);
  bool has_changed_terms() const { return system_has_changed_; }

  // True where no event is left but more may come.
  bool must_compute() const { return position_ == static_cast<int>(events_.size()) && !has_ended_; }
  // More events on the way up from the state, which is that of the present position.
  void compute(const BodyState& state);

  // The next of the events computed; null if there is none.
  const ForecastEvent* next() const;
  void take();  // the system's terms change
  // True if the window has come to its end before an event that no window can perform, or after which faces of cracks
  // open or close.
  bool needs_whole_body() const { return needs_whole_body_ || faces_move_; }
  bool frees_a_motion() const { return needs_whole_body_; }
  bool ended_at_faces() const { return faces_move_; }

  // States since the events were computed last, 0 first; only these can be asked for and returned to.
  int position() const { return position_; }
  void return_to(int position) noexcept;
  coupling::Affine displacement(int position) const;
  std::vector<std::uint8_t> stages(int position) const;
  // The residual of the whole body after the last of the events computed together, or of what rounding had led the
  // window away by where that was more; it stands for all of them.
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

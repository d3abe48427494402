#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/event_forecast.hpp"

namespace bempd::fracture {

// The source of events that a window has computed ahead, which are performed one by one. The body's displacements and
// forces fall behind meanwhile: only its load factor and bonds are right until they are asked for.
class WindowEvents final : public EventSource {
 public:
  // Calls `before_forgetting` before places told so far lose their meaning.
  WindowEvents(LoadedBody& body, std::function<void()> before_forgetting);

  // Makes events steps of lines from now on.
  void follow(const LineSteps& lines) { forecast_.follow(lines); }

  // Says before the first solution where initial cracks are, given by the bonds they cut.
  void expect_cracks(const std::vector<int>& cut) { forecast_.expect_cracks(cut); }

  // Opens a window around what is critical at the load factor of the next event. False if there is no window that would
  // be of use.
  bool open(double load_factor, const SteppingOptions& options);
  bool is_open() const { return forecast_.is_open(); }
  bool suits(const SteppingOptions& options) const;  // the window, once open
  void close();
  void forget();            // and where the window was; the body's state is no longer brought up to date
  void abandon() noexcept;  // the same, but for where it was

  // How an open window has come to where it is; what it remembers of the place of the last one; and the way back.
  // After remember() in the state in which the window was opened, open_again() leaves it as it was, with the body's
  // state; false if it does not come to the same.
  WindowOrigin origin() const;
  WindowLocation place_of_last() const { return forecast_.place(); }
  int most_events() const { return is_open() ? most_events_at_first_ : forecast_.most_events(); }
  void remember(WindowLocation place, int most_events) { forecast_.remember(std::move(place), most_events); }
  bool open_again(const WindowOrigin& origin);

  // Null if the window has come to its end.
  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;

  std::int64_t events_performed() const { return events_performed_; }  // since the window was opened
  // True if the window has come to its end before an event that no window can perform.
  bool needs_whole_body() const { return forecast_.needs_whole_body(); }
  // True if the window has come to its end because faces of cracks close or open after the events that it knew.
  bool ended_at_faces() const { return forecast_.ended_at_faces(); }

  void bring_up_to_date();
  // Brings displacements up to date for someone who looks: the run goes on as if nobody had.
  void show();

  // The place of the body among the events of the window.
  struct Place {
    int position;
    std::int64_t events_performed;
    double load_factor, largest_force;
    bool separated;
    std::vector<GrowingTip> tips;
  };
  Place place() const;
  BodyState state_at(const Place& place) const;
  void return_to(Place& place) noexcept;  // for the last time

 private:
  EventForecast forecast_;
  LoadedBody& body_;
  std::function<void()> before_forgetting_;
  void take(const ForecastEvent& next);
  void take_faces(FaceState faces);
  bool take_again();

  bool is_behind_ = false;
  bool is_shown_ = false;  // although the run itself is behind
  std::int64_t events_performed_ = 0;
  WindowOrigin origin_;  // but for what changes from event to event
  bool faces_have_switched_ = false;
  int most_events_at_first_ = 0;
};

}  // namespace bempd::fracture

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"
#include "fracture/window/event_forecast.hpp"

namespace bempd::fracture {

// Source of events that a window has computed ahead and that are performed one by one. Meanwhile the displacements and
// forces in the body's state are out of date; only its load factor and the stages of bonds are correct until
// bring_up_to_date().
class WindowEvents final : public EventSource {
 public:
  // `before_forgetting` is called before positions in the window (Place) returned so far become invalid.
  WindowEvents(LoadedBody& body, std::function<void()> before_forgetting);

  // Switches to growth of crack lines: events are steps of lines from now on.
  void grow_lines(const LineSteps& lines) { forecast_.grow_lines(lines); }

  // Announces, before the first solution, where initial cracks are: they have broken the bonds `cut`.
  void expect_cracks(const std::vector<int>& cut) { forecast_.expect_cracks(cut); }

  // Opens a window around the bonds that are critical at the load factor of the next event. Returns false if no window
  // would save time.
  bool open(double load_factor, const SteppingOptions& options);
  bool is_open() const { return forecast_.is_open(); }
  bool suits(const SteppingOptions& options) const;  // the window, once open
  void close();
  void forget();            // and where the window was; the body's state is no longer brought up to date
  void abandon() noexcept;  // the same, but for where it was

  // Saving and restoring the window. origin() tells how the open window has got to its present state, place_of_last()
  // where the present window or the last one is. To restore, call remember() in the state in which the window was
  // opened, then open_again(). This also restores the body's state; it returns false if the result differs from what
  // was saved.
  WindowOrigin origin() const;
  WindowLocation place_of_last() const { return forecast_.place(); }
  int most_events() const { return is_open() ? most_events_at_first_ : forecast_.most_events(); }
  void remember(WindowLocation place, int most_events) { forecast_.remember(std::move(place), most_events); }
  bool open_again(const WindowOrigin& origin);

  // Next event, or null if the window has ended.
  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;

  std::int64_t events_performed() const { return events_performed_; }  // since the window was opened
  // Whether the window has ended before an event that only the whole body can perform.
  bool needs_whole_body() const { return forecast_.needs_whole_body(); }
  // Whether the window has ended because faces of cracks close or open after its last event.
  bool ended_at_faces() const { return forecast_.ended_at_faces(); }

  void bring_up_to_date();
  // Brings displacements up to date for a reader only: the run continues as if they were still out of date.
  void update_for_reader();

  // Position of the body among the events of the window, to which it can return.
  struct Place {
    int position;
    std::int64_t events_performed;
    double load_factor, largest_force;
    bool separated;
    std::vector<GrowingTip> tips;
    std::size_t pending_faces;  // events whose faces are pending
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

  bool is_out_of_date_ = false;
  bool is_updated_for_reader_ = false;  // although the run itself is behind
  std::int64_t events_performed_ = 0;
  WindowOrigin origin_;  // but for what changes from event to event
  bool faces_have_switched_ = false;
  int most_events_at_first_ = 0;
};

}  // namespace bempd::fracture

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

// Source of events that a window (region around crack tips or bonds close to breaking that is solved alone) has
// computed ahead and that are performed one by one. Until bring_up_to_date() the displacements and forces in the body's
// state are out of date; only its load factor and the damage stages of bonds are correct.
class WindowEvents final : public EventSource {
 public:
  // Prepares windows of a body. `before_forgetting` is called before the positions in the window that place() has
  // returned become invalid.
  WindowEvents(LoadedBody& body, std::function<void()> before_forgetting);

  // Switches to crack lines (cracks that grow in a lattice by steps). From this call on, events are steps of crack
  // lines.
  void grow_lines(const LineSteps& lines) { forecast_.grow_lines(lines); }

  // Announces, before the first solution, where initial cracks are: the cracks that have broken the bonds `cut`.
  void expect_cracks(const std::vector<int>& cut) { forecast_.expect_cracks(cut); }

  // Opens a window around the bonds or crack tips that become critical at the load factor of the next event. Returns
  // false if no window would save time.
  bool open(double load_factor, const SteppingOptions& options);
  bool is_open() const { return forecast_.is_open(); }
  bool suits(const SteppingOptions& options) const;  // whether the open window has these options
  void close();
  void forget();            // closes the window and forgets its location; the state is not brought up to date
  void abandon() noexcept;  // closes the window; the state is not brought up to date

  // Origin of the open window: the data from which the window and its present state can be computed again.
  WindowOrigin origin() const;
  // Location of the open window or, if none is open, of the last window.
  WindowLocation place_of_last() const { return forecast_.place(); }
  // Largest number of events that the open window computed at first or, if none is open, that the next one will
  // compute.
  int most_events() const { return is_open() ? most_events_at_first_ : forecast_.most_events(); }
  // Restores place_of_last() and most_events() of a saved run.
  void remember(WindowLocation place, int most_events) { forecast_.remember(std::move(place), most_events); }
  // Opens a saved window again and takes its events again, which also restores the body's state. To be called after
  // remember(), in the state in which the window was first opened. Returns false if the result differs from the saved
  // window.
  bool open_again(const WindowOrigin& origin);

  // Next event that the window has computed; null if the window has ended.
  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;

  std::int64_t events_performed() const { return events_performed_; }  // since the window was opened
  // Whether the window has ended before an event that only the whole body can perform, or because faces of cracks open
  // or close after its last event.
  bool needs_whole_body() const { return forecast_.needs_whole_body(); }
  // Whether the window has ended because faces of cracks close or open after its last event.
  bool ended_at_faces() const { return forecast_.ended_at_faces(); }

  // Brings displacements and forces in the body's state up to date.
  void bring_up_to_date();
  // Brings displacements and forces up to date for a reader only: the run continues as if they were still out of date.
  void update_for_reader();

  // Position of the body among the events of the window, to which the body can return.
  struct Place {
    int position;
    std::int64_t events_performed;
    double load_factor, largest_force;
    bool separated;
    std::vector<GrowingTip> tips;
    std::size_t pending_faces;  // number of events whose contact places are not added yet
  };
  Place place() const;
  BodyState state_at(const Place& place) const;
  void return_to(Place& place) noexcept;  // returns to a position for the last time

 private:
  EventForecast forecast_;
  LoadedBody& body_;
  std::function<void()> before_forgetting_;
  void take(const ForecastEvent& next);
  void take_faces(FaceState faces);
  bool take_again();

  bool is_out_of_date_ = false;
  bool is_updated_for_reader_ = false;  // up to date for a reader only
  std::int64_t events_performed_ = 0;
  WindowOrigin origin_;  // its parts that do not change from event to event
  bool faces_have_switched_ = false;
  int most_events_at_first_ = 0;
};

}  // namespace bempd::fracture

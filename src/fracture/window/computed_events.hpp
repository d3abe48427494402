#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"
#include "fracture/window/window_functions.hpp"

namespace bempd::fracture {

// Event that a window (region around crack tips or bonds close to breaking that is solved alone) has computed ahead,
// with its outcome once the window has performed it.
struct ForecastEvent {
  Event event;
  Outcome outcome;                          // without the work before the event and the residual
  std::vector<coupling::StageChange> back;  // changes of stages that undo the event
  EnergyForm before;                        // stored energy before the event
  double largest_force = 0;                 // largest internal nodal force known up to the event [N]
  std::optional<FaceState> faces;           // contact state after the event, if faces close or open at it
  std::vector<GrowingTip> tips;             // tips of crack lines after the event
  std::vector<GrowingTip> growing;          // tips near which no bond breaks by itself before the event
};

// Events that a window has computed together, and the number of them that the run has performed (taken). The system has
// the damage stages of terms after the events taken; while events are computed, those after the last computed event.
class ComputedEvents {
 public:
  explicit ComputedEvents(coupling::EquilibriumSystem& system) : system_(system) {}

  const std::vector<ForecastEvent>& list() const { return list_; }
  bool empty() const { return list_.empty(); }
  int count() const { return static_cast<int>(list_.size()); }
  ForecastEvent& last() { return list_.back(); }
  void add(ForecastEvent event) { list_.push_back(std::move(event)); }
  void clear() noexcept { list_.clear(), position_ = 0; }
  // Returns the system to the damage stages after the first `count` events. The later events stay in the list;
  // keep_first() removes them from the list, too.
  void take_back(int count);
  void keep_first(int count);

  // Next event that the run can take; null if all have been taken.
  const ForecastEvent* next() const { return position_ < count() ? &list_[position_] : nullptr; }
  void take();  // takes the next event, and changes the stages of terms in the system
  bool are_all_taken() const { return position_ == count(); }
  // Number of events taken, the present position. A state can be asked for, and returned to, only at positions from 0
  // to this one.
  int position() const { return position_; }
  void return_to(int position) noexcept;
  std::vector<std::uint8_t> stages(int position) const;

  // Whether events have been taken since the window was opened.
  bool have_changed_terms() const { return have_changed_terms_; }
  void begin_window() { clear(), have_changed_terms_ = false; }

 private:
  coupling::EquilibriumSystem& system_;
  std::vector<ForecastEvent> list_;
  int position_ = 0;
  bool have_changed_terms_ = false;
};

}  // namespace bempd::fracture

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/window/window_functions.hpp"

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

// Events that a window has computed together, and how many of them have been taken. Stages of terms in the system are
// those after the events taken; while events are computed, those after the last one.
class ComputedEvents {
 public:
  explicit ComputedEvents(coupling::EquilibriumSystem& system) : system_(system) {}

  const std::vector<ForecastEvent>& list() const { return list_; }
  bool empty() const { return list_.empty(); }
  int count() const { return static_cast<int>(list_.size()); }
  ForecastEvent& last() { return list_.back(); }
  void add(ForecastEvent event) { list_.push_back(std::move(event)); }
  void clear() noexcept { list_.clear(), position_ = 0; }
  // Returns the system to the stages after the first `count` events. The later ones stay in the list; keep_first()
  // removes them from it, too.
  void take_back(int count);
  void keep_first(int count);

  // Next event to take; null if there is none.
  const ForecastEvent* next() const { return position_ < count() ? &list_[position_] : nullptr; }
  void take();  // the system's terms change
  bool are_all_taken() const { return position_ == count(); }
  // Number of events taken. Only the states at positions 0 up to this one can be asked for or returned to.
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

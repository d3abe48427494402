#pragma once

#include <algorithm>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// Rule for when the next window (region around crack tips that is solved alone) is tried. After each window that has
// saved nothing, the number of events on the whole body before the next window is doubled.
class WindowPatience {
 public:
  int events() const { return events_; }      // events to come on the whole body before the next window
  int patience() const { return patience_; }  // number of events to wait, doubled where a window saves nothing
  void set(int events, int patience) { events_ = events, patience_ = patience; }

  bool waits() const { return events_ > 0; }
  void wait_for(int events) { events_ = events; }
  void note_event() { events_ = std::max(0, events_ - 1); }
  void note_useless() {
    patience_ = std::min(2 * patience_, WindowSettings::most_patience);
    events_ = patience_;
  }
  void note_useful() { patience_ = 1; }

 private:
  int events_ = 0, patience_ = 1;
};

}  // namespace bempd::fracture

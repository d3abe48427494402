#pragma once

#include <algorithm>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// When the next window is tried. After one without use it is tried later, each time after twice as many events.
class WindowPatience {
 public:
  int events() const { return events_; }      // to come in the whole body before the next window
  int patience() const { return patience_; }  // how many they were, doubled where a window finds nothing to do
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

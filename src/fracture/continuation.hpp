#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/factor_origin.hpp"
#include "fracture/window/window_origin.hpp"

namespace bempd::fracture {

// Data of a run beside its state. With them a restored run repeats the events that the saved run had computed ahead in
// a window (region around crack tips that is solved alone), and continues with the same digits. The data are optional:
// the state of the body is complete without them.
struct Continuation {
  int whole_body_events = 0;  // events to come on the whole body before the next window
  int patience = 1;
  int most_events = 0;  // largest number that the next window computes at once, or that the open one began with
  WindowLocation place;
  coupling::PlacesMet places_met;
  std::vector<char> barred;  // flags of the constraints with a penalty that may not close; empty if not known yet
  std::uint64_t changes_that_bar = 0;
  std::optional<coupling::FactorOrigin> factor;
  std::optional<WindowOrigin> window;  // the open window, if any
};

}  // namespace bempd::fracture

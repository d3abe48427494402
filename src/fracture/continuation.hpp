#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/factor_origin.hpp"
#include "fracture/window/window_origin.hpp"

namespace bempd::fracture {

// What a run knows beside its state, including how to compute again what it has computed ahead: with it a restored run
// continues with the same digits as the saved one. It is optional, because the body's state is complete without.
struct Continuation {
  int whole_body_events = 0;  // before the next window
  int patience = 1;
  int most_events = 0;  // that the next window computes at once, or the open one at first
  WindowLocation place;
  coupling::PlacesMet places_met;
  std::vector<char> barred;  // flags of the constraints with a penalty, once known
  std::uint64_t changes_that_bar = 0;
  std::optional<coupling::FactorOrigin> factor;
  std::optional<WindowOrigin> window;  // that is open
};

}  // namespace bempd::fracture

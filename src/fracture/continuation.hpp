#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/factor_origin.hpp"
#include "fracture/window/window_origin.hpp"

namespace bempd::fracture {

// What a run knows beside its state, and what it has computed ahead, as the way to compute it again: with it a restored
// run goes on with the same digits as the one that was saved. The body of the state follows from it and from nothing
// else, so that a run may go on without.
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

#pragma once

#include <atomic>
#include <cstdint>
#include <set>

#include "fracture/body_carrier.hpp"
#include "fracture/load_way.hpp"

namespace bempd::fracture {

// Order in which bonds break as the load factor changes.
enum class SteppingMode {
  // Event by event: the most stretched bonds break first, at the load factor at which they reach their critical
  // stretch, until no bond exceeds it.
  events,
  // Fixed increments with one solution each: every bond that exceeds its critical stretch at the end of an increment
  // breaks; bonds that these breaks overload break in the next increment (Yang and Liu 2021, fig. 6).
  increments
};

struct SteppingOptions {
  SteppingMode mode = SteppingMode::events;
  double increment = 1;          // size of an increment of the load factor
  double tie_band = 1e-3;        // relative difference of stretch ratios up to which bonds break together
  int max_breaks_per_solve = 0;  // 0: no limit
  std::int64_t max_events = 10'000'000;
  bool window = true;       // compute events ahead in a window (region around crack tips), where possible
  double window_ahead = 0;  // length of a window ahead of a crack tip [lattice spacings]; 0: chosen by the size
  Control control = Control::load;
  double separation_share = 0;  // share of the largest resistance below which the body counts as separated
  bool leaves_fresh = false;  // a step that changes the system leaves no factor behind (CrackEvolution::synchronize())
  BodyCarrier* elements = nullptr;          // carrier of cracks in boundary elements; null: no such crack may grow
  std::set<crack::TipId> frozen{};          // tips that the host keeps where they are
  const std::atomic<bool>* stop = nullptr;  // flag by which the host asks for the end of the step; null: none
};

}  // namespace bempd::fracture

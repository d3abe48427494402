#pragma once

#include <cstdint>

#include "fracture/crack_evolution.hpp"

// Result of a step (a run of the model).
namespace bempd::model {

struct StepResult {
  fracture::StopReason reason;
  std::int64_t events = 0;
  std::int64_t broken_bonds = 0;
  std::int64_t unstable_event = 0;  // number of the first event at which equilibrium was lost; 0: none
  std::int64_t face_switches = 0;   // places where faces have closed or opened
  std::int64_t ties = 0;            // tips or places that tied with one that grew
  bool hanging = false;             // separated, and nothing has come off
  double seconds_total = 0, seconds_solve = 0, seconds_update = 0, seconds_search = 0;
};

struct GrowthResult {
  int tips = 0;   // that have grown
  int ended = 0;  // of them at an edge, a hole or another crack
  double load_factor = 0;
  double length = 0;  // of all extensions
  double released_energy = 0;
};

}  // namespace bempd::model

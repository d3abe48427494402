#pragma once

#include <cstdint>

#include "fracture/crack_evolution.hpp"

// Answers to calls that drive the run: the result of a step, and that of growth by lengths.
namespace bempd::model {

// Time [s] for solutions, for changes of the factorization, and for the search for events.
struct TimeSpent {
  double solve = 0, update = 0, search = 0;

  void operator+=(const TimeSpent& other) { solve += other.solve, update += other.update, search += other.search; }
  void operator-=(const TimeSpent& other) { solve -= other.solve, update -= other.update, search -= other.search; }
};

struct StepResult {
  fracture::StopReason reason;
  std::int64_t events = 0;
  std::int64_t broken_bonds = 0;
  std::int64_t unstable_event = 0;  // number of the first event at which equilibrium was lost; 0: none
  std::int64_t face_switches = 0;   // number of places where crack faces have closed or opened
  std::int64_t ties = 0;            // number of tips or places that tied with a tip or place that grew
  bool hanging = false;             // separated, although a hinge joins the parts
  double seconds_total = 0;
  TimeSpent seconds{};  // parts of seconds_total
};

struct GrowthResult {
  int tips = 0;   // number of tips that have grown
  int ended = 0;  // number of these tips that ended at an edge, a hole or another crack
  double load_factor = 0;
  double length = 0;  // sum of the lengths of all extensions
  double released_energy = 0;
};

}  // namespace bempd::model

#pragma once

#include <cstdint>
#include <vector>

#include "coupling/term_law.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// Rounding error of the ratio of a term that just reaches its critical value.
constexpr double ratio_rounding = 1e-9;

// Event: terms that reach their critical value together, at one load factor.
struct Event {
  double load_factor = 0;
  double ratio = 0;                 // largest stretch over critical stretch
  double critical_load_factor = 0;  // at which the term of this ratio just reaches its critical value
  // Whether equilibrium is lost: the term is stretched beyond its critical value, not just to it.
  bool is_out_of_balance() const { return ratio > 1 + ratio_rounding; }

  // Changes of the stages of the event's terms and their followers, ascending; empty if the event lies beyond the
  // target.
  std::vector<coupling::StageChange> changes;

  // Whether nothing breaks and faces of cracks close or open.
  bool is_contact = false;
  bool goes_down = false;  // then: the load factor falls on the way

  crack::TipId tip{};       // that grows at it; crack 0: none
  double taken_energy = 0;  // at most, by what grows, where that is known; else 0: the ratio tells it [J]
  int ties = 0;             // others that would grow as soon
  bool is_growth = false;   // nothing breaks: a tip with boundary elements grows

  // Notes the ratio of one of the event's terms; the largest one counts.
  void reach(double ratio_of_term, double critical_of_term) {
    if (ratio_of_term <= ratio) return;
    ratio = ratio_of_term;
    critical_load_factor = critical_of_term;
  }
};

// Share of the loads that only supports balance (BodyLoads::unbalanced_share), before and after a part takes its loads
// away.
struct LostBalance {
  double before = 0, after = 0;
};

// Outcome of an event.
struct Outcome {
  std::int64_t broken = 0;    // terms that break
  std::int64_t switches = 0;  // places of faces that have closed or opened
  double work_before = 0;     // of the loads on the way to the event
  double work = 0;            // of the event itself
  double released_energy = 0;
  double bond_energy = 0;             // of it, what the terms take where they just reach their critical values
  double stored_energy_before = 0;    // at the same load factor
  double within_before = 0;           // InnerWork::at() this load factor
  double stored_energy = 0;           // after it
  double critical_stored_energy = 0;  // the same at the critical load factor
  double unit_energy = 0;             // of the proportional load alone, after it
  double residual = 0;
  double energy_scale = 0;  // what energies are measured by at least
  std::int64_t fragments = 0;
  bool comes_free = false;                          // of faces that close or open: a part does
  std::vector<double> reactions_before, reactions;  // at the same load factor and after it, x and y of every support
  double resistance_before = 0;                     // at the same load factor
  double resistance = 0;
  LostBalance lost_balance;
  std::vector<CrackExtension> extensions;  // but for what the books know: event, length of the crack, energy
  int ties = 0;                            // others that would have grown as soon
};

// Event source: finds the next event as the load factor changes, and performs it on the body.
class EventSource {
 public:
  EventSource() = default;
  EventSource(const EventSource&) = delete;
  EventSource& operator=(const EventSource&) = delete;
  virtual ~EventSource() = default;

  // Next event on the way to a target; null if the source knows of none in that direction. It may lie beyond the
  // target.
  virtual const Event* next(double target, const SteppingOptions& options) = 0;

  // Performs the event that next() returned.
  virtual Outcome perform() = 0;
};

}  // namespace bempd::fracture

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

  crack::TipId tip{};       // tip that grows at the event; crack 0: none
  double taken_energy = 0;  // largest energy that growth takes [J]; 0: it follows from the ratio
  int ties = 0;             // other tips or bonds that tie with it
  bool is_growth = false;   // nothing breaks: a tip with boundary elements grows

  // Notes the ratio of one of the event's terms; the largest one counts.
  void reach(double ratio_of_term, double critical_of_term) {
    if (ratio_of_term <= ratio) return;
    ratio = ratio_of_term;
    critical_load_factor = critical_of_term;
  }
};

// Share of the loads that only supports balance (LoadedBody::unbalanced_share), before and after a part takes its loads
// away.
struct LostBalance {
  double before = 0, after = 0;
};

// Outcome of an event.
struct Outcome {
  std::int64_t broken = 0;    // terms that break
  std::int64_t switches = 0;  // places of faces that have closed or opened
  double work_before = 0;     // work of the loads on the path to the event
  double work = 0;            // work of the loads at the event
  double released_energy = 0;
  double bond_energy = 0;             // part of it that terms absorb: released at their critical values
  double stored_energy_before = 0;    // just before the event, at its load factor
  double within_before = 0;           // CrackEvolution::within() just before it
  double stored_energy = 0;           // after it
  double critical_stored_energy = 0;  // after it, at the critical load factor
  double unit_energy = 0;             // of the proportional load alone, after it
  double residual = 0;
  double energy_scale = 0;  // least scale of energies
  std::int64_t fragments = 0;
  bool comes_free = false;                          // contact event at which a part comes free
  std::vector<double> reactions_before, reactions;  // before and after it at its load factor, x and y of every support
  double resistance_before = 0;                     // just before it, at its load factor
  double resistance = 0;
  LostBalance lost_balance;
  std::vector<CrackExtension> extensions;  // without event, crack length and energy, which the records add
  int ties = 0;                            // other tips or bonds that tied with it
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

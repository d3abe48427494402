#pragma once

#include <cstdint>
#include <vector>

#include "coupling/term_law.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// Rounding error of the ratio of a term's stretch to its critical stretch, when the term just becomes critical.
constexpr double ratio_rounding = 1e-9;

// Event of a run at one load factor: terms (bonds and cell squares) that become critical together change their damage
// stages, crack faces close or open, or a crack tip grows.
struct Event {
  double load_factor = 0;
  double ratio = 0;  // largest stretch over critical stretch, or of a tip: stress intensity over toughness
  double critical_load_factor = 0;  // at which the term or tip of this ratio just reaches its critical value
  // Whether equilibrium is lost at the event: the term or tip is loaded beyond its critical value, not just to it.
  bool is_out_of_balance() const { return ratio > 1 + ratio_rounding; }

  // Changes of the damage stages of the event's terms and their followers, by ascending numbers of terms; empty if the
  // event lies beyond the target.
  std::vector<coupling::StageChange> changes;

  // Whether the event is a contact event: crack faces close or open, and nothing breaks.
  bool is_contact = false;
  bool goes_down = false;  // whether the load factor falls on the way to a contact event

  crack::TipId tip{};       // tip that grows at the event; crack 0: none
  double taken_energy = 0;  // largest energy that the growing tip takes [J]; 0: not known, the ratio decides
  int ties = 0;             // other tips or places that would grow at the same load factor
  bool is_growth = false;   // a tip in boundary elements grows, and nothing breaks

  // Notes the stretch ratio (stretch over critical stretch) of one of the event's terms, and the load factor at which
  // this term becomes critical. The event keeps both numbers of the term with the largest ratio.
  void reach(double ratio_of_term, double critical_of_term) {
    if (ratio_of_term <= ratio) return;
    ratio = ratio_of_term;
    critical_load_factor = critical_of_term;
  }
};

// Share of the loads that the other loads do not balance, only supports do (BodyLoads::unbalanced_share()): before and
// after a freed part takes its loads away.
struct LostBalance {
  double before = 0, after = 0;
};

// Outcome of an event.
struct Outcome {
  std::int64_t broken = 0;    // terms that break
  std::int64_t switches = 0;  // places of faces that have closed or opened
  double work_before = 0;     // work of the loads on the way to the event [J]
  double work = 0;            // work of the loads at the event [J]
  double released_energy = 0;
  double bond_energy = 0;           // part of the released energy that the terms take, each just at its critical value
  double stored_energy_before = 0;  // just before the event
  double within_before = 0;         // InnerWork::at() the event, just before it
  double stored_energy = 0;         // just after the event
  double critical_stored_energy = 0;  // after the event, at its critical load factor
  double unit_energy = 0;             // elastic energy of the proportional load alone, after the event [J]
  double residual = 0;
  double energy_scale = 0;  // least scale of energy errors (balance.hpp)
  std::int64_t fragments = 0;
  bool comes_free = false;                          // at a contact event: a part of the body comes free
  std::vector<double> reactions_before, reactions;  // just before and after the event: x and y of every support [N]
  double resistance_before = 0;                     // just before the event (SupportForces::resistance()) [N]
  double resistance = 0;                            // just after the event [N]
  LostBalance lost_balance;
  std::vector<CrackExtension> extensions;  // of crack lines; RunRecords adds event, crack length and energies
  int ties = 0;                            // other tips or places that would have grown at the same load factor
};

// Event source: finds the next event as the load factor changes, and performs it on the body.
class EventSource {
 public:
  EventSource() = default;
  EventSource(const EventSource&) = delete;
  EventSource& operator=(const EventSource&) = delete;
  virtual ~EventSource() = default;

  // Next event on the way to a target, which may lie beyond the target; null if the source knows of no event in that
  // direction.
  virtual const Event* next(double target, const SteppingOptions& options) = 0;

  // Performs the event that next() returned.
  virtual Outcome perform() = 0;
};

}  // namespace bempd::fracture

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"

namespace bempd::fracture {

// Elongation of a term [m], and what of it goes beyond its rest elongation.
struct Elongation {
  double whole, elastic;
};

// A term whose stage changes, as it is just before.
struct ChangingTerm {
  int term;
  double stiffness_lost;
  Elongation before;
};

// What a body does at an event, besides what its terms release.
struct BodyChange {
  double work = 0;
  // Energy that faces and a fluid release, in the order in which it is added up: before the terms, and after them.
  double released_first = 0;
  std::vector<double> released_then;
  bool takes_loads_along = false;  // a part that comes free takes its loads along
};

// What an event asks of the body that it happens to: of the whole one, or of the part of it that a window follows. By
// it events are performed, and their books written, in one way.
class EventBody {
 public:
  EventBody() = default;
  EventBody(const EventBody&) = delete;
  EventBody& operator=(const EventBody&) = delete;
  virtual ~EventBody() = default;

  // Energies and forces at a load factor, in the present stages of all terms.
  virtual double stored_energy(double load_factor) const = 0;
  virtual double unit_energy() const = 0;                               // of the proportional load alone
  virtual std::vector<double> reactions(double load_factor) const = 0;  // x and y of every support
  // Half of the sum of the magnitudes of these reactions and of the nodal loads.
  virtual double resistance(const std::vector<double>& reactions, double load_factor) const = 0;
  virtual Elongation elongation(int term, double load_factor) const = 0;

  // Puts terms into their next stages, holds what that frees, and closes and opens faces until their gaps agree; parts
  // and faces are counted in the outcome. Null, and nothing is changed, where this body cannot perform the event.
  virtual std::optional<BodyChange> change(const Event& event, std::span<const ChangingTerm> terms,
                                           Outcome& outcome) = 0;
};

// Performs an event that lies at the body's load factor. Null where the body cannot. What only the source of the event
// knows is left open: the work before the event, the residual, and what tips of lines do.
std::optional<Outcome> perform_event(const Event& event, const coupling::EquilibriumSystem& system, EventBody& body);

}  // namespace bempd::fracture

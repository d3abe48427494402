#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Elongation of a term [m], and the elastic part of it, beyond the rest elongation.
struct Elongation {
  double whole, elastic;
};

// Term whose stage changes, with its values just before.
struct ChangingTerm {
  int term;
  double stiffness_lost;
  Elongation before;
};

// Work and released energies [J] when a body performs an event. The energies that its terms (bonds and squares) release
// are not included.
struct BodyChange {
  double work = 0;
  // Energies that faces and a fluid release, in the order of summation: before and after those of the terms.
  double released_before_terms = 0;
  std::vector<double> released_after_terms;
  bool takes_loads_along = false;  // a part that comes free takes its loads along
};

// Body as an event changes it: the whole body, or the part of it that a window follows. With this interface both
// perform events and compute their outcomes in the same way.
class EventBody {
 public:
  EventBody() = default;
  EventBody(const EventBody&) = delete;
  EventBody& operator=(const EventBody&) = delete;
  virtual ~EventBody() = default;

  // Energies and forces at a load factor, for the present stages of all terms.
  virtual double stored_energy(double load_factor) const = 0;
  virtual double unit_energy() const = 0;                               // of the proportional load alone
  virtual std::vector<double> reactions(double load_factor) const = 0;  // x and y of every support
  virtual Elongation elongation(int term, double load_factor) const = 0;

  // Changes the stages of terms, holds what that frees, and closes and opens faces until they agree with their gaps.
  // Parts and faces are counted in `outcome`. Returns null and changes nothing if this body cannot perform the event.
  virtual std::optional<BodyChange> change(const Event& event, std::span<const ChangingTerm> terms,
                                           Outcome& outcome) = 0;
};

// Performs an event at the load factor of `body`, which is `whole` or a part of it; null if the body cannot. The
// event's source adds to the outcome the work before the event, the residual, and what tips of lines do.
std::optional<Outcome> perform_event(const Event& event, const LoadedBody& whole, EventBody& body);

}  // namespace bempd::fracture

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Elongation of a term (bond or cell square) [m], and its elastic part: the elongation less the rest elongation that
// swelling causes.
struct Elongation {
  double whole, elastic;
};

// Term whose damage stage an event changes: the stiffness that it loses [N/m], and its elongation just before the
// event.
struct ChangingTerm {
  int term;
  double stiffness_lost;
  Elongation before;
};

// Work of the loads [J] when a body performs an event, and the energies released by other causes than the terms that
// change their damage stage.
struct BodyChange {
  double work = 0;
  // Energy that crack faces in a window release by opening or closing. It is the first summand of the released energy,
  // before the energies of the terms.
  double released_before_terms = 0;
  // Energies that crack faces, and fluid in cracks, release in the whole body. They are the last summands of the
  // released energy, after the energies of the terms.
  std::vector<double> released_after_terms;
  bool takes_loads_along = false;  // a part that comes free takes its loads along
};

// Body that events change: the whole body, or a window (region around crack tips that is solved alone). Both perform
// events through this interface, so that perform_event() computes outcomes in the same way.
class EventBody {
 public:
  EventBody() = default;
  EventBody(const EventBody&) = delete;
  EventBody& operator=(const EventBody&) = delete;
  virtual ~EventBody() = default;

  // Stored energy [J] at a load factor, for the present damage stages of all terms.
  virtual double stored_energy(double load_factor) const = 0;
  virtual double unit_energy() const = 0;                               // energy of the proportional load alone [J]
  virtual std::vector<double> reactions(double load_factor) const = 0;  // x and y of every support [N]
  virtual Elongation elongation(int term, double load_factor) const = 0;

  // Changes the damage stages of the event's terms, holds parts that this frees, and closes and opens crack faces until
  // they agree with their gaps. `terms` holds values before the event. `outcome` gets the numbers of freed parts and
  // switched faces. Returns null and changes nothing if this body cannot perform the event.
  virtual std::optional<BodyChange> change(const Event& event, std::span<const ChangingTerm> terms,
                                           Outcome& outcome) = 0;
};

// Performs an event on `body`, which is the body `whole` or a window of it, at the event's load factor; null if `body`
// cannot perform it. The caller adds to the outcome the work before the event, the residual, and the extensions of
// crack lines.
std::optional<Outcome> perform_event(const Event& event, const LoadedBody& whole, EventBody& body);

}  // namespace bempd::fracture

#include "fracture/event_body.hpp"

#include <algorithm>

#include "fracture/balance.hpp"

namespace bempd::fracture {

namespace {

std::vector<ChangingTerm> changing_terms(const Event& event, const coupling::EquilibriumSystem& system,
                                         const EventBody& body) {
  std::vector<ChangingTerm> result;
  result.reserve(event.changes.size());
  for (const coupling::StageChange& change : event.changes) {
    const auto term = static_cast<std::size_t>(change.term);
    result.push_back({change.term, system.stages().stiffness()[term] - system.stages().stiffness_after(change),
                      body.elongation(change.term, event.load_factor)});
  }
  return result;
}

// Potential energy lost in an event. The potential energy is a quadratic function of the displacements that is least in
// equilibrium. It falls by k e e' / 2 if a term loses the stiffness k while its elastic elongation grows from e to e'.
double released_energy(const std::vector<ChangingTerm>& terms, const BodyChange& change, const EventBody& body,
                       double load_factor) {
  double sum = change.released_before_terms;
  for (const ChangingTerm& term : terms) {
    sum += 0.5 * term.stiffness_lost * term.before.elastic * body.elongation(term.term, load_factor).elastic;
  }
  for (const double energy : change.released_after_terms) sum += energy;
  return sum;
}

}  // namespace

std::optional<Outcome> perform_event(const Event& event, const LoadedBody& whole, EventBody& body) {
  const coupling::EquilibriumSystem& system = whole.system();
  const SupportForces& supports = whole.supports();
  const double f = event.load_factor;
  Outcome outcome;
  outcome.reactions_before = body.reactions(f);
  outcome.resistance_before = supports.resistance(outcome.reactions_before, f);
  outcome.stored_energy_before = body.stored_energy(f);
  outcome.broken = system.stages().count_broken(event.changes);
  const std::vector<ChangingTerm> terms = changing_terms(event, system, body);
  const std::optional<BodyChange> change = body.change(event, terms, outcome);
  if (!change) return std::nullopt;
  outcome.work = change->work;
  outcome.stored_energy = body.stored_energy(f);
  const double released = released_energy(terms, *change, body, f);
  // A piece that comes free takes its loads along, with their potential energy. The released energy is then the work of
  // the loads less the increase of the stored energy; otherwise it is the sum over the changed terms.
  outcome.released_energy =
      change->takes_loads_along ? outcome.work + outcome.stored_energy_before - outcome.stored_energy : released;
  // The energy of the bonds counts as released at the critical load, so that it does not matter whether the load is
  // held or falls.
  outcome.bond_energy = released / (event.ratio * event.ratio);
  if (event.taken_energy > 0) outcome.bond_energy = std::min(outcome.bond_energy, event.taken_energy);
  outcome.critical_stored_energy = body.stored_energy(event.critical_load_factor);
  outcome.unit_energy = body.unit_energy();
  outcome.energy_scale = least_energy_scale(system, f);
  outcome.reactions = body.reactions(f);
  outcome.resistance = supports.resistance(outcome.reactions, f);
  return outcome;
}

}  // namespace bempd::fracture

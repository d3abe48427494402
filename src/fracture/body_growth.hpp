#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "fracture/event_sources.hpp"
#include "fracture/inner_work.hpp"
#include "fracture/run_records.hpp"

namespace bempd::fracture {

// Event at which crack tips in boundary elements have grown.
struct Growth {
  double ratio = 1;  // largest ratio of equivalent stress intensity factor to toughness, before the event
  double critical_load_factor = 0;  // at which the tip with that ratio just reached its toughness
  double surface_energy = 0;        // fracture energy times new area [J]
  double beyond_path = 0;           // BodyGrowth::released_beyond_path() of the event [J]
  std::vector<CrackExtension> extensions;
  int ties = 0;  // other tips that would have grown at the same load factor
};

// Relation of the nodes and terms (bonds and cell squares) of the body in which a run continues to those of the body
// before it.
struct FormerBody {
  std::vector<int> node;      // by present node: node of the body before at the same place, or a close one
  std::vector<int> node_now;  // by node of the body before: present node at the same place, or a close one; -1: none
  // Numbers of terms in the present body by their numbers in the body before; empty: all terms keep their numbers. The
  // map contains all terms that have changed their damage stage, except terms of lattices that boundary elements have
  // replaced.
  std::optional<std::unordered_map<int, int>> terms;
  bool has_fewer_terms = false;  // boundary elements have replaced a part of a lattice and carry a crack there

  // Number in the present body of a term of the body before; -1 if the term no longer exists.
  int new_number(int term) const {
    if (!terms) return term;
    if (!has_fewer_terms) return terms->at(term);
    const auto found = terms->find(term);
    return found == terms->end() ? -1 : found->second;
  }
};

// Continuation of a run in a new body, after cracks in boundary elements have grown or lattice patches (lattices that
// follow crack tips) have been enlarged. The object belongs to the new body.
class BodyGrowth {
 public:
  BodyGrowth(EvolutionState& state, LoadedBody& body, EventSources& sources, const InnerWork& inner_work,
             RunRecords& records)
      : system_(body.system()),
        state_(state),
        body_(body),
        sources_(sources),
        inner_work_(inner_work),
        records_(records) {}

  // Continues the run of the body `before` at its load factor. `former` relates that body to this one; `entering` are
  // crack tips that have entered a lattice. book() or book_layout() has to follow.
  void go_on_from(BodyGrowth& before, const FormerBody& former, const std::vector<crack::TipId>& entering);
  // Energy that the growth would release at constant loads [J].
  double released() const { return outcome_.released_energy; }
  // Part of released() beyond the energy that the growth releases along the equilibrium path, on which the load factor
  // changes to `load_factor` meanwhile [J].
  double released_beyond_path(const BodyGrowth& before, double load_factor) const;
  // Enters the growth of cracks in the history as an event.
  void book(const Growth& growth);
  // Enters an enlargement of lattice patches in the history, as an entry without an event. `layout` is the entry of
  // EvolutionState::layouts that describes the enlargement. Larger lattices store slightly more or less energy at the
  // same loads; the difference counts as work, as if the lattices had been there before.
  void book_layout(std::int64_t layout);
  // Change of the stored energy by an enlargement of lattice patches [J].
  double stored_by_layout() const { return outcome_.stored_energy - outcome_.stored_energy_before; }

 private:
  double potential_at(double load_factor) const;
  LoadedBody::FirstEquilibrium find_equilibrium_of_pieces();
  void take_over_faces(LoadedBody& then, const FaceState& old, const FormerBody& former);
  void take_over_lattices(const BodyState& old, const FormerBody& former, const std::vector<crack::TipId>& entering);
  void take_over_body(const BodyState& old, const FormerBody& former, const std::vector<crack::TipId>& entering);

  coupling::EquilibriumSystem& system_;
  EvolutionState& state_;
  LoadedBody& body_;
  EventSources& sources_;
  const InnerWork& inner_work_;
  RunRecords& records_;
  Outcome outcome_;  // outcome of the growth that is to be booked
};

}  // namespace bempd::fracture

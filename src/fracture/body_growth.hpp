#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "fracture/event_sources.hpp"
#include "fracture/inner_work.hpp"
#include "fracture/run_records.hpp"

namespace bempd::fracture {

// Event at which tips with boundary elements have grown.
struct Growth {
  double ratio = 1;                 // largest equivalent stress intensity factor over the toughness, before it
  double critical_load_factor = 0;  // at which that tip just reached its toughness
  double surface_energy = 0;        // fracture energy times new area [J]
  double beyond_path = 0;           // of the energy released, as BodyGrowth::released_beyond_path() has it [J]
  std::vector<CrackExtension> extensions;
  int ties = 0;  // tips that would have grown as soon
};

// How the nodes and terms of a body that goes on are related to those of the body before.
struct FormerBody {
  std::vector<int> node;      // by node: the one at the same place before, or a close one
  std::vector<int> node_now;  // by node before: the one at the same place, or a close one; -1: there is none
  // New numbers of terms, by those before. All that have changed are known, but for those of lattices that elements
  // have replaced; empty: every term has the same number.
  std::optional<std::unordered_map<int, int>> terms;
  bool has_fewer_terms = false;  // elements have replaced a part of a lattice, and carry a crack there

  // New number of a term; -1 if it is gone.
  int new_number(int term) const {
    if (!terms) return term;
    if (!has_fewer_terms) return terms->at(term);
    const auto found = terms->find(term);
    return found == terms->end() ? -1 : found->second;
  }
};

// Growth of cracks with boundary elements, or of lattices that follow tips, at which a run goes on in another body,
// prepared anew. This is the body that goes on.
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

  // Continues the run of another body (`before`) whose cracks or lattices have grown since, at its load factor.
  // `entering` are tips that have entered a lattice. book() has to follow.
  void go_on_from(BodyGrowth& before, const FormerBody& former, const std::vector<crack::TipId>& entering);
  // Energy released by the growth at constant loads; and the part of it that exceeds the release along the equilibrium
  // path, on which the load factor changes to `load_factor` [J].
  double released() const { return outcome_.released_energy; }
  double released_beyond_path(const BodyGrowth& before, double load_factor) const;
  // Enters a growth in the history as an event.
  void book(const Growth& growth);
  // Enters larger lattices in the history, as a line of their own: by `layout`, an entry of
  // EvolutionState::layouts, they have grown. They store a little
  // more or less energy at the same loads. Nothing has released or done that: work counts as if the lattices had been
  // there before.
  void book_layout(std::int64_t layout);
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
  Outcome outcome_;  // of the growth that is to be booked
};

}  // namespace bempd::fracture

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/inner_work.hpp"
#include "fracture/loaded_body.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Records of a run: work and energies, resistance of the body, extensions of cracks, and entries of the history. They
// are kept in the state.
class RunRecords {
 public:
  RunRecords(EvolutionState& state, LoadedBody& body, const InnerWork& inner_work)
      : state_(state), body_(body), inner_work_(inner_work) {}

  // Lengths of the cracks that the host described.
  void set_lengths(std::vector<pd::CrackLength> lengths) { lengths_ = std::move(lengths); }
  // Sets the mode of stepping. Only in the mode `events` does the excess work of an event out of equilibrium become
  // kinetic energy.
  void set_mode(SteppingMode mode) { mode_ = mode; }

  // Sums, and sizes of lists, at the start of a call to which a failed call returns.
  struct Start {
    Sums sums;
    std::size_t history_size, extensions_size;
  };
  Start start() const { return {state_, state_.history.size(), state_.extensions.size()}; }
  void forget_since(const Start& start) noexcept;

  // Adds the work of loads and supports while the load factor changes without an event.
  void add_work(double work);
  double work() const;  // work of loads and supports so far [J]
  // Updates the largest work so far, the scale of energy errors.
  void measure_work();

  void book(const Event& event, const Outcome& outcome);
  // Books a contact event, at which nothing breaks.
  void book_contact(const Outcome& outcome);
  // Books an equilibrium under new loads.
  void book(LoadedBody::FirstEquilibrium found);
  // Adds the extensions of tips in boundary elements at the last event.
  void add_extensions(const std::vector<CrackExtension>& extensions);
  // Ends a step with an entry of the history, for a state that is up to date.
  void end_step();

  void set_separated() { state_.separated = true; }

  // Notes nodes of parts that could move freely in the last equilibrium under new loads and have been held by springs
  // from there on. take_held() returns the list and clears it.
  void set_held(std::vector<int> nodes) { held_ = std::move(nodes); }
  std::vector<int> take_held() { return std::exchange(held_, {}); }

 private:
  double work_that_moves(const Event& event, const Outcome& outcome);
  void book_lines(const Outcome& outcome, double released_energy);
  void find_lost_work(double stored_energy);
  void note_separation(const Outcome& outcome);
  // Adds an entry to the history. Throws Error (unsolvable) if its forces or energies do not balance.
  void write_line(const HistoryEntry& line, double energy_scale, const std::vector<double>& reactions_before,
                  const std::vector<double>& reactions);

  EvolutionState& state_;
  LoadedBody& body_;
  const InnerWork& inner_work_;
  std::vector<pd::CrackLength> lengths_;
  std::vector<int> held_;
  SteppingMode mode_ = SteppingMode::events;
};

}  // namespace bempd::fracture

// Records of a run: work and energies, resistance of the body, and lines of the history.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/balance.hpp"
#include "fracture/crack_evolution.hpp"
#include "fracture/resistance.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

// Excess work of an event out of equilibrium: the part of the loads' work that the bonds do not absorb. It becomes
// kinetic energy, so it counts neither as released by breaking nor as work of a quasi-static run.
double CrackEvolution::work_that_moves(const Event& event, const Outcome& outcome) {
  if (mode_ != SteppingMode::events || !event.is_out_of_balance()) {
    state_.work_out_of_balance = 0;
    return 0;
  }
  const double given = std::max(0.0, state_.work_out_of_balance + outcome.work);
  const double moved = std::clamp(outcome.released_energy - outcome.bond_energy, 0.0, given);
  state_.work_out_of_balance = given - moved;
  return moved;
}

void CrackEvolution::book(const Event& event, const Outcome& outcome) {
  const double moved = work_that_moves(event, outcome);
  state_.work += outcome.work_before;
  find_lost_work(outcome.stored_energy_before);
  HistoryEntry line;
  line.load_factor_before = state_.load_factor;
  line.stored_energy_before = in_range(outcome.stored_energy_before + outcome.within_before);
  line.work_before = in_range(state_.work + outcome.within_before);
  line.resistance_before = borne_before(event, outcome);
  line.resistance = outcome.resistance;
  state_.work = in_range(state_.work + (outcome.work - moved));
  state_.released_energy = in_range(state_.released_energy + (outcome.released_energy - moved));
  state_.bond_energy = in_range(state_.bond_energy + outcome.bond_energy);
  ++state_.events;
  state_.broken_bonds += outcome.broken;
  state_.fragments += outcome.fragments;
  state_.contact_switches += outcome.switches;
  state_.ties += outcome.ties;
  book_lines(outcome, outcome.released_energy - moved);
  add(state_.resistance, event, outcome, state_.separated);
  note_separation(outcome);
  line.event = state_.events;
  line.ties = outcome.ties;
  line.stretch_ratio = event.ratio;
  line.stored_energy = outcome.stored_energy;
  line.critical_load_factor = event.critical_load_factor;
  line.critical_stored_energy = in_range(outcome.critical_stored_energy + within(event.critical_load_factor));
  line.residual = outcome.residual;
  write_line(line, outcome.energy_scale, outcome.reactions_before, outcome.reactions);
}

// Records a contact event, at which nothing breaks.
void CrackEvolution::pass(const Outcome& outcome) {
  state_.work = in_range(state_.work + outcome.work_before);
  measure_work();
  state_.contact_switches += outcome.switches;
  // Closed faces may be all that holds the undamaged scene; its energy is then larger after they close.
  if (state_.events == 0) state_.first_unit_energy = std::max(state_.first_unit_energy, body_.unit_energy());
  if (!outcome.comes_free) return;
  state_.work = in_range(state_.work + outcome.work);
  state_.released_energy = in_range(state_.released_energy + outcome.released_energy);
  state_.fragments += outcome.fragments;
  note_separation(outcome);
}

void CrackEvolution::note_separation(const Outcome& outcome) {
  if (is_separated(system_, outcome.unit_energy, state_.first_unit_energy) || is_balance_lost(outcome.lost_balance))
    state_.separated = true;
}

// Restores the work after it was beyond the range of numbers, as the sum of the stored and the released energy.
void CrackEvolution::find_lost_work(double stored_energy) {
  const auto is_lost = [](double energy) { return !(std::abs(energy) < std::numeric_limits<double>::max()); };
  if (!is_lost(state_.work) || is_lost(stored_energy) || is_lost(state_.released_energy)) return;
  state_.work = stored_energy + state_.released_energy;
  state_.largest_work = 0;
}

void CrackEvolution::end_step() {
  sources_.bring_up_to_date();
  HistoryEntry line;
  line.stored_energy = body_.stored_energy();
  line.critical_load_factor = state_.load_factor;
  line.critical_stored_energy = in_range(line.stored_energy + within(state_.load_factor));
  line.residual = body_.residual();
  const std::vector<double> reactions = body_.reactions();
  line.load_factor_before = state_.load_factor;
  line.stored_energy_before = line.critical_stored_energy;
  find_lost_work(line.stored_energy);
  line.work_before = work();
  line.resistance_before = line.resistance = body_.resistance(reactions);
  write_line(line, least_energy_scale(system_, state_.load_factor), reactions, reactions);
}

void CrackEvolution::write_line(const HistoryEntry& known, double energy_scale,
                                const std::vector<double>& reactions_before, const std::vector<double>& reactions) {
  HistoryEntry line = known;
  line.total_broken_bonds = state_.broken_bonds;
  line.load_factor = state_.load_factor;
  line.stored_energy = in_range(line.stored_energy);
  find_lost_work(line.stored_energy);
  line.released_energy = state_.released_energy;
  line.bond_energy = state_.bond_energy;
  const double difference = std::abs(state_.work - line.stored_energy - state_.released_energy);
  line.stored_energy = in_range(line.stored_energy + within(state_.load_factor));
  line.work = work();
  state_.largest_work = std::max(state_.largest_work, std::abs(line.work));
  const double scale = std::max({state_.largest_work, energy_scale, least_scale_within(state_.load_factor)});
  line.energy_balance_error = scale > 0 ? difference / scale : difference;
  if (!std::isfinite(line.energy_balance_error)) line.energy_balance_error = 0;  // of energies that are lost
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(reactions.begin(), reactions.end(), is_finite) || !is_finite(line.load_factor) ||
      !is_finite(line.stretch_ratio) || !is_finite(line.residual)) {
    fail_out_of_range();
  }
  require_balance(line.residual, system_.is_symmetric() ? line.energy_balance_error : 0);
  state_.worst_energy_balance_error = std::max(state_.worst_energy_balance_error, line.energy_balance_error);
  state_.residual = line.residual;
  state_.history.push_back(line);
  const auto append = [](std::vector<double>& all, const std::vector<double>& here) {
    all.insert(all.end(), here.begin(), here.end());
  };
  append(state_.reactions_before, reactions_before);
  append(state_.reactions, reactions);
  append(state_.support_displacements, body_.support_displacements());
}

}  // namespace bempd::fracture

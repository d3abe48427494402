#include "fracture/run_records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/balance.hpp"
#include "fracture/resistance.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

void RunRecords::forget_since(const Start& start) noexcept {
  static_cast<Sums&>(state_) = start.sums;
  state_.history.resize(start.history_size);
  const std::size_t values = 2 * body_.supports().dofs().own.size() * start.history_size;
  for (std::vector<double>* of_supports : {&state_.reactions, &state_.reactions_before, &state_.support_displacements})
    of_supports->resize(values);
  state_.extensions.resize(start.extensions_size);
}

// The largest work so far is the scale of energy errors, because the present work may come back to zero when loads are
// taken away.
void RunRecords::measure_work() { state_.largest_work = std::max(state_.largest_work, std::abs(work())); }

double RunRecords::work() const { return in_range(state_.work + inner_work_.at(state_.load_factor)); }

void RunRecords::add_work(double work) { state_.work = in_range(state_.work + work); }

void RunRecords::book(LoadedBody::FirstEquilibrium found) {
  held_ = std::move(found.held);
  state_.fragments += found.fragments;
  state_.contact_switches += found.switches;
  state_.work = in_range(state_.work + found.work);
  measure_work();
}

void RunRecords::add_extensions(const std::vector<CrackExtension>& extensions) {
  for (const CrackExtension& extension : extensions) {
    state_.extensions.push_back(extension);
    state_.extensions.back().event = state_.events;
  }
}

// Excess work of an event out of equilibrium: the part of the loads' work that the bonds do not absorb. The excess
// becomes kinetic energy, so that it counts neither as energy released by breaking nor as work of a quasi-static run.
double RunRecords::work_that_moves(const Event& event, const Outcome& outcome) {
  if (mode_ != SteppingMode::events || !event.is_out_of_balance()) {
    state_.work_out_of_balance = 0;
    return 0;
  }
  const double given = std::max(0.0, state_.work_out_of_balance + outcome.work);
  const double moved = std::clamp(outcome.released_energy - outcome.bond_energy, 0.0, given);
  state_.work_out_of_balance = given - moved;
  return moved;
}

void RunRecords::book(const Event& event, const Outcome& outcome) {
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
  line.critical_stored_energy = in_range(outcome.critical_stored_energy + inner_work_.at(event.critical_load_factor));
  line.residual = outcome.residual;
  write_line(line, outcome.energy_scale, outcome.reactions_before, outcome.reactions);
}

void RunRecords::book_contact(const Outcome& outcome) {
  state_.work = in_range(state_.work + outcome.work_before);
  measure_work();
  state_.contact_switches += outcome.switches;
  // first_unit_energy is the energy of the proportional load with which later values are compared (is_separated()). The
  // largest value before the first event counts, because a body that only closed faces hold stores hardly any energy
  // until the faces close.
  if (state_.events == 0) state_.first_unit_energy = std::max(state_.first_unit_energy, body_.response().unit_energy());
  if (!outcome.comes_free) return;
  state_.work = in_range(state_.work + outcome.work);
  state_.released_energy = in_range(state_.released_energy + outcome.released_energy);
  state_.fragments += outcome.fragments;
  note_separation(outcome);
}

// Records the extensions of crack lines at an event. Each extension gets a share of the energy in proportion to its
// length.
void RunRecords::book_lines(const Outcome& outcome, double released_energy) {
  double length = 0;
  for (const CrackExtension& extension : outcome.extensions) length += extension.length;
  for (CrackExtension extension : outcome.extensions) {
    const auto& all = state_.extensions;
    const auto last =
        std::find_if(all.rbegin(), all.rend(), [&](const auto& other) { return other.crack == extension.crack; });
    const auto number = static_cast<std::size_t>(extension.crack - 1);
    const pd::CrackLength described = number < lengths_.size() ? lengths_[number] : pd::CrackLength();
    const bool is_first = std::ranges::none_of(all, [&](const auto& other) { return other.tip() == extension.tip(); });
    extension.event = state_.events;
    extension.crack_length = (last != all.rend() ? last->crack_length : described.length) + extension.length;
    if (is_first) extension.crack_length += described.to_cut[static_cast<std::size_t>(extension.end)];
    extension.released_energy = released_energy * extension.length / length;
    // A last ligament may release more than its fracture energy at a constant load factor; the excess becomes kinetic
    // energy.
    const double taken = outcome.bond_energy * extension.length / length;
    const double most = extension.has_ended() ? extension.surface_energy : taken;
    state_.bond_energy -= std::max(0.0, taken - most);
    extension.surface_energy = std::min(taken, most);
    state_.extensions.push_back(extension);
  }
}

void RunRecords::note_separation(const Outcome& outcome) {
  if (is_separated(body_.system(), outcome.unit_energy, state_.first_unit_energy) ||
      is_balance_lost(outcome.lost_balance))
    state_.separated = true;
}

// Sets the work to the sum of the stored and the released energy if the work has left the range of numbers and these
// energies have not.
void RunRecords::find_lost_work(double stored_energy) {
  const auto is_lost = [](double energy) { return !(std::abs(energy) < std::numeric_limits<double>::max()); };
  if (!is_lost(state_.work) || is_lost(stored_energy) || is_lost(state_.released_energy)) return;
  state_.work = stored_energy + state_.released_energy;
  state_.largest_work = 0;
}

void RunRecords::end_step() {
  HistoryEntry line;
  line.stored_energy = body_.response().stored_energy();
  line.critical_load_factor = state_.load_factor;
  line.critical_stored_energy = in_range(line.stored_energy + inner_work_.at(state_.load_factor));
  line.residual = body_.response().residual();
  const std::vector<double> reactions = body_.supports().reactions();
  line.load_factor_before = state_.load_factor;
  line.stored_energy_before = line.critical_stored_energy;
  find_lost_work(line.stored_energy);
  line.work_before = work();
  line.resistance_before = line.resistance = body_.supports().resistance(reactions);
  write_line(line, least_energy_scale(body_.system(), state_.load_factor), reactions, reactions);
}

void RunRecords::write_line(const HistoryEntry& known, double energy_scale, const std::vector<double>& reactions_before,
                            const std::vector<double>& reactions) {
  HistoryEntry line = known;
  line.total_broken_bonds = state_.broken_bonds;
  line.load_factor = state_.load_factor;
  line.stored_energy = in_range(line.stored_energy);
  find_lost_work(line.stored_energy);
  line.released_energy = state_.released_energy;
  line.bond_energy = state_.bond_energy;
  const double difference = std::abs(state_.work - line.stored_energy - state_.released_energy);
  line.stored_energy = in_range(line.stored_energy + inner_work_.at(state_.load_factor));
  line.work = work();
  state_.largest_work = std::max(state_.largest_work, std::abs(line.work));
  const double scale = std::max({state_.largest_work, energy_scale, inner_work_.least_scale(state_.load_factor)});
  line.energy_balance_error = scale > 0 ? difference / scale : difference;
  if (!std::isfinite(line.energy_balance_error)) line.energy_balance_error = 0;  // energies beyond the range of numbers
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(reactions.begin(), reactions.end(), is_finite) || !is_finite(line.load_factor) ||
      !is_finite(line.stretch_ratio) || !is_finite(line.residual)) {
    fail_out_of_range();
  }
  require_balance(line.residual, body_.system().is_symmetric() ? line.energy_balance_error : 0);
  state_.worst_energy_balance_error = std::max(state_.worst_energy_balance_error, line.energy_balance_error);
  state_.residual = line.residual;
  state_.history.push_back(line);
  const auto append = [](std::vector<double>& all, const std::vector<double>& here) {
    all.insert(all.end(), here.begin(), here.end());
  };
  append(state_.reactions_before, reactions_before);
  append(state_.reactions, reactions);
  append(state_.support_displacements, body_.supports().displacements());
}

}  // namespace bempd::fracture

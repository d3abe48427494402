#include "results/history_table.hpp"

#include "output/csv.hpp"
#include "output/file.hpp"
#include "results/writing.hpp"

namespace bempd::results {

namespace {

void add_columns(std::vector<std::string>& columns, const std::vector<SupportColumns>& supports,
                 std::initializer_list<const char*> values) {
  for (std::size_t s = 0; s < supports.size(); ++s)
    for (const char* value : values) {
      if (!supports[s].there) continue;
      const std::string& name = supports[s].name;
      columns.push_back(name.empty() ? text(value, s + 1) : text(value, s + 1, " (", name, ")"));
    }
}

}  // namespace

void write_history(const std::string& path, const fracture::EvolutionState* state,
                   const std::vector<SupportColumns>& supports) {
  std::vector<std::string> columns{"event",         "load_factor",          "total_broken_bonds",
                                   "stretch_ratio", "stored_energy",        "released_energy",
                                   "work",          "energy_balance_error", "residual"};
  add_columns(columns, supports, {"reaction_x_", "reaction_y_"});
  // New columns come last, so that programs that count columns find the older columns in their places.
  columns.insert(columns.end(), {"critical_load_factor", "critical_stored_energy", "bond_energy", "load_factor_before",
                                 "stored_energy_before", "work_before", "resistance_before", "resistance", "ties"});
  add_columns(columns, supports, {"reaction_before_x_", "reaction_before_y_", "displacement_x_", "displacement_y_"});
  output::CsvTable table(columns);
  const std::size_t lines = state ? state->history.size() : 0;
  for (std::size_t i = 0; i < lines; ++i) {
    const fracture::HistoryEntry& h = state->history[i];
    std::vector<output::CsvValue> row{h.event,         h.load_factor,          h.total_broken_bonds,
                                      h.stretch_ratio, h.stored_energy,        h.released_energy,
                                      h.work,          h.energy_balance_error, h.residual};
    for (std::size_t s = 0; s < supports.size(); ++s) {
      if (!supports[s].there) continue;
      const std::size_t at = 2 * (supports.size() * i + s);
      row.emplace_back(state->reactions[at]);
      row.emplace_back(state->reactions[at + 1]);
    }
    row.insert(row.end(), {h.critical_load_factor, h.critical_stored_energy, h.bond_energy, h.load_factor_before,
                           h.stored_energy_before, h.work_before, h.resistance_before, h.resistance, h.ties});
    for (std::size_t s = 0; s < supports.size(); ++s) {
      if (!supports[s].there) continue;
      const std::size_t at = 2 * (supports.size() * i + s);
      for (const std::vector<double>* values : {&state->reactions_before, &state->support_displacements})
        row.insert(row.end(), {(*values)[at], (*values)[at + 1]});
    }
    table.add_row(row);
  }
  writing([&] { table.save(output::path_from_utf8(path)); });
}

}  // namespace bempd::results

#include <algorithm>
#include <cmath>
#include <limits>

#include "capi/guard.hpp"
#include "model/present_errors.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

regions::Field field_of(std::int32_t field) {
  require(field >= BEMPD_POSITION && field <= BEMPD_STRESS_ORDER, "field is ", field,
          "; it must be a bempd_field, 1 .. 8");
  return static_cast<regions::Field>(field);
}

void require_capacity(std::int64_t capacity, std::int64_t needed, const char* what) {
  require(capacity >= needed, "capacity is ", capacity, "; ", needed, " ", what, " are needed");
}

Point finite_point(double x, double y) {
  require(std::isfinite(x) && std::isfinite(y), "the point is (", x, ", ", y, "); give finite coordinates");
  return {x, y};
}

// State of a run whose history has the line `index`; throws Error (argument) if there is no such line.
const fracture::EvolutionState& state_with_history_line(const model::Model& m, std::int64_t index) {
  const model::PreparedScene* p = m.prepared_or_null();
  require_index(index, p ? p->evolution->progress().history.size() : 0, "; the history has ", " lines");
  return p->evolution->progress();
}

bempd_status get_history_entry(const bempd_model* model, const char* function, std::int64_t index,
                               bempd_history_entry* entry) {
  return with_model(model, function, [&](const model::Model& m) {
    const fracture::HistoryEntry& h = state_with_history_line(m, index).history[static_cast<std::size_t>(index)];
    write_struct(entry,
                 {
                     .struct_size = sizeof(bempd_history_entry),
                     .event = h.event,
                     .total_broken_bonds = h.total_broken_bonds,
                     .load_factor = h.load_factor,
                     .stretch_ratio = h.stretch_ratio,
                     .stored_energy = h.stored_energy,
                     .released_energy = h.released_energy,
                     .work = h.work,
                     .energy_balance_error = h.energy_balance_error,
                     .residual = h.residual,
                     .critical_load_factor = h.critical_load_factor,
                     .critical_stored_energy = h.critical_stored_energy,
                     .bond_energy = h.bond_energy,
                     .load_factor_before = h.load_factor_before,
                     .stored_energy_before = h.stored_energy_before,
                     .work_before = h.work_before,
                     .resistance_before = h.resistance_before,
                     .resistance = h.resistance,
                     .ties = h.ties,
                 },
                 "entry");
  });
}

}  // namespace

bempd_status bempd_admissible_load_factors(bempd_model* model, double* lowest, double* highest) {
  return with_model(model, __func__, [&](model::Model& m) {
    double &low = out(lowest, "lowest"), &high = out(highest, "highest");
    constexpr double largest = std::numeric_limits<double>::max();
    const fracture::LoadInterval admissible = m.driver().admissible_load_factors();
    low = std::clamp(admissible.lowest, -largest, largest);
    high = std::clamp(admissible.highest, -largest, largest);
  });
}

bempd_status bempd_load_factor(const bempd_model* model, double* load_factor) {
  return with_model(model, __func__, [&](const model::Model& m) { out(load_factor, "load_factor") = m.load_factor(); });
}

bempd_status bempd_generation(const bempd_model* model, int64_t* generation) {
  return with_model(model, __func__, [&](const model::Model& m) { out(generation, "generation") = m.generation(); });
}

bempd_status bempd_node_count(bempd_model* model, int32_t region, int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = m.results().field_size(region, regions::Field::position).count;
  });
}

bempd_status bempd_element_count(bempd_model* model, int32_t region, int64_t* count) {
  return with_model(model, __func__,
                    [&](model::Model& m) { out(count, "count") = m.results().region(region).results().cell_count(); });
}

bempd_status bempd_copy_elements(bempd_model* model, int32_t region, int64_t capacity, int32_t* nodes) {
  return with_model(model, __func__, [&](model::Model& m) {
    const std::vector<std::int32_t> elements = m.results().region(region).results().cells().nodes;
    require_capacity(capacity, static_cast<std::int64_t>(elements.size()), "integers");
    std::copy(elements.begin(), elements.end(), &out(nodes, "nodes"));
  });
}

bempd_status bempd_field_size(bempd_model* model, int32_t region, int32_t field, int64_t* count, int32_t* components) {
  return with_model(model, __func__, [&](model::Model& m) {
    const regions::FieldSize size = m.results().field_size(region, field_of(field));
    give(count, size.count);
    give(components, size.components);
  });
}

bempd_status bempd_copy_field(bempd_model* model, int32_t region, int32_t field, int64_t capacity, double* values) {
  return with_model(model, __func__, [&](model::Model& m) {
    const regions::FieldSize size = m.results().field_size(region, field_of(field));
    require_capacity(capacity, size.count * size.components, "numbers");
    out(values, "values");
    const regions::FieldValues& f = m.results().field(region, field_of(field));
    std::copy(f.values.begin(), f.values.end(), values);
  });
}

bempd_status bempd_view_field(bempd_model* model, int32_t region, int32_t field, const double** values, int64_t* count,
                              int32_t* components, int64_t* generation) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(values, "values");
    const regions::FieldValues& f = m.results().field(region, field_of(field));
    *values = f.values.data();
    give(count, f.count());
    give(components, f.components);
    give(generation, m.generation());
  });
}

bempd_status bempd_bond_count(bempd_model* model, int32_t region, int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = static_cast<std::int64_t>(m.results().bonds(region).size());
  });
}

bempd_status bempd_copy_bonds(bempd_model* model, int32_t region, int64_t capacity, int32_t* points, int32_t* states) {
  return with_model(model, __func__, [&](model::Model& m) {
    const auto bonds = m.results().bonds(region);
    require_capacity(capacity, static_cast<std::int64_t>(bonds.size()), "bonds");
    const std::vector<regions::BondState> known = m.results().bond_states(region);
    for (std::size_t b = 0; b < bonds.size(); ++b) {
      if (points) {
        points[2 * b] = bonds[b].first;
        points[2 * b + 1] = bonds[b].second;
      }
      if (states) states[b] = static_cast<std::int32_t>(known[b]);
    }
  });
}

bempd_status bempd_reaction(bempd_model* model, int32_t support, double* force) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(force, "force");
    std::copy_n(m.results().reaction(support).data(), 2, force);
  });
}

bempd_status bempd_reaction_moment(bempd_model* model, int32_t support, double x, double y, double* moment) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(moment, "moment") = m.results().reaction_moment(support, finite_point(x, y));
  });
}

bempd_status bempd_edge_reaction(bempd_model* model, int32_t region, int32_t edge, double x, double y, double* force,
                                 double* moment) {
  return with_model(model, __func__, [&](model::Model& m) {
    const model::EdgeResults::Reaction reaction = m.edges().reaction(region, edge, finite_point(x, y));
    if (force) std::copy_n(reaction.force.data(), 2, force);
    give(moment, reaction.moment);
  });
}

bempd_status bempd_evaluate(bempd_model* model, int64_t count, const double* points, double* displacement,
                            double* stress, int32_t* regions) {
  return with_model(model, __func__, [&](model::Model& m) {
    const auto values = m.results().evaluate(points_from(points, count, "points"), stress != nullptr);
    give_values(values, displacement, stress);
    for (std::size_t i = 0; regions && i < values.size(); ++i) regions[i] = values[i].region;
  });
}

bempd_status bempd_evaluate_in(bempd_model* model, int32_t region, int32_t face, int64_t count, const double* points,
                               double* displacement, double* stress) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.scene().region(region);
    require(face == BEMPD_FACE_LEFT || face == BEMPD_FACE_RIGHT, "face is ", face,
            "; it must be BEMPD_FACE_LEFT (1) or BEMPD_FACE_RIGHT (2)");
    const auto values = m.results().evaluate(points_from(points, count, "points"), stress != nullptr,
                                             {region, face == BEMPD_FACE_RIGHT});
    give_values(values, displacement, stress);
  });
}

bempd_status bempd_evaluate_errors(bempd_model* model, int64_t count, const double* points, double* displacement,
                                   double* stress) {
  return with_model(model, __func__, [&](model::Model& m) {
    const model::PlaceErrors errors = model::errors_at(m, points_from(points, count, "points"), {});
    if (displacement) std::copy(errors.displacement.begin(), errors.displacement.end(), displacement);
    if (stress) std::copy(errors.stress.begin(), errors.stress.end(), stress);
  });
}

bempd_status bempd_statistics_init(bempd_statistics* statistics, int64_t struct_size) {
  return init_struct(__func__, "statistics", statistics, struct_size, {});
}

bempd_status bempd_get_statistics(const bempd_model* model, bempd_statistics* statistics) {
  return with_model(model, __func__, [&](const model::Model& m) {
    bempd_statistics s{};
    s.reciprocal_condition = 1;
    if (const model::PreparedScene* p = m.prepared_or_null()) {
      const auto& c = p->system->counters();
      const regions::RegionStatistics r = p->discretization.statistics();
      s.kernel_evaluations = r.kernel_evaluations + p->interior_kernel_evaluations;
      s.boundary_nodes = r.boundary_nodes;
      s.boundary_elements = r.boundary_elements;
      s.material_points = r.material_points;
      s.bonds = static_cast<int64_t>(p->system->terms().bond_count());
      s.cut_bonds = static_cast<int64_t>(p->cut_bonds.size());
      s.broken_bonds = p->evolution->progress().broken_bonds;
      s.sparse_unknowns = c.sparse_unknowns;
      s.factor_nonzeros = c.factor_nonzeros;
      s.dense_factorizations = c.dense_factorizations;
      s.sparse_factorizations = c.sparse_factorizations;
      s.factor_updates = c.factor_updates;
      s.solves = c.solves;
      s.solver_iterations = c.iterations;
      s.seconds_boundary = r.seconds_boundary;
      s.seconds_lattice = r.seconds_lattice;
      s.seconds_assembly = c.seconds_assembly;
      s.seconds_factorization = c.seconds_factorization;
      s.seconds_solve = c.seconds_solve;
      s.seconds_update = c.seconds_update;
      s.seconds_search = p->evolution->seconds_search();
      s.reciprocal_condition = c.reciprocal_condition;
      s.subdomains = r.subdomains;
      s.cut_nodes = r.cut_nodes;
    }
    write_struct(statistics, s, "statistics");
  });
}

bempd_status bempd_history_entry_init(bempd_history_entry* entry, int64_t struct_size) {
  return init_struct(__func__, "entry", entry, struct_size, {});
}

bempd_status bempd_history_count(const bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) {
    const model::PreparedScene* p = m.prepared_or_null();
    out(count, "count") = p ? static_cast<int64_t>(p->evolution->progress().history.size()) : 0;
  });
}

bempd_status bempd_get_history_entry(const bempd_model* model, int64_t index, bempd_history_entry* entry) {
  return get_history_entry(model, __func__, index, entry);
}

bempd_status bempd_get_history_support(const bempd_model* model, int64_t index, int32_t support, double* displacement,
                                       double* force, double* force_before) {
  return with_model(model, __func__, [&](const model::Model& m) {
    m.scene().support(support);
    const fracture::EvolutionState& state = state_with_history_line(m, index);
    const auto at = 2 * (static_cast<std::ptrdiff_t>(m.scene().supports().size()) * index + support - 1);
    const auto give_pair = [&](const std::vector<double>& values, double* target) {
      if (target) std::copy_n(values.begin() + at, 2, target);
    };
    give_pair(state.support_displacements, displacement);
    give_pair(state.reactions, force);
    give_pair(state.reactions_before, force_before);
  });
}

bempd_status bempd_history(const bempd_model* model, int64_t index, bempd_history_entry* entry) {
  return get_history_entry(model, __func__, index, entry);
}

#include <algorithm>

#include "capi/guard.hpp"
#include "model/step_beginning.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

bempd_stop_reason stop_reason(fracture::StopReason reason) {
  switch (reason) {
    case fracture::StopReason::event:
      return BEMPD_STOP_EVENT;
    case fracture::StopReason::separated:
      return BEMPD_STOP_SEPARATED;
    case fracture::StopReason::no_further_event:
      return BEMPD_STOP_NO_FURTHER_EVENT;
    case fracture::StopReason::no_admissible_load:
      return BEMPD_STOP_NO_ADMISSIBLE_LOAD;
    case fracture::StopReason::no_equilibrium:
      return BEMPD_STOP_NO_EQUILIBRIUM;
    case fracture::StopReason::requested:
      return BEMPD_STOP_REQUESTED;
    case fracture::StopReason::crack_stopped:
      return BEMPD_STOP_CRACK_STOPPED;
    case fracture::StopReason::load_factor:
      break;
  }
  return BEMPD_STOP_LOAD_FACTOR;
}

bempd_step_report report_of(const model::StepResult& result, const fracture::EvolutionState& state) {
  bempd_step_report r{};
  r.stop_reason = stop_reason(result.reason);
  r.separated = state.separated ? 1 : 0;
  r.events = result.events;
  r.broken_bonds = result.broken_bonds;
  r.total_events = state.events;
  r.total_broken_bonds = state.broken_bonds;
  r.fragments = state.fragments;
  r.load_factor = state.load_factor;
  r.stored_energy = state.history.empty() ? 0.0 : state.history.back().stored_energy;
  r.released_energy = state.released_energy;
  r.work = state.history.empty() ? 0.0 : state.history.back().work;
  r.energy_balance_error = state.worst_energy_balance_error;
  r.residual = state.residual;
  r.seconds_total = result.seconds_total;
  r.seconds_solve = result.seconds.solve;
  r.seconds_update = result.seconds.update;
  r.seconds_search = result.seconds.search;
  r.bond_energy = state.bond_energy;
  r.unstable_event = result.unstable_event;
  r.resistance = state.resistance.present;
  r.peak_resistance = state.resistance.peak;
  r.face_switches = result.face_switches;
  r.ties = result.ties;
  r.hanging = result.hanging ? 1 : 0;
  return r;
}

void write_report(model::Model& m, const model::StepResult& result, bempd_step_report* report) {
  if (!report) return;
  const model::PreparedScene* scene = m.prepared_or_null();  // null if the step was stopped while it was prepared
  static const fracture::EvolutionState nothing;
  bempd_step_report r = report_of(result, scene ? scene->evolution->progress() : nothing);
  if (scene) r.closed_places = static_cast<std::int64_t>(scene->system->constraints().closed_count());
  write_struct(report, r, "report");
}

using Step = model::StepResult (model::LoadDriver::*)(double, fracture::Goal);

bempd_status advance(bempd_model* handle, const char* function, const char* target_name, double target,
                     fracture::Goal goal, bempd_step_report* report, Step step = &model::LoadDriver::advance) {
  return with_model(handle, function, [&](model::Model& m) {
    require_finite(target, target_name);
    if (report) struct_bytes(report, "report");
    write_report(m, model::unless_stopped([&] { return (m.driver().*step)(target, goal); }), report);
  });
}

fracture::Goal goal_of(std::int32_t until) {
  switch (until) {
    case BEMPD_UNTIL_VALUES:
      return fracture::Goal::load_factor;
    case BEMPD_UNTIL_EVENT:
      return fracture::Goal::next_event;
    case BEMPD_UNTIL_SEPARATED:
      return fracture::Goal::separation;
    default:
      fail(Failure::argument, "until is ", until,
           "; it must be BEMPD_UNTIL_VALUES (1), BEMPD_UNTIL_EVENT (2) or BEMPD_UNTIL_SEPARATED (3)");
  }
}

constexpr std::int64_t most_rows = std::int64_t{1} << 31;

scene::LoadTable table_of(std::int64_t row_count, const double* times, std::int64_t column_count,
                          const std::int32_t* kinds, const std::int32_t* ids, const double* factors) {
  require(row_count >= 1 && row_count < most_rows, "row_count is ", row_count, "; give at least 1 row");
  require(column_count >= 0 && column_count < most_rows / row_count, "column_count is ", column_count,
          "; give 0 for all supports and loads together, or one column for each that has factors of its own");
  require(times != nullptr, "times is NULL; give row_count increasing times");
  require(factors != nullptr, "factors is NULL; give one for each row and column");
  require(column_count == 0 || (kinds && ids), kinds ? "ids" : "kinds", " is NULL; give one for each column");
  scene::LoadTable table;
  table.times.assign(times, times + row_count);
  table.factors.assign(factors, factors + row_count * std::max<std::int64_t>(1, column_count));
  for (std::int64_t c = 0; c < column_count; ++c) {
    require(kinds[c] == BEMPD_COLUMN_SUPPORT || kinds[c] == BEMPD_COLUMN_LOAD, "kind ", c + 1, " is ", kinds[c],
            "; it must be BEMPD_COLUMN_SUPPORT (1) or BEMPD_COLUMN_LOAD (2)");
    table.columns.push_back({kinds[c] == BEMPD_COLUMN_SUPPORT, ids[c]});
  }
  return table;
}

}  // namespace

bempd_status bempd_set_progress(bempd_model* model, bempd_progress_function function, void* user) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (!function) {
      m.host().set_progress(nullptr);
    } else {
      m.host().set_progress([=](double load_factor, std::int64_t events, std::int64_t broken) {
        return function(load_factor, events, broken, user) == 0;
      });
    }
  });
}

bempd_status bempd_set_phase_progress(bempd_model* model, bempd_phase_function function, void* user) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (!function) {
      m.host().set_phase_progress(nullptr);
    } else {
      m.host().set_phase_progress([=](const char* phase, double share, double seconds, double expected) {
        return function(phase, share, seconds, expected, user) == 0;
      });
    }
  });
}

bempd_status bempd_set_log(bempd_model* model, bempd_log_function function, void* user) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (!function) {
      m.host().set_log(nullptr);
    } else {
      m.host().set_log([=](int level, const std::string& message) { function(level, message.c_str(), user); });
    }
  });
}

bempd_status bempd_request_cancel(bempd_model* model) {
  // Another call may be running on the model, so this one only sets an atomic flag.
  if (!model) return with_model(model, __func__, [](model::Model&) {});
  model->engine.host().request_cancel();
  return BEMPD_OK;
}

bempd_status bempd_request_stop(bempd_model* model) {
  // Another call may be running on the model, so this one only sets an atomic flag.
  if (!model) return with_model(model, __func__, [](model::Model&) {});
  model->engine.host().request_stop();
  return BEMPD_OK;
}

bempd_status bempd_step_report_init(bempd_step_report* report, int64_t struct_size) {
  return init_struct(__func__, "report", report, struct_size, {});
}

bempd_status bempd_prepare(bempd_model* model) {
  return with_model(model, __func__, [](model::Model& m) { m.prepare(); });
}

bempd_status bempd_step(bempd_model* model, double load_factor, bempd_step_report* report) {
  return advance(model, __func__, "load_factor", load_factor, fracture::Goal::load_factor, report);
}

bempd_status bempd_step_to_next_event(bempd_model* model, double load_factor_limit, bempd_step_report* report) {
  return advance(model, __func__, "load_factor_limit", load_factor_limit, fracture::Goal::next_event, report);
}

bempd_status bempd_run_to_separation(bempd_model* model, double load_factor_limit, bempd_step_report* report) {
  return advance(model, __func__, "load_factor_limit", load_factor_limit, fracture::Goal::separation, report);
}

bempd_status bempd_step_to_values(bempd_model* model, double load_factor, int32_t until, bempd_step_report* report) {
  fracture::Goal goal{};
  const bempd_status known = with_model(model, __func__, [&](model::Model&) { goal = goal_of(until); });
  if (known != BEMPD_OK) return known;
  return advance(model, __func__, "load_factor", load_factor, goal, report, &model::LoadDriver::advance_to_values);
}

bempd_status bempd_run_program(bempd_model* model, int64_t row_count, const double* times, int64_t column_count,
                               const int32_t* kinds, const int32_t* ids, const double* factors, int32_t until,
                               bempd_step_report* report) {
  return with_model(model, __func__, [&](model::Model& m) {
    const scene::LoadTable table = table_of(row_count, times, column_count, kinds, ids, factors);
    const fracture::Goal goal = goal_of(until);
    if (report) struct_bytes(report, "report");
    write_report(m, model::unless_stopped([&] { return m.driver().run_program(table, goal); }), report);
  });
}

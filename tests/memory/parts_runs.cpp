// Calls that run, ask for results and keep states.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "parts.hpp"

namespace memory_test {

namespace {

// The first `count` of the numbers that a call has given.
auto first(std::size_t count) {
  return [count](Host& h) {
    return std::vector<double>(h.numbers.begin(), h.numbers.begin() + static_cast<std::ptrdiff_t>(count));
  };
}

std::vector<double> file_size(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  return {file ? static_cast<double>(file.tellg()) : -1.0};
}

void count_line(int32_t, const char*, void* user) { ++static_cast<Host*>(user)->lines_logged; }
int32_t go_on(double, int64_t, int64_t, void*) { return 0; }
int32_t stop(double, int64_t, int64_t, void*) { return 1; }

// What a step reports, and what its state is.
template <class Step>
Call stepping(const char* name, const Step& advance) {
  return {name,
          [advance](Host& h) {
            bempd_step_report report;
            bempd_step_report_init(&report, sizeof report);
            const bempd_status status = advance(h, report);
            h.numbers[0] = static_cast<double>(report.total_broken_bonds);
            h.numbers[1] = report.load_factor;
            h.numbers[2] = report.work;
            h.numbers[3] = report.stored_energy;
            return status;
          },
          first(4)};
}

Call repeatable(Call call) {
  call.can_be_repeated = true;
  return call;
}

double load_factor_of(const Host& h) {
  double value = 0;
  bempd_load_factor(h.model, &value);
  return value;
}

}  // namespace

Call listen() {
  return {"set_log", [](Host& h) { return bempd_set_log(h.model, &count_line, &h); }, {}};
}

Call progress() {
  return {"set_progress", [](Host& h) { return bempd_set_progress(h.model, &go_on, nullptr); }, {}};
}

Call stopped_by_progress() {
  return {"run_to_separation, stopped",
          [](Host& h) {
            const bempd_status status = bempd_set_progress(h.model, &stop, nullptr);
            return status == BEMPD_OK ? bempd_run_to_separation(h.model, 10, nullptr) : status;
          },
          {}};
}

Call prepare() {
  return {"prepare", [](Host& h) { return bempd_prepare(h.model); }, {}};
}

Call step(double load_factor) {
  return stepping("step", [=](Host& h, bempd_step_report& r) { return bempd_step(h.model, load_factor, &r); });
}

Call step_by(double increment) {
  return stepping(
      "step", [=](Host& h, bempd_step_report& r) { return bempd_step(h.model, load_factor_of(h) + increment, &r); });
}

Call next_event() {
  return stepping("step_to_next_event",
                  [](Host& h, bempd_step_report& r) { return bempd_step_to_next_event(h.model, 10, &r); });
}

Call run() {
  return stepping("run_to_separation",
                  [](Host& h, bempd_step_report& r) { return bempd_run_to_separation(h.model, 10, &r); });
}

Call grow(double length) {
  return {"grow_cracks",
          [=](Host& h) {
            bempd_growth growth;
            bempd_growth_init(&growth, sizeof growth);
            const bempd_status status = bempd_grow_cracks(h.model, length, &growth);
            h.numbers[0] = growth.load_factor;
            h.numbers[1] = growth.tips;
            return status;
          },
          first(2)};
}

Call run_errors() {
  return repeatable({"run_error_estimate",
                     [](Host& h) {
                       bempd_run_errors errors;
                       bempd_run_errors_init(&errors, sizeof errors);
                       const bempd_status status = bempd_run_error_estimate(h.model, 1e6, &errors);
                       h.numbers[0] = errors.lattice_first_growth;
                       return status;
                     },
                     first(1)});
}

Call field(int region, int32_t which) {
  return repeatable({"copy_field",
                     [=](Host& h) {
                       return bempd_copy_field(h.model, h.region[region], which, static_cast<int64_t>(h.numbers.size()),
                                               h.numbers.data());
                     },
                     [=](Host& h) {
                       int64_t count = 0;
                       int32_t components = 0;
                       bempd_field_size(h.model, h.region[region], which, &count, &components);
                       return first(static_cast<std::size_t>(count * components))(h);
                     }});
}

Call bonds(int region) {
  return repeatable({"copy_bonds",
                     [=](Host& h) {
                       return bempd_copy_bonds(h.model, h.region[region], 100000, h.integers.data(),
                                               h.integers.data() + 100000);
                     },
                     [](Host& h) { return std::vector<double>(h.integers.begin(), h.integers.end()); }});
}

Call reaction(int support) {
  return repeatable(
      {"reaction", [=](Host& h) { return bempd_reaction(h.model, h.support[support], h.numbers.data()); }, first(2)});
}

Call evaluate_at(std::vector<double> places) {
  const auto count = static_cast<int64_t>(places.size() / 2);
  return repeatable({"evaluate",
                     [=](Host& h) {
                       return bempd_evaluate(h.model, count, places.data(), h.numbers.data(),
                                             h.numbers.data() + 2 * count, nullptr);
                     },
                     first(static_cast<std::size_t>(5 * count))});
}

Call evaluate() { return evaluate_at({1, 1, 8, 4, 20.5, 4, 15, 2}); }

Call tips() {
  return repeatable({"tip",
                     [](Host& h) {
                       bempd_crack_tip tip;
                       bempd_crack_tip_init(&tip, sizeof tip);
                       const bempd_status status = bempd_tip(h.model, 0, &tip);
                       h.numbers[0] = tip.stress_intensity_1;
                       h.numbers[1] = tip.stress_intensity_2;
                       return status;
                     },
                     first(2)});
}

Call openings() {
  return repeatable({"crack_opening",
                     [](Host& h) {
                       const double fractions[] = {0, 0.5};
                       return bempd_crack_opening(h.model, 1, 2, fractions, h.numbers.data(), h.numbers.data() + 2);
                     },
                     first(4)});
}

Call statistics() {
  return repeatable({"get_statistics",
                     [](Host& h) {
                       bempd_statistics s;
                       bempd_statistics_init(&s, sizeof s);
                       const bempd_status status = bempd_get_statistics(h.model, &s);
                       h.numbers[0] = static_cast<double>(s.broken_bonds);
                       return status;
                     },
                     first(1)});
}

Call history() {
  return repeatable({"write_history", [](Host& h) { return bempd_write_history(h.model, h.history_path.c_str()); },
                     [](Host& h) {
                       const std::vector<double> size = file_size(h.history_path);
                       std::remove(h.history_path.c_str());
                       return std::vector<double>{size[0] > 0 ? 1.0 : 0.0};
                     }});
}

Call history_in(const char* path) {
  return {"write_history, nowhere", [=](Host& h) { return bempd_write_history(h.model, path); }, {}};
}

Call snapshot() {
  return {"write_snapshot",
          [](Host& h) {
            const bempd_status status = bempd_set_option_text(h.model, "snapshots.existing", "replace");
            return status == BEMPD_OK ? bempd_write_snapshot(h.model, h.snapshot_prefix.c_str()) : status;
          },
          [](Host& h) { return file_size(h.snapshot_prefix + ".pvd"); }};
}

Call save() {
  return {"state_save",
          [](Host& h) {
            bempd_state* saved = nullptr;
            const bempd_status status = bempd_state_save(h.model, &saved);
            if (status != BEMPD_OK) return status;
            bempd_state_free(h.state);
            h.state = saved;
            return status;
          },
          {}};
}

Call restore() {
  return {"state_restore", [](Host& h) { return bempd_state_restore(h.model, h.state); }, {}};
}

Call to_bytes() {
  return repeatable({"state_to_bytes",
                     [](Host& h) {
                       return bempd_state_to_bytes(h.state, static_cast<int64_t>(h.bytes.size()), h.bytes.data(),
                                                   &h.byte_count);
                     },
                     [](Host& h) { return std::vector<double>{static_cast<double>(h.byte_count)}; }});
}

Call from_bytes() {
  return {"state_from_bytes",
          [](Host& h) {
            bempd_state* read = nullptr;
            const bempd_status status = bempd_state_from_bytes(h.byte_count, h.bytes.data(), &read);
            if (status != BEMPD_OK) return status;
            bempd_state_free(h.other_state);
            h.other_state = read;
            return status;
          },
          {}};
}

Call damaged_bytes() {
  return {"state_from_bytes, damaged",
          [](Host& h) { return bempd_state_from_bytes(1000, h.bytes.data(), &h.other_state); },
          {}};
}

Call free_state() {
  return {"state_free",
          [](Host& h) {
            bempd_state_free(h.state);
            bempd_state_free(h.other_state);
            h.state = h.other_state = nullptr;
            return BEMPD_OK;
          },
          {}};
}

}  // namespace memory_test

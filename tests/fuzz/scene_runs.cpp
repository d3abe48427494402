// Steps, results, states and files.
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "checks.hpp"
#include "scene.hpp"

namespace fuzz {

namespace {

// A folder of this process, removed when it ends.
class Folder {
 public:
  Folder() {
    path_ = (std::filesystem::temp_directory_path() / "bempd_fuzz_XXXXXX").string();
    require_true(mkdtemp(path_.data()) != nullptr, "mkdtemp", "no folder for files");
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const char* name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace

void require_same(const char* call, const Marks& before, const Marks& after) {
  require_true(before.regions == after.regions, call, "failed, and the regions are others");
  require_true(before.lines == after.lines, call, "failed, and the history is another");
  require_true(before.load_factor == after.load_factor, call, "failed, and the load factor moved");
}

void Scene::advance() {
  const int way = bytes_.pick(7);
  const double target = bytes_.pick(3) == 0 ? bytes_.number() : 3.0;
  bempd_step_report report;
  good("bempd_step_report_init", nullptr, bempd_step_report_init(&report, sizeof report));
  const Marks before = marks();
  const char* call = "bempd_prepare";
  bool done = false;
  if (way == 0) done = FUZZ_CALL(bempd_prepare, model_);
  if (way == 1) call = "bempd_step", done = FUZZ_CALL(bempd_step, model_, target, &report);
  if (way == 2) call = "bempd_run_to_separation", done = FUZZ_CALL(bempd_run_to_separation, model_, target, &report);
  if (way == 6) {
    const std::array times = {bytes_.number(), target, bytes_.number()}, factors = {bytes_.number(), 0.0, target};
    const int until = bytes_.pick(4), rows = bytes_.pick(4);
    call = "bempd_run_program";
    done =
        FUZZ_CALL(bempd_run_program, model_, rows, times.data(), 0, nullptr, nullptr, factors.data(), until, &report);
  } else if (way == 5) {
    const int until = bytes_.pick(4);
    call = "bempd_step_to_values", done = FUZZ_CALL(bempd_step_to_values, model_, target, until, &report);
  } else if (way > 2)
    call = "bempd_step_to_next_event", done = FUZZ_CALL(bempd_step_to_next_event, model_, target, &report);
  if (!done)
    require_same(call, before, marks());
  else if (way > 0)
    read_report(call, report);
}

// Another thread's requests, which the next call hears.
void Scene::interrupt() {
  if (bytes_.pick(2) == 0) {
    good("bempd_request_stop", model_, bempd_request_stop(model_));
  } else {
    good("bempd_request_cancel", model_, bempd_request_cancel(model_));
  }
}

void Scene::read_report(const char* call, const bempd_step_report& r) {
  // Energies of loads near the end of the range of numbers are beyond it; the log says so.
  const std::array numbers = {r.load_factor,   r.residual,       r.seconds_total,
                              r.seconds_solve, r.seconds_update, r.seconds_search};
  require_finite(call, numbers.data(), numbers.size());
  const bool known = r.stop_reason >= BEMPD_STOP_LOAD_FACTOR && r.stop_reason <= BEMPD_STOP_CRACK_STOPPED;
  require_true(known, call, "an unknown reason to stop");
  require_true(r.events >= 0 && r.broken_bonds >= 0 && r.fragments >= 0, call, "a negative count");
}

void Scene::read_fields() {
  const std::int32_t of = region();
  for (std::int32_t field = BEMPD_POSITION; field <= BEMPD_ELEMENT_STRESS + 1; ++field) {
    std::int64_t count = 0, generation = 0;
    std::int32_t components = 0;
    const double* view = nullptr;
    if (!FUZZ_CALL(bempd_field_size, model_, of, field, &count, &components)) continue;
    const std::int64_t size = count * components;
    std::vector<double> values(static_cast<std::size_t>(size));
    if (FUZZ_CALL(bempd_copy_field, model_, of, field, size, values.data()))
      require_finite("bempd_copy_field", values.data(), values.size());
    if (FUZZ_CALL(bempd_view_field, model_, of, field, &view, &count, &components, &generation))
      require_true(std::memcmp(view, values.data(), values.size() * sizeof(double)) == 0 && size == count * components,
                   "bempd_view_field", "the view is not the copy");
  }
  std::int64_t elements = 0;
  if (FUZZ_CALL(bempd_element_count, model_, of, &elements)) {
    std::vector<std::int32_t> nodes(static_cast<std::size_t>(4 * elements));
    FUZZ_CALL(bempd_copy_elements, model_, of, 4 * elements, nodes.data());
  }
  read_bonds(of);
}

void Scene::read_bonds(std::int32_t of) {
  std::int64_t bonds = 0, points = 0;
  if (!FUZZ_CALL(bempd_bond_count, model_, of, &bonds) || !FUZZ_CALL(bempd_node_count, model_, of, &points)) return;
  std::vector<std::int32_t> ends(static_cast<std::size_t>(2 * bonds)), states(static_cast<std::size_t>(bonds));
  if (!FUZZ_CALL(bempd_copy_bonds, model_, of, bonds, ends.data(), states.data())) return;
  for (const std::int32_t end : ends) require_true(end >= 0 && end < points, "bempd_copy_bonds", "an end is no point");
  for (const std::int32_t state : states)
    require_true(state >= BEMPD_BOND_INTACT && state <= BEMPD_BOND_CUT, "bempd_copy_bonds", "an unknown state");
}

void Scene::evaluate() {
  std::array<double, 6> points, displacement;
  std::array<double, 9> stress;
  std::array<std::int32_t, 3> regions;
  const std::int64_t count = bytes_.pick(4);
  for (std::size_t k = 0; k < 3; ++k) {
    const Place at = place();
    points[2 * k] = at.x, points[2 * k + 1] = at.y;
  }
  if (!FUZZ_CALL(bempd_evaluate, model_, count, points.data(), displacement.data(), stress.data(), regions.data()))
    return;
  require_finite("bempd_evaluate", displacement.data(), static_cast<std::size_t>(2 * count));
  require_finite("bempd_evaluate", stress.data(), static_cast<std::size_t>(3 * count));
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    require_true(regions[k] >= 1 && regions[k] <= regions_, "bempd_evaluate", "a place in no region");
    for (const std::int32_t of : {regions[k], regions_}) {
      if (!FUZZ_CALL(bempd_evaluate_in, model_, of, BEMPD_FACE_RIGHT, 1, &points[2 * k], &displacement[2 * k],
                     &stress[3 * k]))
        continue;
      require_finite("bempd_evaluate_in", &displacement[2 * k], 2);
      require_finite("bempd_evaluate_in", &stress[3 * k], 3);
    }
  }
}

void Scene::read_singular_places() {
  const Place at = place();
  const std::array point = {at.x, at.y};
  double order = -1;
  if (FUZZ_CALL(bempd_stress_orders, model_, 1, point.data(), &order))
    require_true(order >= 0 && order <= 1, "bempd_stress_orders", "no order");  // 1 at point forces
  double error = -1;                                                            // of a stress: not known in lattices
  if (FUZZ_CALL(bempd_evaluate_errors, model_, 1, point.data(), nullptr, &error))
    require_true(!(error < 0), "bempd_evaluate_errors", "a length below 0");
  std::int64_t count = 0;
  if (!FUZZ_CALL(bempd_singularity_count, model_, &count)) return;
  for (std::int64_t k = 0; k <= count; ++k) {
    bempd_singularity s;
    good("bempd_singularity_init", nullptr, bempd_singularity_init(&s, sizeof s));
    if (!FUZZ_CALL(bempd_get_singularity, model_, k, &s)) continue;
    const std::array numbers = {s.x, s.y, s.exponent, s.oscillation};
    require_finite("bempd_get_singularity", numbers.data(), numbers.size());
    require_true(s.exponent >= 0 && s.exponent < 1 && s.oscillation >= 0, "bempd_get_singularity", "no exponent");
    require_true(s.region >= 1 && s.region <= regions_, "bempd_get_singularity", "a place in no region");
  }
}

void Scene::read_books() {
  bempd_statistics statistics;
  good("bempd_statistics_init", nullptr, bempd_statistics_init(&statistics, sizeof statistics));
  if (FUZZ_CALL(bempd_get_statistics, model_, &statistics))
    require_finite("bempd_get_statistics", &statistics.reciprocal_condition, 1);
  bempd_body_plan plan;
  bempd_errors errors;
  good("bempd_body_plan_init", nullptr, bempd_body_plan_init(&plan, sizeof plan));
  good("bempd_errors_init", nullptr, bempd_errors_init(&errors, sizeof errors));
  if (FUZZ_CALL(bempd_plan, model_, &plan)) require_finite("bempd_plan", &plan.displacement_error, 1);
  bempd_model_part part;
  good("bempd_part_init", nullptr, bempd_part_init(&part, sizeof part));
  std::int64_t part_count = 0, points = 0;
  if (FUZZ_CALL(bempd_part_count, model_, &part_count) && FUZZ_CALL(bempd_part, model_, bytes_.pick(3), &part))
    FUZZ_CALL(bempd_part_outline, model_, 0, bytes_.pick(3), 0, nullptr, &points);
  if (FUZZ_CALL(bempd_error_estimate, model_, &errors)) require_finite("bempd_error_estimate", &errors.displacement, 1);
  bempd_run_errors of_run;
  good("bempd_run_errors_init", nullptr, bempd_run_errors_init(&of_run, sizeof of_run));
  if (FUZZ_CALL(bempd_run_error_estimate, model_, 0.02, &of_run))
    require_finite("bempd_run_error_estimate", &of_run.expected_seconds, 1);
  for (std::int32_t support = 0; support <= supports_; ++support) {
    std::array<double, 2> force;
    if (FUZZ_CALL(bempd_reaction, model_, support, force.data())) require_finite("bempd_reaction", force.data(), 2);
  }
  for (std::int32_t edge = 1; edge <= 4; ++edge) {
    std::array<double, 3> reaction;
    if (FUZZ_CALL(bempd_edge_reaction, model_, regions_, edge, 0.0, 0.0, reaction.data(), &reaction[2]))
      require_finite("bempd_edge_reaction", reaction.data(), 3);
  }
  read_singular_places();
  const std::int64_t lines = marks().lines;
  for (std::int64_t line = 0; line <= lines; ++line) {
    bempd_history_entry e;
    good("bempd_history_entry_init", nullptr, bempd_history_entry_init(&e, sizeof e));
    if (!FUZZ_CALL(bempd_get_history_entry, model_, line, &e)) continue;
    const std::array numbers = {e.load_factor, e.stretch_ratio, e.residual};
    require_finite("bempd_get_history_entry", numbers.data(), numbers.size());
    std::array<double, 2> displacement{}, force{}, before{};
    if (!FUZZ_CALL(bempd_get_history_support, model_, line, 1, displacement.data(), force.data(), before.data()))
      continue;
    require_finite("bempd_get_history_support", force.data(), force.size());
  }
}

void Scene::keep_state() {
  if (bytes_.pick(2) == 0) {
    bempd_state* state = nullptr;
    if (!FUZZ_CALL(bempd_state_save, model_, &state)) return;
    bempd_state_free(state_);
    state_ = state;
    return;
  }
  if (state_ == nullptr) return;
  std::int64_t size = 0;
  require_true(bempd_state_to_bytes(state_, 0, nullptr, &size) == BEMPD_OK, "bempd_state_to_bytes", "no size");
  std::vector<std::uint8_t> written(static_cast<std::size_t>(size)), again = written;
  require_true(bempd_state_to_bytes(state_, size, written.data(), &size) == BEMPD_OK, "bempd_state_to_bytes",
               "no bytes");
  bempd_state* read = nullptr;
  if (!good("bempd_state_from_bytes", nullptr, bempd_state_from_bytes(size, written.data(), &read)))
    report("bempd_state_from_bytes", "a saved state is refused", bempd_last_error(nullptr));
  const bool same = bempd_state_to_bytes(read, size, again.data(), &size) == BEMPD_OK && again == written;
  require_true(same, "bempd_state_from_bytes", "the bytes read are not those written");
  const Marks before = marks();
  if (!FUZZ_CALL(bempd_state_restore, model_, read)) require_same("bempd_state_restore", before, marks());
  bempd_state_free(read);
}

void Scene::write_files() {
  static const Folder folder;
  static constexpr std::array<const char*, 5> names = {"run", "a & b", "\xff", "line\nbreak", "no/such/folder"};
  const std::string path = folder / bytes_.of(names);
  switch (bytes_.pick(3)) {
    case 0:
      FUZZ_CALL(bempd_write_snapshot, model_, path.c_str());
      break;
    case 1:
      FUZZ_CALL(bempd_write_tips, model_, path.c_str());
      break;
    default:
      FUZZ_CALL(bempd_write_history, model_, path.c_str());
  }
}

}  // namespace fuzz

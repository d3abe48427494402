/* A scene pays for what it has, and a step for what happens in it. */
#include "scenes.h"

static bempd_statistics statistics_of(const bempd_model* model) {
  bempd_statistics statistics;
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_get_statistics(model, &statistics));
  return statistics;
}

static void boundary_scene_has_no_lattice_and_no_sparse_factor(void) {
  bempd_model* model = bem_block();
  const double one = 1.0;
  bempd_statistics s;
  CHECK_OK(model, bempd_set_option_text(model, "bem.grading", "none"));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  s = statistics_of(model);
  CHECK(s.boundary_nodes > 0 && s.boundary_elements == 18 && s.kernel_evaluations > 0);
  CHECK(s.material_points == 0 && s.bonds == 0 && s.cut_bonds == 0 && s.broken_bonds == 0);
  CHECK(s.sparse_factorizations == 0 && s.factor_updates == 0);
  CHECK(s.seconds_lattice == 0.0 && s.seconds_update == 0.0);
  bempd_model_free(model);
}

static void lattice_scene_has_no_boundary_operators(void) {
  bempd_model* model = pd_block();
  bempd_statistics s;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_point(model, 10.0, 4.0, BEMPD_X, 0.0, 1e-4, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  s = statistics_of(model);
  CHECK(s.material_points == 99 && s.bonds > 0 && s.cut_bonds == 0);
  CHECK(s.boundary_nodes == 0 && s.boundary_elements == 0 && s.kernel_evaluations == 0);
  CHECK(s.dense_factorizations == 0 && s.sparse_factorizations == 1 && s.seconds_boundary == 0.0);
  bempd_model_free(model);
}

static void nothing_is_built_before_it_is_needed(void) {
  const coupled_plate plate = coupled_plate_create();
  const bempd_statistics s = statistics_of(plate.model);
  CHECK(s.kernel_evaluations == 0 && s.bonds == 0 && s.solves == 0 && s.sparse_factorizations == 0);
  bempd_model_free(plate.model);
}

static void step_without_event_makes_no_solve(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  bempd_statistics once, often;
  CHECK_OK(plate.model, bempd_step(plate.model, 0.2 * first_event, NULL));
  once = statistics_of(plate.model);
  CHECK(once.solves >= 1 && once.solves <= 2 && once.sparse_factorizations == 1 && once.dense_factorizations == 2);
  CHECK_OK(plate.model, bempd_step(plate.model, 0.4 * first_event, NULL));
  CHECK_OK(plate.model, bempd_step(plate.model, 0.9 * first_event, NULL));
  CHECK_OK(plate.model, bempd_step(plate.model, 0.1 * first_event, NULL));
  CHECK_OK(plate.model, bempd_step(plate.model, 0.1 * first_event, NULL));
  often = statistics_of(plate.model);
  CHECK(often.solves == once.solves && often.sparse_factorizations == once.sparse_factorizations);
  CHECK(often.kernel_evaluations == once.kernel_evaluations && often.factor_updates == once.factor_updates);
  bempd_model_free(plate.model);
}

static void looking_at_results_builds_nothing_twice(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  bempd_statistics before, after;
  outcome seen;
  CHECK_OK(plate.model, bempd_step(plate.model, 0.5 * first_event, NULL));
  before = statistics_of(plate.model);
  seen = coupled_plate_outcome(&plate);
  outcome_free(&seen);
  after = statistics_of(plate.model);
  CHECK(after.solves == before.solves && after.sparse_factorizations == before.sparse_factorizations);
  CHECK(after.dense_factorizations == before.dense_factorizations && after.bonds == before.bonds);
  bempd_model_free(plate.model);
}

static void new_load_values_touch_the_right_hand_side_only(void) {
  bempd_model* model = pd_block();
  const double one = 1e-3;
  const double two = 2e-3;
  int32_t load = 0;
  bempd_statistics before, after;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &one, &load));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  before = statistics_of(model);
  CHECK_OK(model, bempd_set_load_values(model, load, 1, NULL, &two));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  after = statistics_of(model);
  CHECK(after.solves > before.solves && after.sparse_factorizations == before.sparse_factorizations);
  CHECK(after.seconds_lattice == before.seconds_lattice && after.seconds_assembly == before.seconds_assembly);
  bempd_model_free(model);
}

int main(void) {
  const double first_event = coupled_plate_first_event();
  boundary_scene_has_no_lattice_and_no_sparse_factor();
  lattice_scene_has_no_boundary_operators();
  nothing_is_built_before_it_is_needed();
  step_without_event_makes_no_solve(first_event);
  looking_at_results_builds_nothing_twice(first_event);
  new_load_values_touch_the_right_hand_side_only();
  return check_finish();
}

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

static double largest_displacement(bempd_model* model, int32_t region) {
  int64_t count = 0, k;
  int32_t components = 0;
  double values[400], largest = 0.0;
  CHECK_OK(model, bempd_field_size(model, region, BEMPD_DISPLACEMENT, &count, &components));
  CHECK(count * components <= 400);
  CHECK_OK(model, bempd_copy_field(model, region, BEMPD_DISPLACEMENT, 400, values));
  for (k = 0; k < count * components; ++k) largest = fmax(largest, fabs(values[k]));
  return largest;
}

static void equal_regions_are_built_and_factorized_once(void) {
  const double loads[] = {1.0, 2.0};
  bempd_model *alone = bem_block(), *model = bem_block();
  bempd_statistics once, twice;
  double expected;
  int32_t k;
  add_bem_rectangle(model, 1, 20.0, 5.0, 30.0, 13.0, 2.0);
  for (k = 0; k < 2; ++k) {
    CHECK_OK(model, bempd_fix_edge(model, k + 1, 4, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_add_traction(model, k + 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &loads[k], NULL));
  }
  CHECK_OK(alone, bempd_fix_edge(alone, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(alone, bempd_add_traction(alone, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &loads[0], NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(alone, bempd_step(alone, 1.0, NULL));
  once = statistics_of(alone);
  twice = statistics_of(model);
  CHECK(twice.boundary_nodes == 2 * once.boundary_nodes && twice.kernel_evaluations == once.kernel_evaluations);
  CHECK(once.dense_factorizations == 1 && twice.dense_factorizations == 1);
  expected = largest_displacement(alone, 1);
  CHECK(expected > 0.0 && fabs(largest_displacement(model, 1) - expected) <= 1e-12 * expected);
  CHECK(fabs(largest_displacement(model, 2) - 2.0 * expected) <= 1e-12 * expected);
  bempd_model_free(model);
  /* Held elsewhere, a region needs a factorization of its own. */
  model = bem_block();
  CHECK_OK(model, bempd_set_option_text(model, "bem.grading", "none"));
  add_bem_rectangle(model, 1, 20.0, 5.0, 30.0, 13.0, 2.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 2, 2, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &loads[0], NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK(statistics_of(model).dense_factorizations == 2);
  bempd_model_free(model);
  bempd_model_free(alone);
}

/** A cracked lattice in some unit of length. */
static int64_t factor_entries(double unit) {
  const rectangle r = rectangle_of(0.0, 0.0, 70.0 * unit, 50.0 * unit);
  const double crack[4] = {20.5 * unit, 0.0, 20.5 * unit, 15.3 * unit};
  bempd_model* model = new_model();
  int64_t entries;
  CHECK_OK(model, bempd_add_pd_region(model, add_sound_material(model), 4, r.vertices, unit, 3, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_point(model, 70.0 * unit, 50.0 * unit, BEMPD_X, 0.0, 1e-4 * unit, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  entries = statistics_of(model).factor_nonzeros;
  bempd_model_free(model);
  return entries;
}

static void the_unit_of_length_costs_nothing(void) {
  const double units[] = {1e-11, 1e-10, 1e-9, 1e-6, 1e-3, 1e3, 1e9, 1e11};
  const int64_t expected = factor_entries(1.0);
  size_t k;
  CHECK(expected > 0);
  for (k = 0; k < sizeof units / sizeof units[0]; ++k)
    CHECK_CLOSE((double)factor_entries(units[k]), (double)expected, 0.01 * (double)expected);
}

int main(void) {
  const double first_event = coupled_plate_first_event();
  boundary_scene_has_no_lattice_and_no_sparse_factor();
  lattice_scene_has_no_boundary_operators();
  nothing_is_built_before_it_is_needed();
  step_without_event_makes_no_solve(first_event);
  looking_at_results_builds_nothing_twice(first_event);
  new_load_values_touch_the_right_hand_side_only();
  equal_regions_are_built_and_factorized_once();
  the_unit_of_length_costs_nothing();
  return check_finish();
}

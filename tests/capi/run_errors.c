/* Errors of runs in which cracks have grown: the scene is run again with longer extensions, and without lattice
 * patches. */
#include "scenes.h"

static const double all_time = 1e9, far = 1e6;

/** Square body with a slanted crack in its middle, or a crack from its left edge; its upper edge is pulled and sheared.
 * Ids: body 1, crack 1, loads 1 and 2. `step` is the option crack.step. */
static bempd_model* sheared_square(int from_edge, double step) {
  const rectangle r = rectangle_of(0, 0, 2, 2);
  static const double edge[4] = {0, 1, 0.4, 1.1}, inside[4] = {0.8, 0.95, 1.2, 1.05};
  const double up = 1, along = 0.3;
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  int32_t id = 0;
  material.critical_stretch = 0;
  material.fracture_energy = 1e-3;
  CHECK_OK(model, bempd_set_option_text(model, "stepping.control", "path"));
  CHECK_OK(model, bempd_set_option(model, "crack.step", step));
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  CHECK_OK(model, bempd_add_body(model, id, 4, r.vertices, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, from_edge ? edge : inside, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &up, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 3, 0, 1, BEMPD_X, 1, NULL, &along, NULL));
  return model;
}

static bempd_step_report next_event(bempd_model* model) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, far, &report));
  return report;
}

static void grow(bempd_model* model, int events) {
  for (int k = 0; k < events; ++k) next_event(model);
}

static bempd_run_errors run_errors_of(bempd_model* model, double allowed) {
  bempd_run_errors errors;
  CHECK_OK(NULL, bempd_run_errors_init(&errors, sizeof errors));
  CHECK_OK(model, bempd_run_error_estimate(model, allowed, &errors));
  return errors;
}

static void check_no_errors(bempd_model* model, const char* why) {
  bempd_run_errors errors;
  CHECK_OK(NULL, bempd_run_errors_init(&errors, sizeof errors));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, why, bempd_run_error_estimate(model, all_time, &errors));
}

static bempd_crack_tip last_tip(bempd_model* model) {
  bempd_crack_tip tip;
  int64_t count = 0;
  CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip_count(model, &count));
  CHECK_OK(model, bempd_tip(model, count - 1, &tip));
  return tip;
}

/** What the errors tell against a run with extensions a fifth as long, whose path passes near the tip. */
static void errors_are_those_of_long_extensions(void) {
  const double step = 0.1, fine = 0.02;
  bempd_model *model = sheared_square(1, step), *finer = sheared_square(1, fine);
  double length = 0, finer_length = 0, apart = 0;
  bempd_run_errors errors;
  bempd_crack_tip tip, before = {0}, after;
  grow(model, 3);
  errors = run_errors_of(model, all_time);
  CHECK(errors.is_made == 1 && errors.seconds > 0 && errors.path_crack == 1);
  CHECK(errors.first_growth > 0 && errors.first_growth < 1e-2 && errors.peak >= errors.first_growth &&
        errors.peak < 0.2);
  CHECK(errors.lattice_first_growth == 0 && errors.lattice_peak == 0 && errors.lattice_path == 0);
  tip = last_tip(model);
  CHECK_OK(model, bempd_crack_length(model, 1, &length));
  while (finer_length < length) {
    before = last_tip(finer);
    next_event(finer);
    CHECK_OK(finer, bempd_crack_length(finer, 1, &finer_length));
  }
  after = last_tip(finer);
  apart = fabs((after.x - before.x) * (tip.y - before.y) - (after.y - before.y) * (tip.x - before.x)) /
          hypot(after.x - before.x, after.y - before.y);
  printf("path: told %.2e, apart %.2e after %.3f; peak %.2e, first growth %.2e\n", errors.path, apart, length,
         errors.peak, errors.first_growth);
  CHECK(apart > 1e-5 && errors.path >= apart && errors.path < 20 * apart);
  bempd_model_free(model);
  bempd_model_free(finer);
}

/** The model goes on to the same digits, whether or not it was asked on the way; a cost is told without a run. */
static void the_run_stays_as_it_is(int lattice) {
  bempd_model* models[2];
  bempd_step_report ends[2];
  for (int asked = 0; asked < 2; ++asked) {
    bempd_model* model = models[asked] = sheared_square(!lattice, lattice ? 0 : 0.1);
    if (lattice) {
      CHECK_OK(model, bempd_set_body_lattice(model, 1, 0.04, 3));
      CHECK_OK(model, bempd_set_crack_treatment(model, 1, BEMPD_TREATMENT_LATTICE));
    }
    grow(model, 1);
    if (asked) {
      const bempd_run_errors cost = run_errors_of(model, 0);
      bempd_run_errors errors;
      CHECK(cost.is_made == 0 && cost.expected_seconds > 0 && cost.seconds == 0 && isnan(cost.peak) &&
            isnan(cost.path));
      errors = run_errors_of(model, all_time);
      printf("lattice: first growth %.2e, peak %.2e, path %.2e\n", errors.lattice_first_growth, errors.lattice_peak,
             errors.lattice_path);
      CHECK(errors.is_made == 1 && (errors.lattice_peak > 0) == (lattice == 1) && errors.lattice_peak < 0.1);
      CHECK(errors.lattice_path < 0.05 && (errors.lattice_first_growth > 0) == (lattice == 1));
    }
    CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START, 1));
    grow(model, 1);
    ends[asked] = next_event(model);
  }
  CHECK(ends[0].load_factor == ends[1].load_factor && ends[0].stored_energy == ends[1].stored_energy);
  CHECK(ends[0].work == ends[1].work && ends[0].total_events == ends[1].total_events);
  bempd_model_free(models[0]);
  bempd_model_free(models[1]);
}

/** A state in memory knows its run, bytes of a state do not; loads may take new values on the way. */
static void states_know_their_run(void) {
  bempd_model *model = sheared_square(1, 0.1), *other = sheared_square(1, 0.1);
  const double more = 0.5;
  bempd_state *state = NULL, *read = NULL;
  int64_t size = 0;
  uint8_t* bytes = NULL;
  bempd_run_errors first, again;
  grow(model, 1);
  CHECK_OK(model, bempd_set_load_values(model, 2, 1, NULL, &more));
  grow(model, 2);
  first = run_errors_of(model, all_time);
  CHECK_OK(model, bempd_state_save(model, &state));
  CHECK_OK(model, bempd_state_restore(model, state));
  again = run_errors_of(model, all_time);
  CHECK(first.path > 0 && first.path == again.path && first.peak == again.peak);
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
  bytes = malloc((size_t)size);
  CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, NULL));
  CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &read));
  CHECK_OK(other, bempd_state_restore(other, read));
  check_no_errors(other, "bytes of a state");
  free(bytes);
  bempd_state_free(state);
  bempd_state_free(read);
  bempd_model_free(model);
  bempd_model_free(other);
}

static void misuse(void) {
  const rectangle r = rectangle_of(2, 0, 4, 2);
  bempd_run_errors errors;
  bempd_model* model = sheared_square(1, 0.1);
  CHECK_OK(NULL, bempd_run_errors_init(&errors, sizeof errors));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "errors is NULL", bempd_run_error_estimate(model, 1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "seconds_allowed", bempd_run_error_estimate(model, NAN, &errors));
  check_no_errors(model, "no crack has grown");
  CHECK_OK(model, bempd_grow_cracks(model, 0.1, NULL));
  check_no_errors(model, "cannot be repeated");
  bempd_model_free(model);
  model = sheared_square(1, 0.1);
  CHECK_OK(model, bempd_add_pd_region(model, 1, 4, r.vertices, 0.2, 3, NULL));
  check_no_errors(model, "lattice of the host");
  bempd_model_free(model);
}

int main(void) {
  errors_are_those_of_long_extensions();
  the_run_stays_as_it_is(0);
  the_run_stays_as_it_is(1);
  states_know_their_run();
  misuse();
  return 0;
}

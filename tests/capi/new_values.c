/* New values of loads and supports: on a straight line to them, at once, and what results show in between. */
#define CRACK_RULE "bond"
#include "scenes.h"

#define GOAL 1.2 /* load factor of the coupled plate at which its crack has grown a good way */

/** Values of the plate's two ends as proportional ones have them at a load factor. */
static void pull(const coupled_plate* plate, double load_factor) {
  const double none[2] = {0.0, 0.0};
  const double left[2] = {-0.002 * load_factor, -0.02 * load_factor};
  const double right[2] = {0.02 * load_factor, 0.002 * load_factor};
  CHECK_OK(plate->model, bempd_set_support_values(plate->model, plate->pulled_left, 2, left, none));
  CHECK_OK(plate->model, bempd_set_support_values(plate->model, plate->pulled_right, 2, right, none));
}

static bempd_step_report go(const coupled_plate* plate, double load_factor, int32_t until) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate->model, bempd_step_to_values(plate->model, load_factor, until, &report));
  return report;
}

static bempd_history_entry line_of(bempd_model* model, int64_t index) {
  bempd_history_entry line;
  CHECK_OK(NULL, bempd_history_entry_init(&line, sizeof line));
  CHECK_OK(model, bempd_get_history_entry(model, index, &line));
  return line;
}

/** Checks that two models have the same events at the same load factors; ends of steps in between do not count. */
static void check_same_events(bempd_model* one, bempd_model* other) {
  int64_t lines = 0, others = 0, k, at = 0, events = 0;
  CHECK_OK(one, bempd_history_count(one, &lines));
  CHECK_OK(other, bempd_history_count(other, &others));
  for (k = 0; k < lines; ++k) {
    const bempd_history_entry line = line_of(one, k);
    bempd_history_entry same = line;
    if (line.event == 0) continue;
    ++events;
    for (; at < others; ++at) {
      same = line_of(other, at);
      if (same.event != 0) break;
    }
    ++at;
    CHECK(at <= others && same.event == line.event && same.total_broken_bonds == line.total_broken_bonds);
    CHECK(fabs(same.load_factor - line.load_factor) <= 1e-9 * GOAL);
    CHECK(fabs(same.released_energy - line.released_energy) <= 1e-9 * fabs(line.work));
  }
  CHECK(events > 3);
  for (; at < others; ++at) CHECK(line_of(other, at).event == 0);
}

static coupled_plate pulled_in_one_step(void) {
  const coupled_plate plate = coupled_plate_create();
  CHECK_OK(plate.model, bempd_step(plate.model, GOAL, NULL));
  return plate;
}

static void values_on_a_line_break_what_a_proportional_load_breaks(int parts) {
  const coupled_plate expected = pulled_in_one_step(), plate = coupled_plate_create();
  outcome seen, wanted;
  int k;
  for (k = 1; k <= parts; ++k) {
    const double load_factor = GOAL * k / parts;
    double force[2];
    bempd_step_report report;
    pull(&plate, load_factor);
    /* Looking at the new values before the step moves nothing. */
    if (k % 2 == 0) CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_left, force));
    report = go(&plate, load_factor, BEMPD_UNTIL_VALUES);
    CHECK(report.stop_reason == BEMPD_STOP_LOAD_FACTOR && report.energy_balance_error < 1e-9);
    CHECK(fabs(report.load_factor - load_factor) <= 0.0);
  }
  check_same_events(expected.model, plate.model);
  seen = coupled_plate_outcome(&plate);
  wanted = coupled_plate_outcome(&expected);
  CHECK(outcome_difference(&seen, &wanted) < 1e-8);
  outcome_free(&seen);
  outcome_free(&wanted);
  bempd_model_free(plate.model);
  bempd_model_free(expected.model);
}

static void a_jump_breaks_at_the_new_values(void) {
  const coupled_plate plate = coupled_plate_create(), ramp = coupled_plate_create();
  bempd_step_report jumped, gone;
  double now[2], before[2] = {1.0, 1.0};
  int64_t lines = 0;
  CHECK_OK(NULL, bempd_step_report_init(&jumped, sizeof jumped));
  pull(&plate, 0.0);
  CHECK_OK(plate.model, bempd_step(plate.model, 0.0, NULL));
  CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_left, before));
  pull(&plate, GOAL);
  CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_left, now));
  CHECK_OK(plate.model, bempd_history_count(plate.model, &lines));
  CHECK(fabs(before[0]) < 1e-12 && now[0] < -1e-3 && lines == 1);
  CHECK_OK(plate.model, bempd_step(plate.model, 0.0, &jumped));
  pull(&ramp, GOAL);
  gone = go(&ramp, 1.0, BEMPD_UNTIL_VALUES);
  CHECK(jumped.events > 0 && jumped.released_energy > 1.01 * gone.released_energy);
  CHECK(fabs(jumped.load_factor) <= 0.0 && jumped.energy_balance_error < 1e-9);
  bempd_model_free(plate.model);
  bempd_model_free(ramp.model);
}

static void a_step_that_ends_on_the_way_is_gone_on_with(void) {
  const coupled_plate expected = pulled_in_one_step(), plate = coupled_plate_create();
  bempd_state* state = NULL;
  bempd_state* other = NULL;
  bempd_step_report report;
  outcome first, again;
  uint8_t* bytes;
  int64_t size = 0;
  pull(&plate, GOAL);
  go(&plate, GOAL, BEMPD_UNTIL_EVENT);
  report = go(&plate, GOAL, BEMPD_UNTIL_EVENT);
  CHECK(report.stop_reason == BEMPD_STOP_EVENT && report.events == 1 && report.total_events == 2);
  CHECK(report.load_factor > 0.0 && report.load_factor < GOAL);
  CHECK_OK(plate.model, bempd_state_save(plate.model, &state));
  while (report.stop_reason == BEMPD_STOP_EVENT) report = go(&plate, GOAL, BEMPD_UNTIL_EVENT);
  CHECK(report.stop_reason == BEMPD_STOP_LOAD_FACTOR);
  check_same_events(expected.model, plate.model);
  first = coupled_plate_outcome(&plate);
  /* The state has the way in it, also as bytes. */
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
  bytes = (uint8_t*)malloc((size_t)size);
  if (bytes == NULL) abort();
  CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, NULL));
  CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &other));
  CHECK_OK(plate.model, bempd_state_restore(plate.model, other));
  do report = go(&plate, GOAL, BEMPD_UNTIL_EVENT);
  while (report.stop_reason == BEMPD_STOP_EVENT);
  again = coupled_plate_outcome(&plate);
  CHECK(outcome_same(&first, &again));
  /* Values between, then on a new line to others. */
  CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
  pull(&plate, 0.0);
  report = go(&plate, 2 * GOAL, BEMPD_UNTIL_VALUES);
  CHECK(report.total_events < 10 && report.stop_reason == BEMPD_STOP_LOAD_FACTOR && report.stored_energy < 1e-12);
  /* A step goes to the values at once. */
  CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
  pull(&plate, GOAL);
  CHECK_OK(plate.model, bempd_step(plate.model, report.load_factor, &report));
  CHECK(report.events > 0 && report.energy_balance_error < 1e-9);
  free(bytes);
  outcome_free(&first);
  outcome_free(&again);
  bempd_state_free(state);
  bempd_state_free(other);
  bempd_model_free(plate.model);
  bempd_model_free(expected.model);
}

static int32_t stop_at_third(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)broken_bonds, (void)user;
  return events >= 3;
}

static void a_cancelled_way_is_not_begun(void) {
  const coupled_plate plate = coupled_plate_create(), undisturbed = coupled_plate_create();
  outcome before, after, seen, wanted;
  pull(&plate, 0.3);
  pull(&undisturbed, 0.3);
  go(&plate, 0.3, BEMPD_UNTIL_VALUES);
  go(&undisturbed, 0.3, BEMPD_UNTIL_VALUES);
  before = coupled_plate_outcome(&plate);
  pull(&plate, GOAL);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, stop_at_third, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_CANCELLED, "progress",
              bempd_step_to_values(plate.model, GOAL, BEMPD_UNTIL_VALUES, NULL));
  pull(&plate, 0.3);
  after = coupled_plate_outcome(&plate);
  CHECK(outcome_difference(&before, &after) < 1e-12);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, NULL, NULL));
  pull(&plate, GOAL);
  pull(&undisturbed, GOAL);
  go(&plate, GOAL, BEMPD_UNTIL_VALUES);
  go(&undisturbed, GOAL, BEMPD_UNTIL_VALUES);
  seen = coupled_plate_outcome(&plate);
  wanted = coupled_plate_outcome(&undisturbed);
  CHECK(outcome_difference(&seen, &wanted) < 1e-8);
  check_same_events(undisturbed.model, plate.model);
  outcome_free(&before);
  outcome_free(&after);
  outcome_free(&seen);
  outcome_free(&wanted);
  bempd_model_free(plate.model);
  bempd_model_free(undisturbed.model);
}

/** Two edges of a block that share a corner get new values one after the other. */
static void supports_with_a_common_corner_get_new_values_together(void) {
  bempd_model* model = bem_block();
  const double none = 0.0, old_value = 0.01, new_value = 0.02;
  int32_t bottom = 0, right = 0;
  double force[2];
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_X, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 1, 0.0, 1.0, BEMPD_Y, 1, &old_value, NULL, &bottom));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_Y, 1, &old_value, NULL, &right));
  CHECK_OK(model, bempd_step(model, 0.0, NULL));
  CHECK_OK(model, bempd_set_support_values(model, bottom, 1, &new_value, &none));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "prescribe different displacements", bempd_step(model, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "prescribe different displacements",
              bempd_step_to_values(model, 1.0, BEMPD_UNTIL_VALUES, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "prescribe different displacements", bempd_reaction(model, right, force));
  CHECK_OK(model, bempd_set_support_values(model, right, 1, &new_value, &none));
  CHECK_OK(model, bempd_step_to_values(model, 1.0, BEMPD_UNTIL_VALUES, NULL));
  CHECK_OK(model, bempd_reaction(model, right, force));
  CHECK(fabs(force[0]) < 1e-9 && fabs(force[1]) < 1e-9); /* the whole block has moved */
  bempd_model_free(model);
}

/** Late times leave values on short ways fewer digits: as many as the way is shorter than the time. */
static void short_ways_at_late_times_lose_digits_or_are_refused(void) {
  const coupled_plate early = coupled_plate_create(), late = coupled_plate_create();
  double expected[2], found[2];
  pull(&early, 0.1);
  go(&early, 1.0, BEMPD_UNTIL_VALUES);
  pull(&late, 0.05);
  go(&late, 1e6, BEMPD_UNTIL_VALUES);
  pull(&late, 0.1);
  CHECK_FAILS(late.model, BEMPD_ERROR_ARGUMENT, "digits",
              bempd_step_to_values(late.model, 1e6 + 1e-3, BEMPD_UNTIL_VALUES, NULL));
  go(&late, 1e6 + 1.0, BEMPD_UNTIL_VALUES);
  CHECK_OK(early.model, bempd_reaction(early.model, early.pulled_right, expected));
  CHECK_OK(late.model, bempd_reaction(late.model, late.pulled_right, found));
  CHECK(expected[0] > 0.0);
  CHECK_CLOSE(found[0], expected[0], 1e-8 * expected[0]);
  bempd_model_free(early.model);
  bempd_model_free(late.model);
}

static void what_makes_no_way_is_refused(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_step_report report;
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "already",
              bempd_step_to_values(plate.model, 0.0, BEMPD_UNTIL_VALUES, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "finite",
              bempd_step_to_values(plate.model, NAN, BEMPD_UNTIL_VALUES, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "BEMPD_UNTIL_EVENT", bempd_step_to_values(plate.model, 1.0, 7, NULL));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model", bempd_step_to_values(NULL, 1.0, BEMPD_UNTIL_VALUES, NULL));
  memset(&report, 0, sizeof report);
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "struct_size",
              bempd_step_to_values(plate.model, 1.0, BEMPD_UNTIL_VALUES, &report));
  bempd_model_free(plate.model);
}

int main(void) {
  values_on_a_line_break_what_a_proportional_load_breaks(1);
  values_on_a_line_break_what_a_proportional_load_breaks(7);
  a_jump_breaks_at_the_new_values();
  a_step_that_ends_on_the_way_is_gone_on_with();
  a_cancelled_way_is_not_begun();
  supports_with_a_common_corner_get_new_values_together();
  short_ways_at_late_times_lose_digits_or_are_refused();
  what_makes_no_way_is_refused();
  return check_finish();
}

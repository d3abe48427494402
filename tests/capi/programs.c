/* Load programs: tables of factors by time, with cycles, and what the books of energy say of them. */
#define CRACK_RULE "bond"
#include "scenes.h"

#define GOAL 1.2 /* factor at which the crack of the coupled plate has grown a good way */

static bempd_step_report run(const coupled_plate* plate, int64_t rows, const double* times, const double* factors,
                             int32_t until) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate->model, bempd_run_program(plate->model, rows, times, 0, NULL, NULL, factors, until, &report));
  return report;
}

static double force_of(const coupled_plate* plate) {
  double force[2] = {0.0, 0.0};
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pulled_right, force));
  return force[0];
}

static bempd_history_entry last_line(bempd_model* model) {
  int64_t lines = 0;
  bempd_history_entry line;
  CHECK_OK(NULL, bempd_history_entry_init(&line, sizeof line));
  CHECK_OK(model, bempd_history_count(model, &lines));
  CHECK_OK(model, bempd_get_history_entry(model, lines - 1, &line));
  return line;
}

static void a_ramp_breaks_what_a_proportional_load_breaks(void) {
  const coupled_plate expected = coupled_plate_create(), plate = coupled_plate_create();
  const double times[] = {0.5, 0.9, GOAL}, factors[] = {0.2 * GOAL, 0.7 * GOAL, GOAL};
  bempd_step_report step, table;
  outcome wanted, seen;
  CHECK_OK(NULL, bempd_step_report_init(&step, sizeof step));
  CHECK_OK(expected.model, bempd_step(expected.model, GOAL, &step));
  table = run(&plate, 3, times, factors, BEMPD_UNTIL_VALUES);
  CHECK(table.stop_reason == BEMPD_STOP_LOAD_FACTOR && table.events == step.events && table.events > 3);
  CHECK(table.broken_bonds == step.broken_bonds && table.energy_balance_error < 1e-9);
  CHECK_CLOSE(table.load_factor, GOAL, 0.0);
  CHECK_CLOSE(table.released_energy, step.released_energy, 1e-9 * step.work);
  wanted = coupled_plate_outcome(&expected);
  seen = coupled_plate_outcome(&plate);
  CHECK(outcome_difference(&seen, &wanted) < 1e-8);
  outcome_free(&wanted);
  outcome_free(&seen);
  bempd_model_free(expected.model);
  bempd_model_free(plate.model);
}

/** A closed loop of loads below the first break returns its work, in either direction. */
static void a_loop_without_a_break_returns_its_work(void) {
  const coupled_plate plate = coupled_plate_create();
  const double top[] = {1.0}, up[] = {0.05};
  const double times[] = {2.0, 3.5, 4.0, 5.0}, loop[] = {0.02, -0.05, -0.05, 0.0};
  bempd_step_report report;
  double force, work;
  CHECK_OK(plate.model, bempd_set_option_text(plate.model, "contact", "none")); /* the same both ways */
  report = run(&plate, 1, top, up, BEMPD_UNTIL_VALUES);
  force = force_of(&plate);
  work = report.work;
  CHECK(report.events == 0 && force > 0.0 && work > 0.0);
  report = run(&plate, 3, times, loop, BEMPD_UNTIL_VALUES);
  CHECK_CLOSE(report.work, work, 1e-12 * work);
  CHECK_CLOSE(force_of(&plate), -force, 1e-12 * force);
  report = run(&plate, 4, times, loop, BEMPD_UNTIL_VALUES);
  CHECK(report.events == 0 && report.energy_balance_error < 1e-12);
  CHECK_CLOSE(report.work, 0.0, 1e-12 * work);
  CHECK_CLOSE(report.stored_energy, 0.0, 1e-12 * work);
  CHECK_CLOSE(force_of(&plate), 0.0, 1e-12 * force);
  bempd_model_free(plate.model);
}

/** What is broken stays so: unloading and loading again to the same factor is elastic and costs nothing. */
static void damage_of_a_cycle_stays(void) {
  const coupled_plate plate = coupled_plate_create();
  const double times[] = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const double factors[] = {0.8 * GOAL, 0.0, 0.8 * GOAL, 0.0, 0.8 * GOAL, 3.0 * GOAL};
  const bempd_step_report first = run(&plate, 1, times, factors, BEMPD_UNTIL_VALUES);
  const double force = force_of(&plate);
  bempd_step_report report = run(&plate, 2, times, factors, BEMPD_UNTIL_VALUES);
  CHECK(first.events > 1 && report.events == 0 && last_line(plate.model).event == 0);
  /* Unloaded the body has back what it stored, and the rest is what breaking released. */
  CHECK_CLOSE(report.work, first.released_energy, 1e-10 * first.work);
  CHECK_CLOSE(report.stored_energy, 0.0, 1e-12 * first.work);
  report = run(&plate, 5, times, factors, BEMPD_UNTIL_VALUES);
  CHECK(report.events == 0);
  CHECK_CLOSE(report.work, first.work, 1e-10 * first.work);
  CHECK_CLOSE(force_of(&plate), force, 1e-10 * force);
  report = run(&plate, 6, times, factors, BEMPD_UNTIL_VALUES);
  CHECK(report.events > 0 && report.energy_balance_error < 1e-9);
  bempd_model_free(plate.model);
}

static void a_program_that_ended_early_goes_on(void) {
  const coupled_plate expected = coupled_plate_create(), plate = coupled_plate_create();
  const double times[] = {1.0, 2.0, 3.0}, factors[] = {0.9 * GOAL, 0.1, GOAL};
  const bempd_step_report whole = run(&expected, 3, times, factors, BEMPD_UNTIL_VALUES);
  bempd_step_report report;
  int64_t events = 0, broken = 0;
  outcome wanted, seen;
  do {
    report = run(&plate, 3, times, factors, BEMPD_UNTIL_EVENT);
    events += report.events;
    broken += report.broken_bonds;
    CHECK(report.events <= 1);
  } while (report.stop_reason == BEMPD_STOP_EVENT);
  CHECK(report.stop_reason == BEMPD_STOP_LOAD_FACTOR && events == whole.events && broken == whole.broken_bonds);
  wanted = coupled_plate_outcome(&expected);
  seen = coupled_plate_outcome(&plate);
  CHECK(outcome_difference(&seen, &wanted) < 1e-8);
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "already",
              bempd_run_program(plate.model, 3, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL));
  outcome_free(&wanted);
  outcome_free(&seen);
  bempd_model_free(expected.model);
  bempd_model_free(plate.model);
}

/** A dead load that takes the time and a pull with a column of its own. */
static void columns_move_what_they_are_of(void) {
  bempd_model* model = pd_block();
  const double unit = 1.0;
  const int32_t kinds[] = {BEMPD_COLUMN_LOAD, BEMPD_COLUMN_SUPPORT};
  const double times[] = {1.0, 4.0}, again[] = {4.0, 6.0}, factors[] = {1e-3, 1e-3, -2e-3, 0.0};
  int32_t ids[2], held = 0;
  double force[2];
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &unit, &held));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 0.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &unit, &ids[0]));
  CHECK_OK(model, bempd_add_body_force(model, 1, BEMPD_X, 0.0, 1e-4, NULL));
  ids[1] = held;
  CHECK_OK(model, bempd_run_program(model, 2, times, 2, kinds, ids, factors, BEMPD_UNTIL_VALUES, NULL));
  CHECK_OK(model, bempd_reaction(model, held, force));
  CHECK_CLOSE(force[0], 2e-3 * 8.0 - 4.0 * 1e-4 * 80.0, 1e-9);
  /* A first row at the present time acts at once. */
  CHECK_OK(model, bempd_run_program(model, 2, again, 2, kinds, ids, factors, BEMPD_UNTIL_VALUES, NULL));
  CHECK_OK(model, bempd_reaction(model, held, force));
  CHECK_CLOSE(force[0], 2e-3 * 8.0 - 6.0 * 1e-4 * 80.0, 1e-9);
  bempd_model_free(model);
}

static int32_t stop_at_third(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)broken_bonds, (void)user;
  return events >= 3;
}

static void a_cancelled_program_has_not_begun(void) {
  const coupled_plate plate = coupled_plate_create();
  const double times[] = {0.5, 1.0, 2.0, 3.0}, factors[] = {0.01, 0.02, 0.0, GOAL};
  outcome before, after;
  run(&plate, 1, times, factors, BEMPD_UNTIL_VALUES);
  before = coupled_plate_outcome(&plate);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, stop_at_third, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_CANCELLED, "progress",
              bempd_run_program(plate.model, 4, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL));
  after = coupled_plate_outcome(&plate);
  CHECK(outcome_difference(&before, &after) < 1e-12);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, NULL, NULL));
  CHECK(run(&plate, 4, times, factors, BEMPD_UNTIL_VALUES).events > 3);
  outcome_free(&before);
  outcome_free(&after);
  bempd_model_free(plate.model);
}

#define REFUSED(words, ...) \
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, words, bempd_run_program(plate.model, __VA_ARGS__))

static void tables_that_cannot_be_meant_are_refused(void) {
  const coupled_plate plate = coupled_plate_create();
  const double times[] = {1.0, 2.0}, same[] = {1.0, 1.0}, back[] = {2.0, 1.0}, lost[] = {1.0, NAN},
               far[] = {1.0, INFINITY};
  const double factors[] = {0.1, 0.2, 0.3, 0.4}, past[] = {-2.0, -1.0};
  const int32_t kinds[] = {BEMPD_COLUMN_SUPPORT, BEMPD_COLUMN_SUPPORT}, load[] = {BEMPD_COLUMN_LOAD}, odd[] = {3};
  const int32_t ids[] = {1, 1}, none[] = {0}, many[] = {99};
  bempd_step_report report;
  REFUSED("row_count is 0", 0, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("row_count is -1", -1, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("row_count", INT64_MAX, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("column_count", 2, times, -1, kinds, ids, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("column_count", 2, times, INT64_MAX, kinds, ids, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("times is NULL", 2, NULL, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("factors is NULL", 2, times, 0, NULL, NULL, NULL, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("kinds is NULL", 2, times, 1, NULL, ids, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("ids is NULL", 2, times, 1, kinds, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("increase", 2, same, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("increase", 2, back, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("time 2 is", 2, lost, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("time 2 is", 2, far, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("row 2, column 1", 2, times, 0, NULL, NULL, lost, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("already", 2, past, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("kind 1 is 3", 2, times, 1, odd, ids, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("support 0", 2, times, 1, kinds, none, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("support 99", 2, times, 1, kinds, many, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("load 1", 2, times, 1, load, ids, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("column before", 2, times, 2, kinds, ids, factors, BEMPD_UNTIL_VALUES, NULL);
  REFUSED("BEMPD_UNTIL_EVENT", 2, times, 0, NULL, NULL, factors, 9, NULL);
  memset(&report, 0, sizeof report);
  REFUSED("struct_size", 2, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, &report);
  CHECK_OK(plate.model, bempd_set_option_text(plate.model, "stepping.control", "path"));
  REFUSED("path", 2, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model",
              bempd_run_program(NULL, 2, times, 0, NULL, NULL, factors, BEMPD_UNTIL_VALUES, NULL));
  bempd_model_free(plate.model);
}

static void temperatures_of_boundary_elements_have_columns(void) {
  bempd_model* model = bem_block();
  const double times[] = {1.0}, factors[] = {0.1}, unit = 1e-4;
  const int32_t load[] = {BEMPD_COLUMN_LOAD}, first[] = {1};
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_temperature(model, 1, 0.0, 1.0, NULL));
  CHECK_OK(model, bempd_run_program(model, 1, times, 1, load, first, factors, BEMPD_UNTIL_VALUES, NULL));
  CHECK_OK(model, bempd_set_load_values(model, 1, 1, &unit, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  bempd_model_free(model);
}

static void pressures_that_no_crack_has_are_refused(void) {
  static const double wrong[] = {NAN, INFINITY, -INFINITY};
  const double crack[] = {0.0, 3.5, 4.0, 3.5}, many[] = {1.0, 2.0};
  bempd_model* model = pd_block();
  int32_t load = 0;
  size_t k;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 1", bempd_add_crack_pressure(model, 1, 0.0, 1.0, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite", bempd_add_crack_pressure(model, 1, wrong[k], 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite", bempd_add_crack_pressure(model, 1, 0.0, wrong[k], NULL));
  }
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 0", bempd_add_crack_pressure(model, 0, 0.0, 1.0, NULL));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model", bempd_add_crack_pressure(NULL, 1, 0.0, 1.0, NULL));
  CHECK_OK(model, bempd_add_crack_pressure(model, 1, 0.0, 1e-6, &load));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 1", bempd_remove_crack(model, 1));
  CHECK_OK(model, bempd_fix_edge(model, 1, 2, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "2", bempd_set_load_values(model, load, 2, many, NULL));
  CHECK_OK(model, bempd_set_load_values(model, load, 1, many, NULL));
  bempd_model_free(model);
}

int main(void) {
  a_ramp_breaks_what_a_proportional_load_breaks();
  a_loop_without_a_break_returns_its_work();
  damage_of_a_cycle_stays();
  a_program_that_ended_early_goes_on();
  columns_move_what_they_are_of();
  a_cancelled_program_has_not_begun();
  tables_that_cannot_be_meant_are_refused();
  temperatures_of_boundary_elements_have_columns();
  pressures_that_no_crack_has_are_refused();
  return check_finish();
}

/* A step that is asked to stop keeps what it has done; long parts of calls say how far they are. */
#define _POSIX_C_SOURCE 200112L /* nanosleep() */
#define CRACK_RULE "bond"
#include <time.h>

#include "scenes.h"

typedef struct listener {
  bempd_model* model;
  int64_t calls;
  int64_t stop_at; /**< call that asks for the end of the step */
} listener;

static int32_t stop_after_events(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  listener* heard = (listener*)user;
  (void)load_factor, (void)events, (void)broken_bonds;
  if (++heard->calls == heard->stop_at) CHECK_OK(NULL, bempd_request_stop(heard->model));
  return 0;
}

/** Outcome of a run to as many events, one step for each. */
static outcome outcome_after_events(int64_t events) {
  const coupled_plate plate = coupled_plate_create();
  outcome seen;
  int64_t k;
  for (k = 0; k < events; ++k) CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, NULL));
  seen = coupled_plate_outcome(&plate);
  bempd_model_free(plate.model);
  return seen;
}

static void stopped_step_keeps_its_events(const char* solver) {
  const coupled_plate plate = coupled_plate_create();
  listener heard = {NULL, 0, 3};
  bempd_step_report report;
  outcome expected = outcome_after_events(3), seen;
  bempd_history_entry line;
  int64_t lines = 0;
  heard.model = plate.model;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(NULL, bempd_history_entry_init(&line, sizeof line));
  CHECK_OK(plate.model, bempd_set_option_text(plate.model, "test.solver", solver));
  CHECK_OK(plate.model, bempd_set_progress(plate.model, stop_after_events, &heard));
  CHECK_OK(plate.model, bempd_run_to_separation(plate.model, 100.0, &report));
  CHECK(report.stop_reason == BEMPD_STOP_REQUESTED && report.events == 3 && !report.separated);
  seen = coupled_plate_outcome(&plate);
  CHECK(outcome_difference(&seen, &expected) <= 1e-9);
  outcome_free(&seen);
  outcome_free(&expected);

  /* The history ends with the line of the step's end, and the run goes on from there. */
  CHECK_OK(plate.model, bempd_history_count(plate.model, &lines));
  CHECK_OK(plate.model, bempd_get_history_entry(plate.model, lines - 1, &line));
  CHECK(line.event == 0 && line.load_factor == report.load_factor);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, NULL, NULL));
  CHECK_OK(plate.model, bempd_run_to_separation(plate.model, 1e4, &report));
  CHECK(report.separated && report.total_events == report.events + 3);
  bempd_model_free(plate.model);
}

static void early_request_is_forgotten(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK(bempd_request_stop(NULL) == BEMPD_ERROR_ARGUMENT);
  CHECK_OK(plate.model, bempd_request_stop(plate.model));
  CHECK_OK(plate.model, bempd_run_to_separation(plate.model, 1e4, &report));
  CHECK(report.stop_reason == BEMPD_STOP_SEPARATED);
  bempd_model_free(plate.model);
}

typedef struct interrupter {
  bempd_model* model;
  int64_t calls;
} interrupter;

/** Asks for the end of the step from the first long part of it. */
static int32_t stop_in_first_phase(const char* phase, double share, double seconds, double expected, void* user) {
  interrupter* one = (interrupter*)user;
  (void)phase, (void)share, (void)seconds, (void)expected;
  if (++one->calls == 1) CHECK_OK(NULL, bempd_request_stop(one->model));
  return 0;
}

/** A run whose next event begins with a long part gives it up: all is as before, and the run goes on as one that nobody
 * disturbs. */
static void next_event_is_given_up(bempd_model* model, outcome (*outcome_of)(bempd_model*)) {
  const struct timespec pause = {0, 150000000}; /* parts are told of ten times a second */
  interrupter one = {NULL, 0};
  bempd_step_report report;
  bempd_statistics before, after;
  outcome was = outcome_of(model), is;
  one.model = model;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(NULL, bempd_statistics_init(&before, sizeof before));
  CHECK_OK(NULL, bempd_statistics_init(&after, sizeof after));
  CHECK_OK(model, bempd_get_statistics(model, &before));
  nanosleep(&pause, NULL);
  CHECK_OK(model, bempd_set_phase_progress(model, stop_in_first_phase, &one));
  CHECK_OK(model, bempd_run_to_separation(model, 1e6, &report));
  CHECK_OK(model, bempd_set_phase_progress(model, NULL, NULL));
  CHECK_OK(model, bempd_get_statistics(model, &after));
  CHECK(one.calls > 0 && report.stop_reason == BEMPD_STOP_REQUESTED && report.events == 0 && !report.separated);
  /* The part was not finished: its factorization is still to come. */
  CHECK(after.sparse_factorizations == before.sparse_factorizations &&
        after.dense_factorizations == before.dense_factorizations);
  is = outcome_of(model);
  CHECK(outcome_same(&was, &is));
  outcome_free(&was);
  outcome_free(&is);
}

static outcome of_lattice(bempd_model* model) {
  outcome seen = {NULL, 0};
  double load_factor = 0.0;
  CHECK_OK(model, bempd_load_factor(model, &load_factor));
  outcome_append(&seen, &load_factor, 1);
  outcome_append_bonds(&seen, model, 2);
  outcome_append_field(&seen, model, 2, BEMPD_DISPLACEMENT);
  return seen;
}

static outcome of_elements(bempd_model* model) {
  outcome seen = {NULL, 0};
  double numbers[2] = {0.0, 0.0};
  CHECK_OK(model, bempd_load_factor(model, &numbers[0]));
  CHECK_OK(model, bempd_crack_length(model, 1, &numbers[1]));
  outcome_append(&seen, numbers, 2);
  outcome_append_field(&seen, model, 1, BEMPD_DISPLACEMENT);
  return seen;
}

/** Events in a lattice: behind a return to an earlier state the next one needs a factorization. */
static void events_in_lattices_are_given_up(const char* rule) {
  outcome expected = {NULL, 0}, seen;
  int disturbed, k;
  for (disturbed = 0; disturbed < 2; ++disturbed) {
    const coupled_plate plate = coupled_plate_create();
    bempd_state* state = NULL;
    CHECK_OK(plate.model, bempd_set_option_text(plate.model, "test.solver", "plain"));
    CHECK_OK(plate.model, bempd_set_option_text(plate.model, "crack.rule", rule));
    CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, NULL));
    CHECK_OK(plate.model, bempd_state_save(plate.model, &state));
    CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, NULL));
    CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
    bempd_state_free(state);
    if (disturbed)
      for (k = 0; k < 2; ++k) next_event_is_given_up(plate.model, of_lattice);
    for (k = 0; k < 2; ++k) CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, NULL));
    seen = of_lattice(plate.model);
    if (disturbed)
      CHECK(outcome_difference(&seen, &expected) <= 1e-9);
    else
      expected = seen;
    if (disturbed) outcome_free(&seen);
    bempd_model_free(plate.model);
  }
  outcome_free(&expected);
}

/** Growth of a crack with boundary elements: the longer crack's operators are built inside the event. */
static void growth_is_given_up(void) {
  static const double crack[4] = {0.0, 2.0, 1.0, 2.2};
  const double pull = 1e-3;
  outcome expected = {NULL, 0}, seen;
  int disturbed, k;
  for (disturbed = 0; disturbed < 2; ++disturbed) {
    bempd_material tough = sound_material();
    int32_t material = 0;
    bempd_model* model = new_model();
    tough.fracture_energy = 1.0;
    tough.critical_stretch = 0.0;
    CHECK_OK(model, bempd_add_material(model, &tough, &material));
    add_bem_rectangle(model, material, 0.0, 0.0, 4.0, 4.0, 1.0);
    CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
    CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_prescribe_edge(model, 1, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &pull, NULL));
    CHECK_OK(model, bempd_step_to_next_event(model, 1e6, NULL));
    if (disturbed)
      for (k = 0; k < 2; ++k) next_event_is_given_up(model, of_elements);
    for (k = 0; k < 2; ++k) CHECK_OK(model, bempd_step_to_next_event(model, 1e6, NULL));
    seen = of_elements(model);
    if (disturbed)
      CHECK(outcome_difference(&seen, &expected) <= 1e-9 * fabs(expected.numbers[0]));
    else
      expected = seen;
    if (disturbed) outcome_free(&seen);
    bempd_model_free(model);
  }
  outcome_free(&expected);
}

/** A plate with so many cells along each side of its lattice; with 150 its preparation takes longer than the pause
 * between two calls. */
static bempd_model* plate_of_cells(double cells) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  add_pd_rectangle(model, material, 0.0, 0.0, cells, cells, 1.0);
  add_bem_rectangle(model, material, cells, 0.0, 2.0 * cells, cells, 0.01 * cells);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  return model;
}

typedef struct phases {
  bempd_model* model;
  int64_t calls, wrong, stop, foretold;

  char last[80];
} phases;

static int32_t hear_phase(const char* phase, double share, double seconds, double expected, void* user) {
  phases* heard = (phases*)user;
  ++heard->calls;
  if (phase == NULL || phase[0] == '\0' || !(share >= 0.0 && share <= 1.0) || !(seconds >= 0.0)) ++heard->wrong;
  if (share > 0.0 ? !(expected >= seconds) : !(expected >= 0.0)) ++heard->wrong;
  if (share == 0.0 && expected > 0.0 && strstr(phase, "factorization") != NULL) ++heard->foretold;
  strncpy(heard->last, phase, sizeof heard->last - 1);
  /* Nothing else may be called meanwhile. */
  if (bempd_prepare(heard->model) != BEMPD_ERROR_ORDER) ++heard->wrong;
  return heard->stop != 0 && heard->calls >= heard->stop;
}

static void long_parts_say_how_far_they_are(void) {
  bempd_model* model = plate_of_cells(150.0);
  phases heard = {NULL, 0, 0, 1, 0, ""};
  heard.model = model;
  CHECK_OK(model, bempd_set_phase_progress(model, hear_phase, &heard));
  CHECK(bempd_step(model, 1.0, NULL) == BEMPD_ERROR_CANCELLED);
  CHECK(heard.calls == 1 && heard.wrong == 0);
  heard.stop = 0;
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK(heard.calls > 1 && heard.wrong == 0);
  CHECK(heard.foretold > 0); /* long factorizations say when they will end before they begin */
  printf("told %d times, last of \"%s\"\n", (int)heard.calls, heard.last);
  heard.calls = 0;
  CHECK_OK(model, bempd_set_phase_progress(model, NULL, NULL));
  CHECK_OK(model, bempd_step(model, 2.0, NULL));
  CHECK(heard.calls == 0);
  bempd_model_free(model);
}

typedef struct beginning {
  bempd_model* model;
  int64_t asked;
} beginning;

static int32_t stop_at_once(const char* phase, double share, double seconds, double expected, void* user) {
  beginning* one = (beginning*)user;
  (void)phase, (void)share, (void)seconds, (void)expected;
  CHECK_OK(NULL, bempd_request_stop(one->model));
  ++one->asked;
  return 0;
}

/** Report of a step to the load factor 2, or of a program of one row that goes there. */
static bempd_step_report moved(bempd_model* model, int in_program) {
  static const double time = 2.0, factor = 2.0;
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  if (in_program)
    CHECK_OK(model, bempd_run_program(model, 1, &time, 0, NULL, NULL, &factor, BEMPD_UNTIL_VALUES, &report));
  else
    CHECK_OK(model, bempd_step(model, time, &report));
  return report;
}

/** A step that is asked to stop while its scene is prepared, or in its first equilibrium, has done nothing; the next
 * one does what it would have done. Returns the force of the pulled edge. */
static double force_after_stop(int in_program, int is_prepared, int is_stopped) {
  bempd_model* model = plate_of_cells(60.0);
  const double pull = 1e-4;
  double load_factor = -1.0, force[2] = {0.0, 0.0};
  int64_t lines = -1;
  int32_t support = 0;
  beginning one = {NULL, 0};
  bempd_step_report report;
  bempd_statistics statistics;
  one.model = model;
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_prescribe_edge(model, 2, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, &support));
  if (is_prepared) CHECK_OK(model, bempd_prepare(model));
  if (is_stopped) {
    CHECK_OK(model, bempd_set_phase_progress(model, stop_at_once, &one));
    report = moved(model, in_program);
    CHECK_OK(model, bempd_set_phase_progress(model, NULL, NULL));
    CHECK(one.asked > 0 && report.stop_reason == BEMPD_STOP_REQUESTED && report.load_factor == 0.0);
    CHECK(report.events == 0 && report.total_events == 0 && !report.separated);
    CHECK_OK(model, bempd_load_factor(model, &load_factor));
    CHECK_OK(model, bempd_history_count(model, &lines));
    CHECK(load_factor == 0.0 && lines == 0);
    if (is_prepared) {
      CHECK_OK(model, bempd_get_statistics(model, &statistics));
      CHECK(statistics.sparse_factorizations == 0);
    }
  }
  report = moved(model, in_program);
  CHECK(report.stop_reason == BEMPD_STOP_LOAD_FACTOR && report.load_factor == 2.0 && report.residual < 1e-9);
  CHECK_OK(model, bempd_reaction(model, support, force));
  bempd_model_free(model);
  return force[0];
}

static void first_equilibrium_is_given_up(void) {
  const double by_step = force_after_stop(0, 0, 0), by_program = force_after_stop(1, 0, 0);
  int is_prepared;
  CHECK(by_step > 0.0 && by_program > 0.0);
  for (is_prepared = 0; is_prepared < 2; ++is_prepared) {
    CHECK(force_after_stop(0, is_prepared, 1) == by_step);
    CHECK(force_after_stop(1, is_prepared, 1) == by_program);
  }
}

int main(void) {
  stopped_step_keeps_its_events("window");
  stopped_step_keeps_its_events("plain");
  early_request_is_forgotten();
  events_in_lattices_are_given_up("bond");
  events_in_lattices_are_given_up("line");
  growth_is_given_up();
  long_parts_say_how_far_they_are();
  first_equilibrium_is_given_up();
  return check_finish();
}

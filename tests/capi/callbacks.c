/* Callbacks: progress that cancels, boundary functions, the log; a cancelled step returns to its start. */
#define CRACK_RULE "bond"
#include "scenes.h"

typedef struct listener {
  bempd_model* model;  /**< asked to cancel where set */
  int64_t calls;       /**< progress calls so far */
  int64_t last_events; /**< events at the last call */
  int64_t cancel_at;   /**< call that cancels, 0 for none */
  int in_order;        /**< whether events and load factor never fell */
  double last_load_factor;
} listener;

static int32_t listen(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  listener* heard = (listener*)user;
  ++heard->calls;
  if (events <= heard->last_events || load_factor < heard->last_load_factor || broken_bonds < events)
    heard->in_order = 0;
  heard->last_events = events;
  heard->last_load_factor = load_factor;
  if (heard->cancel_at == 0 || heard->calls < heard->cancel_at) return 0;
  if (heard->model == NULL) return 1;
  CHECK_OK(NULL, bempd_request_cancel(heard->model));
  return 0;
}

static listener quiet_listener(void) {
  const listener heard = {NULL, 0, 0, 0, 1, 0.0};
  return heard;
}

static void progress_is_told_after_every_event(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  listener heard = quiet_listener();
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate.model, bempd_set_progress(plate.model, listen, &heard));
  CHECK_OK(plate.model, bempd_step(plate.model, 0.5 * first_event, &report));
  CHECK(heard.calls == 0 && report.events == 0);
  CHECK_OK(plate.model, bempd_step(plate.model, 1.1 * first_event, &report));
  CHECK(report.events > 0 && heard.calls == report.events && heard.in_order);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, NULL, NULL));
  CHECK_OK(plate.model, bempd_step(plate.model, 1.2 * first_event, NULL));
  CHECK(heard.calls == report.events);
  bempd_model_free(plate.model);
}

/**
 * Cancel the step from `start` to `goal` at some event, by the return value or by a request; then let it run. The model
 * is as before to the last bit; the step that then runs through may find its way to the same answer by other rounding.
 */
static void cancelled_step_returns_to_its_start(double start, double goal, int64_t cancel_at, int by_request) {
  const coupled_plate plate = coupled_plate_create();
  const coupled_plate undisturbed = coupled_plate_create();
  listener heard = quiet_listener();
  outcome before, after, seen, expected;
  CHECK_OK(plate.model, bempd_step(plate.model, start, NULL));
  CHECK_OK(undisturbed.model, bempd_step(undisturbed.model, start, NULL));
  CHECK_OK(undisturbed.model, bempd_step(undisturbed.model, goal, NULL));
  before = coupled_plate_outcome(&plate);
  heard.cancel_at = cancel_at;
  if (by_request) heard.model = plate.model;
  CHECK_OK(plate.model, bempd_set_progress(plate.model, listen, &heard));
  CHECK_FAILS(plate.model, BEMPD_ERROR_CANCELLED, "cancel|stop", bempd_step(plate.model, goal, NULL));
  CHECK(heard.calls == cancel_at);
  after = coupled_plate_outcome(&plate);
  CHECK(outcome_same(&before, &after));
  CHECK_OK(plate.model, bempd_set_progress(plate.model, NULL, NULL));
  CHECK_OK(plate.model, bempd_step(plate.model, goal, NULL));
  seen = coupled_plate_outcome(&plate);
  expected = coupled_plate_outcome(&undisturbed);
  CHECK_CLOSE(outcome_difference(&seen, &expected), 0.0, 1e-9);
  outcome_free(&before);
  outcome_free(&after);
  outcome_free(&seen);
  outcome_free(&expected);
  bempd_model_free(plate.model);
  bempd_model_free(undisturbed.model);
}

static void cancelled_step_leaves_the_counters(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  listener heard = quiet_listener();
  bempd_statistics statistics;
  bempd_step_report report;
  int64_t lines = 0;
  heard.cancel_at = 1;
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate.model, bempd_set_progress(plate.model, listen, &heard));
  CHECK_FAILS(plate.model, BEMPD_ERROR_CANCELLED, "cancel|stop",
              bempd_run_to_separation(plate.model, 100.0 * first_event, &report));
  CHECK_FAILS(plate.model, BEMPD_ERROR_CANCELLED, "cancel|stop",
              bempd_step_to_next_event(plate.model, 100.0 * first_event, &report));
  CHECK_OK(plate.model, bempd_get_statistics(plate.model, &statistics));
  CHECK_OK(plate.model, bempd_history_count(plate.model, &lines));
  CHECK(statistics.broken_bonds == 0 && lines == 0);
  CHECK_OK(plate.model, bempd_set_progress(plate.model, NULL, NULL));
  CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0 * first_event, &report));
  CHECK(report.events == 1 && report.total_events == 1 && report.broken_bonds == report.total_broken_bonds);
  CHECK_CLOSE(report.load_factor, first_event, 0.0);
  bempd_model_free(plate.model);
}

/** The model is at work while its callback runs: other calls on it are refused and change nothing. */
static int32_t call_back(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  const coupled_plate* plate = (const coupled_plate*)user;
  double value = 0.0;
  (void)load_factor, (void)events, (void)broken_bonds;
  CHECK(bempd_step(plate->model, 0.0, NULL) == BEMPD_ERROR_ORDER);
  CHECK(bempd_load_factor(plate->model, &value) == BEMPD_ERROR_ORDER);
  CHECK(check_has_word(bempd_last_error(NULL), "callback"));
  return 0;
}

static void callbacks_cannot_call_their_model(double first_event) {
  coupled_plate plate = coupled_plate_create();
  const coupled_plate undisturbed = coupled_plate_create();
  outcome seen, expected;
  CHECK_OK(plate.model, bempd_set_progress(plate.model, call_back, &plate));
  CHECK_OK(plate.model, bempd_step(plate.model, 1.05 * first_event, NULL));
  CHECK_OK(undisturbed.model, bempd_step(undisturbed.model, 1.05 * first_event, NULL));
  seen = coupled_plate_outcome(&plate);
  expected = coupled_plate_outcome(&undisturbed);
  CHECK(outcome_same(&seen, &expected));
  outcome_free(&seen);
  outcome_free(&expected);
  bempd_model_free(plate.model);
  bempd_model_free(undisturbed.model);
}

static void early_request_to_cancel_is_forgotten(void) {
  const coupled_plate plate = coupled_plate_create();
  CHECK_OK(plate.model, bempd_request_cancel(plate.model));
  CHECK_OK(plate.model, bempd_step(plate.model, 0.1, NULL));
  bempd_model_free(plate.model);
}

/** A traction of 3 (constant) and 5 (proportional) along x, and a count of calls; cancels at the call asked for. */
typedef struct boundary_values {
  int64_t calls;
  int64_t cancel_at;
  double extra; /**< added to the proportional part, to try NaN */
  int on_edge;  /**< whether every place lay on the edge x = 10 and both parts were 0 on entry */
} boundary_values;

static int32_t give_values(double x, double y, double* constant, double* proportional, void* user) {
  boundary_values* given = (boundary_values*)user;
  ++given->calls;
  if (fabs(x - 10.0) > 1e-9 || y < -1e-9 || y > 8.0 + 1e-9) given->on_edge = 0;
  if (constant[0] != 0.0 || constant[1] != 0.0 || proportional[0] != 0.0 || proportional[1] != 0.0) given->on_edge = 0;
  constant[0] = 3.0;
  proportional[0] = 5.0 + given->extra;
  return given->cancel_at != 0 && given->calls >= given->cancel_at;
}

static void boundary_function_gives_tractions(void) {
  bempd_model* model = bem_block();
  boundary_values given = {0, 0, 0.0, 1};
  const double place[2] = {5.0, 4.0};
  double stress[3] = {0.0, 0.0, 0.0};
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_X, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 4.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction_function(model, 1, 2, 0.0, 1.0, give_values, &given, NULL));
  CHECK_OK(model, bempd_step(model, 2.0, NULL));
  CHECK(given.calls > 0 && given.on_edge);
  CHECK_OK(model, bempd_evaluate(model, 1, place, NULL, stress, NULL));
  CHECK_CLOSE(stress[0], 13.0, 1e-6);
  bempd_model_free(model);
}

static void boundary_function_can_cancel(void) {
  bempd_model* model = bem_block();
  boundary_values given = {0, 1, 0.0, 1};
  bempd_status status;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  status = bempd_add_traction_function(model, 1, 2, 0.0, 1.0, give_values, &given, NULL);
  if (status == BEMPD_OK) status = bempd_prepare(model);
  CHECK(status == BEMPD_ERROR_CANCELLED && given.calls == 1);
  CHECK(check_has_word(bempd_last_error(model), "cancel|stop"));
  given.cancel_at = 0;
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  bempd_model_free(model);
}

static void boundary_function_gives_finite_values(void) {
  bempd_model* model = bem_block();
  boundary_values given = {0, 0, NAN, 1};
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_REFUSED_BY_PREPARE(model, "finite|nan",
                           bempd_add_traction_function(model, 1, 2, 0.0, 1.0, give_values, &given, NULL));
  bempd_model_free(model);
  model = bem_block();
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_REFUSED_BY_PREPARE(model, "finite|nan",
                           bempd_prescribe_edge_function(model, 1, 2, 0.0, 1.0, BEMPD_BOTH, give_values, &given, NULL));
  bempd_model_free(model);
}

typedef struct log_lines {
  int64_t count;
  int good;
} log_lines;

static void keep_line(int32_t level, const char* message, void* user) {
  log_lines* lines = (log_lines*)user;
  ++lines->count;
  if (level < 1 || level > 3 || message == NULL || message[0] == '\0') lines->good = 0;
}

static void log_receives_lines(void) {
  const coupled_plate plate = coupled_plate_create();
  log_lines lines = {0, 1};
  int64_t so_far;
  CHECK_OK(plate.model, bempd_set_log(plate.model, keep_line, &lines));
  CHECK_OK(plate.model, bempd_prepare(plate.model));
  CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, NULL));
  CHECK(lines.count > 0 && lines.good);
  so_far = lines.count;
  CHECK_OK(plate.model, bempd_set_log(plate.model, NULL, NULL));
  CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, NULL));
  CHECK(lines.count == so_far);
  bempd_model_free(plate.model);
}

/** A model that its own callback frees lives until the call that runs returns. */
static int32_t free_in_progress(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  bempd_model** model = (bempd_model**)user;
  (void)load_factor, (void)events, (void)broken_bonds;
  bempd_model_free(*model);
  bempd_model_free(*model);
  CHECK(bempd_step(*model, 0.0, NULL) == BEMPD_ERROR_ORDER);
  *model = NULL;
  return 1;
}

static void free_in_log(int32_t level, const char* message, void* user) {
  bempd_model** model = (bempd_model**)user;
  (void)level, (void)message;
  bempd_model_free(*model);
  *model = NULL;
}

static int32_t free_in_boundary_function(double x, double y, double* constant, double* proportional, void* user) {
  bempd_model** model = (bempd_model**)user;
  (void)x, (void)y, (void)constant, (void)proportional;
  bempd_model_free(*model);
  *model = NULL;
  return 0;
}

static void callbacks_can_free_their_model(void) {
  coupled_plate plate = coupled_plate_create();
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate.model, bempd_set_progress(plate.model, free_in_progress, &plate.model));
  CHECK(bempd_step_to_next_event(plate.model, 100.0, &report) == BEMPD_ERROR_CANCELLED);
  CHECK(plate.model == NULL);
  CHECK(check_has_word(bempd_last_error(NULL), "progress callback"));

  plate = coupled_plate_create();
  CHECK_OK(plate.model, bempd_set_log(plate.model, free_in_log, &plate.model));
  CHECK(bempd_step(plate.model, 0.1, &report) == BEMPD_OK);
  CHECK(plate.model == NULL && report.stop_reason == BEMPD_STOP_LOAD_FACTOR);

  plate.model = bem_block();
  CHECK_OK(plate.model, bempd_fix_edge(plate.model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(plate.model,
           bempd_add_traction_function(plate.model, 1, 2, 0.0, 1.0, free_in_boundary_function, &plate.model, NULL));
  if (plate.model != NULL) CHECK(bempd_prepare(plate.model) == BEMPD_OK);
  CHECK(plate.model == NULL);
}

static void count_gaps(int32_t level, const char* message, void* user) {
  if (level == 1 && strstr(message, "apart") != NULL && strstr(message, "regions 1 and 2") != NULL) ++*(int*)user;
}

/** Two squares side by side: bonded within 1e-9 of the diagonal, else told to the log up to a tenth of an element. */
static void gaps_between_regions_are_logged(void) {
  const double gaps[] = {0.0, 1e-9, 1e-8, 1e-6, 1e-4, 1e-2, 0.03};
  const int logged[] = {0, 0, 1, 1, 1, 1, 0};
  size_t k;
  for (k = 0; k < sizeof gaps / sizeof gaps[0]; ++k) {
    bempd_model* model = new_model();
    const int32_t material = add_sound_material(model);
    int count = 0;
    add_bem_rectangle(model, material, 0.0, 0.0, 1.0, 1.0, 0.25);
    add_bem_rectangle(model, material, 1.0 + gaps[k], 0.0, 2.0, 1.0, 0.25);
    CHECK_OK(model, bempd_fix_edge(model, 1, 1, 3, NULL));
    CHECK_OK(model, bempd_fix_edge(model, 2, 1, 3, NULL));
    CHECK_OK(model, bempd_set_log(model, count_gaps, &count));
    CHECK_OK(model, bempd_prepare(model));
    CHECK(count == logged[k]);
    bempd_model_free(model);
  }
}

int main(void) {
  const double first_event = coupled_plate_first_event();
  progress_is_told_after_every_event(first_event);
  cancelled_step_returns_to_its_start(0.5 * first_event, 1.1 * first_event, 1, 0);
  cancelled_step_returns_to_its_start(0.5 * first_event, 1.1 * first_event, 2, 1);
  cancelled_step_returns_to_its_start(1.02 * first_event, 1.3 * first_event, 1, 0);
  cancelled_step_leaves_the_counters(first_event);
  callbacks_cannot_call_their_model(first_event);
  early_request_to_cancel_is_forgotten();
  boundary_function_gives_tractions();
  boundary_function_can_cancel();
  boundary_function_gives_finite_values();
  log_receives_lines();
  callbacks_can_free_their_model();
  gaps_between_regions_are_logged();
  return check_finish();
}

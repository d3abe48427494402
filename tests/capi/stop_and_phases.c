/* A step that is asked to stop keeps what it has done; long parts of calls say how far they are. */
#define CRACK_RULE "bond"
#include <pthread.h>
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

typedef struct impatient {
  bempd_model* model;
  double seconds; /**< until the request */
  volatile int has_ended;
} impatient;

static void* request_later(void* user) {
  impatient* one = (impatient*)user;
  const clock_t start = clock();
  while (!one->has_ended && (double)(clock() - start) < one->seconds * CLOCKS_PER_SEC) {
  }
  while (!one->has_ended) bempd_request_stop(one->model); /* a request before the call is forgotten */
  return NULL;
}

/** A plate of which each event changes the whole body, run to its end by steps that are asked to end at any moment,
 * most of them inside an event: these events are given up, and the run is the one that nobody disturbs. */
static void events_are_given_up(const char* rule) {
  outcome seen[2];
  bempd_step_report report;
  double seconds = 0.0;
  int64_t inside = 0, calls = 0;
  int disturbed;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  for (disturbed = 0; disturbed < 2; ++disturbed) {
    const coupled_plate plate = coupled_plate_create();
    impatient one = {NULL, 0.0, 0};
    one.model = plate.model;
    CHECK_OK(plate.model, bempd_set_option_text(plate.model, "test.solver", "plain"));
    CHECK_OK(plate.model, bempd_set_option_text(plate.model, "crack.rule", rule));
    CHECK_OK(plate.model, bempd_step(plate.model, 0.0, NULL));
    do {
      const clock_t start = clock();
      pthread_t other;
      /* Later and later within an event, so that each moment of it is met and the run comes to its end. */
      one.seconds = seconds * (double)(calls % 40) / 8.0;
      one.has_ended = 0;
      if (disturbed) CHECK(pthread_create(&other, NULL, request_later, &one) == 0);
      CHECK_OK(plate.model, bempd_run_to_separation(plate.model, 100.0, &report));
      one.has_ended = 1;
      if (disturbed) pthread_join(other, NULL);
      ++calls;
      if (report.stop_reason == BEMPD_STOP_REQUESTED && report.events == 0) ++inside;
      if (!disturbed) seconds = (double)(clock() - start) / CLOCKS_PER_SEC / (double)report.events;
    } while (report.stop_reason == BEMPD_STOP_REQUESTED);
    CHECK(report.separated);
    seen[disturbed] = coupled_plate_outcome(&plate);
    bempd_model_free(plate.model);
  }
  printf("%s: %d calls, %d of them ended without an event\n", rule, (int)calls, (int)inside);
  CHECK(inside > 10);
  CHECK(outcome_difference(&seen[0], &seen[1]) <= 1e-9);
  outcome_free(&seen[0]);
  outcome_free(&seen[1]);
}

/** A plate large enough that its preparation takes longer than the pause between two calls. */
static bempd_model* large_plate(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  add_pd_rectangle(model, material, 0.0, 0.0, 150.0, 150.0, 1.0);
  add_bem_rectangle(model, material, 150.0, 0.0, 300.0, 150.0, 1.5);
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
  bempd_model* model = large_plate();
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

int main(void) {
  stopped_step_keeps_its_events("window");
  stopped_step_keeps_its_events("plain");
  early_request_is_forgotten();
  events_are_given_up("bond");
  events_are_given_up("line");
  long_parts_say_how_far_they_are();
  return check_finish();
}

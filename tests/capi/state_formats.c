/* States that earlier versions of the library wrote are read: tests/data has one for each format, of the same run. */
#define CRACK_RULE "bond"
#include "scenes.h"

enum { events_before = 3, events_behind = 20 };

/** A run that begins with a state of an older format has the events of one without a break. */
static void older_states_go_on(const char* path) {
  const coupled_plate plate = coupled_plate_create(), straight = coupled_plate_create();
  bempd_state* state = NULL;
  int k;
  CHECK_OK(NULL, bempd_state_read(path, &state));
  CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
  for (k = 0; k < events_before; ++k) CHECK_OK(straight.model, bempd_step_to_next_event(straight.model, 1e4, NULL));
  for (k = 0; k < events_behind; ++k) {
    bempd_step_report seen, expected;
    CHECK_OK(NULL, bempd_step_report_init(&seen, sizeof seen));
    CHECK_OK(NULL, bempd_step_report_init(&expected, sizeof expected));
    CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 1e4, &seen));
    CHECK_OK(straight.model, bempd_step_to_next_event(straight.model, 1e4, &expected));
    CHECK(seen.total_events == expected.total_events && seen.total_broken_bonds == expected.total_broken_bonds);
    CHECK_CLOSE(seen.load_factor, expected.load_factor, 1e-9 * expected.load_factor);
    CHECK_CLOSE(seen.released_energy, expected.released_energy, 1e-9 * expected.released_energy);
  }
  bempd_state_free(state);
  bempd_model_free(plate.model);
  bempd_model_free(straight.model);
}

/** The state is one of its own scene, also in the words of its own format. */
static void older_states_of_other_options_are_refused(const char* path) {
  const coupled_plate plate = coupled_plate_create();
  bempd_state* state = NULL;
  CHECK_OK(NULL, bempd_state_read(path, &state));
  CHECK_OK(plate.model, bempd_set_option_text(plate.model, "contact", "none"));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "another scene", bempd_state_restore(plate.model, state));
  bempd_state_free(state);
  bempd_model_free(plate.model);
}

int main(int count, char** words) {
  if (count != 2) return EXIT_FAILURE;
  older_states_go_on(words[1]);
  older_states_of_other_options_are_refused(words[1]);
  return check_finish();
}

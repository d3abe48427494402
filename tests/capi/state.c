/* Saved states: a host can repeat a step, and carry a state to another process. */
#include "scenes.h"

static bempd_state* save(const coupled_plate* plate) {
  bempd_state* state = NULL;
  CHECK_OK(plate->model, bempd_state_save(plate->model, &state));
  CHECK(state != NULL);
  return state;
}

static outcome step_and_see(const coupled_plate* plate, double load_factor) {
  CHECK_OK(plate->model, bempd_step(plate->model, load_factor, NULL));
  return coupled_plate_outcome(plate);
}

/** Save at `start`, step to `goal`, go back, step again: the same bits, as often as one likes. */
static void repeated_step_gives_the_same_bits(double start, double goal) {
  const coupled_plate plate = coupled_plate_create();
  outcome at_start = step_and_see(&plate, start);
  bempd_state* state = save(&plate);
  outcome first = step_and_see(&plate, goal);
  int k;
  for (k = 0; k < 2; ++k) {
    outcome restored, again;
    CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
    restored = coupled_plate_outcome(&plate);
    CHECK(outcome_same(&at_start, &restored));
    again = step_and_see(&plate, goal);
    CHECK(outcome_same(&first, &again));
    outcome_free(&restored);
    outcome_free(&again);
  }
  bempd_state_free(state);
  outcome_free(&at_start);
  outcome_free(&first);
  bempd_model_free(plate.model);
}

/** A run that is saved now and then ends in the same bits as one that is not. */
static void saving_alters_no_bit(void) {
  const coupled_plate saved = coupled_plate_create(), other = coupled_plate_create();
  outcome with_saves, without;
  int k;
  for (k = 0; k < 40; ++k) {
    CHECK_OK(saved.model, bempd_step_to_next_event(saved.model, 1e4, NULL));
    CHECK_OK(other.model, bempd_step_to_next_event(other.model, 1e4, NULL));
    if (k % 3 == 0) bempd_state_free(save(&saved));
  }
  with_saves = coupled_plate_outcome(&saved);
  without = coupled_plate_outcome(&other);
  CHECK(outcome_same(&with_saves, &without));
  outcome_free(&with_saves);
  outcome_free(&without);
  bempd_model_free(saved.model);
  bempd_model_free(other.model);
}

static void restoring_brings_back_history_and_counters(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  bempd_state* state;
  bempd_statistics before, after;
  int64_t lines_before = 0;
  int64_t lines_after = 0;
  CHECK_OK(NULL, bempd_statistics_init(&before, sizeof before));
  CHECK_OK(NULL, bempd_statistics_init(&after, sizeof after));
  CHECK_OK(plate.model, bempd_step(plate.model, 1.01 * first_event, NULL));
  CHECK_OK(plate.model, bempd_get_statistics(plate.model, &before));
  CHECK_OK(plate.model, bempd_history_count(plate.model, &lines_before));
  state = save(&plate);
  CHECK_OK(plate.model, bempd_step(plate.model, 1.4 * first_event, NULL));
  CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
  CHECK_OK(plate.model, bempd_get_statistics(plate.model, &after));
  CHECK_OK(plate.model, bempd_history_count(plate.model, &lines_after));
  CHECK(before.broken_bonds > 0 && after.broken_bonds == before.broken_bonds && lines_after == lines_before);
  bempd_state_free(state);
  bempd_model_free(plate.model);
}

/** A state outlives its model, as bytes, in a fresh model of the same scene. */
static void bytes_carry_a_state_to_another_model(double start, double goal) {
  coupled_plate plate = coupled_plate_create();
  outcome at_start = step_and_see(&plate, start);
  bempd_state* state = save(&plate);
  outcome at_goal = step_and_see(&plate, goal);
  outcome seen;
  uint8_t* bytes;
  int64_t size = 0;
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
  bytes = (uint8_t*)malloc((size_t)size + 1);
  if (bytes == NULL) abort();
  CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, NULL));
  bempd_model_free(plate.model);
  bempd_state_free(state);
  state = NULL;
  CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &state));
  free(bytes);
  plate = coupled_plate_create();
  CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
  bempd_state_free(state);
  seen = coupled_plate_outcome(&plate);
  CHECK(outcome_same(&at_start, &seen));
  outcome_free(&seen);
  seen = step_and_see(&plate, goal);
  CHECK(outcome_same(&at_goal, &seen));
  outcome_free(&seen);
  outcome_free(&at_start);
  outcome_free(&at_goal);
  bempd_model_free(plate.model);
}

static void bytes_of_equal_states_are_equal(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  uint8_t* bytes[2] = {NULL, NULL};
  int64_t sizes[2] = {0, 0};
  int k;
  CHECK_OK(plate.model, bempd_step(plate.model, 1.1 * first_event, NULL));
  for (k = 0; k < 2; ++k) {
    bempd_state* state = save(&plate);
    CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &sizes[k]));
    bytes[k] = (uint8_t*)malloc((size_t)sizes[k] + 1);
    if (bytes[k] == NULL) abort();
    CHECK_OK(NULL, bempd_state_to_bytes(state, sizes[k], bytes[k], NULL));
    bempd_state_free(state);
  }
  CHECK(sizes[0] == sizes[1] && memcmp(bytes[0], bytes[1], (size_t)sizes[0]) == 0);
  free(bytes[0]);
  free(bytes[1]);
  bempd_model_free(plate.model);
}

static void two_runs_give_the_same_bits(double goal) {
  const coupled_plate one = coupled_plate_create();
  const coupled_plate other = coupled_plate_create();
  outcome seen_of_one = step_and_see(&one, goal);
  outcome seen_of_other = step_and_see(&other, goal);
  CHECK(outcome_same(&seen_of_one, &seen_of_other));
  outcome_free(&seen_of_one);
  outcome_free(&seen_of_other);
  bempd_model_free(one.model);
  bempd_model_free(other.model);
}

int main(void) {
  const double first_event = coupled_plate_first_event();
  two_runs_give_the_same_bits(1.2 * first_event);
  repeated_step_gives_the_same_bits(0.5 * first_event, 0.9 * first_event);
  repeated_step_gives_the_same_bits(0.5 * first_event, 1.1 * first_event);
  repeated_step_gives_the_same_bits(1.02 * first_event, 1.4 * first_event);
  restoring_brings_back_history_and_counters(first_event);
  bytes_carry_a_state_to_another_model(0.5 * first_event, 0.9 * first_event);
  bytes_carry_a_state_to_another_model(0.5 * first_event, 1.1 * first_event);
  bytes_carry_a_state_to_another_model(1.02 * first_event, 1.4 * first_event);
  bytes_of_equal_states_are_equal(first_event);
  saving_alters_no_bit();
  return check_finish();
}

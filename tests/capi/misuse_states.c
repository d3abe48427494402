/* Saved states that are damaged, cut short or belong to another scene. */
#include "scenes.h"

typedef struct bytes {
  uint8_t* data;
  int64_t size;
} bytes;

static bytes state_bytes(const bempd_state* state) {
  bytes saved = {NULL, 0};
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &saved.size));
  CHECK(saved.size > 16);
  saved.data = (uint8_t*)malloc((size_t)saved.size);
  if (saved.data == NULL) abort();
  CHECK_OK(NULL, bempd_state_to_bytes(state, saved.size, saved.data, NULL));
  return saved;
}

/** A state of the plate after its first event. */
static bempd_state* cracked_state(const coupled_plate* plate) {
  bempd_state* state = NULL;
  CHECK_OK(plate->model, bempd_step_to_next_event(plate->model, 100.0, NULL));
  CHECK_OK(plate->model, bempd_state_save(plate->model, &state));
  CHECK(state != NULL);
  return state;
}

static void unprepared_models_have_no_state(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_state* state = NULL;
  CHECK_FAILS(plate.model, BEMPD_ERROR_ORDER, "prepare", bempd_state_save(plate.model, &state));
  CHECK(state == NULL);
  bempd_model_free(plate.model);
}

static void buffers_have_to_be_large_enough(const bempd_state* state, const bytes* saved) {
  uint8_t* buffer = (uint8_t*)malloc((size_t)saved->size);
  int64_t needed = 0;
  if (buffer == NULL) abort();
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "capacity|buffer",
              bempd_state_to_bytes(state, saved->size - 1, buffer, &needed));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "capacity|buffer", bempd_state_to_bytes(state, -1, buffer, NULL));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "NULL|buffer", bempd_state_to_bytes(state, saved->size, NULL, NULL));
  free(buffer);
}

static void short_bytes_are_refused(const bytes* saved) {
  const int64_t sizes[] = {0, 1, 4, 7, 8, 16, 31, saved->size / 2, saved->size - 1};
  size_t k;
  bempd_state* state = NULL;
  for (k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
    /* A block of exactly this size, so that a read past its end shows under a sanitizer. */
    uint8_t* block = (uint8_t*)malloc((size_t)sizes[k] + (sizes[k] == 0));
    if (block == NULL) abort();
    memcpy(block, saved->data, (size_t)sizes[k]);
    CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "state|bytes|size", bempd_state_from_bytes(sizes[k], block, &state));
    CHECK(state == NULL);
    free(block);
  }
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "size|bytes", bempd_state_from_bytes(-1, saved->data, &state));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "size|bytes", bempd_state_from_bytes(INT64_MIN, saved->data, &state));
}

/** Every byte of the head, then every so many: no single flipped bit goes unseen. */
static void flipped_bits_are_refused(const bytes* saved) {
  const int64_t stride = saved->size / 300 + 1;
  int64_t k;
  for (k = 0; k < saved->size; k += k < 256 ? 1 : stride) {
    bempd_state* state = NULL;
    const uint8_t mask = (uint8_t)(1u << (k % 8));
    saved->data[k] ^= mask;
    CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "state|bytes|checksum|magic|version",
                bempd_state_from_bytes(saved->size, saved->data, &state));
    CHECK(state == NULL);
    bempd_state_free(state);
    saved->data[k] ^= mask;
  }
}

static void noise_is_refused(void) {
  uint8_t noise[4096];
  uint32_t seed = 12345;
  size_t k;
  bempd_state* state = NULL;
  for (k = 0; k < sizeof noise; ++k) {
    seed = seed * 1664525u + 1013904223u;
    noise[k] = (uint8_t)(seed >> 24);
  }
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "state|bytes", bempd_state_from_bytes((int64_t)sizeof noise, noise, &state));
  memset(noise, 0, sizeof noise);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "state|bytes", bempd_state_from_bytes((int64_t)sizeof noise, noise, &state));
  CHECK(state == NULL);
}

/** The plate's scene, with the right rectangle a little longer. */
static bempd_model* longer_plate(void) {
  static const double crack[4] = {14.5, 2.5, 14.5, 5.5};
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const int32_t left = add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 2.0);
  add_pd_rectangle(model, material, 10.0, 0.0, 19.0, 8.0, 1.0);
  add_bem_rectangle(model, material, 19.0, 0.0, 29.5, 8.0, 2.0);
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, left, 4, BEMPD_BOTH, NULL));
  return model;
}

static void states_of_other_scenes_are_refused(const bempd_state* state) {
  bempd_model* others[3];
  size_t k;
  others[0] = bem_block();
  CHECK_OK(others[0], bempd_fix_edge(others[0], 1, 4, BEMPD_BOTH, NULL));
  others[1] = pd_block();
  CHECK_OK(others[1], bempd_fix_edge(others[1], 1, 4, BEMPD_BOTH, NULL));
  others[2] = longer_plate();
  for (k = 0; k < 3; ++k) {
    double load_factor = 7.0;
    CHECK_FAILS(others[k], BEMPD_ERROR_ARGUMENT, "scene|other|different|state", bempd_state_restore(others[k], state));
    CHECK_OK(others[k], bempd_load_factor(others[k], &load_factor));
    CHECK(load_factor == 0.0);
    CHECK_OK(others[k], bempd_step(others[k], 0.01, NULL));
    bempd_model_free(others[k]);
  }
}

/** The plate's supports added last first: their reactions would be each other's. */
static void supports_in_another_order_are_refused(const bempd_state* state) {
  static const double crack[4] = {14.5, 0.0, 14.5, 3.5};
  const double pull_left[2] = {-0.002, -0.02};
  const double pull_right[2] = {0.02, 0.002};
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const int32_t left = add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 2.0);
  int32_t right;
  add_pd_rectangle(model, material, 10.0, 0.0, 19.0, 8.0, 1.0);
  right = add_bem_rectangle(model, material, 19.0, 0.0, 29.0, 8.0, 2.0);
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 4.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, right, 2, 0.0, 1.0, BEMPD_X, 2, NULL, pull_right, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, left, 4, 0.0, 1.0, BEMPD_X, 2, NULL, pull_left, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "another order", bempd_state_restore(model, state));
  bempd_model_free(model);
}

/** What shapes the equations belongs to the scene as it was when the model was prepared. */
static void states_of_other_options_are_refused(const bempd_state* state, const coupled_plate* prepared) {
  const coupled_plate other = coupled_plate_create();
  CHECK_OK(other.model, bempd_set_option(other.model, "bem.quadrature_tolerance", 1e-4));
  CHECK_FAILS(other.model, BEMPD_ERROR_ARGUMENT, "scene", bempd_state_restore(other.model, state));
  CHECK_OK(prepared->model, bempd_set_option(prepared->model, "bem.quadrature_tolerance", 1e-4));
  CHECK_OK(prepared->model, bempd_state_restore(prepared->model, state));
  bempd_model_free(other.model);
}

int main(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_state* state = cracked_state(&plate);
  bytes saved = state_bytes(state);
  unprepared_models_have_no_state();
  buffers_have_to_be_large_enough(state, &saved);
  short_bytes_are_refused(&saved);
  flipped_bits_are_refused(&saved);
  noise_is_refused();
  states_of_other_scenes_are_refused(state);
  supports_in_another_order_are_refused(state);
  states_of_other_options_are_refused(state, &plate);
  bempd_state_free(state);
  bempd_model_free(plate.model);
  free(saved.data);
  return check_finish();
}

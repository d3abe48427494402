/* A state written by one process is read by another, which may run on another kind of processor. */
#include "scenes.h"

/** Boundary elements with an arc and a smooth row of edges next to a lattice with a crack. */
static bempd_model* curved_scene(void) {
  static const double crack[4] = {14.5, 0.0, 14.5, 3.5};
  static const double vertices[] = {0.0, 0.0, 10.0, 0.0, 10.0, 8.0, 4.0, 8.0, 1.0, 6.5, 0.0, 4.0};
  const double pull = 0.02;
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  CHECK_OK(model, bempd_add_bem_region(model, material, 6, vertices, 2.0, NULL));
  CHECK_OK(model, bempd_set_edges_smooth(model, 1, 3, 5));
  CHECK_OK(model, bempd_set_edge_arc(model, 1, 1, 5.0, -0.7));
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 5.0, 4.0, 1.5, NULL));
  add_pd_rectangle(model, material, 10.0, 0.0, 19.0, 8.0, 1.0);
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 6, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 2, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  return model;
}

static void write_state(const char* path) {
  bempd_model* model = curved_scene();
  bempd_state* state = NULL;
  int64_t size = 0;
  uint8_t* bytes;
  FILE* file = fopen(path, "wb");
  CHECK_OK(model, bempd_step_to_next_event(model, 100.0, NULL));
  CHECK_OK(model, bempd_state_save(model, &state));
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
  bytes = (uint8_t*)malloc((size_t)size + 1);
  if (bytes == NULL || file == NULL) abort();
  CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, NULL));
  CHECK(fwrite(bytes, 1, (size_t)size, file) == (size_t)size);
  fclose(file);
  free(bytes);
  bempd_state_free(state);
  bempd_model_free(model);
}

/** The state is accepted, and the next event comes where a run without a break in between has it. */
static void read_state(const char* path) {
  bempd_model* model = curved_scene();
  bempd_model* straight = curved_scene();
  bempd_step_report seen, expected;
  bempd_state* state = NULL;
  uint8_t* bytes = (uint8_t*)malloc(1 << 24);
  FILE* file = fopen(path, "rb");
  size_t size;
  if (bytes == NULL || file == NULL) abort();
  size = fread(bytes, 1, 1 << 24, file);
  fclose(file);
  CHECK_OK(NULL, bempd_state_from_bytes((int64_t)size, bytes, &state));
  CHECK_OK(model, bempd_state_restore(model, state));
  CHECK_OK(NULL, bempd_step_report_init(&seen, sizeof seen));
  CHECK_OK(NULL, bempd_step_report_init(&expected, sizeof expected));
  CHECK_OK(model, bempd_step_to_next_event(model, 100.0, &seen));
  CHECK_OK(straight, bempd_step_to_next_event(straight, 100.0, NULL));
  CHECK_OK(straight, bempd_step_to_next_event(straight, 100.0, &expected));
  CHECK(seen.total_broken_bonds == expected.total_broken_bonds && seen.total_events == 2);
  CHECK_CLOSE(seen.load_factor, expected.load_factor, 1e-9 * expected.load_factor);
  free(bytes);
  bempd_state_free(state);
  bempd_model_free(model);
  bempd_model_free(straight);
}

int main(int count, char** words) {
  if (count != 3) return EXIT_FAILURE;
  if (strcmp(words[1], "write") == 0)
    write_state(words[2]);
  else
    read_state(words[2]);
  return check_finish();
}

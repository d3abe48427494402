/* What was added can be removed, and corrected after a call that failed, until the model is prepared. */
#include "scenes.h"

static int32_t cancel_at_once(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)events, (void)broken_bonds, (void)user;
  return 1;
}

/** A block that a crack of bad place and a missing support spoil. */
static void a_failed_preparation_can_be_mended(void) {
  const double along_the_edge[] = {2.5, 0.0, 6.5, 0.0};
  const double sound[] = {4.5, 0.0, 4.5, 3.5};
  bempd_model* model = pd_block();
  int32_t crack = 0, support = 0;
  int64_t points = 0;
  CHECK_OK(model, bempd_add_crack(model, 2, along_the_edge, &crack));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "material point", bempd_prepare(model));
  CHECK_OK(model, bempd_remove_crack(model, crack));
  CHECK_OK(model, bempd_add_crack(model, 2, sound, &crack));
  CHECK(crack == 2);
  CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, "support", bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &support));
  CHECK_OK(model, bempd_node_count(model, 1, &points));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepared", bempd_remove_support(model, support));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  bempd_model_free(model);
}

/** A first call that fails after it has prepared leaves the scene open. */
static void a_failed_first_call_leaves_the_scene_open(void) {
  bempd_model* model = pd_block();
  double far_away[] = {1e6, 1e6}, u[2];
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "outside", bempd_evaluate(model, 1, far_away, u, NULL, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 2, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  bempd_model_free(model);
}

static void a_cancelled_first_step_leaves_the_scene_open(void) {
  const double pull = 1.0;
  bempd_model* model = pd_block();
  int32_t support = 0;
  double before[2], after[2];
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &support));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_set_progress(model, cancel_at_once, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_CANCELLED, "asked to stop", bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_set_progress(model, NULL, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 2, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_step(model, 1e-4, NULL));
  CHECK_OK(model, bempd_reaction(model, support, before));
  /* The scene stays from here on, whatever fails. */
  CHECK_OK(model, bempd_set_progress(model, cancel_at_once, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_CANCELLED, "asked to stop", bempd_step(model, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepared", bempd_fix_edge(model, 1, 1, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_reaction(model, support, after));
  CHECK(before[0] == after[0] && before[0] != 0);
  bempd_model_free(model);
}

/** Saves and restores through bytes, with and without the values of loads and supports. */
static void save_and_restore(bempd_model* model) {
  int32_t contents;
  for (contents = BEMPD_STATE_BODY; contents <= BEMPD_STATE_BODY_AND_VALUES; ++contents) {
    bempd_state *state = NULL, *copy = NULL;
    int64_t size = 0;
    uint8_t* bytes = NULL;
    CHECK_OK(model, bempd_state_save_with(model, contents, &state));
    CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
    bytes = (uint8_t*)malloc((size_t)size);
    CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, &size));
    CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &copy));
    CHECK_OK(model, bempd_state_restore(model, copy));
    free(bytes);
    bempd_state_free(state);
    bempd_state_free(copy);
  }
}

/** Results of the coupled plate with a load, without what `spare` adds and removes again. */
static double plate_reaction(int spare) {
  const double pull = 1e-4, wrong[] = {14.5, 1.5, 14.5, 4.5}, right[] = {15.5, 0.0, 15.5, 3.5};
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  int32_t first = 0, left = 0, lattice = 0, load = 0, support = 0, held = 0, crack = 0;
  double reaction[2] = {0, 0};
  if (spare) first = add_bem_rectangle(model, material, -30.0, 0.0, 5.0, 8.0, 2.0);
  left = add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 2.0);
  if (spare) {
    CHECK_OK(model, bempd_fix_edge(model, first, 4, BEMPD_BOTH, &support));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support 1", bempd_remove_region(model, first));
    CHECK_OK(model, bempd_remove_support(model, support));
    CHECK_OK(model, bempd_remove_region(model, first));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "removed", bempd_remove_region(model, first));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "removed", bempd_fix_edge(model, first, 4, BEMPD_BOTH, NULL));
  }
  lattice = add_pd_rectangle(model, material, 10.0, 0.0, 19.0, 8.0, 1.0);
  CHECK(lattice == left + 1);
  if (spare) CHECK_OK(model, bempd_add_crack(model, 2, wrong, &crack));
  if (spare) CHECK_OK(model, bempd_remove_crack(model, crack));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 7 does not exist", bempd_remove_crack(model, 7));
  CHECK_OK(model, bempd_add_crack(model, 2, right, NULL));
  CHECK_OK(model, bempd_fix_edge(model, left, 4, BEMPD_BOTH, &held));
  if (spare) CHECK_OK(model, bempd_add_point_force(model, 0.0, 8.0, BEMPD_X, 3.0, 5.0, &load));
  if (spare) CHECK_OK(model, bempd_remove_load(model, load));
  if (spare) CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "removed", bempd_set_load_values(model, load, 1, &pull, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, lattice, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  save_and_restore(model);
  CHECK_OK(model, bempd_reaction(model, held, reaction));
  if (spare) CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "removed", bempd_reaction(model, support, reaction));
  bempd_model_free(model);
  return reaction[0];
}

static void what_was_removed_leaves_no_trace(void) {
  const double plain = plate_reaction(0), spared = plate_reaction(1);
  CHECK(plain != 0);
  CHECK(plain == spared);
}

static void what_can_be_told_at_once_is(void) {
  const double beside[] = {50.5, 2.5, 50.5, 5.5};
  const double shifted[] = {-5.0, 2.0, 3.0, 2.0, 3.0, 20.0, -5.0, 20.0};
  bempd_model* model = pd_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "outside", bempd_add_crack(model, 2, beside, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no node", bempd_fix_point(model, 50.0, 2.0, BEMPD_X, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no node", bempd_add_point_force(model, -9.0, 2.0, BEMPD_X, 1, 0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "overlap", bempd_add_pd_region(model, 1, 4, shifted, 1.0, 3, NULL));
  bempd_model_free(model);
}

/** Sizes are estimated before anything is built. */
static void what_does_not_fit_is_refused_with_the_estimate(void) {
  const rectangle wide = rectangle_of(0.0, 0.0, 40000.0, 20000.0), large = rectangle_of(0.0, 0.0, 200.0, 200.0);
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "GB", bempd_add_pd_region(model, material, 4, wide.vertices, 1.0, 8, NULL));
  CHECK_OK(model, bempd_add_pd_region(model, material, 4, large.vertices, 1.0, 3, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_set_option(model, "memory.limit", 0.05));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "memory.limit allows 0.05 GB", bempd_prepare(model));
  CHECK_OK(model, bempd_remove_support(model, 1));
  CHECK_OK(model, bempd_remove_region(model, 1));
  add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 10.0, 0.1);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "400 boundary elements", bempd_prepare(model));
  CHECK_OK(model, bempd_set_option(model, "memory.limit", 0.0));
  CHECK_OK(model, bempd_fix_edge(model, 2, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  bempd_model_free(model);
}

int main(void) {
  what_does_not_fit_is_refused_with_the_estimate();
  a_failed_preparation_can_be_mended();
  a_failed_first_call_leaves_the_scene_open();
  a_cancelled_first_step_leaves_the_scene_open();
  what_was_removed_leaves_no_trace();
  what_can_be_told_at_once_is();
  return check_finish();
}

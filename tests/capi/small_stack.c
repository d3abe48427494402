/* A thread with as much stack as the header asks for (bempd.h, Threads) does all that there is. */
#include <pthread.h>

#include "scenes.h"

enum { stack_of_a_thread = 256 * 1024 };

static void* all_kinds_of_work(void* nothing) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  const rectangle plate = rectangle_of(0.0, 0.0, 10.0, 8.0);
  const double line[4] = {15.5, 0.0, 15.5, 2.5}, inside[4] = {3.0, 4.0, 5.0, 4.5}, pull = 1e-3;
  const double places[4] = {12.0, 4.0, 2.0, 2.0};
  bempd_crack_tip tip;
  double stress[6];
  bempd_state* state = NULL;
  int32_t id = 0;
  material.critical_stretch = 0.0;
  material.fracture_energy = 1.0;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  CHECK_OK(model, bempd_add_bem_region(model, id, 4, plate.vertices, 1.0, NULL));
  add_pd_rectangle(model, id, 10.0, 0.0, 20.0, 8.0, 0.5);
  CHECK_OK(model, bempd_add_crack(model, 2, inside, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, line, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 2, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e9, NULL));
  CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, 0, &tip));
  CHECK_OK(model, bempd_evaluate(model, 2, places, NULL, stress, NULL));
  CHECK_OK(model, bempd_state_save(model, &state));
  CHECK_OK(model, bempd_run_to_separation(model, 1e9, NULL));
  CHECK_OK(model, bempd_state_restore(model, state));
  bempd_state_free(state);
  bempd_model_free(model);
  return nothing;
}

int main(void) {
  pthread_attr_t attributes;
  pthread_t thread;
  CHECK(pthread_attr_init(&attributes) == 0);
  CHECK(pthread_attr_setstacksize(&attributes, stack_of_a_thread) == 0);
  CHECK(pthread_create(&thread, &attributes, all_kinds_of_work, NULL) == 0);
  CHECK(pthread_join(thread, NULL) == 0);
  return check_finish();
}

/* The BLAS has one thread while a call runs, or as many as the option says, and afterwards the number that the host
 * has set: also after calls that fail, and where the host changes the number meanwhile. */
#define _GNU_SOURCE
#include <dlfcn.h>

#define CRACK_RULE "bond"
#include "scenes.h"

typedef int (*get_function)(void);
typedef void (*set_function)(int);

static get_function get_threads;
static set_function set_threads;
static int seen, set_meanwhile;

static int32_t look(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)events, (void)broken_bonds, (void)user;
  seen = get_threads();
  if (set_meanwhile) set_threads(set_meanwhile);
  return 0;
}

int main(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  /* POSIX's way of making a function of what dlsym() gives. */
  *(void**)&get_threads = dlsym(RTLD_DEFAULT, "openblas_get_num_threads");
  *(void**)&set_threads = dlsym(RTLD_DEFAULT, "openblas_set_num_threads");
  if (!get_threads || !set_threads) {
    printf("another BLAS than OpenBLAS: nothing to look at\n");
    bempd_model_free(model);
    return 77;
  }
  CHECK_OK(model, bempd_set_progress(model, look, NULL));
  set_threads(4);
  CHECK_OK(model, bempd_step_to_next_event(model, 1e9, NULL));
  CHECK(seen == 1);
  CHECK(get_threads() == 4);

  CHECK(bempd_step(model, -1.0 / 0.0, NULL) != BEMPD_OK);
  CHECK(get_threads() == 4);

  CHECK_OK(model, bempd_set_option(model, "threads", 3.0));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e9, NULL));
  CHECK(seen == 3);
  CHECK(get_threads() == 4);

  /* The host's last word counts. */
  set_meanwhile = 2;
  CHECK_OK(model, bempd_step_to_next_event(model, 1e9, NULL));
  CHECK(get_threads() == 2);
  bempd_model_free(model);
  return check_finish();
}

/* The library writes nothing on the host's terminal, whatever scene it gets. */
#define _POSIX_C_SOURCE 200809L
#include <unistd.h>

#include "scenes.h"

/** What was written to standard output and standard error meanwhile. */
static long bytes_written(void (*run)(void)) {
  FILE* file = tmpfile();
  const int output = dup(1), errors = dup(2);
  long size;
  if (file == NULL || output < 0 || errors < 0) abort();
  fflush(NULL);
  dup2(fileno(file), 1);
  dup2(fileno(file), 2);
  run();
  fflush(NULL);
  dup2(output, 1);
  dup2(errors, 2);
  close(output);
  close(errors);
  fseek(file, 0, SEEK_END);
  size = ftell(file);
  fclose(file);
  return size;
}

/** Runs with the scheme of that number; returns 0 if there is none. */
static int run_with_scheme(bempd_model* model, int number) {
  char words[64] = "", *scheme;
  int64_t index, count = 0;
  CHECK_OK(NULL, bempd_option_count(&count));
  for (index = 0; index < count; ++index) {
    bempd_option_info info;
    CHECK_OK(NULL, bempd_option_info_init(&info, sizeof info));
    CHECK_OK(NULL, bempd_option_describe(index, &info));
    if (strcmp(info.name, "scheme") == 0) snprintf(words, sizeof words, "%s", info.choices);
  }
  for (scheme = strtok(words, " |"); scheme != NULL && number > 0; --number) scheme = strtok(NULL, " |");
  if (scheme != NULL) {
    CHECK_OK(model, bempd_set_option_text(model, "scheme", scheme));
    CHECK_OK(model, bempd_step_to_next_event(model, 100.0, NULL));
  }
  bempd_model_free(model);
  return scheme != NULL;
}

/** A region of boundary elements beside the lattice that breaks. */
static bempd_model* regions_that_share_nothing(void) {
  const double pull = 0.1;
  bempd_model* model = pd_block();
  add_bem_rectangle(model, 1, 20.0, 0.0, 30.0, 8.0, 2.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 2, 2, BEMPD_BOTH, NULL));
  return model;
}

/** All that the regions share is held. */
static bempd_model* regions_with_a_held_interface(void) {
  const double pull = 0.1;
  bempd_model* model = pd_block();
  add_bem_rectangle(model, 1, 10.0, 0.0, 20.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 2, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  return model;
}

static void run_all(void) {
  int scheme = 0;
  while (run_with_scheme(regions_that_share_nothing(), scheme)) ++scheme;
  CHECK(scheme > 0);
  CHECK(run_with_scheme(regions_with_a_held_interface(), 0));
}

int main(void) {
  CHECK(bytes_written(run_all) == 0);
  return check_finish();
}

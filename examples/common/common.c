#define _POSIX_C_SOURCE 200809L

#include "common/common.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

void ensure(const bempd_model* model, bempd_status status) {
  if (status == BEMPD_OK) return;
  fprintf(stderr, "%s: %s\n", bempd_status_name(status), bempd_last_error(model));
  exit(EXIT_FAILURE);
}

double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void rectangle(double left, double bottom, double right, double top, double vertices[8]) {
  const double corners[8] = {left, bottom, right, bottom, right, top, left, top};
  memcpy(vertices, corners, sizeof corners);
}

void make_output_folder(const char* name) {
  char path[256];
  snprintf(path, sizeof path, "out/%s", name);
  /* The folders may exist already; if they cannot be made, writing the first file says so. */
  mkdir("out", 0777);
  mkdir(path, 0777);
}

static int knows_scheme(const char* scheme) {
  bempd_model* model = NULL;
  int known;
  ensure(NULL, bempd_model_create(&model));
  known = bempd_set_option_text(model, "scheme", scheme) == BEMPD_OK;
  bempd_model_free(model);
  return known;
}

scheme_list schemes_to_run(int argument_count, char** arguments) {
  scheme_list schemes = {2, {"symmetric", "paper"}};
  int k;
  if (argument_count > 1) {
    schemes.count = argument_count > 3 ? 2 : argument_count - 1;
    for (k = 0; k < schemes.count; ++k) schemes.names[k] = arguments[k + 1];
  } else if (!knows_scheme("paper")) {
    schemes.count = 1;
  }
  return schemes;
}

bempd_model* create_model(const char* scheme) {
  bempd_model* model = NULL;
  ensure(NULL, bempd_model_create(&model));
  ensure(model, bempd_set_option_text(model, "scheme", scheme));
  /* The paper's cracks, in both schemes. */
  ensure(model, bempd_set_option_text(model, "crack.rule", "bond"));
  return model;
}

int32_t add_material(bempd_model* model, double young_modulus, double critical_stretch) {
  bempd_material material;
  int32_t id;
  ensure(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = young_modulus;
  material.poisson_ratio = 1.0 / 3.0;
  material.critical_stretch = critical_stretch;
  ensure(model, bempd_add_material(model, &material, &id));
  return id;
}

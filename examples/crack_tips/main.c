/* Stress intensity factors of centre and edge cracks in strips, beside published values. */
#include <bempd.h>
#include <math.h>
#include <stdio.h>

static const double pi = 3.14159265358979323846;

/** Says what went wrong in a call, if anything. */
static int failed(const bempd_model* model) {
  const char* message = bempd_last_error(model);
  if (message[0] == '\0') return 0;
  printf("%s\n", message);
  return 1;
}

/** A strip from x = left to 1, three times as high as wide, with a crack along y = 0, pulled by 1 in y. */
static bempd_model* strip(double left, double from, double to) {
  const double vertices[] = {left, -3, 1, -3, 1, 3, left, 3}, crack[] = {from, 0, to, 0}, up = 1, down = -1;
  bempd_material material;
  int32_t id = 0;
  bempd_model* model = NULL;
  bempd_model_create(&model);
  bempd_material_init(&material, sizeof material);
  material.young_modulus = 1;
  material.poisson_ratio = 0.3;
  material.fracture_energy = 1;
  bempd_add_material(model, &material, &id);
  bempd_add_bem_region(model, id, 4, vertices, 0.125, NULL);
  bempd_add_crack(model, 2, crack, NULL);
  bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START,
                       1); /* stationary: what its tips carry is asked for, beyond growth too */
  bempd_set_tip_frozen(model, 1, BEMPD_CRACK_END, 1);
  bempd_fix_point(model, left, -3, BEMPD_BOTH, NULL); /* nothing pulls there: only against rigid motions */
  bempd_fix_point(model, 1, -3, BEMPD_Y, NULL);
  bempd_add_traction(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &up, NULL);
  bempd_add_traction(model, 1, 1, 0, 1, BEMPD_Y, 1, NULL, &down, NULL);
  return model;
}

/** Prints one line of the table; the last tip of the crack. Returns whether it is right to 1e-4. */
static int line(bempd_model* model, const char* name, double a, double reference) {
  bempd_crack_tip tip;
  int64_t count = 0;
  double value;
  bempd_step(model, 1.0, NULL);
  bempd_tip_count(model, &count);
  bempd_crack_tip_init(&tip, sizeof tip);
  if (bempd_tip(model, count - 1, &tip) != BEMPD_OK) {
    failed(model);
    bempd_model_free(model);
    return 0;
  }
  value = tip.stress_intensity_1 / sqrt(pi * a);
  printf("%-7s %4.1f %10.5f %10.4f %9.1e %9.1e %9.4f %9.4f\n", name, a, value, reference, value / reference - 1,
         tip.error / tip.stress_intensity_1, tip.t_stress, tip.critical_load_factor);
  bempd_model_free(model);
  return fabs(value / reference - 1) < 1e-4;
}

int main(void) {
  /* Isida, in Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook; Kaya and Erdogan 1987. */
  const double centre[] = {1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033};
  const double edge[] = {1.1892, 1.3673, 1.6599, 2.1114, 2.8246, 4.0332};
  int good = 1;
  printf("crack    a/W          K  reference      off    told it  T-stress  grows at\n");
  for (int i = 0; i < 6; ++i) {
    const double a = 0.1 * (i + 1);
    good &= line(strip(-1, -a, a), "centre", a, centre[i]);
  }
  for (int i = 0; i < 6; ++i) {
    const double a = 0.1 * (i + 1);
    good &= line(strip(0, 0, a), "edge", a, edge[i]);
  }
  return good ? 0 : 1;
}

/** Plates with cracks that grow by cycles. */
#ifndef BEMPD_TESTS_CAPI_FATIGUE_SCENES_H
#define BEMPD_TESTS_CAPI_FATIGUE_SCENES_H

#include "scenes.h"

typedef struct plate {
  bempd_model* model;
  int32_t material, region, crack, up, down;
} plate;

/** A plate of half the given width and height with a crack on the x axis, pulled by 1 Pa per unit of the load factor.
 * E = 1, nu = 0.3. */
static inline plate plate_of(double half, double from, double to, double element_length, double fracture_energy) {
  const rectangle square = rectangle_of(-half, -half, half, half);
  const double crack[] = {from, 0.0, to, 0.0}, up = 1.0, down = -1.0;
  plate made = {new_model(), 0, 0, 0, 0, 0};
  bempd_material material;
  CHECK_OK(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1.0;
  material.poisson_ratio = 0.3;
  material.fracture_energy = fracture_energy;
  CHECK_OK(made.model, bempd_add_material(made.model, &material, &made.material));
  CHECK_OK(made.model,
           bempd_add_bem_region(made.model, made.material, 4, square.vertices, element_length, &made.region));
  CHECK_OK(made.model, bempd_add_crack(made.model, 2, crack, &made.crack));
  CHECK_OK(made.model, bempd_fix_point(made.model, -half, -half, BEMPD_BOTH, NULL));
  CHECK_OK(made.model, bempd_fix_point(made.model, half, -half, BEMPD_Y, NULL));
  CHECK_OK(made.model, bempd_add_traction(made.model, made.region, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &up, &made.up));
  CHECK_OK(made.model, bempd_add_traction(made.model, made.region, 1, 0.0, 1.0, BEMPD_Y, 1, NULL, &down, &made.down));
  return made;
}

/** da/dN = 1e-6 dK^3. */
static inline bempd_growth_rate paris(void) {
  bempd_growth_rate rate;
  CHECK_OK(NULL, bempd_growth_rate_init(&rate, sizeof rate));
  rate.coefficient = 1e-6;
  rate.exponent = 3.0;
  return rate;
}

static inline bempd_fatigue to_length(double length) {
  bempd_fatigue options;
  CHECK_OK(NULL, bempd_fatigue_init(&options, sizeof options));
  options.most_length = length;
  return options;
}

static inline bempd_fatigue_report new_report(void) {
  bempd_fatigue_report report;
  CHECK_OK(NULL, bempd_fatigue_report_init(&report, sizeof report));
  return report;
}

static inline bempd_fatigue_record last_record(const bempd_model* model) {
  bempd_fatigue_record record;
  int64_t count = 0;
  CHECK_OK(model, bempd_fatigue_record_count(model, &count));
  CHECK_OK(NULL, bempd_fatigue_record_init(&record, sizeof record));
  CHECK_OK(model, bempd_get_fatigue_record(model, count - 1, &record));
  return record;
}

#endif

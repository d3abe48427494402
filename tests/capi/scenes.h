/**
 * Scenes that several tests use, and their results as one block of bytes, to compare two runs bit for bit.
 */
#ifndef BEMPD_TESTS_CAPI_SCENES_H
#define BEMPD_TESTS_CAPI_SCENES_H

#include "check.h"

/** Tests of bonds that break one by one define CRACK_RULE as "bond" before they include this. */

static inline bempd_model* new_model(void) {
  bempd_model* model = NULL;
  CHECK_OK(NULL, bempd_model_create(&model));
#ifdef CRACK_RULE
  CHECK_OK(model, bempd_set_option_text(model, "crack.rule", CRACK_RULE));
#endif
  return model;
}

/** E = 1000, nu = 1/3, plane stress, critical stretch 1e-3. */
static inline bempd_material sound_material(void) {
  bempd_material material;
  CHECK_OK(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1000.0;
  material.poisson_ratio = 1.0 / 3.0;
  material.critical_stretch = 1e-3;
  return material;
}

static inline int32_t add_sound_material(bempd_model* model) {
  const bempd_material material = sound_material();
  int32_t id = 0;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  return id;
}

/** Vertices of a rectangle; its edges are 1 bottom, 2 right, 3 top, 4 left. */
typedef struct rectangle {
  double vertices[8];
} rectangle;

static inline rectangle rectangle_of(double left, double bottom, double right, double top) {
  rectangle r;
  r.vertices[0] = r.vertices[6] = left;
  r.vertices[2] = r.vertices[4] = right;
  r.vertices[1] = r.vertices[3] = bottom;
  r.vertices[5] = r.vertices[7] = top;
  return r;
}

static inline int32_t add_bem_rectangle(bempd_model* model, int32_t material, double left, double bottom, double right,
                                        double top, double element_length) {
  const rectangle r = rectangle_of(left, bottom, right, top);
  int32_t id = 0;
  CHECK_OK(model, bempd_add_bem_region(model, material, 4, r.vertices, element_length, &id));
  return id;
}

static inline int32_t add_pd_rectangle(bempd_model* model, int32_t material, double left, double bottom, double right,
                                       double top, double spacing) {
  const rectangle r = rectangle_of(left, bottom, right, top);
  int32_t id = 0;
  CHECK_OK(model, bempd_add_pd_region(model, material, 4, r.vertices, spacing, 3, &id));
  return id;
}

/** A model with one BEM rectangle, 10 x 8 with elements of length 2, and no support. */
static inline bempd_model* bem_block(void) {
  bempd_model* model = new_model();
  add_bem_rectangle(model, add_sound_material(model), 0.0, 0.0, 10.0, 8.0, 2.0);
  return model;
}

/** A model with one PD rectangle, 10 x 8 cells of size 1, and no support. */
static inline bempd_model* pd_block(void) {
  bempd_model* model = new_model();
  add_pd_rectangle(model, add_sound_material(model), 0.0, 0.0, 10.0, 8.0, 1.0);
  return model;
}

/** The README's strip with an edge crack of another length, its right end pulled by `count` values (NULL for `pulled`:
 * it is left alone). */
static inline bempd_model* strip_with_crack(double length, int64_t count, const double* constant,
                                            const double* proportional, int32_t* pulled) {
  const double crack[] = {0.0295, 0.0, 0.0295, length};
  bempd_model* model = new_model();
  bempd_material material;
  int32_t acrylic = 0;
  const rectangle middle = rectangle_of(0.02, 0.0, 0.04, 0.02);
  CHECK_OK(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = 3e9;
  material.poisson_ratio = 1.0 / 3.0;
  material.thickness = 0.005;
  material.fracture_energy = 300.0;
  CHECK_OK(model, bempd_add_material(model, &material, &acrylic));
  add_bem_rectangle(model, acrylic, 0.0, 0.0, 0.02, 0.02, 0.005);
  CHECK_OK(model, bempd_add_pd_region(model, acrylic, 4, middle.vertices, 0.001, 4, NULL));
  add_bem_rectangle(model, acrylic, 0.04, 0.0, 0.06, 0.02, 0.005);
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  if (pulled != NULL)
    CHECK_OK(model, bempd_prescribe_edge(model, 3, 2, 0.0, 1.0, BEMPD_X, count, constant, proportional, pulled));
  return model;
}

/**
 * BEM 10 x 8 | PD 9 x 8 cells of size 1 with a crack from the bottom across four rows | BEM 10 x 8. The ends are pulled
 * apart, per unit of the load factor by 0.02 at the bottom and 0.002 at the top, so that the crack grows stably.
 */
typedef struct coupled_plate {
  bempd_model* model;
  int32_t material, left, strip, right, crack, pulled_left, pulled_right, pinned;
} coupled_plate;

/** Build the plate; after every call that adds something, call `between` (NULL for nothing). */
static inline coupled_plate coupled_plate_build(void (*between)(coupled_plate*)) {
  static const double crack[4] = {14.5, 0.0, 14.5, 3.5};
  const double pull_left[2] = {-0.002, -0.02};
  const double pull_right[2] = {0.02, 0.002};
  coupled_plate plate = {NULL, 0, 0, 0, 0, 0, 0, 0, 0};
  int part;
  plate.model = new_model();
  for (part = 0; part < 8; ++part) {
    if (between != NULL) between(&plate);
    switch (part) {
      case 0:
        plate.material = add_sound_material(plate.model);
        break;
      case 1:
        plate.left = add_bem_rectangle(plate.model, plate.material, 0.0, 0.0, 10.0, 8.0, 2.0);
        break;
      case 2:
        plate.strip = add_pd_rectangle(plate.model, plate.material, 10.0, 0.0, 19.0, 8.0, 1.0);
        break;
      case 3:
        plate.right = add_bem_rectangle(plate.model, plate.material, 19.0, 0.0, 29.0, 8.0, 2.0);
        break;
      case 4:
        CHECK_OK(plate.model, bempd_add_crack(plate.model, 2, crack, &plate.crack));
        break;
      case 5:
        CHECK_OK(plate.model, bempd_prescribe_edge(plate.model, plate.left, 4, 0.0, 1.0, BEMPD_X, 2, NULL, pull_left,
                                                   &plate.pulled_left));
        break;
      case 6:
        CHECK_OK(plate.model, bempd_prescribe_edge(plate.model, plate.right, 2, 0.0, 1.0, BEMPD_X, 2, NULL, pull_right,
                                                   &plate.pulled_right));
        break;
      default:
        CHECK_OK(plate.model, bempd_fix_point(plate.model, 0.0, 4.0, BEMPD_Y, &plate.pinned));
        break;
    }
  }
  if (between != NULL) between(&plate);
  return plate;
}

static inline coupled_plate coupled_plate_create(void) { return coupled_plate_build(NULL); }

/** Load factor of the first event, found with a model of its own. */
static inline double coupled_plate_first_event(void) {
  const coupled_plate plate = coupled_plate_create();
  double load_factor = 0.0;
  bempd_step_report report;
  CHECK_OK(plate.model, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate.model, bempd_step_to_next_event(plate.model, 100.0, &report));
  CHECK(report.stop_reason == BEMPD_STOP_EVENT && report.events == 1 && report.broken_bonds > 0);
  CHECK_OK(plate.model, bempd_load_factor(plate.model, &load_factor));
  CHECK(load_factor > 0.0);
  bempd_model_free(plate.model);
  return load_factor;
}

/** All that a host can see of a run. Free it with outcome_free(). */
typedef struct outcome {
  double* numbers;
  size_t count;
} outcome;

static inline void outcome_append(outcome* seen, const double* numbers, size_t count) {
  double* longer = (double*)realloc(seen->numbers, (seen->count + count + 1) * sizeof *longer);
  if (longer == NULL) abort();
  memcpy(longer + seen->count, numbers, count * sizeof *numbers);
  seen->numbers = longer;
  seen->count += count;
}

static inline void outcome_append_field(outcome* seen, bempd_model* model, int32_t region, int32_t field) {
  const double* values = NULL;
  int64_t count = 0;
  int32_t components = 0;
  CHECK_OK(model, bempd_view_field(model, region, field, &values, &count, &components, NULL));
  CHECK(values != NULL && count > 0 && components > 0);
  if (values != NULL) outcome_append(seen, values, (size_t)count * (size_t)components);
}

static inline void outcome_append_bonds(outcome* seen, bempd_model* model, int32_t region) {
  int64_t count = 0;
  int64_t k;
  int32_t* states;
  CHECK_OK(model, bempd_bond_count(model, region, &count));
  states = (int32_t*)calloc((size_t)count + 1, sizeof *states);
  if (states == NULL) abort();
  CHECK_OK(model, bempd_copy_bonds(model, region, count, NULL, states));
  for (k = 0; k < count; ++k) {
    const double state = states[k];
    outcome_append(seen, &state, 1);
  }
  free(states);
}

static inline outcome coupled_plate_outcome(const coupled_plate* plate) {
  outcome seen = {NULL, 0};
  double numbers[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
  CHECK_OK(plate->model, bempd_load_factor(plate->model, &numbers[0]));
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pulled_left, &numbers[1]));
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pulled_right, &numbers[3]));
  outcome_append(&seen, numbers, 5);
  outcome_append_bonds(&seen, plate->model, plate->strip);
  outcome_append_field(&seen, plate->model, plate->left, BEMPD_DISPLACEMENT);
  outcome_append_field(&seen, plate->model, plate->left, BEMPD_TRACTION);
  outcome_append_field(&seen, plate->model, plate->left, BEMPD_STRESS);
  outcome_append_field(&seen, plate->model, plate->strip, BEMPD_DISPLACEMENT);
  outcome_append_field(&seen, plate->model, plate->strip, BEMPD_STRESS);
  outcome_append_field(&seen, plate->model, plate->strip, BEMPD_DAMAGE);
  outcome_append_field(&seen, plate->model, plate->strip, BEMPD_BOND_STRETCH);
  outcome_append_field(&seen, plate->model, plate->right, BEMPD_DISPLACEMENT);
  return seen;
}

/** Bit for bit. */
static inline int outcome_same(const outcome* one, const outcome* other) {
  return one->count > 0 && one->count == other->count &&
         memcmp(one->numbers, other->numbers, one->count * sizeof *one->numbers) == 0;
}

/** Largest difference of two numbers; infinite where the outcomes cannot be compared. */
static inline double outcome_difference(const outcome* one, const outcome* other) {
  double largest = 0.0;
  size_t k;
  if (one->count == 0 || one->count != other->count) return INFINITY;
  for (k = 0; k < one->count; ++k) {
    const double difference = fabs(one->numbers[k] - other->numbers[k]);
    if (!(difference <= largest)) largest = isnan(difference) ? INFINITY : difference;
  }
  return largest;
}

static inline void outcome_free(outcome* seen) {
  free(seen->numbers);
  seen->numbers = NULL;
  seen->count = 0;
}

#endif

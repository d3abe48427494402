/* Ends of the number range: what is out of it is an error, and no call that is good hands out what is no number. */
#include <float.h>
#include <math.h>

#include "scenes.h"

static void moduli_near_the_ends_are_refused(void) {
  const double moduli[] = {5e-324, 1e-310, 1e-300, 1e300, DBL_MAX, INFINITY, NAN};
  size_t k;
  for (k = 0; k < sizeof moduli / sizeof moduli[0]; ++k) {
    bempd_model* model = new_model();
    bempd_material material = sound_material();
    int32_t id = 0;
    material.young_modulus = moduli[k];
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "young_modulus", bempd_add_material(model, &material, &id));
    material.thickness = 1.0 / moduli[k];
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "young_modulus|thickness", bempd_add_material(model, &material, &id));
    material.young_modulus = 1e150;
    material.thickness = 1e150;
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "thickness", bempd_add_material(model, &material, &id));
    bempd_model_free(model);
  }
}

/** A force whose displacements, or a motion whose forces, no number holds. */
static void results_beyond_the_range_are_an_error(void) {
  const double pull = 1e300;
  const double moduli[] = {1e-100, 1e100};
  int k;
  for (k = 0; k < 2; ++k) {
    bempd_model* model = new_model();
    bempd_material material = sound_material();
    int32_t id = 0;
    bempd_status status;
    double load_factor = 1.0;
    material.young_modulus = moduli[k];
    CHECK_OK(model, bempd_add_material(model, &material, &id));
    add_pd_rectangle(model, id, 0.0, 0.0, 10.0, 8.0, 1.0);
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
    if (k == 0) {
      CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
    } else {
      CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
    }
    status = bempd_step(model, 1.0, NULL);
    CHECK(status == BEMPD_ERROR_UNSOLVABLE);
    CHECK(check_has_word(bempd_last_error(model), "units"));
    CHECK_OK(model, bempd_load_factor(model, &load_factor));
    CHECK(load_factor == 0.0);
    bempd_model_free(model);
  }
}

/** Displacements and forces are numbers, their products are not: the largest number stands for such an energy. */
static void energies_beyond_the_range_stay_numbers(void) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  const double pull = 1e200;
  int32_t id = 0;
  bempd_step_report report;
  material.critical_stretch = 0.0;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  add_pd_rectangle(model, id, 0.0, 0.0, 10.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step(model, 1.0, &report));
  CHECK(report.work == DBL_MAX && report.stored_energy == DBL_MAX);
  CHECK(isfinite(report.energy_balance_error) && isfinite(report.residual));
  CHECK_OK(model, bempd_step(model, 0.5, &report));
  CHECK(isfinite(report.work) && isfinite(report.stored_energy) && isfinite(report.energy_balance_error));
  CHECK_OK(model, bempd_step(model, 1e-200, &report));
  CHECK(report.work > 0 && fabs(report.work / report.stored_energy - 1.0) < 1e-12);
  bempd_model_free(model);
}

/** More bonds than 32 bits count: in one region, and in two that each would do. */
/* The tip of a crack whose faces are loaded by this much, in boundary elements. */
static bempd_crack_tip tip_under(double load) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  const rectangle plate = rectangle_of(0.0, 0.0, 4.0, 2.0);
  const double crack[4] = {1.5, 1.0, 2.5, 1.2};
  int32_t id = 0;
  bempd_crack_tip tip;
  material.young_modulus = 1.0;
  material.critical_stretch = 0.0;
  material.fracture_energy = 1e-4;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  CHECK_OK(model, bempd_add_bem_region(model, id, 4, plate.vertices, 1.0, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START, 1));
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_END, 1));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 1, NULL, &load, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, 0, &tip));
  bempd_model_free(model);
  return tip;
}

/* Squares of factors leave the range of numbers before they do. */
static void tips_keep_their_digits_over_the_range(void) {
  const double loads[] = {1e-250, 1e-170, 1e-30, 1e30, 1e100, 1e154, 1e200, 1e300};
  const bempd_crack_tip one = tip_under(1.0);
  size_t k;
  CHECK(one.stress_intensity_1 > 0.5 && fabs(one.stress_intensity_2) > 1e-3);
  for (k = 0; k < sizeof loads / sizeof loads[0]; ++k) {
    const bempd_crack_tip tip = tip_under(loads[k]);
    CHECK(fabs(tip.stress_intensity_1 / loads[k] / one.stress_intensity_1 - 1.0) < 1e-12);
    CHECK(fabs(tip.stress_intensity_2 / loads[k] / one.stress_intensity_2 - 1.0) < 1e-9);
    CHECK(fabs(tip.kink_angle - one.kink_angle) < 1e-9);
    CHECK(tip.energy_release_rate <= DBL_MAX && tip.error <= 1e-2 * tip.stress_intensity_1);
    CHECK(fabs(tip.critical_load_factor * loads[k] / one.critical_load_factor - 1.0) < 1e-12);
  }
}

/* The deviation of a piece from a rigid motion keeps its digits over the range, too. */
static void pieces_move_by_numbers(void) {
  const double pulls[] = {1e-250, 1.0, 1e170, 1e300};
  double first = 0.0;
  size_t k;
  for (k = 0; k < sizeof pulls / sizeof pulls[0]; ++k) {
    bempd_model* model = new_model();
    bempd_material material = sound_material();
    int32_t id = 0;
    bempd_piece piece;
    material.critical_stretch = 0.0;
    material.young_modulus = 1.0;
    CHECK_OK(model, bempd_add_material(model, &material, &id));
    add_pd_rectangle(model, id, 0.0, 0.0, 10.0, 8.0, 1.0);
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_Y, 1, NULL, &pulls[k], NULL));
    CHECK_OK(model, bempd_step(model, 1.0, NULL));
    CHECK_OK(NULL, bempd_piece_init(&piece, sizeof piece));
    CHECK_OK(model, bempd_get_piece(model, 1, &piece));
    if (k == 0) first = piece.deviation / pulls[k];
    CHECK(first > 1.0 && fabs(piece.deviation / pulls[k] / first - 1.0) < 1e-12);
    CHECK(isfinite(piece.rotation) && piece.rotation > 0.1 * pulls[k]);
    bempd_model_free(model);
  }
}

static void bonds_that_no_int_counts_are_refused_before_memory_is_taken(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const rectangle all = rectangle_of(0.0, 0.0, 20000.0, 20000.0);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "the limit is 2147483647 bonds",
              bempd_add_pd_region(model, material, 4, all.vertices, 1.0, 3, NULL));
  CHECK_OK(model, bempd_set_option(model, "memory.limit", 1e9));
  add_pd_rectangle(model, material, 0.0, 0.0, 10000.0, 10000.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  add_pd_rectangle(model, material, 20000.0, 0.0, 30000.0, 10000.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 2, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "comes to about 2400000000 bonds; the limit is", bempd_prepare(model));
  bempd_model_free(model);
}

int main(void) {
  bonds_that_no_int_counts_are_refused_before_memory_is_taken();
  moduli_near_the_ends_are_refused();
  results_beyond_the_range_are_an_error();
  energies_beyond_the_range_stay_numbers();
  tips_keep_their_digits_over_the_range();
  pieces_move_by_numbers();
  return check_finish();
}

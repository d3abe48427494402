/* Tips of cracks in peridynamic regions, and tips that are recorded. */
#include <stddef.h>

#define CRACK_RULE "bond"
#include "scenes.h"

/** A square of 41 spacings around the origin, so that y = 0 lies between rows and whole x between columns. */
static bempd_model* plate(double left, double right, double fracture_energy) {
  const double crack[] = {left, 0, right, 0};
  const double one = 1, minus = -1;
  bempd_model* model = new_model();
  bempd_material material;
  int32_t id = 0, region = 0;
  CHECK_OK(model, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1;
  material.poisson_ratio = 1.0 / 3;
  material.fracture_energy = fracture_energy;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  region = add_pd_rectangle(model, id, -20.5, -20.5, 20.5, 20.5, 1);
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_point(model, -20.5, -20.5, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_point(model, 20.5, -20.5, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, region, 3, 0, 1, BEMPD_Y, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_add_traction(model, region, 1, 0, 1, BEMPD_Y, 1, NULL, &minus, NULL));
  return model;
}

static bempd_crack_tip tip_of(bempd_model* model, int64_t index) {
  bempd_crack_tip tip;
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, index, &tip));
  return tip;
}

static int64_t tips_of(bempd_model* model) {
  int64_t count = -1;
  CHECK_OK(model, bempd_tip_count(model, &count));
  return count;
}

static void both_tips_carry_the_same(void) {
  bempd_model* model = plate(-10, 10, 1);
  double factor = 0;
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK(tips_of(model) == 2);
  factor = tip_of(model, 1).stress_intensity_1;
  for (int k = 0; k < 2; ++k) {
    const bempd_crack_tip tip = tip_of(model, k);
    CHECK(tip.crack == 1 && tip.end == (k == 0 ? BEMPD_CRACK_START : BEMPD_CRACK_END));
    CHECK(tip.method == BEMPD_TIP_CONTOURS && tip.contours == 3 && !tip.grown && !tip.branched);
    CHECK_CLOSE(tip.x, k == 0 ? -10 : 10, 1e-12);
    CHECK_CLOSE(tip.direction_x, k == 0 ? -1 : 1, 1e-12);
    /* The factor is above that of the infinite plate. */
    CHECK(tip.stress_intensity_1 > 1e-3 * sqrt(10 * 3.14159) && tip.stress_intensity_1 < 1.4e-3 * sqrt(10 * 3.14159));
    CHECK_CLOSE(tip.stress_intensity_1, factor, 1e-9 * factor);
    CHECK_CLOSE(tip.stress_intensity_2, 0, 1e-9 * factor);
    CHECK_CLOSE(tip.energy_release_rate, factor * factor, 1e-9 * factor * factor);
    CHECK_CLOSE(tip.critical_load_factor, 1e-3 / factor, 1e-9 / factor);
    CHECK(tip.error > 0 && tip.error < 2e-3 * factor);
    CHECK(tip.felt_ahead > 0.3 && tip.felt_ahead < 0.55);
    CHECK(tip.contour_radius > 8 && tip.contour_radius <= 20);
    CHECK(tip.load_rule == BEMPD_LOAD_FACTORS && !tip.closed && tip.load_error > 0 && tip.load_error < 2e-3);
    CHECK_CLOSE(tip.valid_radius, 10.5, 1e-12);
  }
  /* The factor is linear in the load factor. */
  CHECK_OK(model, bempd_step(model, 2e-3, NULL));
  CHECK_CLOSE(tip_of(model, 0).stress_intensity_1, 2 * factor, 1e-9 * factor);
  bempd_model_free(model);
}

static void without_load_there_is_a_critical_one(void) {
  bempd_model* model = plate(-10, 10, 1);
  CHECK(tip_of(model, 0).stress_intensity_1 == 0 && tip_of(model, 0).error == 0);
  CHECK(tip_of(model, 0).critical_load_factor > 0.1 && tip_of(model, 0).critical_load_factor < 0.2);
  bempd_model_free(model);
}

static void ends_at_edges_are_no_tips(void) {
  bempd_model* model = plate(-20.5, -8, 1);
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK(tips_of(model) == 1);
  CHECK(tip_of(model, 0).end == BEMPD_CRACK_END && tip_of(model, 0).contours == 3);
  bempd_model_free(model);
}

/** What is not known is no number: a zero would be the smallest of all critical load factors. */
static void short_cracks_have_no_contours(void) {
  bempd_model* model = plate(-2, 2, 1);
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK(tips_of(model) == 2);
  {
    const bempd_crack_tip tip = tip_of(model, 1);
    CHECK(tip.contours == 0 && tip.contour_radius == 0 && isnan(tip.felt_ahead));
    CHECK_CLOSE(tip.x, 2, 1e-12);
    CHECK(isnan(tip.stress_intensity_1) && isnan(tip.stress_intensity_2) && isnan(tip.energy_release_rate));
    CHECK(isnan(tip.t_stress) && isnan(tip.error) && isnan(tip.kink_angle) && isnan(tip.critical_kink_angle));
    CHECK(isnan(tip.critical_load_factor) && isnan(tip.critical_load_factor_down) && isnan(tip.straight_load_factor));
  }
  bempd_model_free(model);
}

/** A program that was compiled before the struct grew. */
static void shorter_structs_of_older_programs(void) {
  bempd_model* model = plate(-10, 10, 1);
  bempd_crack_tip tip;
  CHECK_OK(model, bempd_crack_tip_init(&tip, offsetof(bempd_crack_tip, method)));
  tip.method = 77;
  CHECK_OK(model, bempd_tip(model, 1, &tip));
  CHECK(tip.method == 77 && tip.x == 10 && tip.struct_size == (int64_t)offsetof(bempd_crack_tip, method));
  bempd_model_free(model);
}

static void tips_are_recorded_if_asked_for(void) {
  bempd_model* model = plate(-10, 10, 1);
  bempd_crack_tip tip;
  bempd_state* state = NULL;
  int64_t count = -1, event = -1, broken = -1;
  double factor = 0;
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK_OK(model, bempd_tip_history_count(model, &count));
  CHECK(count == 0);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tips.record",
              bempd_get_tip_history(model, 0, &event, &broken, &factor, &tip));
  CHECK_OK(model, bempd_set_option(model, "tips.record", 1));
  CHECK_OK(model, bempd_step(model, 2e-3, NULL));
  CHECK_OK(model, bempd_tip_history_count(model, &count));
  CHECK(count == 2);
  CHECK_OK(model, bempd_get_tip_history(model, 1, &event, &broken, &factor, &tip));
  CHECK(event == 0 && broken == 0 && factor == 2e-3 && tip.end == BEMPD_CRACK_END);
  CHECK_CLOSE(tip.stress_intensity_1, tip_of(model, 1).stress_intensity_1, 0);
  CHECK_OK(model, bempd_state_save(model, &state));
  for (int k = 0; k < 3; ++k) CHECK_OK(model, bempd_step_to_next_event(model, 10, NULL));
  CHECK_OK(model, bempd_tip_history_count(model, &count));
  CHECK(count == 8);
  CHECK_OK(model, bempd_get_tip_history(model, 7, &event, &broken, NULL, &tip));
  CHECK(event == 3 && broken > 2);
  CHECK_OK(model, bempd_get_tip_history(model, 7, NULL, NULL, &factor, &tip));
  CHECK(factor > 0.1);
  CHECK_OK(model, bempd_state_restore(model, state));
  CHECK_OK(model, bempd_tip_history_count(model, &count));
  CHECK(count == 2);
  bempd_state_free(state);
  bempd_model_free(model);
}

static int32_t stop_at_third_event(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)broken_bonds, (void)user;
  return events >= 3;
}

static void a_cancelled_step_leaves_no_records(void) {
  bempd_model* model = plate(-10, 10, 1);
  int64_t count = -1;
  CHECK_OK(model, bempd_set_option(model, "tips.record", 1));
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK_OK(model, bempd_set_progress(model, stop_at_third_event, NULL));
  CHECK(bempd_run_to_separation(model, 10, NULL) == BEMPD_ERROR_CANCELLED);
  CHECK_OK(model, bempd_tip_history_count(model, &count));
  CHECK(count == 2);
  bempd_model_free(model);
}

/** A run is the same to the last bit, whether tips are looked at or not. */
static void recording_changes_no_run(void) {
  bempd_history_entry last[2];
  for (int recorded = 0; recorded < 2; ++recorded) {
    bempd_model* model = plate(-10, 10, 1);
    int64_t count = 0;
    CHECK_OK(model, bempd_set_option(model, "tips.record", 3 * recorded));
    for (int k = 0; k < 20; ++k) CHECK_OK(model, bempd_step_to_next_event(model, 10, NULL));
    CHECK_OK(model, bempd_history_count(model, &count));
    CHECK_OK(model, bempd_history_entry_init(&last[recorded], sizeof last[recorded]));
    CHECK_OK(model, bempd_get_history_entry(model, count - 1, &last[recorded]));
    CHECK_OK(model, bempd_tip_history_count(model, &count));
    CHECK(recorded ? count == 12 : count == 0);
    bempd_model_free(model);
  }
  CHECK(last[0].event == 20 && last[1].event == 20);
  CHECK(last[0].load_factor == last[1].load_factor && last[0].total_broken_bonds == last[1].total_broken_bonds);
}

static void files_of_tips(void) {
  bempd_model* model = plate(-10, 10, 1);
  char line[1000];
  int lines = 0;
  FILE* file = NULL;
  CHECK_OK(model, bempd_set_option(model, "tips.record", 1));
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK_OK(model, bempd_write_tips(model, "lattice_tips.csv"));
  file = fopen("lattice_tips.csv", "r");
  CHECK(file != NULL);
  if (file != NULL) {
    while (fgets(line, sizeof line, file) != NULL) {
      if (lines == 0) CHECK(strncmp(line, "event,total_broken_bonds,load_factor,crack,end,x,y,", 51) == 0);
      if (lines == 2) CHECK(strncmp(line, "0,0,0.001,1,2,10,0,", 19) == 0);
      ++lines;
    }
    fclose(file);
  }
  CHECK(lines == 3);
  CHECK_OK(model, bempd_set_option_text(model, "snapshots.existing", "replace"));
  CHECK_OK(model, bempd_write_snapshot(model, "lattice_tips"));
  file = fopen("lattice_tips_0000_tips.vtu", "r");
  CHECK(file != NULL);
  if (file != NULL) fclose(file);
  file = fopen("lattice_tips_0000_cracks.vtu", "r");
  CHECK(file != NULL);
  if (file != NULL) fclose(file);
  CHECK_OK(model, bempd_set_option(model, "tips.record", 0));
  CHECK_OK(model, bempd_write_snapshot(model, "lattice_without_tips"));
  CHECK(fopen("lattice_without_tips_0000_tips.vtu", "r") == NULL);
  file = fopen("lattice_without_tips_0000_cracks.vtu", "r");
  CHECK(file != NULL);
  if (file != NULL) fclose(file);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "path", bempd_write_tips(model, ""));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "path", bempd_write_tips(model, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_IO, "folder", bempd_write_tips(model, "nowhere/at/all.csv"));
  bempd_model_free(model);
}

static void misuse(void) {
  bempd_model* model = plate(-10, 10, 1);
  bempd_crack_tip tip;
  int64_t count = 0;
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tips.record", bempd_set_option(model, "tips.record", -1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tips.record", bempd_set_option(model, "tips.record", 0.5));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_tip_history_count(model, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tip", bempd_get_tip_history(model, 0, NULL, NULL, NULL, NULL));
  CHECK(bempd_tip_history_count(NULL, &count) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_get_tip_history(NULL, 0, NULL, NULL, NULL, &tip) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_write_tips(NULL, "tips.csv") == BEMPD_ERROR_ARGUMENT);
  CHECK_OK(model, bempd_set_option(model, "tips.record", 1));
  CHECK_OK(model, bempd_step(model, 1e-3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_get_tip_history(model, -1, NULL, NULL, NULL, &tip));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_get_tip_history(model, 2, NULL, NULL, NULL, &tip));
  tip.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_get_tip_history(model, 0, NULL, NULL, NULL, &tip));
  bempd_model_free(model);
}

int main(void) {
  both_tips_carry_the_same();
  without_load_there_is_a_critical_one();
  ends_at_edges_are_no_tips();
  short_cracks_have_no_contours();
  shorter_structs_of_older_programs();
  tips_are_recorded_if_asked_for();
  a_cancelled_step_leaves_no_records();
  recording_changes_no_run();
  files_of_tips();
  misuse();
  return check_finish();
}

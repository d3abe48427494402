/* Calls that come too early or too late, and steps to nowhere. */
#include "scenes.h"

static void an_empty_model_has_nothing_to_step(void) {
  bempd_model* model = new_model();
  bempd_state* state = NULL;
  int64_t count = 0;
  int32_t regions = -1;
  double place[2] = {0.0, 0.0};
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "region", bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "region", bempd_step(model, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "region", bempd_step_to_next_event(model, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "region", bempd_run_to_separation(model, 1.0, NULL));
  CHECK_REFUSED(model, "region", bempd_node_count(model, 1, &count));
  CHECK_REFUSED(model, "region", bempd_element_count(model, 1, &count));
  CHECK_REFUSED(model, "region", bempd_field_size(model, 1, BEMPD_POSITION, &count, NULL));
  CHECK_REFUSED(model, "region", bempd_copy_field(model, 1, BEMPD_POSITION, 2, place));
  CHECK_REFUSED(model, "region", bempd_bond_count(model, 1, &count));
  CHECK_REFUSED(model, "support|region", bempd_reaction(model, 1, place));
  CHECK_REFUSED(model, "region", bempd_evaluate(model, 1, place, NULL, NULL, NULL));
  CHECK_REFUSED(model, "prepare|region", bempd_state_save(model, &state));
  CHECK_REFUSED(model, "prepare|region|step", bempd_write_snapshot(model, "never_written"));
  CHECK(state == NULL);
  CHECK_OK(model, bempd_region_count(model, &regions));
  CHECK(regions == 0);
  CHECK_OK(model, bempd_load_factor(model, place));
  CHECK_OK(model, bempd_history_count(model, &count));
  CHECK(place[0] == 0.0 && count == 0);
  bempd_model_free(model);
}

static void nothing_can_be_added_to_a_prepared_model(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  const bempd_material material = sound_material();
  const rectangle r = rectangle_of(50.0, 0.0, 60.0, 8.0);
  const double hole[] = {2, 2, 2, 4, 4, 4, 4, 2};
  const double crack[] = {12.5, 2.5, 12.5, 5.5};
  const double one = 1.0;
  CHECK_OK(model, bempd_prepare(model));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_add_material(model, &material, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_add_bem_region(model, 1, 4, r.vertices, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_add_pd_region(model, 1, 4, r.vertices, 1.0, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_add_hole(model, 1, 4, hole, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_set_edge_mesh(model, 1, 1, 1.0, 1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_add_crack(model, 2, crack, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_fix_edge(model, 1, 1, BEMPD_Y, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_fix_point(model, 0.0, 0.0, BEMPD_Y, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare",
              bempd_prescribe_edge(model, 1, 1, 0.0, 1.0, BEMPD_Y, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_prescribe_point(model, 0.0, 0.0, BEMPD_Y, 0.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare",
              bempd_add_traction(model, 1, 1, 0.0, 1.0, BEMPD_Y, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_add_point_force(model, 0.0, 8.0, BEMPD_Y, 0.0, 1.0, NULL));
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  bempd_model_free(model);
}

static void steps_go_to_finite_load_factors(void) {
  static const double nowhere[] = {NAN, INFINITY, -INFINITY};
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  bempd_step_report report;
  double load_factor = 7.0;
  int prepared;
  size_t k;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  for (prepared = 0; prepared < 2; ++prepared) {
    for (k = 0; k < sizeof nowhere / sizeof nowhere[0]; ++k) {
      CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load factor|load_factor", bempd_step(model, nowhere[k], &report));
      CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load factor|load_factor",
                  bempd_step_to_next_event(model, nowhere[k], &report));
      CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load factor|load_factor",
                  bempd_run_to_separation(model, nowhere[k], &report));
    }
    CHECK_OK(model, bempd_load_factor(model, &load_factor));
    CHECK(load_factor == 0.0);
    CHECK_OK(model, bempd_prepare(model));
  }
  bempd_model_free(model);
}

static void structs_that_come_back_say_their_size(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  bempd_step_report report;
  bempd_statistics statistics;
  bempd_history_entry entry;
  double load_factor = 7.0;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  CHECK(report.struct_size == (int64_t)sizeof report && statistics.struct_size == (int64_t)sizeof statistics);
  CHECK(entry.struct_size == (int64_t)sizeof entry);
  report.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_step(model, 0.1, &report));
  report.struct_size = -5;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_step(model, 0.1, &report));
  CHECK_OK(model, bempd_load_factor(model, &load_factor));
  CHECK(load_factor == 0.0);
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  statistics.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_get_statistics(model, &statistics));
  entry.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_history(model, 0, &entry));
  bempd_model_free(model);
}

int main(void) {
  an_empty_model_has_nothing_to_step();
  nothing_can_be_added_to_a_prepared_model();
  steps_go_to_finite_load_factors();
  structs_that_come_back_say_their_size();
  return check_finish();
}

/* NULL handles, NULL outputs and unknown enumerators are argument errors, never crashes. */
#include <limits.h>

#include "scenes.h"

#define NO_MODEL(...) CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model|NULL", __VA_ARGS__)
#define NO_OUTPUT(model, ...) CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "NULL", __VA_ARGS__)

static int32_t no_displacement(double x, double y, double* constant, double* proportional, void* user) {
  (void)x, (void)y, (void)constant, (void)proportional, (void)user;
  return 0;
}

static void library_speaks_without_a_model(void) {
  const char* version = bempd_version_string();
  CHECK(version != NULL && strchr(version, '.') != NULL);
  CHECK(bempd_build_info() != NULL && bempd_build_info()[0] != '\0');
  CHECK(strcmp(bempd_status_name(BEMPD_OK), "BEMPD_OK") == 0);
  CHECK(strcmp(bempd_status_name(BEMPD_ERROR_ARGUMENT), "BEMPD_ERROR_ARGUMENT") == 0);
  CHECK(strcmp(bempd_status_name(BEMPD_ERROR_INTERNAL), "BEMPD_ERROR_INTERNAL") == 0);
  CHECK(bempd_status_name((bempd_status)7) != NULL && bempd_status_name((bempd_status)-99)[0] != '\0');
  CHECK(bempd_last_error(NULL) != NULL && bempd_last_error(NULL)[0] == '\0');
}

static void freeing_null_is_fine(void) {
  bempd_model_free(NULL);
  bempd_state_free(NULL);
  CHECK(bempd_last_error(NULL) != NULL);
}

static void null_model_is_refused_while_building(void) {
  const bempd_material material = sound_material();
  const rectangle r = rectangle_of(0.0, 0.0, 1.0, 1.0);
  const double value = 0.0;
  int32_t id = 0;
  NO_MODEL(bempd_model_create(NULL));
  NO_MODEL(bempd_add_material(NULL, &material, &id));
  NO_MODEL(bempd_add_bem_region(NULL, 1, 4, r.vertices, 1.0, &id));
  NO_MODEL(bempd_add_pd_region(NULL, 1, 4, r.vertices, 0.1, 3, &id));
  NO_MODEL(bempd_add_hole(NULL, 1, 4, r.vertices, &id));
  NO_MODEL(bempd_set_edge_mesh(NULL, 1, 1, 1.0, 1.0));
  NO_MODEL(bempd_set_toughness_at(NULL, 1, 1, &value, &value));
  NO_MODEL(bempd_set_resistance_curve(NULL, 1, 1, &value, &value));
  NO_MODEL(bempd_set_resistance_directions(NULL, 1, 1, &value, &value));
  NO_MODEL(bempd_load_case_add(NULL, 1, &id, 0, NULL, NULL));
  NO_MODEL(bempd_load_case_count(NULL, &id));
  NO_MODEL(bempd_add_crack(NULL, 2, r.vertices, &id));
  NO_MODEL(bempd_region_count(NULL, &id));
  NO_MODEL(bempd_edge_count(NULL, 1, &id));
  NO_MODEL(bempd_fix_edge(NULL, 1, 1, BEMPD_X, &id));
  NO_MODEL(bempd_fix_point(NULL, 0.0, 0.0, BEMPD_X, &id));
  NO_MODEL(bempd_prescribe_edge(NULL, 1, 1, 0.0, 1.0, BEMPD_X, 1, &value, NULL, &id));
  NO_MODEL(bempd_prescribe_edge_function(NULL, 1, 1, 0.0, 1.0, BEMPD_X, no_displacement, NULL, &id));
  NO_MODEL(bempd_prescribe_point(NULL, 0.0, 0.0, BEMPD_X, 0.0, 1.0, &id));
  NO_MODEL(bempd_add_traction(NULL, 1, 1, 0.0, 1.0, BEMPD_X, 1, &value, NULL, &id));
  NO_MODEL(bempd_add_traction_function(NULL, 1, 1, 0.0, 1.0, no_displacement, NULL, &id));
  NO_MODEL(bempd_add_point_force(NULL, 0.0, 0.0, BEMPD_X, 0.0, 1.0, &id));
  NO_MODEL(bempd_add_temperature(NULL, 1, 0.0, 1.0, &id));
  NO_MODEL(bempd_add_temperature_function(NULL, 1, NULL, NULL, &id));
  NO_MODEL(bempd_add_crack_pressure(NULL, 1, 0.0, 1.0, &id));
  NO_MODEL(bempd_add_body_force(NULL, 1, BEMPD_X, 0.0, 1.0, &id));
  NO_MODEL(bempd_add_rotation(NULL, 1, 0.0, 0.0, 0.0, 1.0, &id));
  NO_MODEL(bempd_set_load_values(NULL, 1, 1, &value, NULL));
  NO_MODEL(bempd_set_support_values(NULL, 1, 1, &value, NULL));
  NO_MODEL(bempd_set_option(NULL, "threads", 1.0));
  NO_MODEL(bempd_set_option_text(NULL, "scheme", "symmetric"));
  NO_MODEL(bempd_set_progress(NULL, NULL, NULL));
  NO_MODEL(bempd_set_log(NULL, NULL, NULL));
}

static void null_model_is_refused_while_running(void) {
  bempd_step_report report;
  bempd_statistics statistics;
  bempd_history_entry entry;
  bempd_state* state = NULL;
  const double* view = NULL;
  double values[8] = {0};
  int32_t integers[8] = {0};
  int64_t count = 0;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  NO_MODEL(bempd_prepare(NULL));
  NO_MODEL(bempd_step(NULL, 1.0, &report));
  NO_MODEL(bempd_step_to_next_event(NULL, 1.0, &report));
  NO_MODEL(bempd_run_to_separation(NULL, 1.0, &report));
  NO_MODEL(bempd_request_cancel(NULL));
  NO_MODEL(bempd_load_factor(NULL, values));
  NO_MODEL(bempd_generation(NULL, &count));
  NO_MODEL(bempd_node_count(NULL, 1, &count));
  NO_MODEL(bempd_element_count(NULL, 1, &count));
  NO_MODEL(bempd_copy_elements(NULL, 1, 8, integers));
  NO_MODEL(bempd_field_size(NULL, 1, BEMPD_POSITION, &count, integers));
  NO_MODEL(bempd_copy_field(NULL, 1, BEMPD_POSITION, 8, values));
  NO_MODEL(bempd_view_field(NULL, 1, BEMPD_POSITION, &view, &count, integers, NULL));
  NO_MODEL(bempd_bond_count(NULL, 1, &count));
  NO_MODEL(bempd_copy_bonds(NULL, 1, 4, integers, NULL));
  NO_MODEL(bempd_reaction(NULL, 1, values));
  NO_MODEL(bempd_edge_reaction(NULL, 1, 1, 0.0, 0.0, values, values));
  NO_MODEL(bempd_evaluate(NULL, 1, values, values, NULL, NULL));
  NO_MODEL(bempd_evaluate_in(NULL, 1, BEMPD_FACE_LEFT, 1, values, values, NULL));
  NO_MODEL(bempd_singularity_count(NULL, &count));
  NO_MODEL(bempd_get_singularity(NULL, 0, NULL));
  NO_MODEL(bempd_get_statistics(NULL, &statistics));
  NO_MODEL(bempd_history_count(NULL, &count));
  NO_MODEL(bempd_history(NULL, 0, &entry));
  NO_MODEL(bempd_get_option(NULL, "threads", values));
  NO_MODEL(bempd_get_option_text(NULL, "scheme", NULL, 0, &count));
  NO_MODEL(bempd_state_save(NULL, &state));
  NO_MODEL(bempd_write_snapshot(NULL, "never_written"));
  NO_MODEL(bempd_write_history(NULL, "never_written.csv"));
  CHECK(state == NULL && view == NULL);
}

static void null_structs_and_arrays_are_refused(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  const bempd_material material = sound_material();
  uint8_t byte = 0;
  bempd_state* state = NULL;
  NO_OUTPUT(NULL, bempd_material_init(NULL, sizeof(bempd_material)));
  NO_OUTPUT(NULL, bempd_step_report_init(NULL, sizeof(bempd_step_report)));
  NO_OUTPUT(NULL, bempd_statistics_init(NULL, sizeof(bempd_statistics)));
  NO_OUTPUT(NULL, bempd_history_entry_init(NULL, sizeof(bempd_history_entry)));
  NO_OUTPUT(NULL, bempd_singularity_init(NULL, sizeof(bempd_singularity)));
  NO_OUTPUT(NULL, bempd_option_count(NULL));
  NO_OUTPUT(NULL, bempd_option_describe(0, NULL));
  NO_OUTPUT(model, bempd_add_material(model, NULL, NULL));
  CHECK_OK(model, bempd_add_material(model, &material, NULL));
  NO_OUTPUT(model, bempd_add_bem_region(model, plate.material, 4, NULL, 1.0, NULL));
  NO_OUTPUT(model, bempd_add_pd_region(model, plate.material, 4, NULL, 1.0, 3, NULL));
  NO_OUTPUT(model, bempd_add_hole(model, plate.left, 4, NULL, NULL));
  NO_OUTPUT(model, bempd_add_crack(model, 2, NULL, NULL));
  NO_OUTPUT(model, bempd_region_count(model, NULL));
  NO_OUTPUT(model, bempd_edge_count(model, plate.left, NULL));
  NO_OUTPUT(model, bempd_prescribe_edge_function(model, plate.left, 4, 0.0, 1.0, BEMPD_Y, NULL, NULL, NULL));
  NO_OUTPUT(model, bempd_add_traction_function(model, plate.left, 3, 0.0, 1.0, NULL, NULL, NULL));
  NO_OUTPUT(model, bempd_set_option(model, NULL, 1.0));
  NO_OUTPUT(model, bempd_set_option_text(model, NULL, "symmetric"));
  NO_OUTPUT(model, bempd_set_option_text(model, "scheme", NULL));
  NO_OUTPUT(model, bempd_get_option(model, "threads", NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "NULL|empty", bempd_write_snapshot(model, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "NULL|empty", bempd_write_history(model, NULL));
  NO_OUTPUT(model, bempd_state_save(model, NULL));
  NO_OUTPUT(model, bempd_state_restore(model, NULL));
  NO_OUTPUT(NULL, bempd_state_to_bytes(NULL, 1, &byte, NULL));
  NO_OUTPUT(NULL, bempd_state_from_bytes(4, NULL, &state));
  NO_OUTPUT(NULL, bempd_state_from_bytes(1, &byte, NULL));
  bempd_model_free(model);
}

static void null_outputs_of_results_are_refused(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  const double place[2] = {1.0, 1.0};
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  NO_OUTPUT(model, bempd_load_factor(model, NULL));
  NO_OUTPUT(model, bempd_generation(model, NULL));
  NO_OUTPUT(model, bempd_node_count(model, plate.left, NULL));
  NO_OUTPUT(model, bempd_element_count(model, plate.left, NULL));
  NO_OUTPUT(model, bempd_copy_elements(model, plate.left, 1000, NULL));
  NO_OUTPUT(model, bempd_copy_field(model, plate.left, BEMPD_POSITION, 1000, NULL));
  NO_OUTPUT(model, bempd_view_field(model, plate.left, BEMPD_POSITION, NULL, NULL, NULL, NULL));
  NO_OUTPUT(model, bempd_bond_count(model, plate.strip, NULL));
  NO_OUTPUT(model, bempd_reaction(model, plate.pulled_left, NULL));
  NO_OUTPUT(model, bempd_evaluate(model, 1, NULL, NULL, NULL, NULL));
  NO_OUTPUT(model, bempd_evaluate_in(model, plate.left, BEMPD_FACE_LEFT, 1, NULL, NULL, NULL));
  NO_OUTPUT(model, bempd_singularity_count(model, NULL));
  NO_OUTPUT(model, bempd_get_singularity(model, 0, NULL));
  NO_OUTPUT(model, bempd_get_statistics(model, NULL));
  NO_OUTPUT(model, bempd_history_count(model, NULL));
  NO_OUTPUT(model, bempd_history(model, 0, NULL));
  CHECK_OK(model, bempd_field_size(model, plate.left, BEMPD_POSITION, NULL, NULL));
  CHECK_OK(model, bempd_copy_bonds(model, plate.strip, 100000, NULL, NULL));
  CHECK_OK(model, bempd_evaluate(model, 1, place, NULL, NULL, NULL));
  bempd_model_free(model);
}

static void unknown_enumerators_are_refused(void) {
  static const int32_t unknown_components[] = {0, 4, -1, INT32_MAX, INT32_MIN};
  static const int32_t unknown_fields[] = {0, 7, -1, INT32_MAX, INT32_MIN};
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  const double value = 1.0;
  double values[4];
  size_t k;
  for (k = 0; k < sizeof unknown_components / sizeof unknown_components[0]; ++k) {
    const int32_t component = unknown_components[k];
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component", bempd_fix_edge(model, plate.left, 4, component, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component", bempd_fix_point(model, 0.0, 0.0, component, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component",
                bempd_prescribe_edge(model, plate.left, 4, 0.0, 1.0, component, 1, &value, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component",
                bempd_prescribe_edge_function(model, plate.left, 4, 0.0, 1.0, component, no_displacement, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component",
                bempd_prescribe_point(model, 0.0, 0.0, component, 0.0, 1.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component",
                bempd_add_traction(model, plate.left, 3, 0.0, 1.0, component, 1, &value, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component",
                bempd_add_point_force(model, 0.0, 8.0, component, 0.0, 1.0, NULL));
  }
  for (k = 0; k < sizeof unknown_fields / sizeof unknown_fields[0]; ++k) {
    const int32_t field = unknown_fields[k];
    const double* view = NULL;
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "field", bempd_field_size(model, plate.strip, field, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "field", bempd_copy_field(model, plate.strip, field, 4, values));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "field",
                bempd_view_field(model, plate.strip, field, &view, NULL, NULL, NULL));
    CHECK(view == NULL);
  }
  bempd_model_free(model);
}

int main(void) {
  library_speaks_without_a_model();
  freeing_null_is_fine();
  null_model_is_refused_while_building();
  null_model_is_refused_while_running();
  null_structs_and_arrays_are_refused();
  null_outputs_of_results_are_refused();
  unknown_enumerators_are_refused();
  return check_finish();
}

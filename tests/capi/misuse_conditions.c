/* Supports and loads that cannot be applied. */
#include <limits.h>

#include "scenes.h"

static const double one = 1.0;

static int32_t unit_value(double x, double y, double* constant, double* proportional, void* user) {
  (void)x, (void)y, (void)constant, (void)user;
  proportional[0] = 1.0;
  return 0;
}

static void parts_of_an_edge_run_from_less_to_more(void) {
  static const double wrong[][2] = {{0.5, 0.5}, {0.7, 0.3}, {-0.1, 0.5},     {0.5, 1.1},
                                    {NAN, 1.0}, {0.0, NAN}, {0.0, INFINITY}, {-INFINITY, 1.0}};
  bempd_model* model = bem_block();
  size_t k;
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
    const double from = wrong[k][0];
    const double to = wrong[k][1];
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "from|to ",
                bempd_prescribe_edge(model, 1, 2, from, to, BEMPD_X, 1, &one, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "from|to ",
                bempd_prescribe_edge_function(model, 1, 2, from, to, BEMPD_X, unit_value, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "from|to ",
                bempd_add_traction(model, 1, 2, from, to, BEMPD_X, 1, &one, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "from|to ",
                bempd_add_traction_function(model, 1, 2, from, to, unit_value, NULL, NULL));
  }
  bempd_model_free(model);
}

static void both_components_only_where_the_function_says_so(void) {
  bempd_model* model = bem_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component|BOTH",
              bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_BOTH, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component|BOTH",
              bempd_prescribe_point(model, 10.0, 4.0, BEMPD_BOTH, 0.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component|BOTH",
              bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_BOTH, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component|BOTH",
              bempd_add_point_force(model, 10.0, 4.0, BEMPD_BOTH, 0.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component|BOTH",
              bempd_add_body_force(model, 1, BEMPD_BOTH, 0.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 2", bempd_add_temperature(model, 2, 0.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "function is NULL",
              bempd_add_temperature_function(model, 1, NULL, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 2", bempd_add_body_force(model, 2, BEMPD_Y, 0.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 2", bempd_add_rotation(model, 2, 0.0, 0.0, 0.0, 1.0, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_point(model, 10.0, 4.0, BEMPD_BOTH, NULL));
  bempd_model_free(model);
}

static void values_are_finite_and_counted(void) {
  static const int64_t wrong_counts[] = {0, -1, INT64_MIN, INT64_MAX};
  static const double wrong_values[] = {NAN, INFINITY, -INFINITY};
  bempd_model* model = bem_block();
  double values[3] = {0.0, 0.0, 0.0};
  size_t k;
  for (k = 0; k < sizeof wrong_counts / sizeof wrong_counts[0]; ++k) {
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count|values",
                bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, wrong_counts[k], values, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count|values",
                bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, wrong_counts[k], values, NULL, NULL));
  }
  for (k = 0; k < sizeof wrong_values / sizeof wrong_values[0]; ++k) {
    values[2] = wrong_values[k];
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 3, values, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 3, NULL, values, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_prescribe_point(model, 10.0, 4.0, BEMPD_X, wrong_values[k], 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_prescribe_point(model, 10.0, 4.0, BEMPD_X, 0.0, wrong_values[k], NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_add_point_force(model, 10.0, 4.0, BEMPD_X, wrong_values[k], 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_add_point_force(model, 10.0, wrong_values[k], BEMPD_X, 1.0, 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_add_temperature(model, 1, wrong_values[k], 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_add_body_force(model, 1, BEMPD_Y, wrong_values[k], 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_add_rotation(model, 1, 0.0, 0.0, wrong_values[k], 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "axis",
                bempd_add_rotation(model, 1, wrong_values[k], 0.0, 1.0, 0.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan|inf",
                bempd_fix_point(model, wrong_values[k], 4.0, BEMPD_X, NULL));
  }
  bempd_model_free(model);
}

static void interfaces_take_no_traction(void) {
  coupled_plate plate = coupled_plate_create();
  CHECK_REFUSED_BY_PREPARE(plate.model, "interface",
                           bempd_add_traction(plate.model, plate.left, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &one, NULL));
  bempd_model_free(plate.model);
  plate = coupled_plate_create();
  CHECK_REFUSED_BY_PREPARE(plate.model, "interface",
                           bempd_add_traction(plate.model, plate.strip, 4, 0.2, 0.4, BEMPD_Y, 1, NULL, &one, NULL));
  bempd_model_free(plate.model);
  plate = coupled_plate_create();
  CHECK_REFUSED_BY_PREPARE(plate.model, "interface",
                           bempd_add_traction_function(plate.model, plate.strip, 2, 0.0, 1.0, unit_value, NULL, NULL));
  bempd_model_free(plate.model);
}

static void points_are_on_nodes(void) {
  static const double nowhere[][2] = {{5.0, 4.0}, {14.5, 4.0}, {14.5, 0.0}, {50.0, 50.0}, {-1e-3, 4.0}};
  size_t k;
  for (k = 0; k < sizeof nowhere / sizeof nowhere[0]; ++k) {
    const double x = nowhere[k][0];
    const double y = nowhere[k][1];
    coupled_plate plate = coupled_plate_create();
    CHECK_REFUSED_BY_PREPARE(plate.model, "node|material point|boundary|outside",
                             bempd_fix_point(plate.model, x, y, BEMPD_X, NULL));
    bempd_model_free(plate.model);
    plate = coupled_plate_create();
    CHECK_REFUSED_BY_PREPARE(plate.model, "node|material point|boundary|outside",
                             bempd_add_point_force(plate.model, x, y, BEMPD_X, 0.0, 1.0, NULL));
    bempd_model_free(plate.model);
  }
}

static void supports_agree_where_they_meet(void) {
  bempd_model* model = bem_block();
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_REFUSED_BY_PREPARE(model, "contradict|conflict|differ|already|both|two|same",
                           bempd_prescribe_point(model, 0.0, 8.0, BEMPD_X, 0.5, 0.0, NULL));
  bempd_model_free(model);
  model = pd_block();
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_REFUSED_BY_PREPARE(model, "contradict|conflict|differ|already|both|two|same",
                           bempd_prescribe_edge(model, 1, 3, 0.0, 1.0, BEMPD_X, 1, NULL, &one, NULL));
  bempd_model_free(model);
  model = bem_block();
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  bempd_model_free(model);
}

static void new_values_fit_what_is_there(void) {
  static const int32_t unknown[] = {0, -1, 9, INT32_MAX, INT32_MIN};
  bempd_model* model = bem_block();
  const double values[3] = {1.0, 2.0, NAN};
  int32_t load = 0;
  int32_t function_load = 0;
  int32_t support = 0;
  int32_t function_support = 0;
  int prepared;
  size_t k;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &support));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 2, values, NULL, &load));
  CHECK_OK(model, bempd_add_traction_function(model, 1, 3, 0.0, 1.0, unit_value, NULL, &function_load));
  CHECK_OK(model, bempd_prescribe_edge_function(model, 1, 1, 0.5, 1.0, BEMPD_Y, unit_value, NULL, &function_support));
  for (prepared = 0; prepared < 2; ++prepared) {
    for (k = 0; k < sizeof unknown / sizeof unknown[0]; ++k) {
      CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load", bempd_set_load_values(model, unknown[k], 2, values, NULL));
      CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support", bempd_set_support_values(model, unknown[k], 1, values, NULL));
    }
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count|values", bempd_set_load_values(model, load, 1, values, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count|values", bempd_set_load_values(model, load, 3, values, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count|values", bempd_set_load_values(model, load, -2, values, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan", bempd_set_load_values(model, load, 2, values + 1, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "function", bempd_set_load_values(model, function_load, 1, values, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count|values", bempd_set_support_values(model, support, 2, values, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan",
                bempd_set_support_values(model, support, 1, NULL, values + 2));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "function",
                bempd_set_support_values(model, function_support, 1, values, NULL));
    CHECK_OK(model, bempd_set_load_values(model, load, 2, NULL, values));
    CHECK_OK(model, bempd_set_support_values(model, support, 1, NULL, NULL));
    CHECK_OK(model, bempd_prepare(model));
  }
  bempd_model_free(model);
}

int main(void) {
  parts_of_an_edge_run_from_less_to_more();
  both_components_only_where_the_function_says_so();
  values_are_finite_and_counted();
  interfaces_take_no_traction();
  points_are_on_nodes();
  supports_agree_where_they_meet();
  new_values_fit_what_is_there();
  return check_finish();
}

/* Values along an edge by one struct: each kind does what its short form does, to the bit. */
#include "scenes.h"

static bempd_edge_values values_of(int32_t kind) {
  bempd_edge_values values;
  CHECK_OK(NULL, bempd_edge_values_init(&values, sizeof values));
  values.kind = kind;
  return values;
}

static int32_t linear_in_y(double x, double y, double* constant, double* proportional, void* user) {
  (void)constant;
  proportional[0] = 1e-4 * y;
  proportional[1] = *(const double*)user * x;
  return 0;
}

/** A lattice held at its left end; its work after a step under what `load` puts on its right one. */
static double work_under(void (*load)(bempd_model*)) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  bempd_step_report report;
  int32_t id = 0;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  material.critical_stretch = 0.0;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  add_pd_rectangle(model, id, 0.0, 0.0, 10.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  load(model);
  CHECK_OK(model, bempd_step(model, 1.0, &report));
  bempd_model_free(model);
  return report.work;
}

static const double two[2] = {1e-3, 2e-3}, fractions[3] = {0.0, 0.25, 1.0}, one_tilt = 1e-5;
static const double table[6] = {1e-3, 0.0, 1.25e-3, 0.0, 2e-3, 0.0}, nodes[18] = {1e-3, 0.0, 2e-3};

static void short_linear(bempd_model* model) {
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 2, NULL, two, NULL));
}
static void long_linear(bempd_model* model) {
  bempd_edge_values values = values_of(BEMPD_LINEAR);
  values.count = 2;
  values.proportional = two;
  CHECK_OK(model, bempd_prescribe_edge_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
}
static void long_table(bempd_model* model) {
  bempd_edge_values values = values_of(BEMPD_TABLE);
  values.count = 3;
  values.components = 2;
  values.fractions = fractions;
  values.proportional = table;
  CHECK_OK(model, bempd_prescribe_edge_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
}
static void short_table(bempd_model* model) {
  short_linear(model);
  CHECK_OK(model, bempd_set_support_values_at(model, 2, 3, fractions, NULL, table));
}
static void set_table(bempd_model* model) {
  bempd_edge_values values = values_of(BEMPD_TABLE);
  short_linear(model);
  values.count = 3;
  values.components = 2;
  values.fractions = fractions;
  values.proportional = table;
  CHECK_OK(model, bempd_set_support_edge_values(model, 2, &values));
}
static void short_function(bempd_model* model) {
  CHECK_OK(model, bempd_add_traction_function(model, 1, 2, 0.0, 1.0, linear_in_y, (void*)&one_tilt, NULL));
}
static void long_function(bempd_model* model) {
  bempd_edge_values values = values_of(BEMPD_FUNCTION);
  values.function = linear_in_y;
  values.user = (void*)&one_tilt;
  CHECK_OK(model, bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_BOTH, &values, NULL));
}
static void short_nodal(bempd_model* model) {
  short_function(model);
  CHECK_OK(model, bempd_set_load_nodal_values(model, 1, 9, NULL, nodes));
}
static void long_nodal(bempd_model* model) {
  bempd_edge_values values = values_of(BEMPD_NODAL);
  short_function(model);
  values.count = 9;
  values.components = 2;
  values.proportional = nodes;
  CHECK_OK(model, bempd_set_load_edge_values(model, 1, &values));
}
static void uniform_of_another_count(bempd_model* model) {
  bempd_edge_values values = values_of(BEMPD_UNIFORM);
  short_linear(model);
  values.proportional = two;
  CHECK_OK(model, bempd_set_support_edge_values(model, 2, &values));
}
static void short_uniform(bempd_model* model) {
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, two, NULL));
}

static void every_kind_is_its_short_form(void) {
  CHECK(work_under(long_linear) == work_under(short_linear));
  CHECK(work_under(long_table) == work_under(short_table));
  CHECK(work_under(set_table) == work_under(short_table));
  CHECK(fabs(work_under(long_table) / work_under(short_linear) - 1.0) < 1e-12);
  CHECK(work_under(long_function) == work_under(short_function));
  CHECK(work_under(long_nodal) == work_under(short_nodal));
  CHECK(fabs(work_under(uniform_of_another_count) / work_under(short_uniform) - 1.0) < 1e-12);
}

static void misuse(void) {
  bempd_model* model = pd_block();
  bempd_edge_values values = values_of(BEMPD_UNIFORM);
  CHECK(values.components == 1 && values.constant == NULL);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_edge_values_init(&values, 0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "values",
              bempd_prescribe_edge_values(model, 1, 2, 0.0, 1.0, BEMPD_X, NULL, NULL));
  values = values_of(0);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "kind is 0",
              bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
  values = values_of(BEMPD_LINEAR);
  values.count = 1;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count is 1",
              bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
  values = values_of(BEMPD_UNIFORM);
  values.components = 3;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "components is 3",
              bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
  values = values_of(BEMPD_TABLE);
  values.count = 2;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "fractions is NULL",
              bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
  values = values_of(BEMPD_NODAL);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "once the scene is whole",
              bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_X, &values, NULL));
  values = values_of(BEMPD_FUNCTION);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "function is NULL",
              bempd_add_traction_values(model, 1, 2, 0.0, 1.0, BEMPD_BOTH, &values, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "as a table", bempd_set_support_edge_values(model, 1, &values));
  values = values_of(BEMPD_UNIFORM);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load 7", bempd_set_load_edge_values(model, 7, &values));
  bempd_model_free(model);
}

int main(void) {
  every_kind_is_its_short_form();
  misuse();
  return check_finish();
}

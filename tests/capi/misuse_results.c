/* Questions about results that have no answer. */
#include <limits.h>

#include "scenes.h"

static void unknown_regions_and_supports_have_no_results(void) {
  static const int32_t unknown[] = {0, -1, 4, INT32_MAX, INT32_MIN};
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  const double* view = NULL;
  double values[4];
  int32_t integers[4];
  int64_t count = 0;
  size_t k;
  for (k = 0; k < sizeof unknown / sizeof unknown[0]; ++k) {
    const int32_t id = unknown[k];
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_node_count(model, id, &count));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_element_count(model, id, &count));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_copy_elements(model, id, 4, integers));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_field_size(model, id, BEMPD_POSITION, &count, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_copy_field(model, id, BEMPD_POSITION, 4, values));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region",
                bempd_view_field(model, id, BEMPD_POSITION, &view, NULL, NULL, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_bond_count(model, id, &count));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_copy_bonds(model, id, 2, integers, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support", bempd_reaction(model, id, values));
  }
  bempd_model_free(model);
}

static void fields_belong_to_their_kind_of_region(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  int64_t count = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "peridynamic|PD",
              bempd_field_size(model, plate.left, BEMPD_DAMAGE, &count, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "peridynamic|PD",
              bempd_field_size(model, plate.left, BEMPD_BOND_STRETCH, &count, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "peridynamic|PD", bempd_bond_count(model, plate.left, &count));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "peridynamic|PD", bempd_copy_bonds(model, plate.right, 0, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "BEM|boundary",
              bempd_field_size(model, plate.strip, BEMPD_TRACTION, &count, NULL));
  bempd_model_free(model);
}

static void buffers_have_to_be_large_enough(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  double values[1] = {-7.0};
  int32_t integers[1] = {-7};
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_field(model, plate.left, BEMPD_POSITION, 1, values));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_field(model, plate.left, BEMPD_POSITION, 0, values));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_field(model, plate.strip, BEMPD_STRESS, -1, values));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_elements(model, plate.left, 1, integers));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_elements(model, plate.strip, INT64_MIN, integers));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_bonds(model, plate.strip, 0, integers, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity", bempd_copy_bonds(model, plate.strip, 1, NULL, integers));
  CHECK(values[0] == -7.0 && integers[0] == -7);
  bempd_model_free(model);
}

static void places_are_in_the_body(void) {
  static const double wrong[][2] = {{50.0, 4.0}, {-0.01, 4.0}, {14.0, 8.1}, {NAN, 4.0}, {4.0, INFINITY}};
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  size_t k;
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
    double places[4] = {5.0, 4.0, 0.0, 0.0};
    double displacement[4] = {-7.0, -7.0, -7.0, -7.0};
    memcpy(places + 2, wrong[k], sizeof wrong[k]);
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "outside|finite|nan|inf|body",
                bempd_evaluate(model, 2, places, displacement, NULL, NULL));
  }
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_evaluate(model, -1, wrong[0], NULL, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_evaluate(model, INT64_MAX, wrong[0], NULL, NULL, NULL));
  bempd_model_free(model);
}

static void history_lines_exist(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  bempd_history_entry entry;
  int64_t count = 0;
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index|history", bempd_get_history_entry(model, 0, &entry));
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  CHECK_OK(model, bempd_history_count(model, &count));
  CHECK(count == 1);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_get_history_entry(model, count, &entry));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_get_history_entry(model, -1, &entry));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_get_history_entry(model, INT64_MAX, &entry));
  CHECK_OK(model, bempd_get_history_entry(model, 0, &entry));
  CHECK(entry.event == 0 && entry.load_factor == 0.1 && entry.total_broken_bonds == 0);
  bempd_model_free(model);
}

static void files_need_a_folder(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_IO, "no_such_folder", bempd_write_snapshot(model, "no_such_folder/a/b"));
  CHECK_FAILS(model, BEMPD_ERROR_IO, "no_such_folder", bempd_write_history(model, "no_such_folder/history.csv"));
  CHECK(bempd_write_snapshot(model, "") != BEMPD_OK);
  CHECK(bempd_write_history(model, "") != BEMPD_OK);
  CHECK_OK(model, bempd_step(model, 0.2, NULL));
  bempd_model_free(model);
}

int main(void) {
  unknown_regions_and_supports_have_no_results();
  fields_belong_to_their_kind_of_region();
  buffers_have_to_be_large_enough();
  places_are_in_the_body();
  history_lines_exist();
  files_need_a_folder();
  return check_finish();
}

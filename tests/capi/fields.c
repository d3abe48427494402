/* Fields: sizes, views and copies, generations, elements and bonds. */
#include "scenes.h"

static int64_t generation_of(const bempd_model* model) {
  int64_t generation = -1;
  CHECK_OK(model, bempd_generation(model, &generation));
  return generation;
}

static void field_has_size(bempd_model* model, int32_t region, int32_t field, int64_t entries, int32_t numbers) {
  const double* view = NULL;
  double* copy;
  int64_t count = -1;
  int64_t view_count = -1;
  int64_t generation = -1;
  int64_t k;
  int32_t components = -1;
  int32_t view_components = -1;
  CHECK_OK(model, bempd_field_size(model, region, field, &count, &components));
  CHECK(count == entries && components == numbers);
  copy = (double*)malloc((size_t)(count * components + 1) * sizeof *copy);
  if (copy == NULL) abort();
  copy[count * components] = -7.0;
  CHECK_OK(model, bempd_copy_field(model, region, field, count * components, copy));
  CHECK(copy[count * components] == -7.0);
  CHECK_OK(model, bempd_view_field(model, region, field, &view, &view_count, &view_components, &generation));
  CHECK(view != NULL && view_count == count && view_components == components && generation == generation_of(model));
  CHECK(view != NULL && memcmp(view, copy, (size_t)(count * components) * sizeof *copy) == 0);
  for (k = 0; k < count * components && isfinite(copy[k]); ++k) continue;
  CHECK(k == count * components);
  free(copy);
}

static void sizes_views_and_copies_agree(const coupled_plate* plate) {
  bempd_model* model = plate->model;
  bempd_statistics statistics;
  int64_t nodes[3];
  int64_t elements[3];
  int64_t bonds = 0;
  int k;
  const int32_t regions[3] = {plate->left, plate->strip, plate->right};
  for (k = 0; k < 3; ++k) {
    CHECK_OK(model, bempd_node_count(model, regions[k], &nodes[k]));
    CHECK_OK(model, bempd_element_count(model, regions[k], &elements[k]));
    field_has_size(model, regions[k], BEMPD_POSITION, nodes[k], 2);
    field_has_size(model, regions[k], BEMPD_DISPLACEMENT, nodes[k], 2);
    field_has_size(model, regions[k], BEMPD_STRESS, nodes[k], 3);
  }
  CHECK_OK(model, bempd_bond_count(model, plate->strip, &bonds));
  field_has_size(model, plate->strip, BEMPD_DAMAGE, nodes[1], 1);
  field_has_size(model, plate->strip, BEMPD_BOND_STRETCH, bonds, 1);
  field_has_size(model, plate->left, BEMPD_TRACTION, elements[0] * 3, 2);
  field_has_size(model, plate->right, BEMPD_TRACTION, elements[2] * 3, 2);
  field_has_size(model, plate->left, BEMPD_ELEMENT_STRESS, elements[0] * 3, 3);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "peridynamic",
              bempd_field_size(model, plate->strip, BEMPD_ELEMENT_STRESS, NULL, NULL));
  CHECK(nodes[1] == 10 * 9 && elements[1] == 9 * 8);
  CHECK(elements[0] == 5 + 8 + 5 + 4 && elements[2] == 5 + 4 + 5 + 8);
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_get_statistics(model, &statistics));
  CHECK(statistics.material_points == nodes[1] && statistics.bonds == bonds);
  CHECK(statistics.boundary_nodes == nodes[0] + nodes[2]);
  CHECK(statistics.boundary_elements == elements[0] + elements[2]);
}

static void elements_name_their_nodes(const coupled_plate* plate) {
  bempd_model* model = plate->model;
  const double* position = NULL;
  int64_t nodes = 0;
  int64_t elements = 0;
  int64_t k;
  int64_t good = 0;
  int32_t* corners;
  CHECK_OK(model, bempd_element_count(model, plate->left, &elements));
  corners = (int32_t*)malloc((size_t)elements * 3 * sizeof *corners);
  if (corners == NULL) abort();
  CHECK_OK(model, bempd_copy_elements(model, plate->left, elements * 3, corners));
  CHECK_OK(model, bempd_view_field(model, plate->left, BEMPD_POSITION, &position, &nodes, NULL, NULL));
  for (k = 0; k < elements; ++k) {
    const int32_t a = corners[3 * k], b = corners[3 * k + 1], c = corners[3 * k + 2];
    if (a < 0 || b < 0 || c < 0 || a >= nodes || b >= nodes || c >= nodes) continue;
    good += fabs(position[2 * b] - 0.5 * (position[2 * a] + position[2 * c])) < 1e-9 &&
            fabs(position[2 * b + 1] - 0.5 * (position[2 * a + 1] + position[2 * c + 1])) < 1e-9;
  }
  CHECK(good == elements);
  free(corners);
}

static void cells_are_squares_of_material_points(const coupled_plate* plate) {
  static const int32_t steps[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  bempd_model* model = plate->model;
  const double* position = NULL;
  int64_t nodes = 0;
  int64_t cells = 0;
  int64_t k;
  int64_t good = 0;
  int32_t* corners;
  CHECK_OK(model, bempd_element_count(model, plate->strip, &cells));
  corners = (int32_t*)malloc((size_t)cells * 4 * sizeof *corners);
  if (corners == NULL) abort();
  CHECK_OK(model, bempd_copy_elements(model, plate->strip, cells * 4, corners));
  CHECK_OK(model, bempd_view_field(model, plate->strip, BEMPD_POSITION, &position, &nodes, NULL, NULL));
  for (k = 0; k < 4 * cells; ++k) {
    const int32_t first = corners[k - k % 4];
    const int32_t corner = corners[k];
    if (first < 0 || corner < 0 || first >= nodes || corner >= nodes) continue;
    good += fabs(position[2 * corner] - position[2 * first] - steps[k % 4][0]) < 1e-9 &&
            fabs(position[2 * corner + 1] - position[2 * first + 1] - steps[k % 4][1]) < 1e-9;
  }
  CHECK(good == 4 * cells);
  free(corners);
}

/** States add up to the counters, damage is the share of lost bonds, and no intact bond is beyond its critical stretch.
 */
static void bonds_agree_with_counters_and_damage(const coupled_plate* plate) {
  bempd_model* model = plate->model;
  bempd_statistics statistics;
  const double* damage = NULL;
  const double* stretch = NULL;
  int64_t bonds = 0;
  int64_t points = 0;
  int64_t k;
  int64_t broken = 0, cut = 0, ends_in_range = 0, overstretched = 0;
  double largest_difference = 0.0;
  int32_t* ends;
  int32_t* states;
  double* lost;
  double* all;
  CHECK_OK(model, bempd_bond_count(model, plate->strip, &bonds));
  CHECK_OK(model, bempd_view_field(model, plate->strip, BEMPD_BOND_STRETCH, &stretch, NULL, NULL, NULL));
  CHECK_OK(model, bempd_view_field(model, plate->strip, BEMPD_DAMAGE, &damage, &points, NULL, NULL));
  ends = (int32_t*)malloc((size_t)bonds * 2 * sizeof *ends);
  states = (int32_t*)malloc((size_t)bonds * sizeof *states);
  lost = (double*)calloc((size_t)points, sizeof *lost);
  all = (double*)calloc((size_t)points, sizeof *all);
  if (ends == NULL || states == NULL || lost == NULL || all == NULL) abort();
  CHECK_OK(model, bempd_copy_bonds(model, plate->strip, bonds, ends, states));
  for (k = 0; k < 2 * bonds; ++k) {
    const int32_t end = ends[k];
    const int32_t state = states[k / 2];
    if (end < 0 || end >= points || ends[2 * (k / 2)] == ends[2 * (k / 2) + 1]) continue;
    ++ends_in_range;
    all[end] += 1.0;
    lost[end] += state != BEMPD_BOND_INTACT;
  }
  for (k = 0; k < bonds; ++k) {
    broken += states[k] == BEMPD_BOND_BROKEN;
    cut += states[k] == BEMPD_BOND_CUT;
    overstretched += states[k] == BEMPD_BOND_INTACT && stretch[k] > 1e-3 * (1.0 + 1e-9);
  }
  for (k = 0; k < points; ++k)
    if (all[k] > 0.0) largest_difference = fmax(largest_difference, fabs(damage[k] - lost[k] / all[k]));
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_get_statistics(model, &statistics));
  CHECK(cut > 0 && cut == statistics.cut_bonds && broken == statistics.broken_bonds);
  CHECK(ends_in_range == 2 * bonds && overstretched == 0);
  CHECK_CLOSE(largest_difference, 0.0, 1e-12);
  free(ends);
  free(states);
  free(lost);
  free(all);
}

static void generation_changes_with_the_fields_only(const coupled_plate* plate, double first_event) {
  bempd_model* model = plate->model;
  int64_t before = generation_of(model);
  outcome seen = coupled_plate_outcome(plate);
  outcome_free(&seen);
  CHECK(generation_of(model) == before);
  CHECK(bempd_step(model, NAN, NULL) != BEMPD_OK);
  CHECK(generation_of(model) == before);
  CHECK_OK(model, bempd_step(model, 0.6 * first_event, NULL));
  CHECK(generation_of(model) != before);
  before = generation_of(model);
  CHECK_OK(model, bempd_step_to_next_event(model, 2.0 * first_event, NULL));
  CHECK(generation_of(model) != before);
}

int main(void) {
  const double first_event = coupled_plate_first_event();
  const coupled_plate plate = coupled_plate_create();
  sizes_views_and_copies_agree(&plate);
  CHECK_OK(plate.model, bempd_step(plate.model, 0.5 * first_event, NULL));
  sizes_views_and_copies_agree(&plate);
  elements_name_their_nodes(&plate);
  cells_are_squares_of_material_points(&plate);
  bonds_agree_with_counters_and_damage(&plate);
  generation_changes_with_the_fields_only(&plate, first_event);
  CHECK_OK(plate.model, bempd_step(plate.model, 1.2 * first_event, NULL));
  bonds_agree_with_counters_and_damage(&plate);
  sizes_views_and_copies_agree(&plate);
  bempd_model_free(plate.model);
  return check_finish();
}

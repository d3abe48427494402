/* Values at places and at nodes of an edge, forces on nodes, and states with the values of loads and supports. */
#define CRACK_RULE "bond"
#include "scenes.h"

#define MOST 100

static int64_t nodes_of(bempd_model* model, int32_t region, int32_t edge, int32_t* nodes, double* fractions,
                        double* weights) {
  int64_t count = 0;
  CHECK_OK(model, bempd_edge_size(model, region, edge, &count, NULL));
  CHECK(count > 1 && count <= MOST);
  CHECK_OK(model, bempd_copy_edge_nodes(model, region, edge, MOST, nodes, fractions, weights));
  return count;
}

static const double* field_of(bempd_model* model, int32_t region, int32_t field) {
  const double* values = NULL;
  CHECK_OK(model, bempd_view_field(model, region, field, &values, NULL, NULL, NULL));
  return values;
}

/** A block of one kind with its left edge fixed and the right one held by a function in both components. */
static int32_t asked = 0;
static int32_t pull_a_little(double x, double y, double* constant, double* proportional, void* user) {
  (void)x, (void)user;
  ++asked;
  constant[0] = 1e-3 + 1e-5 * y;
  proportional[1] = 1e-4;
  return 0;
}

static bempd_model* driven_block(int is_pd, int32_t* right) {
  bempd_model* model = is_pd ? pd_block() : bem_block();
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge_function(model, 1, 2, 0.0, 1.0, BEMPD_BOTH, pull_a_little, NULL, right));
  return model;
}

static void nodes_have_the_values_that_were_given_to_them(void) {
  int is_pd;
  for (is_pd = 0; is_pd < 2; ++is_pd) {
    int32_t right = 0, nodes[MOST];
    bempd_model* model = driven_block(is_pd, &right);
    const int64_t count = nodes_of(model, 1, 2, nodes, NULL, NULL);
    double values[2 * MOST];
    int round;
    int64_t k;
    for (round = 1; round <= 3; ++round) {
      const double* displacement;
      for (k = 0; k < 2 * count; ++k) values[k] = 1e-4 * round * sin(0.7 * (double)k + round);
      CHECK_OK(model, bempd_set_support_nodal_values(model, right, count, values, NULL));
      CHECK_OK(model, bempd_step(model, 0.0, NULL));
      displacement = field_of(model, 1, BEMPD_DISPLACEMENT);
      for (k = 0; k < count; ++k) {
        CHECK(displacement[2 * nodes[k]] == values[2 * k]);
        CHECK(displacement[2 * nodes[k] + 1] == values[2 * k + 1]);
      }
    }
    bempd_model_free(model);
  }
}

static void places_have_their_values_and_lines_between_them(void) {
  int is_pd;
  for (is_pd = 0; is_pd < 2; ++is_pd) {
    static const double places[6] = {10.0, 0.8, 10.5, 3.3, 10.0, 7.1};
    static const double values[6] = {1e-4, 0.0, 4e-4, -2e-4, 3e-4, 1e-4};
    int32_t right = 0, nodes[MOST];
    double fractions[3], distances[3], along[MOST];
    bempd_model* model = driven_block(is_pd, &right);
    const int64_t count = nodes_of(model, 1, 2, nodes, along, NULL);
    const double* displacement;
    int64_t k;
    int component;
    CHECK_OK(model, bempd_fractions_on_edge(model, 1, 2, 3, places, fractions, distances));
    CHECK(fabs(fractions[1] - 3.3 / 8.0) < 1e-14 && fabs(distances[1] - 0.5) < 1e-14 && distances[0] < 1e-14);
    CHECK_OK(model, bempd_set_support_values_at(model, right, 3, fractions, NULL, values));
    CHECK_OK(model, bempd_step(model, 0.5, NULL));
    displacement = field_of(model, 1, BEMPD_DISPLACEMENT);
    for (k = 0; k < count; ++k) {
      const double s = along[k] < fractions[0] ? fractions[0] : along[k] > fractions[2] ? fractions[2] : along[k];
      const int left = s < fractions[1] ? 0 : 1;
      const double part = (s - fractions[left]) / (fractions[left + 1] - fractions[left]);
      for (component = 0; component < 2; ++component) {
        const double expected =
            0.5 * ((1.0 - part) * values[2 * left + component] + part * values[2 * left + 2 + component]);
        CHECK(fabs(displacement[2 * nodes[k] + component] - expected) < 1e-16);
      }
    }
    bempd_model_free(model);
  }
}

/** Values at nodes as ways of bempd_step_to_values(): from a function, to samples' form, and back to places. */
static void ways_lead_from_one_form_of_values_to_another(void) {
  const coupled_plate expected = coupled_plate_create(), host = coupled_plate_create();
  int part;
  bempd_step_report one, other;
  CHECK_OK(NULL, bempd_step_report_init(&one, sizeof one));
  CHECK_OK(NULL, bempd_step_report_init(&other, sizeof other));
  CHECK_OK(expected.model, bempd_step(expected.model, 1.2, &one));
  for (part = 1; part <= 4; ++part) {
    const double time = 0.3 * part;
    static const double ends[2] = {0.0, 1.0}, none[2] = {0.0, 0.0}, middle[3] = {0.0, 0.4, 1.0};
    const double left[2] = {-0.002 * time, -0.02 * time};
    const double right[4] = {0.02 * time, 0.0, 0.002 * time, 0.0};
    const double same[6] = {0.02 * time, 0.0, 0.0128 * time, 0.0, 0.002 * time, 0.0};
    CHECK_OK(host.model, bempd_set_support_values(host.model, host.pulled_left, 2, left, none));
    if (part % 2 == 0) {
      CHECK_OK(host.model, bempd_set_support_values_at(host.model, host.pulled_right, 2, ends, right, NULL));
    } else {
      CHECK_OK(host.model, bempd_set_support_values_at(host.model, host.pulled_right, 3, middle, same, NULL));
    }
    CHECK_OK(host.model, bempd_step_to_values(host.model, time, BEMPD_UNTIL_VALUES, &other));
  }
  CHECK(one.total_events > 3 && one.total_events == other.total_events);
  CHECK(one.total_broken_bonds == other.total_broken_bonds);
  CHECK_CLOSE(other.released_energy, one.released_energy, 1e-9 * one.released_energy);
  CHECK_CLOSE(other.work, one.work, 1e-9 * one.work);
  {
    static const double again[2] = {0.024, 0.0024}, none[2] = {0.0, 0.0};
    CHECK_OK(host.model, bempd_set_support_values(host.model, host.pulled_right, 2, again, none));
    CHECK_FAILS(host.model, BEMPD_ERROR_ARGUMENT, "has 2 values",
                bempd_set_support_values(host.model, host.pulled_right, 1, again, none));
  }
  bempd_model_free(expected.model);
  bempd_model_free(host.model);
}

static void a_function_gives_way_to_values(void) {
  int32_t right = 0, nodes[MOST];
  bempd_model* model = driven_block(1, &right);
  const int64_t count = nodes_of(model, 1, 2, nodes, NULL, NULL);
  double values[2 * MOST];
  const double* displacement;
  bempd_step_report report;
  int64_t k;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  for (k = 0; k < count; ++k) values[2 * k] = 2e-3, values[2 * k + 1] = 1e-4;
  CHECK_OK(model, bempd_set_support_nodal_values(model, right, count, values, NULL));
  CHECK_OK(model, bempd_step_to_values(model, 3.0, BEMPD_UNTIL_VALUES, &report));
  CHECK(report.total_events == 0);
  displacement = field_of(model, 1, BEMPD_DISPLACEMENT);
  for (k = 0; k < 2 * count; ++k) CHECK(displacement[2 * nodes[k / 2] + k % 2] == values[k]);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "function", bempd_set_support_values(model, right, 1, values, NULL));
  bempd_model_free(model);
}

/** Forces by the weights of nodes are a uniform traction. */
static void forces_on_nodes_act_as_they_are(void) {
  int is_pd;
  for (is_pd = 0; is_pd < 2; ++is_pd) {
    double seen[2][2 * MOST] = {{0.0}, {0.0}};
    int way;
    int64_t count = 0, k;
    for (way = 0; way < 2; ++way) {
      bempd_model* model = is_pd ? pd_block() : bem_block();
      int32_t load = 0, nodes[MOST];
      double weights[MOST], forces[2 * MOST];
      const double traction[1] = {0.05};
      const double* displacement;
      CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
      if (way == 0) CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_Y, 1, NULL, traction, NULL));
      if (way == 1) CHECK_OK(model, bempd_add_edge_forces(model, 1, 2, 0.0, 1.0, &load));
      count = nodes_of(model, 1, 2, nodes, NULL, weights);
      for (k = 0; k < count; ++k) forces[2 * k] = 0.0, forces[2 * k + 1] = 0.05 * weights[k];
      if (way == 1) {
        CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "nodes",
                    bempd_set_load_nodal_values(model, load, count - 1, NULL, forces));
        CHECK_OK(model, bempd_set_load_nodal_values(model, load, count, NULL, forces));
      }
      CHECK_OK(model, bempd_step(model, 0.01, NULL));
      displacement = field_of(model, 1, BEMPD_DISPLACEMENT);
      for (k = 0; k < 2 * count; ++k) seen[way][k] = displacement[2 * nodes[k / 2] + k % 2];
      bempd_model_free(model);
    }
    for (k = 0; k < 2 * count; ++k) CHECK_CLOSE(seen[1][k], seen[0][k], 1e-12 * fabs(seen[0][1]));
  }
}

static void loads_take_values_at_places(void) {
  bempd_model* model = bem_block();
  static const double fractions[2] = {0.0, 1.0}, values[4] = {0.0, 7.0, 0.02, 7.0};
  double reaction[2];
  int32_t left = 0, load = 0;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &left));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, values, NULL, &load));
  CHECK_OK(model, bempd_set_load_values_at(model, load, 2, fractions, values, NULL));
  CHECK_OK(model, bempd_reaction(model, left, reaction));
  CHECK_CLOSE(reaction[0], -0.02 * 8.0 / 2.0, 1e-10);
  CHECK_CLOSE(reaction[1], 0.0, 1e-10);
  bempd_model_free(model);
}

static void bad_values_are_refused(void) {
  int32_t right = 0, force = 0, point = 0;
  bempd_model* model = driven_block(0, &right);
  static const double good[2] = {0.0, 1.0}, falling[2] = {0.5, 0.5}, beyond[2] = {0.0, 1.5};
  static const double values[4] = {0.0, 0.0, 0.0, 0.0}, wrong[4] = {0.0, 0.0, 0.0, NAN};
  CHECK_OK(model, bempd_fix_point(model, 5.0, 0.0, BEMPD_X, &point));
  CHECK_OK(model, bempd_add_point_force(model, 5.0, 8.0, BEMPD_Y, 1.0, 0.0, &force));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "order",
              bempd_set_support_values_at(model, right, 2, falling, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "between 0",
              bempd_set_support_values_at(model, right, 2, beyond, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite", bempd_set_support_values_at(model, right, 2, good, wrong, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count is 0",
              bempd_set_support_values_at(model, right, 0, good, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "fractions is NULL",
              bempd_set_support_values_at(model, right, 2, NULL, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support 9", bempd_set_support_values_at(model, 9, 2, good, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "along an edge",
              bempd_set_support_values_at(model, point, 2, good, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "along an edge",
              bempd_set_load_values_at(model, force, 2, good, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "along an edge",
              bempd_set_support_nodal_values(model, point, 1, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "nodes", bempd_set_support_nodal_values(model, right, 2, values, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge 9", bempd_fractions_on_edge(model, 1, 9, 1, values, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge 9", bempd_add_edge_forces(model, 1, 9, 0.0, 1.0, NULL));
  bempd_model_free(model);
}

/** A state brings the values of loads and supports back if it was saved with them; by bytes too. */
static void states_contain_values_if_asked(void) {
  int with, by_bytes;
  for (with = 0; with < 2; ++with) {
    for (by_bytes = 0; by_bytes < 2; ++by_bytes) {
      const coupled_plate plate = coupled_plate_create();
      static const double ends[2] = {0.0, 1.0}, first[4] = {0.012, 0.0, 0.001, 0.0}, none[2] = {0.0, 0.0};
      static const double other[2] = {0.015, 0.003};
      static const char* const file = "edge_values.state";
      bempd_state* state = NULL;
      double before[2], after[2], present[2];
      CHECK_OK(plate.model, bempd_set_support_values_at(plate.model, plate.pulled_right, 2, ends, first, NULL));
      CHECK_OK(plate.model, bempd_step(plate.model, 0.3, NULL));
      CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_right, before));
      CHECK_OK(plate.model,
               bempd_state_save_with(plate.model, with ? BEMPD_STATE_BODY_AND_VALUES : BEMPD_STATE_BODY, &state));
      if (by_bytes) {
        int64_t size = 0;
        uint8_t* bytes;
        CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
        bytes = (uint8_t*)malloc((size_t)size);
        if (bytes == NULL) abort();
        CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, NULL));
        bempd_state_free(state);
        CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &state));
        free(bytes);
        CHECK_OK(NULL, bempd_state_write(state, file));
        bempd_state_free(state);
        CHECK_OK(NULL, bempd_state_read(file, &state));
        remove(file);
      }
      CHECK_OK(plate.model, bempd_set_support_values(plate.model, plate.pulled_right, 2, other, none));
      CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_right, present));
      CHECK(fabs(present[0] - before[0]) > 1e-3 * fabs(before[0]));
      CHECK_OK(plate.model, bempd_state_restore(plate.model, state));
      CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_right, after));
      CHECK_CLOSE(after[0], with ? before[0] : present[0], 1e-12 * fabs(before[0]));
      bempd_state_free(state);
      bempd_model_free(plate.model);
    }
  }
}

static void files_that_are_no_states_are_refused(void) {
  bempd_model* model = bem_block();
  bempd_state* state = NULL;
  bempd_state* none = NULL;
  FILE* file = fopen("edge_values.text", "wb");
  if (file == NULL) abort();
  fputs("no state", file);
  fclose(file);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_OK(model, bempd_state_save(model, &state));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "not a state", bempd_state_read("edge_values.text", &none));
  CHECK_FAILS(NULL, BEMPD_ERROR_IO, "cannot read", bempd_state_read("edge_values.nothing", &none));
  CHECK_FAILS(NULL, BEMPD_ERROR_IO, "cannot read", bempd_state_read(".", &none));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "path is NULL", bempd_state_read(NULL, &none));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "state is NULL", bempd_state_read("edge_values.text", NULL));
  CHECK_FAILS(NULL, BEMPD_ERROR_IO, "cannot write", bempd_state_write(state, "no_such_folder/a.state"));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "path is NULL", bempd_state_write(state, ""));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "state is NULL", bempd_state_write(NULL, "a.state"));
  remove("edge_values.text");
  bempd_state_free(state);
  bempd_model_free(model);
}

static void states_with_values_of_other_loads_are_refused(void) {
  bempd_model* saved = bem_block();
  bempd_model* other = bem_block();
  bempd_state* state = NULL;
  static const double one[1] = {0.01};
  CHECK_OK(saved, bempd_fix_edge(saved, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(other, bempd_fix_edge(other, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(saved, bempd_add_traction(saved, 1, 2, 0.0, 1.0, BEMPD_X, 1, one, NULL, NULL));
  CHECK_OK(other, bempd_add_traction(other, 1, 3, 0.0, 1.0, BEMPD_X, 1, one, NULL, NULL));
  CHECK_OK(saved, bempd_prepare(saved));
  CHECK_FAILS(saved, BEMPD_ERROR_ARGUMENT, "contents is 3", bempd_state_save_with(saved, 3, &state));
  CHECK_FAILS(saved, BEMPD_ERROR_ARGUMENT, "state is NULL", bempd_state_save_with(saved, BEMPD_STATE_BODY, NULL));
  CHECK_OK(saved, bempd_state_save_with(saved, BEMPD_STATE_BODY_AND_VALUES, &state));
  CHECK_FAILS(other, BEMPD_ERROR_ARGUMENT, "other loads", bempd_state_restore(other, state));
  CHECK_OK(saved, bempd_state_restore(saved, state));
  bempd_state_free(state);
  CHECK_OK(saved, bempd_state_save_with(saved, BEMPD_STATE_BODY, &state));
  CHECK_OK(other, bempd_state_restore(other, state));
  bempd_state_free(state);
  bempd_model_free(saved);
  bempd_model_free(other);
}

int main(void) {
  nodes_have_the_values_that_were_given_to_them();
  places_have_their_values_and_lines_between_them();
  ways_lead_from_one_form_of_values_to_another();
  a_function_gives_way_to_values();
  forces_on_nodes_act_as_they_are();
  loads_take_values_at_places();
  bad_values_are_refused();
  states_contain_values_if_asked();
  files_that_are_no_states_are_refused();
  states_with_values_of_other_loads_are_refused();
  return check_finish();
}

/* Paths and lengths of cracks, in elements and in lattices, and their openings among bonds. */
#include <stddef.h>

#include "scenes.h"

/** A plate of 2 x 6 that is pulled, with an edge crack to its middle. */
static bempd_model* plate(int in_lattice) {
  const double crack[] = {-1, 0, 0, 0}, one = 1, minus = -1;
  bempd_model* model = new_model();
  bempd_material material;
  int32_t id = 0, region = 0;
  CHECK_OK(model, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1;
  material.poisson_ratio = 1.0 / 3;
  material.fracture_energy = 1;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  if (in_lattice) {
    region = add_pd_rectangle(model, id, -1, -2.95, 1, 2.95, 0.1);
  } else {
    region = add_bem_rectangle(model, id, -1, -2.95, 1, 2.95, 0.25);
  }
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_point(model, -1, -2.95, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_point(model, 1, -2.95, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, region, 3, 0, 1, BEMPD_Y, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_add_traction(model, region, 1, 0, 1, BEMPD_Y, 1, NULL, &minus, NULL));
  return model;
}

static bempd_path_vertex vertex_of(bempd_model* model, int64_t index) {
  bempd_path_vertex vertex;
  CHECK_OK(model, bempd_path_vertex_init(&vertex, sizeof vertex));
  CHECK_OK(model, bempd_crack_path(model, 1, index, &vertex));
  return vertex;
}

static int64_t vertices_of(bempd_model* model) {
  int64_t count = -1;
  CHECK_OK(model, bempd_crack_path_count(model, 1, &count));
  return count;
}

static double length_of(bempd_model* model, int32_t crack) {
  double length = -1;
  CHECK_OK(model, bempd_crack_length(model, crack, &length));
  return length;
}

static void paths_begin_as_described_and_follow_growth(void) {
  for (int in_lattice = 0; in_lattice < 2; ++in_lattice) {
    bempd_model* model = plate(in_lattice);
    bempd_path_vertex last;
    int64_t count = 0;
    double factor = 0;
    CHECK(vertices_of(model) == 2);
    CHECK_CLOSE(length_of(model, 1), 1, 1e-12);
    CHECK(vertex_of(model, 0).event == 0 && vertex_of(model, 0).end == 0);
    CHECK(isnan(vertex_of(model, 1).load_factor) && isnan(vertex_of(model, 1).stress_intensity_1));
    if (in_lattice) {
      CHECK_OK(model, bempd_step_to_next_event(model, 1e9, NULL));
    } else {
      CHECK_OK(model, bempd_grow_cracks(model, 0.1, NULL));
    }
    CHECK_OK(model, bempd_load_factor(model, &factor));
    CHECK(vertices_of(model) == 3);
    last = vertex_of(model, 2);
    CHECK(last.event == 1 && last.end == BEMPD_CRACK_END && last.load_factor == factor);
    CHECK_CLOSE(last.x, 0.1, 0.06);
    CHECK_CLOSE(length_of(model, 1), 1 + last.x, 1e-4);
    CHECK_CLOSE(last.stress_intensity_1, 1, 0.05);
    CHECK_CLOSE(last.stress_intensity_2, 0, 0.05);
    CHECK_CLOSE(last.energy_release_rate, 1, 0.05);
    CHECK_CLOSE(last.resistance, 1, 1e-9);
    CHECK_OK(model, bempd_crack_count(model, &count));
    CHECK(count == 1 && length_of(model, 0) == length_of(model, 1));
    bempd_model_free(model);
  }
}

static void mouths_open_alike_in_lattices_and_elements(void) {
  const double fractions[] = {0, 0.5};
  double normal[2][2], tangential[2];
  for (int in_lattice = 0; in_lattice < 2; ++in_lattice) {
    bempd_model* model = plate(in_lattice);
    CHECK_OK(model, bempd_step(model, 1e-3, NULL));
    CHECK_OK(model, bempd_crack_opening(model, 1, 2, fractions, normal[in_lattice], tangential));
    bempd_model_free(model);
  }
  /* The crack in the lattice acts 0.04 longer than it is. */
  for (int k = 0; k < 2; ++k) {
    CHECK(normal[1][k] > normal[0][k]);
    CHECK_CLOSE(normal[1][k], normal[0][k], 0.2 * normal[0][k]);
  }
}

static void misuse(void) {
  bempd_model* model = plate(0);
  bempd_path_vertex vertex;
  int64_t count = 0;
  double length = 0;
  CHECK_OK(model, bempd_path_vertex_init(&vertex, sizeof vertex));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_crack_path_count(model, 2, &count));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 0", bempd_crack_path_count(model, 0, &count));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_crack_path_count(model, 1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_crack_path(model, 1, 2, &vertex));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_crack_path(model, 1, -1, &vertex));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "vertex", bempd_crack_path(model, 1, 0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_crack_path(model, 2, 0, &vertex));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_crack_length(model, 2, &length));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack", bempd_crack_length(model, -1, &length));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "length", bempd_crack_length(model, 1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_crack_count(model, NULL));
  vertex.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_crack_path(model, 1, 0, &vertex));
  CHECK(bempd_path_vertex_init(NULL, sizeof vertex) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_crack_count(NULL, &count) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_crack_length(NULL, 1, &length) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_crack_path_count(NULL, 1, &count) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_crack_path(NULL, 1, 0, &vertex) == BEMPD_ERROR_ARGUMENT);
  /* A crack that was removed keeps its number. */
  CHECK_OK(model, bempd_remove_crack(model, 1));
  CHECK_OK(model, bempd_crack_count(model, &count));
  CHECK(count == 1 && length_of(model, 0) == 0);
  bempd_model_free(model);
}

int main(void) {
  misuse();
  paths_begin_as_described_and_follow_growth();
  mouths_open_alike_in_lattices_and_elements();
  return check_finish();
}

/* Peridynamic regions with slanted and round edges: what has no network of bonds, and what such regions do not do. */
#include "scenes.h"

static int32_t add_slanted(bempd_model* model, double slant, double spacing, int32_t ratio) {
  const double vertices[] = {0, 0, 10, 0, 10 + slant, 8, slant, 8};
  int32_t region = 0;
  CHECK_OK(model, bempd_add_pd_region(model, add_sound_material(model), 4, vertices, spacing, ratio, &region));
  return region;
}

static void sharp_corners_are_refused_with_advice(void) {
  bempd_model* model = new_model();
  const int32_t region = add_slanted(model, 6.0, 1.0, 4);
  CHECK_OK(model, bempd_fix_edge(model, region, 1, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "corner of 53.13", bempd_prepare(model));
  CHECK(check_has_word(bempd_last_error(model), "cut it off"));
  bempd_model_free(model);
}

static void chords_of_a_corner_are_alike(void) {
  const double vertices[] = {0, 0, 10, 0, 10, 8, 0.5, 8, 0.5, 7.5, 0, 7.5};
  bempd_model* model = new_model();
  CHECK_OK(model, bempd_set_option_text(model, "test.outline_points", "always"));
  CHECK_OK(model, bempd_add_pd_region(model, add_sound_material(model), 6, vertices, 1.0, 4, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "more alike", bempd_prepare(model));
  bempd_model_free(model);
}

static void parts_thinner_than_a_spacing_have_no_network(void) {
  const double vertices[] = {0, 0, 12, 4, 11.8, 4.6, -0.2, 0.6};
  bempd_model* model = new_model();
  CHECK_OK(model, bempd_add_pd_region(model, add_sound_material(model), 4, vertices, 1.0, 4, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no network|more alike", bempd_prepare(model));
  bempd_model_free(model);
}

static void nearest_neighbours_are_too_few(void) {
  const double vertices[] = {0, 0, 10, 0, 12, 8, 2, 8};
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "at least 3",
              bempd_add_pd_region(model, material, 4, vertices, 1.0, 2, NULL));
  add_pd_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 1.0);
  bempd_model_free(model);
  model = new_model();
  {
    const rectangle r = rectangle_of(0.0, 0.0, 10.0, 8.0);
    CHECK_OK(model, bempd_add_pd_region(model, add_sound_material(model), 4, r.vertices, 1.0, 2, NULL));
  }
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "at least 3", bempd_add_circular_hole(model, 1, 5.0, 4.0, 2.0, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  bempd_model_free(model);
}

static void edges_have_no_elements(void) {
  bempd_model* model = new_model();
  const int32_t region = add_slanted(model, 2.0, 1.0, 4);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "elements", bempd_set_edge_mesh(model, region, 1, 1.0, 1.0));
  bempd_model_free(model);
}

static void neighbours_have_one_spacing_and_common_places(void) {
  const double beside[] = {10, 0, 20, 0, 22, 8, 10, 8}, above[] = {0.5, 8, 6.5, 8, 7.5, 14, 0.5, 14};
  bempd_model* model = pd_block();
  CHECK_OK(model, bempd_add_pd_region(model, 1, 4, beside, 0.5, 4, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "same one", bempd_prepare(model));
  bempd_model_free(model);
  model = pd_block();
  CHECK_OK(model, bempd_add_pd_region(model, 1, 4, above, 1.0, 4, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "not a lattice point", bempd_prepare(model));
  bempd_model_free(model);
}

static void elements_follow_the_points_of_round_interfaces(void) {
  bempd_model* model = new_model();
  int32_t region = 0, plate = 0, first = 0;
  const double diamond[] = {3, 0, 0, 3, -3, 0, 0, -3};
  const int32_t material = add_sound_material(model);
  int32_t k;
  plate = add_bem_rectangle(model, material, -6.0, -6.0, 6.0, 6.0, 2.0);
  CHECK_OK(model, bempd_add_circular_hole(model, plate, 0.0, 0.0, 3.0, &first));
  CHECK_OK(model, bempd_add_pd_region(model, material, 4, diamond, 1.0, 4, &region));
  for (k = 1; k <= 4; ++k)
    CHECK_OK(model, bempd_set_edge_arc_about(model, region, k, 0.0, 0.0, 3.0, BEMPD_COUNTER_CLOCKWISE));
  CHECK_OK(model, bempd_set_edge_mesh(model, plate, first, 0.5, 1.0));
  CHECK_OK(model, bempd_fix_edge(model, plate, 1, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "leave out bempd_set_edge_mesh", bempd_prepare(model));
  bempd_model_free(model);
}

static void the_paper_has_lattices_only(void) {
  bempd_model* model = new_model();
  if (bempd_set_option_text(model, "scheme", "paper") == BEMPD_OK) {
    const int32_t region = add_slanted(model, 2.0, 1.0, 4);
    CHECK_OK(model, bempd_fix_edge(model, region, 1, BEMPD_BOTH, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "symmetric", bempd_prepare(model));
  }
  bempd_model_free(model);
}

static void loads_on_round_edges_add_up(void) {
  bempd_model* model = pd_block();
  const double load = 1e-6, pi = 3.14159265358979; /* breaks no bond */
  const double whole = 4.0 * pi * load * sound_material().thickness;
  double force[2], positions[400];
  int64_t nodes = 0, on_circle = 0;
  int32_t first = 0, clamp = 0, k;
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 4.4, 4.0, 2.0, &first));
  CHECK(first == 5);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &clamp));
  for (k = 0; k < 4; ++k) {
    CHECK_OK(model, bempd_add_traction(model, 1, first + k, 0.0, 1.0, BEMPD_Y, 1, NULL, &load, NULL));
    CHECK_OK(model, bempd_add_pressure(model, 1, first + k, 0.0, 1.0, 1, NULL, &load, NULL));
  }
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_node_count(model, 1, &nodes));
  CHECK_OK(model, bempd_copy_field(model, 1, BEMPD_POSITION, 400, positions));
  for (k = 0; k < nodes; ++k)
    on_circle += fabs(hypot(positions[2 * k] - 4.4, positions[2 * k + 1] - 4.0) - 2.0) < 1e-13;
  CHECK(on_circle == 12);
  CHECK_OK(model, bempd_reaction(model, clamp, force));
  CHECK(fabs(force[0]) < 1e-9 * whole && fabs(force[1] + whole) < 1e-9 * whole);
  bempd_model_free(model);
}

int main(void) {
  sharp_corners_are_refused_with_advice();
  chords_of_a_corner_are_alike();
  parts_thinner_than_a_spacing_have_no_network();
  nearest_neighbours_are_too_few();
  edges_have_no_elements();
  neighbours_have_one_spacing_and_common_places();
  elements_follow_the_points_of_round_interfaces();
  the_paper_has_lattices_only();
  loads_on_round_edges_add_up();
  return check_finish();
}

/* Boundary meshes that cannot be made. */
#include "scenes.h"

static void element_lengths_are_positive_and_finite(void) {
  static const double wrong[] = {0.0, -1.0, NAN, INFINITY, -INFINITY};
  bempd_model* model = bem_block();
  const rectangle r = rectangle_of(20.0, 0.0, 30.0, 8.0);
  size_t k;
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "element_length|element length",
                bempd_add_bem_region(model, 1, 4, r.vertices, wrong[k], NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "element_length|element length",
                bempd_set_edge_mesh(model, 1, 1, wrong[k], 1.0));
  }
  bempd_model_free(model);
}

static void billions_of_elements_are_refused_before_they_are_made(void) {
  static const double tiny[] = {1e-9, 1e-300, 5e-324};
  const rectangle r = rectangle_of(0.0, 0.0, 10.0, 8.0);
  size_t k;
  for (k = 0; k < sizeof tiny / sizeof tiny[0]; ++k) {
    bempd_model* model = new_model();
    const int32_t material = add_sound_material(model);
    CHECK_REFUSED_BY_PREPARE(model, "element", bempd_add_bem_region(model, material, 4, r.vertices, tiny[k], NULL));
    bempd_model_free(model);
    model = bem_block();
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
    CHECK_REFUSED_BY_PREPARE(model, "element", bempd_set_edge_mesh(model, 1, 1, tiny[k], 1.0));
    bempd_model_free(model);
  }
}

static void grading_has_limits(void) {
  static const double wrong[] = {0.0, -1.0, 0.99, 4.01, 1e9, NAN, INFINITY};
  bempd_model* model = bem_block();
  size_t k;
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k)
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "grading", bempd_set_edge_mesh(model, 1, 1, 1.0, wrong[k]));
  CHECK_OK(model, bempd_set_edge_mesh(model, 1, 1, 1.0, 4.0));
  bempd_model_free(model);
}

/* Elements below 1e-9 of their edge: refused at the call, in whatever order edge and elements come. */
static void graded_elements_are_not_too_short(void) {
  bempd_model* model = bem_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "1e-09 of their edge: choose a grading of at most 1.6",
              bempd_set_edge_mesh(model, 1, 1, 0.125, 3.0));
  CHECK_OK(model, bempd_set_edge_mesh(model, 1, 1, 0.125, 1.6));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "1e-09 of their edge", bempd_set_edge_arc(model, 1, 1, 5.0, -100.0));
  bempd_model_free(model);
}

static void lattice_edges_have_no_elements(void) {
  bempd_model* model = pd_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "BEM|boundary|peridynamic", bempd_set_edge_mesh(model, 1, 1, 1.0, 1.0));
  bempd_model_free(model);
}

static void edges_get_the_elements_asked_for(void) {
  bempd_model* model = bem_block();
  int64_t elements = 0;
  CHECK_OK(model, bempd_set_option_text(model, "bem.grading", "none"));
  CHECK_OK(model, bempd_set_edge_mesh(model, 1, 1, 3.0, 1.0));
  CHECK_OK(model, bempd_set_edge_mesh(model, 1, 3, 1.0, 1.5));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_element_count(model, 1, &elements));
  CHECK(elements == 4 + 4 + 10 + 4);
  bempd_model_free(model);
}

/* Five more elements at each end of an edge where stress is singular, unless the host has chosen the edge's elements.
 */
static int64_t elements_with_held_edge(int32_t component, int edge_is_chosen) {
  bempd_model* model = bem_block();
  int64_t elements = 0;
  if (edge_is_chosen) CHECK_OK(model, bempd_set_edge_mesh(model, 1, 1, 2.0, 1.0));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, component, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 2, BEMPD_X, NULL));
  CHECK_OK(model, bempd_fix_point(model, 10.0, 4.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_element_count(model, 1, &elements));
  bempd_model_free(model);
  return elements;
}

static void elements_become_smaller_towards_clamped_corners(void) {
  CHECK(elements_with_held_edge(BEMPD_X, 0) == 18);
  CHECK(elements_with_held_edge(BEMPD_BOTH, 0) == 18 + 4 * 5);
  CHECK(elements_with_held_edge(BEMPD_BOTH, 1) == 18 + 3 * 5);
}

static void elements_become_smaller_towards_reentrant_corners_and_ends_of_supports(void) {
  static const double corner[] = {0.0, 0.0, 4.0, 0.0, 4.0, 2.0, 2.0, 2.0, 2.0, 4.0, 0.0, 4.0};
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  int64_t elements = 0;
  CHECK_OK(model, bempd_add_bem_region(model, material, 6, corner, 1.0, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 6, BEMPD_X, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 2.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_element_count(model, 1, &elements));
  CHECK(elements == 16 + 2 * 5);
  bempd_model_free(model);
  model = bem_block();
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 1, 0.0, 0.4, BEMPD_Y, 1, NULL, NULL, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 0.0, BEMPD_X, NULL));
  CHECK_OK(model, bempd_element_count(model, 1, &elements));
  CHECK(elements == 18 + 2 * 5);
  bempd_model_free(model);
}

int main(void) {
  element_lengths_are_positive_and_finite();
  billions_of_elements_are_refused_before_they_are_made();
  grading_has_limits();
  graded_elements_are_not_too_short();
  lattice_edges_have_no_elements();
  edges_get_the_elements_asked_for();
  elements_become_smaller_towards_clamped_corners();
  elements_become_smaller_towards_reentrant_corners_and_ends_of_supports();
  return check_finish();
}

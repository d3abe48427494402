/* Curved edges that cannot be, and what they are good for. */
#include "scenes.h"

/* A block 10 x 8 (region 1); edges: 1 bottom, 2 right, 3 top, 4 left. */
static void places_on_arcs_are_finite_and_between_the_ends(void) {
  bempd_model* model = bem_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite", bempd_set_edge_arc(model, 1, 1, NAN, -1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite", bempd_set_edge_arc(model, 1, 1, 5.0, INFINITY));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no arc", bempd_set_edge_arc(model, 1, 1, 0.0, 0.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no arc", bempd_set_edge_arc(model, 1, 1, 10.0, 0.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no arc", bempd_set_edge_arc(model, 1, 1, 12.0, 0.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_set_edge_arc(model, 1, 0, 5.0, -1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_set_edge_arc(model, 1, 5, 5.0, -1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_set_edge_arc(model, 2, 1, 5.0, -1.0));
  CHECK_OK(model, bempd_set_edge_arc(model, 1, 1, 5.0, -1.0));
  CHECK_OK(model, bempd_set_edge_arc(model, 1, 1, 5.0, 0.0)); /* straight again */
  bempd_model_free(model);
}

static void arcs_may_not_cross_the_outline(void) {
  bempd_model* model = bem_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "cross|touch", bempd_set_edge_arc(model, 1, 1, 5.0, 8.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "cross|touch", bempd_set_edge_arc(model, 1, 1, 5.0, 9.0));
  /* The arc goes round the whole body, which it does not meet. */
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "arc bulges across", bempd_set_edge_arc(model, 1, 1, 5.0, 30.0));
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 5.0, 3.0, 2.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "hole", bempd_set_edge_arc(model, 1, 1, 5.0, 1.5));
  CHECK_OK(model, bempd_set_edge_arc(model, 1, 1, 5.0, 0.5));
  bempd_model_free(model);
}

static void circular_holes_lie_inside_and_apart(void) {
  static const double wrong[] = {0.0, -1.0, NAN, INFINITY};
  bempd_model* model = bem_block();
  int32_t first = 0, edges = 0;
  size_t k;
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k)
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "radius", bempd_add_circular_hole(model, 1, 5.0, 4.0, wrong[k], NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite", bempd_add_circular_hole(model, 1, NAN, 4.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "inside|touch", bempd_add_circular_hole(model, 1, 5.0, 4.0, 4.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "inside", bempd_add_circular_hole(model, 1, 50.0, 4.0, 1.0, NULL));
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 3.0, 4.0, 1.0, &first));
  CHECK(first == 5);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "hole", bempd_add_circular_hole(model, 1, 4.5, 4.0, 0.5, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "hole", bempd_add_circular_hole(model, 1, 3.0, 4.0, 0.5, NULL));
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 6.0, 4.0, 0.5, &first));
  CHECK_OK(model, bempd_edge_count(model, 1, &edges));
  CHECK(first == 9 && edges == 12);
  bempd_model_free(model);
}

static void smooth_rows_lie_on_one_loop(void) {
  bempd_model* model = bem_block();
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 5.0, 4.0, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_set_edges_smooth(model, 1, 0, 2));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_set_edges_smooth(model, 1, 7, 9));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "loop", bempd_set_edges_smooth(model, 1, 3, 6));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "two edges", bempd_set_edges_smooth(model, 1, 2, 2));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "two edges", bempd_set_edges_smooth(model, 1, 3, 2));
  CHECK_OK(model, bempd_set_edges_smooth(model, 1, 5, 8));
  CHECK_OK(model, bempd_set_edges_smooth(model, 1, 1, 4));
  bempd_model_free(model);
}

static void an_arc_does_not_bulge_over_an_interface_with_a_lattice(void) {
  bempd_model* model = pd_block();
  const int32_t region = add_bem_rectangle(model, 1, 10.0, 0.0, 20.0, 8.0, 2.0);
  CHECK_OK(model, bempd_set_edge_arc(model, region, 4, 9.5, 4.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "straight", bempd_prepare(model));
  bempd_model_free(model);
}

static void arcs_are_fixed_once_the_model_is_prepared(void) {
  bempd_model* model = bem_block();
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepared", bempd_set_edge_arc(model, 1, 1, 5.0, -1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepared", bempd_set_edges_smooth(model, 1, 1, 2));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepared", bempd_add_circular_hole(model, 1, 5.0, 4.0, 1.0, NULL));
  bempd_model_free(model);
}

static void nodes_lie_on_the_circle_and_loads_act_on_it(void) {
  bempd_model* model = bem_block();
  double positions[400], force[2];
  int64_t nodes = 0, elements = 0;
  int32_t first = 0, clamp = 0, k;
  const double one = 1.0;
  CHECK_OK(model, bempd_set_option_text(model, "bem.grading", "none"));
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 4.0, 4.0, 2.0, &first));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &clamp));
  for (k = 0; k < 4; ++k)
    CHECK_OK(model, bempd_add_traction(model, 1, first + k, 0.0, 1.0, BEMPD_Y, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_element_count(model, 1, &elements));
  CHECK(elements == 18 + 8);
  CHECK_OK(model, bempd_node_count(model, 1, &nodes));
  CHECK_OK(model, bempd_copy_field(model, 1, BEMPD_POSITION, 400, positions));
  for (k = 2 * 18; k < nodes; ++k) CHECK(fabs(hypot(positions[2 * k] - 4.0, positions[2 * k + 1] - 4.0) - 2.0) < 1e-14);
  CHECK_OK(model, bempd_reaction(model, clamp, force));
  /* Traction times the circumference and the block's thickness. */
  CHECK(fabs(force[0]) < 1e-9 && fabs(force[1] + 4.0 * 3.14159265358979 * sound_material().thickness) < 1e-9);
  bempd_model_free(model);
}

/* A spiral of which the chords of two edges cross: 3/4 of a circle from (2, 0) to (0, 1), and straight edges. */
static const double spiral[4][2] = {{0.0, 0.0}, {2.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}};
static double three_quarters(void) { return tan(3.0 * 3.14159265358979323846 / 8.0); }

static void chords_of_arcs_given_with_the_vertices_may_cross(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  double bulges[4] = {0.0, 0.0, 0.0, 0.0}, force[2];
  const double pi = 3.14159265358979323846, square = 2.5 * (1.5 * pi + 1.0) / 2.0;
  int32_t region = 0, clamp = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bulges",
              bempd_add_bem_region(model, material, 4, &spiral[0][0], 0.2, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "cross",
              bempd_add_bem_region_with_arcs(model, material, 4, &spiral[0][0], NULL, 0.2, NULL));
  bulges[1] = three_quarters();
  CHECK_OK(model, bempd_add_bem_region_with_arcs(model, material, 4, &spiral[0][0], bulges, 0.2, &region));
  CHECK_OK(model, bempd_fix_edge(model, region, 1, BEMPD_BOTH, &clamp));
  CHECK_OK(model, bempd_add_body_force(model, region, BEMPD_Y, -1.0, 0.0, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_reaction(model, clamp, force));
  CHECK(fabs(force[1] / (square * sound_material().thickness) - 1.0) < 1e-9);
  bempd_model_free(model);
}

static void bulges_are_finite_and_arcs_do_not_cross(void) {
  bempd_model* model = pd_block();
  const double square[4][2] = {{20.0, 0.0}, {28.0, 0.0}, {28.0, 8.0}, {20.0, 8.0}};
  const double hole[4][2] = {{22.0, 4.0}, {24.0, 6.0}, {26.0, 4.0}, {24.0, 2.0}};
  const double round[4] = {-0.41421356237309503, -0.41421356237309503, -0.41421356237309503, -0.41421356237309503};
  double bulges[4] = {0.0, NAN, 0.0, 0.0};
  int32_t region = 0, first = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bulge 2 is nan",
              bempd_add_bem_region_with_arcs(model, 1, 4, &square[0][0], bulges, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bulge 2 is nan",
              bempd_add_pd_region_with_arcs(model, 1, 4, &square[0][0], bulges, 1.0, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "vertices",
              bempd_add_pd_region_with_arcs(model, 1, 4, NULL, bulges, 1.0, 3, NULL));
  bulges[1] = 1.0e300;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "cross|touch|count as one",
              bempd_add_bem_region_with_arcs(model, 1, 4, &square[0][0], bulges, 1.0, NULL));
  bulges[1] = -1.0;
  bulges[3] = -1.0; /* half circles that meet in the middle */
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "cross|touch|spike",
              bempd_add_pd_region_with_arcs(model, 1, 4, &square[0][0], bulges, 1.0, 3, NULL));
  bulges[1] = 0.5;
  bulges[3] = 0.0;
  CHECK_OK(model, bempd_add_pd_region_with_arcs(model, 1, 4, &square[0][0], bulges, 1.0, 3, &region));
  CHECK_OK(model, bempd_add_hole_with_arcs(model, region, 4, &hole[0][0], round, &first));
  CHECK(first == 5);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bulge 2 is nan",
              (bulges[1] = NAN, bempd_add_hole_with_arcs(model, region, 4, &hole[0][0], bulges, NULL)));
  bempd_model_free(model);
}

int main(void) {
  chords_of_arcs_given_with_the_vertices_may_cross();
  bulges_are_finite_and_arcs_do_not_cross();
  places_on_arcs_are_finite_and_between_the_ends();
  arcs_may_not_cross_the_outline();
  circular_holes_lie_inside_and_apart();
  smooth_rows_lie_on_one_loop();
  an_arc_does_not_bulge_over_an_interface_with_a_lattice();
  arcs_are_fixed_once_the_model_is_prepared();
  nodes_lie_on_the_circle_and_loads_act_on_it();
  return check_finish();
}

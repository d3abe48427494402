/* Nodes of an edge with their weights, and the forces on them: supports and neighbours of every kind of region. */
#define CRACK_RULE "bond"
#include "scenes.h"

#define MOST 200

typedef struct edge_of_region {
  int64_t count, elements;
  int32_t nodes[MOST], element[MOST];
  double fractions[MOST], weights[MOST], forces[2 * MOST], displacement[2 * MOST];
} edge_of_region;

/** All there is of an edge, with the displacements of its nodes. */
static void look(bempd_model* model, int32_t region, int32_t edge, edge_of_region* seen) {
  const double* field = NULL;
  int64_t k;
  memset(seen, 0, sizeof *seen);
  CHECK_OK(model, bempd_edge_size(model, region, edge, &seen->count, &seen->elements));
  CHECK(seen->count > 1 && seen->count <= MOST && seen->elements > 0 && seen->elements <= MOST);
  CHECK_OK(model, bempd_copy_edge_nodes(model, region, edge, MOST, seen->nodes, seen->fractions, seen->weights));
  CHECK_OK(model, bempd_copy_edge_elements(model, region, edge, MOST, seen->element));
  CHECK_OK(model, bempd_copy_edge_forces(model, region, edge, MOST, seen->forces));
  CHECK_OK(model, bempd_view_field(model, region, BEMPD_DISPLACEMENT, &field, NULL, NULL, NULL));
  for (k = 0; k < seen->count; ++k) memcpy(seen->displacement + 2 * k, field + 2 * seen->nodes[k], 2 * sizeof *field);
}

static double sum_of(const double* values, int64_t count, int component, int stride) {
  double sum = 0.0;
  int64_t k;
  for (k = 0; k < count; ++k) sum += values[stride * k + component];
  return sum;
}

static int close_to(double one, double other, double scale, double tolerance) {
  if (fabs(one - other) <= tolerance * fabs(scale)) return 1;
  fprintf(stderr, "  %.17g and %.17g, difference %.3g of %.3g\n", one, other, one - other, scale);
  return 0;
}

/** A block 10 x 8 of one kind, held on the left, pulled on the right: 0 BEM, 1 lattice, 2 points on an outline. */
static bempd_model* held_block(int kind, int32_t* left, int32_t* right) {
  bempd_model* model = kind == 0 ? bem_block() : NULL;
  if (model == NULL) {
    model = new_model();
    if (kind == 2) CHECK_OK(model, bempd_set_option_text(model, "test.outline_points", "always"));
    add_pd_rectangle(model, add_sound_material(model), 0.0, 0.0, 10.0, 8.0, 1.0);
  }
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, left));
  {
    const double pull[3] = {0.001, 0.004, 0.002};
    CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 3, NULL, pull, right));
  }
  return model;
}

static void forces_of_a_held_edge_sum_to_its_reaction(void) {
  int kind;
  for (kind = 0; kind < 3; ++kind) {
    int32_t support[2] = {0, 0};
    bempd_model* model = held_block(kind, &support[0], &support[1]);
    int side;
    CHECK_OK(model, bempd_step(model, 0.1, NULL));
    for (side = 0; side < 2; ++side) {
      static edge_of_region edge;
      double reaction[2], of_edge[2], scale;
      int component;
      look(model, 1, side == 0 ? 4 : 2, &edge);
      CHECK_OK(model, bempd_reaction(model, support[side], reaction));
      CHECK_OK(model, bempd_edge_reaction(model, 1, side == 0 ? 4 : 2, 0.0, 0.0, of_edge, NULL));
      scale = hypot(reaction[0], reaction[1]);
      CHECK(scale > 0.1);
      for (component = 0; component < 2; ++component) {
        CHECK(close_to(sum_of(edge.forces, edge.count, component, 2), reaction[component], scale, 1e-12));
        CHECK(close_to(of_edge[component], reaction[component], scale, 1e-12));
      }
    }
    bempd_model_free(model);
  }
}

/** A block under uniform tension: the force at each node is the traction times the weight of the node. */
static void constant_stress_gives_forces_by_the_weights(void) {
  int kind;
  for (kind = 0; kind < 3; ++kind) {
    static edge_of_region edge;
    int32_t side = 0, pulled = 0;
    const double strain = 1e-4, pull[1] = {10.0 * strain};
    bempd_model* model = kind == 0 ? bem_block() : NULL;
    int64_t k;
    if (model == NULL) {
      model = new_model();
      if (kind == 2) CHECK_OK(model, bempd_set_option_text(model, "test.outline_points", "always"));
      add_pd_rectangle(model, add_sound_material(model), 0.0, 0.0, 10.0, 8.0, 1.0);
    }
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_X, &side));
    CHECK_OK(model, bempd_fix_point(model, 0.0, 4.0, BEMPD_Y, NULL));
    CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, pull, NULL, &pulled));
    look(model, 1, 2, &edge);
    CHECK(close_to(sum_of(edge.weights, edge.count, 0, 1), 8.0, 8.0, kind == 2 ? 5e-3 : 1e-13));
    CHECK(edge.fractions[0] == 0.0 && edge.fractions[edge.count - 1] == 1.0);
    for (k = 0; k < edge.count; ++k) {
      CHECK(k == 0 || edge.fractions[k] > edge.fractions[k - 1]);
      CHECK(close_to(edge.forces[2 * k], 1000.0 * strain * edge.weights[k], 0.8, 1e-8));
      CHECK(close_to(edge.forces[2 * k + 1], 0.0, 0.8, 1e-8));
    }
    CHECK(edge.elements == (kind == 0 ? (edge.count - 1) / 2 : edge.count - 1));
    bempd_model_free(model);
  }
}

/** What supports do along a step without an event is half of the forces before and after times the way of the nodes. */
static void forces_do_the_work_that_is_booked(void) {
  int kind;
  for (kind = 0; kind < 3; ++kind) {
    static edge_of_region before[2], after[2];
    int32_t support[2] = {0, 0};
    bempd_model* model = held_block(kind, &support[0], &support[1]);
    bempd_step_report first, second;
    double work = 0.0;
    int side;
    CHECK_OK(NULL, bempd_step_report_init(&first, sizeof first));
    CHECK_OK(NULL, bempd_step_report_init(&second, sizeof second));
    CHECK_OK(model, bempd_step(model, 0.04, &first));
    look(model, 1, 4, &before[0]);
    look(model, 1, 2, &before[1]);
    CHECK_OK(model, bempd_step(model, 0.1, &second));
    CHECK(second.total_events == 0);
    look(model, 1, 4, &after[0]);
    look(model, 1, 2, &after[1]);
    for (side = 0; side < 2; ++side) {
      int64_t k;
      for (k = 0; k < 2 * after[side].count; ++k)
        work += 0.5 * (before[side].forces[k] + after[side].forces[k]) *
                (after[side].displacement[k] - before[side].displacement[k]);
    }
    CHECK(second.work > first.work);
    CHECK(close_to(work, second.work - first.work, second.work, 1e-11));
    bempd_model_free(model);
  }
}

/** Checks both sides of an interface and their sums; where nodes match, node by node. */
static void check_interface(bempd_model* model, int32_t region, int32_t edge, int32_t other, int32_t other_edge,
                            int match) {
  static edge_of_region one, two;
  double scale = 0.0;
  int component;
  int64_t k;
  look(model, region, edge, &one);
  look(model, other, other_edge, &two);
  for (k = 0; k < 2 * one.count; ++k) scale += fabs(one.forces[k]);
  CHECK(scale > 0.01);
  for (component = 0; component < 2; ++component)
    CHECK(close_to(sum_of(one.forces, one.count, component, 2), -sum_of(two.forces, two.count, component, 2), scale,
                   1e-11));
  if (!match) return;
  CHECK(one.count == two.count);
  for (k = 0; k < one.count; ++k) {
    const int64_t same = one.count - 1 - k;
    CHECK(close_to(one.forces[2 * k], -two.forces[2 * same], scale, 1e-11));
    CHECK(close_to(one.forces[2 * k + 1], -two.forces[2 * same + 1], scale, 1e-11));
  }
}

static void forces_of_an_interface_balance_and_carry_the_reaction(void) {
  const coupled_plate plate = coupled_plate_create();
  static edge_of_region edge;
  double reaction[2];
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate.model, bempd_step(plate.model, 1.2, &report));
  CHECK(report.total_events > 3);
  check_interface(plate.model, plate.left, 2, plate.strip, 4, 1);
  check_interface(plate.model, plate.strip, 2, plate.right, 4, 1);
  /* The right block is held by what pulls it and by its interface. */
  look(plate.model, plate.right, 4, &edge);
  CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_right, reaction));
  CHECK(fabs(reaction[0]) > 0.1);
  CHECK(close_to(sum_of(edge.forces, edge.count, 0, 2), -reaction[0], reaction[0], 1e-11));
  CHECK(close_to(sum_of(edge.forces, edge.count, 1, 2), 0.0, reaction[0], 1e-11));
  bempd_model_free(plate.model);
}

/** BEM | PD whose interface has elements of its own, or PD | PD of another spacing, under weight and a side load. */
static void other_interfaces_balance_too(void) {
  int kind;
  for (kind = 0; kind < 2; ++kind) {
    static edge_of_region edge;
    bempd_model* model = new_model();
    const int32_t material = add_sound_material(model);
    const double pull[2] = {0.001, 0.004}, side[1] = {0.05};
    int32_t pulled = 0;
    double reaction[2];
    bempd_material other = sound_material();
    int32_t second = 0;
    other.young_modulus = 700.0;
    CHECK_OK(model, bempd_add_material(model, &other, &second));
    if (kind == 0) {
      add_bem_rectangle(model, material, 0.0, 0.0, 6.0, 8.0, 2.0);
      CHECK_OK(model, bempd_set_edge_mesh(model, 1, 2, 3.0, 1.0));
    } else {
      add_pd_rectangle(model, second, 0.0, 0.0, 6.0, 8.0, 1.0);
    }
    add_pd_rectangle(model, material, 6.0, 0.0, 12.0, 8.0, 1.0);
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_prescribe_edge(model, 2, 2, 0.0, 1.0, BEMPD_X, 2, pull, NULL, &pulled));
    CHECK_OK(model, bempd_add_body_force(model, 2, BEMPD_Y, -0.01, 0.0, NULL));
    CHECK_OK(model, bempd_add_traction(model, 2, 3, 0.0, 1.0, BEMPD_X, 1, side, NULL, NULL));
    check_interface(model, 1, 2, 2, 4, kind == 1);
    /* What the right region bears: its weight, the load on its side up to the very end of the interface, the pull. */
    look(model, 2, 4, &edge);
    CHECK_OK(model, bempd_reaction(model, pulled, reaction));
    CHECK(close_to(sum_of(edge.forces, edge.count, 0, 2) + reaction[0] + 0.05 * 6.0, 0.0, 1.0, 1e-11));
    CHECK(close_to(sum_of(edge.forces, edge.count, 1, 2) + reaction[1], 0.01 * 48.0, 1.0, 1e-11));
    bempd_model_free(model);
  }
}

/** Three blocks that meet in a point, two of them held: every region is in balance with its edges. */
static void regions_balance_where_edges_share_a_node(void) {
  static edge_of_region edge;
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const double pull[1] = {0.003};
  static const int32_t edges[3][3] = {{4, 3, 2}, {2, 3, 4}, {1, 2, 0}};
  int region, k, component;
  add_bem_rectangle(model, material, 0.0, 0.0, 6.0, 4.0, 2.0);
  add_bem_rectangle(model, material, 6.0, 0.0, 12.0, 4.0, 1.0);
  add_pd_rectangle(model, material, 0.0, 4.0, 12.0, 10.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 2, 2, 0.0, 1.0, BEMPD_X, 1, pull, NULL, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 3, 2, 0.0, 1.0, BEMPD_X, 1, pull, NULL, NULL));
  for (region = 0; region < 3; ++region) {
    double sum[2] = {0.0, 0.0};
    for (k = 0; k < 3 && edges[region][k] != 0; ++k) {
      look(model, region + 1, edges[region][k], &edge);
      for (component = 0; component < 2; ++component) sum[component] += sum_of(edge.forces, edge.count, component, 2);
    }
    CHECK(close_to(sum[0], 0.0, 2.0, 1e-11) && close_to(sum[1], 0.0, 2.0, 1e-11));
  }
  bempd_model_free(model);
}

static void edges_without_forces_are_refused(void) {
  int32_t left = 0, right = 0;
  bempd_model* model = held_block(1, &left, &right);
  double forces[2 * MOST];
  int32_t numbers[MOST];
  int64_t count = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "neither held", bempd_copy_edge_forces(model, 1, 1, MOST, forces));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "does not exist", bempd_copy_edge_forces(model, 1, 5, MOST, forces));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "does not exist", bempd_edge_size(model, 1, 0, &count, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 7", bempd_edge_size(model, 7, 1, &count, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity is 8", bempd_copy_edge_forces(model, 1, 4, 8, forces));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "forces is NULL", bempd_copy_edge_forces(model, 1, 4, MOST, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity is 8", bempd_copy_edge_nodes(model, 1, 4, 8, numbers, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity is 7", bempd_copy_edge_elements(model, 1, 4, 7, numbers));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "elements is NULL", bempd_copy_edge_elements(model, 1, 4, MOST, NULL));
  bempd_model_free(model);
}

static void regions_that_act_as_one_have_no_forces_between_them(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  double forces[2 * MOST];
  add_pd_rectangle(model, material, 0.0, 0.0, 6.0, 8.0, 1.0);
  add_pd_rectangle(model, material, 6.0, 0.0, 12.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bonds across", bempd_copy_edge_forces(model, 1, 2, MOST, forces));
  CHECK_OK(model, bempd_copy_edge_forces(model, 1, 4, MOST, forces));
  bempd_model_free(model);
}

/** Points of the scheme "paper" lie inside their cells: the other side of the interface has its forces. */
static void the_scheme_paper_has_forces_on_one_side(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const double pull[1] = {0.01};
  int32_t pulled = 0;
  double forces[2 * MOST], reaction[2];
  static edge_of_region edge;
  if (bempd_set_option_text(model, "scheme", "paper") != BEMPD_OK) { /* the library was built without it */
    bempd_model_free(model);
    return;
  }
  add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 1.0);
  add_pd_rectangle(model, material, 10.0, 0.0, 20.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 2, 2, 0.0, 1.0, BEMPD_X, 1, pull, NULL, &pulled));
  look(model, 1, 2, &edge);
  CHECK_OK(model, bempd_reaction(model, pulled, reaction));
  CHECK(close_to(sum_of(edge.forces, edge.count, 0, 2), reaction[0], reaction[0], 1e-10));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "scheme paper", bempd_copy_edge_forces(model, 2, 4, MOST, forces));
  CHECK_OK(model, bempd_copy_edge_forces(model, 2, 2, MOST, forces));
  bempd_model_free(model);
}

int main(void) {
  forces_of_a_held_edge_sum_to_its_reaction();
  constant_stress_gives_forces_by_the_weights();
  forces_do_the_work_that_is_booked();
  forces_of_an_interface_balance_and_carry_the_reaction();
  other_interfaces_balance_too();
  regions_balance_where_edges_share_a_node();
  edges_without_forces_are_refused();
  regions_that_act_as_one_have_no_forces_between_them();
  the_scheme_paper_has_forces_on_one_side();
  return check_finish();
}

#include "common/half_strip.h"

#include <math.h>

#include "common/common.h"

const double half_strip_length = 1.0, half_strip_height = 0.2, half_strip_young_modulus = 100e9;

const half_strip_case half_strip_cases[half_strip_case_count] = {
    {"1", 0.05, 0.05, 0.05}, {"2", 0.05, 0.05, 0.01},   {"3", 0.01, 0.05, 0.01},
    {"4", 0.01, 0.01, 0.01}, {"5", 0.005, 0.05, 0.005},
};

static int whole(double ratio) { return (int)lround(ratio); }

int half_strip_boundary_nodes(const half_strip_case* mesh) {
  return 2 * whole(half_strip_height / mesh->vertical_nodes) + 2 * whole(0.5 * half_strip_length / mesh->long_nodes);
}

int half_strip_material_points(const half_strip_case* mesh) {
  const int rows = whole(half_strip_height / mesh->spacing);
  return rows * whole(0.5 * half_strip_length / mesh->spacing) + rows + 1;
}

static void support_left_end(bempd_model* model, left_end support) {
  if (support == left_end_clamped) {
    ensure(model, bempd_fix_edge(model, half_strip_bem, 4, BEMPD_BOTH, NULL));
  } else {
    ensure(model, bempd_fix_edge(model, half_strip_bem, 4, BEMPD_X, NULL));
    ensure(model, bempd_fix_point(model, 0.0, 0.5 * half_strip_height, BEMPD_Y, NULL));
  }
}

bempd_model* half_strip_create(const char* scheme, const half_strip_case* mesh, left_end support) {
  const double middle = 0.5 * half_strip_length;
  bempd_model* model = create_model(scheme);
  const int32_t material = add_material(model, half_strip_young_modulus, 0.0);
  double vertices[8];

  rectangle(0.0, 0.0, middle, half_strip_height, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, 2.0 * mesh->long_nodes, NULL));
  rectangle(middle, 0.0, half_strip_length, half_strip_height, vertices);
  ensure(model, bempd_add_pd_region(model, material, 4, vertices, mesh->spacing, 4, NULL));

  ensure(model, bempd_set_edge_mesh(model, half_strip_bem, 4, 2.0 * mesh->vertical_nodes, 1.0));
  /* Nodes that match the lattice need no word: the elements of an interface follow it by themselves. */
  if (mesh->vertical_nodes != mesh->spacing) {
    ensure(model, bempd_set_edge_mesh(model, half_strip_bem, 2, 2.0 * mesh->vertical_nodes, 1.0));
  }
  support_left_end(model, support);
  return model;
}

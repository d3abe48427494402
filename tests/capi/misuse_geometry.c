/* Outlines, holes and arrangements of regions that are no body. */
#include "scenes.h"

#define BAD_BEM(words, count, ...)                                                                                \
  do {                                                                                                            \
    const double vertices_[] = {__VA_ARGS__};                                                                     \
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, words, bempd_add_bem_region(model, 1, count, vertices_, 1.0, NULL)); \
  } while (0)
#define BAD_PD(words, count, ...)                                                                                   \
  do {                                                                                                              \
    const double vertices_[] = {__VA_ARGS__};                                                                       \
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, words, bempd_add_pd_region(model, 1, count, vertices_, 1.0, 3, NULL)); \
  } while (0)

static void outlines_are_refused_by_the_call_that_brings_them(void) {
  bempd_model* model = new_model();
  int32_t regions = -1;
  add_sound_material(model);
  BAD_BEM("vert", 2, 0, 0, 4, 0);
  BAD_BEM("vert", 0, 0, 0);
  BAD_BEM("vert", -3, 0, 0);
  BAD_BEM("vert", INT64_MAX, 0, 0);
  BAD_BEM("finite|nan", 3, 0, 0, 4, NAN, 0, 4);
  BAD_BEM("finite|inf", 3, 0, 0, INFINITY, 0, 0, 4);
  BAD_BEM("clockwise", 4, 0, 0, 0, 4, 4, 4, 4, 0);
  BAD_BEM("cross|intersect", 5, 0, 0, 4, 4, 4, 0, 0, 4, -1, 2);
  BAD_BEM("vertex 1 is", 3, NAN, 0, 4, 0, 0, 4);
  BAD_BEM("vertex 3 is", 3, 0, 0, 4, 0, 0, 1e200);
  BAD_BEM("has the length 1.4e-09; places closer than", 5, 0, 0, 4, 0, 4, 4, 1.4e-9, 4, 0, 4);
  BAD_BEM("repeat|same|coincid|distinct|twice|equal|zero", 4, 0, 0, 0, 0, 4, 0, 0, 4);
  BAD_BEM("repeat|same|coincid|distinct|twice|equal|zero", 4, 0, 0, 4, 0, 0, 4, 0, 0);
  BAD_BEM("area|cross|overlap|line|touch|clockwise|degenerate|back", 3, 0, 0, 4, 0, 2, 0);
  BAD_PD("vert", 2, 0, 0, 4, 0);
  BAD_PD("finite|nan", 4, 0, 0, 4, 0, 4, NAN, 0, 4);
  BAD_PD("clockwise", 4, 0, 0, 0, 4, 4, 4, 4, 0);
  BAD_PD("repeat|same|coincid|distinct|twice|equal|zero", 5, 0, 0, 4, 0, 4, 0, 4, 4, 0, 4);
  BAD_PD("cross|intersect|touch", 8, 0, 0, 6, 0, 6, 4, 2, 4, 2, -2, 4, -2, 4, 2, 0, 2);
  CHECK_OK(model, bempd_region_count(model, &regions));
  CHECK(regions == 0);
  CHECK(add_bem_rectangle(model, 1, 0.0, 0.0, 4.0, 4.0, 1.0) == 1);
  bempd_model_free(model);
}

static void spacing_must_divide_the_edges(void) {
  bempd_model* model = new_model();
  const rectangle r = rectangle_of(0.0, 0.0, 1.0, 0.2);
  add_sound_material(model);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "divide", bempd_add_pd_region(model, 1, 4, r.vertices, 0.03, 3, NULL));
  CHECK(check_has_word(bempd_last_error(model), "0.03"));
  CHECK(check_has_word(bempd_last_error(model), "0.025|0.02|0.04|0.0285|0.0333"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "divide", bempd_add_pd_region(model, 1, 4, r.vertices, 5.0, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "spacing", bempd_add_pd_region(model, 1, 4, r.vertices, 0.0, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "spacing", bempd_add_pd_region(model, 1, 4, r.vertices, -0.1, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "spacing", bempd_add_pd_region(model, 1, 4, r.vertices, NAN, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "spacing", bempd_add_pd_region(model, 1, 4, r.vertices, INFINITY, 3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "spacing|points|cells",
              bempd_add_pd_region(model, 1, 4, r.vertices, 1e-9, 3, NULL));
  CHECK_OK(model, bempd_add_pd_region(model, 1, 4, r.vertices, 0.05, 3, NULL));
  bempd_model_free(model);
}

static void horizon_ratio_has_limits(void) {
  static const int32_t wrong[] = {1, 9, -3, INT32_MAX, INT32_MIN};
  bempd_model* model = new_model();
  const rectangle r = rectangle_of(0.0, 0.0, 10.0, 8.0);
  size_t k;
  add_sound_material(model);
  for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k)
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "horizon",
                bempd_add_pd_region(model, 1, 4, r.vertices, 1.0, wrong[k], NULL));
  CHECK_OK(model, bempd_add_pd_region(model, 1, 4, r.vertices, 1.0, 0, NULL));
  bempd_model_free(model);
}

static void unknown_ids_are_refused(void) {
  static const int32_t unknown[] = {0, -1, 4, INT32_MAX, INT32_MIN};
  const coupled_plate plate = coupled_plate_create();
  bempd_model* model = plate.model;
  const rectangle r = rectangle_of(40.0, 0.0, 50.0, 8.0);
  const double hole[] = {2, 2, 2, 4, 4, 4, 4, 2};
  int32_t count = 0;
  size_t k;
  for (k = 0; k < sizeof unknown / sizeof unknown[0]; ++k) {
    const int32_t id = unknown[k];
    const int32_t edge = id == 4 ? 5 : id;
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "material", bempd_add_bem_region(model, id, 4, r.vertices, 1.0, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "material", bempd_add_pd_region(model, id, 4, r.vertices, 1.0, 3, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_add_hole(model, id, 4, hole, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_edge_count(model, id, &count));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_set_edge_mesh(model, id, 1, 1.0, 1.0));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region", bempd_fix_edge(model, id, 1, BEMPD_X, NULL));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_set_edge_mesh(model, plate.left, edge, 1.0, 1.0));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_fix_edge(model, plate.left, edge, BEMPD_X, NULL));
  }
  bempd_model_free(model);
}

#define BAD_HOLE(words, count, ...)                                                                         \
  do {                                                                                                      \
    const double vertices_[] = {__VA_ARGS__};                                                               \
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, words, bempd_add_hole(model, region, count, vertices_, NULL)); \
  } while (0)

static void holes_lie_inside_and_apart(void) {
  int kind;
  for (kind = 0; kind < 2; ++kind) {
    bempd_model* model = new_model();
    const int32_t material = add_sound_material(model);
    const int32_t region = kind == 0 ? add_bem_rectangle(model, material, 0.0, 0.0, 20.0, 10.0, 2.0)
                                     : add_pd_rectangle(model, material, 0.0, 0.0, 20.0, 10.0, 1.0);
    const double good[] = {3, 3, 3, 6, 6, 6, 6, 3};
    int32_t edge = 0;
    int32_t edges = 0;
    BAD_HOLE("outside|inside|within", 4, 30, 3, 30, 6, 33, 6, 33, 3);
    BAD_HOLE("outside|inside|within|cross|boundary", 4, 18, 3, 18, 6, 23, 6, 23, 3);
    BAD_HOLE("outside|inside|within|cross|around", 4, -5, -5, -5, 15, 25, 15, 25, -5);
    BAD_HOLE("clockwise", 4, 3, 3, 6, 3, 6, 6, 3, 6);
    BAD_HOLE("vert", 2, 3, 3, 6, 6);
    BAD_HOLE("finite|nan", 4, 3, 3, 3, 6, 6, 6, NAN, 3);
    CHECK_OK(model, bempd_add_hole(model, region, 4, good, &edge));
    CHECK(edge == 5);
    BAD_HOLE("overlap|cross|intersect|touch|other hole|another hole", 4, 4, 4, 4, 8, 8, 8, 8, 4);
    BAD_HOLE("overlap|cross|inside|within|touch|same|other hole|another hole", 4, 3, 3, 3, 6, 6, 6, 6, 3);
    BAD_HOLE("overlap|inside|within|cross|touch|other hole|another hole", 4, 4, 4, 4, 5, 5, 5, 5, 4);
    CHECK_OK(model, bempd_edge_count(model, region, &edges));
    CHECK(edges == 8);
    bempd_model_free(model);
  }
}

/** Two rectangles, BEM or PD with spacing 1, on a good left support. */
static bempd_model* two_rectangles(int first_is_pd, rectangle first, int second_is_pd, rectangle second) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  if (first_is_pd)
    CHECK_OK(model, bempd_add_pd_region(model, material, 4, first.vertices, 1.0, 3, NULL));
  else
    CHECK_OK(model, bempd_add_bem_region(model, material, 4, first.vertices, 2.0, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  if (second_is_pd)
    CHECK_OK(model, bempd_add_pd_region(model, material, 4, second.vertices, 1.0, 3, NULL));
  else
    CHECK_OK(model, bempd_add_bem_region(model, material, 4, second.vertices, 2.0, NULL));
  return model;
}

static void regions_may_not_overlap_or_hang_on_a_point(void) {
  int kind;
  const rectangle base = rectangle_of(0.0, 0.0, 10.0, 8.0);
  for (kind = 0; kind < 4; ++kind) {
    const int first = kind & 1;
    const int second = kind >> 1;
    bempd_model* model = NULL;
    if (!first || !second) { /* of two lattices it is told at once, see removal.c */
      model = two_rectangles(first, base, second, rectangle_of(5.0, 4.0, 15.0, 12.0));
      CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "overlap|cross", bempd_prepare(model));
      bempd_model_free(model);
    }
    model = two_rectangles(first, base, second, rectangle_of(2.0, 2.0, 6.0, 6.0));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "overlap|inside|within", bempd_prepare(model));
    bempd_model_free(model);
    model = two_rectangles(first, base, second, base);
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "overlap|same|inside|within", bempd_prepare(model));
    bempd_model_free(model);
    model = two_rectangles(first, base, second, rectangle_of(10.0, 8.0, 20.0, 16.0));
    CHECK_REFUSED(model, "point|corner|hinge", bempd_prepare(model));
    bempd_model_free(model);
  }
}

static void interfaces_follow_one_lattice(void) {
  const rectangle base = rectangle_of(0.0, 0.0, 10.0, 8.0);
  const rectangle finer = rectangle_of(10.0, 0.0, 15.0, 8.0);
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  CHECK_OK(model, bempd_add_pd_region(model, material, 4, base.vertices, 1.0, 3, NULL));
  CHECK_OK(model, bempd_add_pd_region(model, material, 4, finer.vertices, 0.5, 3, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "lattice|spacing|match", bempd_prepare(model));
  bempd_model_free(model);
  model = two_rectangles(1, base, 1, rectangle_of(10.0, 0.5, 20.0, 8.5));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "lattice|spacing|match", bempd_prepare(model));
  bempd_model_free(model);
  model = two_rectangles(1, base, 0, rectangle_of(10.0, 0.5, 20.0, 8.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "lattice|interface|point|match", bempd_prepare(model));
  bempd_model_free(model);
}

int main(void) {
  outlines_are_refused_by_the_call_that_brings_them();
  spacing_must_divide_the_edges();
  horizon_ratio_has_limits();
  unknown_ids_are_refused();
  holes_lie_inside_and_apart();
  regions_may_not_overlap_or_hang_on_a_point();
  interfaces_follow_one_lattice();
  return check_finish();
}

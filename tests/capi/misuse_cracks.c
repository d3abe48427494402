/* Initial cracks that no body can have. */
#include "scenes.h"

/** The coupled plate's regions and supports with this crack, which the call or bempd_prepare() must refuse. */
static void refused(const char* words, int64_t count, const double* points, int line) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const int32_t left = add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 2.0);
  add_pd_rectangle(model, material, 10.0, 0.0, 19.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, left, 4, BEMPD_BOTH, NULL));
  check_refused_by_prepare(model, words, bempd_add_crack(model, count, points, NULL), "bempd_add_crack", __FILE__,
                           line);
  bempd_model_free(model);
}

#define REFUSED(words, count, ...)            \
  do {                                        \
    const double points_[] = {__VA_ARGS__};   \
    refused(words, count, points_, __LINE__); \
  } while (0)

static void cracks_have_points_and_length(void) {
  REFUSED("point", 1, 14.5, 2.5);
  REFUSED("point", 0, 14.5, 2.5);
  REFUSED("point", -2, 14.5, 2.5);
  REFUSED("point", INT64_MAX, 14.5, 2.5);
  REFUSED("finite|nan", 2, 14.5, 2.5, NAN, 5.5);
  REFUSED("finite|inf", 2, 14.5, 2.5, 14.5, INFINITY);
  REFUSED("length|same|zero|coincid|distinct|equal|repeat", 2, 14.5, 2.5, 14.5, 2.5);
  REFUSED("length|same|zero|coincid|distinct|equal|repeat", 3, 14.5, 2.5, 14.5, 5.5, 14.5, 5.5);
}

static void cracks_lie_in_the_body_and_reach_beyond_interfaces(void) {
  REFUSED("outside|inside|peridynamic", 2, 50.5, 2.5, 50.5, 5.5);
  REFUSED("outside|inside|peridynamic", 2, 14.5, 5.5, 14.5, 12.5);
  REFUSED("outside|inside|peridynamic", 2, 14.5, -5.0, 14.5, 15.0);
  REFUSED("less than a spacing", 2, 8.5, 4.5, 10.75, 4.5);
  REFUSED("less than a spacing", 2, 14.5, 4.5, 9.25, 4.5);
  REFUSED("reaches the interface", 2, 8.5, 4.5, 10.0, 4.5);
}

static int32_t add_stiffer_material(bempd_model* model) {
  bempd_material material = sound_material();
  int32_t id = 0;
  material.young_modulus *= 2;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  return id;
}

static void cracks_keep_off_interfaces_of_boundary_elements(void) {
  const double along[][4] = {{2, 4, 7, 4}, {0, 4, 10, 4}, {5, 2, 5, 4}, {5, 2, 5, 6}};
  const char* words[] = {"runs along the interface of the regions 1 and 2", "runs along the interface",
                         "reaches the interface", "regions 1 and 2 at (5, 4), which are of two materials"};
  for (int k = 0; k < 4; ++k) {
    bempd_model* model = new_model();
    const int32_t material = add_sound_material(model), other = add_stiffer_material(model);
    const int32_t low = add_bem_rectangle(model, material, 0.0, 0.0, 10.0, 4.0, 2.0);
    add_bem_rectangle(model, k < 3 ? material : other, 0.0, 4.0, 10.0, 8.0, 2.0);
    CHECK_OK(model, bempd_fix_edge(model, low, 1, BEMPD_BOTH, NULL));
    check_refused_by_prepare(model, words[k], bempd_add_crack(model, 2, along[k], NULL), "bempd_add_crack", __FILE__,
                             __LINE__);
    bempd_model_free(model);
  }
}

static void cracks_keep_off_the_edges_of_lattices(void) {
  REFUSED("material point", 2, 12.5, 0.0, 16.5, 0.0);
  REFUSED("material point", 2, 10.0, 2.5, 10.0, 5.5); /* along the interface */
}

static void cracks_pass_material_points_by(void) {
  const double through[][4] = {{4.0, 2.5, 4.0, 5.5}, {4.5, 2.5, 5.0, 5.0}, {2.0, 2.0, 6.0, 6.0}, {4.0, 0.0, 4.0, 3.0}};
  for (int k = 0; k < 4; ++k) {
    bempd_model* model = pd_block();
    bempd_statistics statistics;
    CHECK_OK(model, bempd_add_crack(model, 2, through[k], NULL));
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_prepare(model));
    CHECK_OK(model, bempd_statistics_init(&statistics, sizeof statistics));
    CHECK_OK(model, bempd_get_statistics(model, &statistics));
    CHECK(statistics.cut_bonds > 0);
    bempd_model_free(model);
  }
}

static void cracks_from_the_edge_and_bent_cracks_are_accepted(void) {
  bempd_model* model = pd_block();
  const double to_the_edge[] = {4.5, 0.0, 4.5, 3.5};
  const double bent[] = {7.5, 2.5, 7.5, 4.5, 8.5, 5.0};
  int32_t crack = 0;
  bempd_statistics statistics;
  CHECK_OK(model, bempd_add_crack(model, 2, to_the_edge, &crack));
  CHECK(crack == 1);
  CHECK_OK(model, bempd_add_crack(model, 3, bent, &crack));
  CHECK(crack == 2);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_OK(model, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_get_statistics(model, &statistics));
  CHECK(statistics.cut_bonds > 0 && statistics.cut_bonds < statistics.bonds);
  bempd_model_free(model);
}

int main(void) {
  cracks_have_points_and_length();
  cracks_lie_in_the_body_and_reach_beyond_interfaces();
  cracks_keep_off_interfaces_of_boundary_elements();
  cracks_keep_off_the_edges_of_lattices();
  cracks_pass_material_points_by();
  cracks_from_the_edge_and_bent_cracks_are_accepted();
  return check_finish();
}

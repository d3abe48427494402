/* What the log tells of scenes that are sound but not what a host may expect: coarse lattices, tips right before an
 * edge, cracks shorter than a spacing, numbers of mixed units. Messages count from 1. */
#include "scenes.h"

typedef struct told {
  char warnings[4000], facts[4000];
} told;

static void keep(int32_t level, const char* message, void* user) {
  told* all = (told*)user;
  char* into = level == 1 ? all->warnings : all->facts;
  if (level > 2 || strlen(into) + strlen(message) + 2 > sizeof all->warnings) return;
  strcat(into, message);
  strcat(into, "\n");
}

/** A plate of 60 x 20 mm in SI, of boundary elements (spacing 0) or of a lattice, with one crack. */
static told tell(double young_modulus, double spacing, const double crack[4]) {
  bempd_model* model = new_model();
  bempd_material glass;
  told all = {"", ""};
  int32_t id = 0;
  CHECK_OK(NULL, bempd_material_init(&glass, sizeof glass));
  glass.young_modulus = young_modulus;
  glass.poisson_ratio = 1.0 / 3.0;
  glass.fracture_energy = 300.0;
  CHECK_OK(model, bempd_add_material(model, &glass, &id));
  if (spacing > 0)
    add_pd_rectangle(model, id, 0.0, 0.0, 0.06, 0.02, spacing);
  else
    add_bem_rectangle(model, id, 0.0, 0.0, 0.06, 0.02, 0.005);
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_set_log(model, keep, &all));
  CHECK_OK(model, bempd_prepare(model));
  bempd_model_free(model);
  return all;
}

static int warns(const told* all, const char* words) { return strstr(all->warnings, words) != NULL; }

/** A sound scene has no warning. Its toughness, internal length and strain at first growth are told once. */
static void sound_scenes_are_told_their_numbers(void) {
  const double crack[] = {0.0295, 0.0, 0.0295, 0.008};
  const told lattice = tell(3e9, 0.001, crack), elements = tell(3e9, 0.0, crack);
  const char* fact = strstr(lattice.facts, "material 1: K_IC");
  CHECK(lattice.warnings[0] == '\0' && elements.warnings[0] == '\0');
  CHECK(fact != NULL && strstr(fact + 1, "material 1: K_IC") == NULL);
  CHECK(strstr(lattice.facts, "sqrt(E' G0) = 9.49e+05") != NULL && strstr(lattice.facts, "E' G0 / f_t^2") != NULL);
  CHECK(strstr(lattice.facts, "crack 1 grows at a strain of the order of 0.00199") != NULL);
  CHECK(strstr(elements.facts, "9.49e+05") != NULL && strstr(elements.facts, "f_t") == NULL);
}

static void coarse_scenes_are_told(void) {
  const double crack[] = {0.03, 0.0, 0.03, 0.008}, shallow[] = {0.0295, 0.0, 0.0295, 0.016};
  const double inside[] = {0.0295, 0.0100, 0.0295, 0.0104};
  told all = tell(3e9, 0.02 / 8, crack);
  CHECK(warns(&all, "region 1 is 8 cells wide, fewer than 10") && warns(&all, "choose the spacing 0.002 "));
  all = tell(3e9, 0.001, shallow);
  CHECK(warns(&all, "4 cells before edge 3 of region 1, less than two horizons") && !warns(&all, "cells wide"));
  all = tell(3e9, 0.001, inside);
  CHECK(warns(&all, "shorter than the spacing 0.001"));
  all = tell(3e9, 0.0, inside);
  CHECK(all.warnings[0] == '\0');
}

/** Ten micrometres of material between a crack and the edge that it was meant to reach. */
static void tips_right_before_an_edge_are_told(void) {
  const double late[] = {0.0295, 1e-5, 0.0295, 0.008}, through[] = {0.0295, 0.0, 0.0295, 0.01999};
  told all = tell(3e9, 0.0, late);
  CHECK(warns(&all, "1e-05 before edge 1 of region 1") && warns(&all, "let it end on the edge"));
  all = tell(3e9, 0.001, late);
  CHECK(warns(&all, "1e-05 before edge 1 of region 1, less than a spacing"));
  all = tell(3e9, 0.0, through);
  CHECK(warns(&all, "1e-05 before edge 3 of region 1"));
}

/** A modulus in MPa beside a fracture energy in J/m^2 and lengths in metres. */
static void mixed_units_are_told(void) {
  const double crack[] = {0.0295, 0.0, 0.0295, 0.008};
  told all = tell(3e3, 0.001, crack);
  CHECK(warns(&all, "material 1 begins to break at a strain of about 1.99") && warns(&all, "mixed units"));
  all = tell(3.0, 0.0, crack);
  CHECK(warns(&all, "mixed units"));
}

/** A part that is not held because it just misses its neighbour: the gap is named before supports are asked for. */
static void a_gap_is_named_before_supports(void) {
  bempd_model* model = bem_block();
  const char *gap, *supports;
  add_bem_rectangle(model, 1, 10.001, 0.0, 20.0, 8.0, 2.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, "region 2 can", bempd_prepare(model));
  gap = strstr(bempd_last_error(model), "regions 1 and 2 lie 0.001 apart at (10.0005, ");
  supports = strstr(bempd_last_error(model), "add supports");
  CHECK(gap != NULL && supports != NULL && gap < supports);
  bempd_model_free(model);
}

/** Three of many tips that are alike are named, and the rest is counted. */
static void many_tips_are_told_in_few_sentences(void) {
  bempd_model* model = pd_block();
  told all = {"", ""};
  const char* at;
  int k, sentences = 0;
  for (k = 0; k < 8; ++k) {
    const double crack[] = {0.5 + k, 0.0, 0.5 + k, 7.5};
    CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  }
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_set_log(model, keep, &all));
  CHECK_OK(model, bempd_prepare(model));
  for (at = all.warnings; (at = strstr(at, "before edge 3")) != NULL; ++at) ++sentences;
  CHECK(sentences == 3 && warns(&all, "(5 more are like this)"));
  bempd_model_free(model);
}

static void messages_count_from_1(void) {
  const double places[] = {5.0, 4.0, 50.0, 4.0}, lost[] = {0.0, NAN}, ends[] = {0.0, 1.5};
  double displacement[4];
  bempd_model* model = bem_block();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "value 2 is",
              bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 2, NULL, lost, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "point 2, (50, 4)",
              bempd_evaluate(model, 2, places, displacement, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "fraction 2 is 1.5",
              bempd_set_support_values_at(model, 1, 2, ends, places, NULL));
  bempd_model_free(model);
}

int main(void) {
  sound_scenes_are_told_their_numbers();
  coarse_scenes_are_told();
  tips_right_before_an_edge_are_told();
  mixed_units_are_told();
  a_gap_is_named_before_supports();
  many_tips_are_told_in_few_sentences();
  messages_count_from_1();
  return check_finish();
}

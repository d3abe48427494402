/* Fracture energies by place: what is refused, what they mean for bonds, lines and boundary elements, and states. */
#include <math.h>

#include "scenes.h"

static void wrong_values_are_refused(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  bempd_material elastic = sound_material();
  elastic.critical_stretch = 0.0, elastic.fracture_energy = 0.0;
  int32_t other = 0, plate = 0, firm = 0;
  CHECK_OK(model, bempd_add_material(model, &elastic, &other));
  const rectangle r = rectangle_of(0.0, 0.0, 4.0, 4.0), beside = rectangle_of(4.0, 0.0, 8.0, 4.0);
  bempd_material tough = sound_material();
  tough.critical_stretch = 0.0, tough.fracture_energy = 2.0;
  int32_t breaking = 0;
  CHECK_OK(model, bempd_add_material(model, &tough, &breaking));
  CHECK_OK(model, bempd_add_pd_region(model, breaking, 4, r.vertices, 1.0, 3, &plate));
  CHECK_OK(model, bempd_add_bem_region(model, other, 4, beside.vertices, 1.0, &firm));
  (void)material;
  const double places[] = {0, 0, 4, 0, 4, 4}, same[] = {0, 0, 4, 0, 0, 0}, lost[] = {0, 0, NAN, 0, 4, 4};
  const double good[] = {1, 2, 3}, negative[] = {1, -2, 3}, none[] = {1, 0, 3}, unknown[] = {1, NAN, 3},
               endless[] = {1, 2, INFINITY};
#define REFUSED(words, region, count, places, values) \
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, words, bempd_set_toughness_at(model, region, count, places, values))
  REFUSED("region 7", 7, 3, places, good);
  REFUSED("region 0", 0, 3, places, good);
  REFUSED("no fracture_energy", firm, 3, places, good);
  REFUSED("count is 0", plate, 0, places, good);
  REFUSED("count is -1", plate, -1, places, good);
  REFUSED("places", plate, 3, NULL, good);
  REFUSED("values is NULL", plate, 3, places, NULL);
  REFUSED("places 1 and 3 are the same", plate, 3, same, good);
  REFUSED("finite|nan", plate, 3, lost, good);
  REFUSED("value 2 is -2", plate, 3, places, negative);
  REFUSED("value 2 is 0", plate, 3, places, none);
  REFUSED("value 2 is nan", plate, 3, places, unknown);
  REFUSED("value 3 is inf", plate, 3, places, endless);
  CHECK_OK(model, bempd_set_toughness_at(model, plate, 3, places, good));
  CHECK_OK(model, bempd_fix_edge(model, plate, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_set_toughness_at(model, plate, 3, places, good));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "NULL", bempd_set_toughness_at(NULL, 1, 3, places, good));
  bempd_model_free(model);
}

/* A strip with an edge crack in its middle, pulled apart; G0 is `left` at its left end and `right` at its right end.
 * `kind`: 0 boundary elements, 1 a lattice with lines, 2 a lattice bond by bond. */
static bempd_model* strip(int kind, int count, double left, double right) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  material.critical_stretch = 0.0, material.fracture_energy = 2.0;
  int32_t id = 0, region = 0, crack = 0;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  const rectangle r = rectangle_of(0.0, 0.0, 20.0, 20.0);
  if (kind == 0)
    CHECK_OK(model, bempd_add_bem_region(model, id, 4, r.vertices, 2.0, &region));
  else
    CHECK_OK(model, bempd_add_pd_region(model, id, 4, r.vertices, 1.0, 3, &region));
  if (kind == 2) CHECK_OK(model, bempd_set_option_text(model, "crack.rule", "bond"));
  const double line[] = {0.0, 10.5, 8.5, 10.5}, places[] = {0, 10.5, 20, 10.5}, values[] = {left, right};
  if (count > 0) CHECK_OK(model, bempd_set_toughness_at(model, region, count, places, values));
  CHECK_OK(model, bempd_add_crack(model, 2, line, &crack));
  CHECK_OK(model, bempd_fix_edge(model, region, 1, BEMPD_BOTH, NULL));
  const double one = 1e-3;
  CHECK_OK(model, bempd_prescribe_edge(model, region, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &one, NULL));
  return model;
}

static double first_load(bempd_model* model) {
  bempd_step_report report;
  CHECK_OK(model, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e6, &report));
  CHECK(report.stop_reason == BEMPD_STOP_EVENT);
  double load_factor = 0;
  CHECK_OK(model, bempd_load_factor(model, &load_factor));
  return load_factor;
}

/* What one value gives is the material's own fracture energy to the last digit, and four times it twice the load. */
static void one_value_is_another_material(void) {
  for (int kind = 0; kind < 3; ++kind) {
    bempd_model *plain = strip(kind, 0, 0, 0), *same = strip(kind, 2, 2, 2), *tough = strip(kind, 1, 8, 0);
    const double load = first_load(plain);
    CHECK(first_load(same) == load);
    CHECK(fabs(first_load(tough) / load - 2.0) < 1e-9);
    bempd_model_free(plain), bempd_model_free(same), bempd_model_free(tough);
  }
}

static double place_of_tip(bempd_model* model) {
  bempd_crack_tip tip;
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, 0, &tip));
  return tip.x;
}

/* The tip at x = 8.5 of 20 grows at the root of G0 there; what is explained agrees. */
static void the_place_of_the_tip_counts(void) {
  for (int kind = 0; kind < 2; ++kind) {
    bempd_model *plain = strip(kind, 0, 0, 0), *graded = strip(kind, 2, 1, 7);
    CHECK_OK(plain, bempd_step(plain, 0, NULL));
    CHECK_OK(graded, bempd_step(graded, 0, NULL));
    bempd_explanation told;
    CHECK_OK(graded, bempd_explanation_init(&told, sizeof told));
    CHECK_OK(graded, bempd_explain(graded, 1, &told, NULL, 0, NULL));
    const double x = place_of_tip(graded), expected = sqrt((1 + 6 * x / 20) / 2), load = first_load(plain);
    const double found = first_load(graded);
    printf("kind %d: tip at %.4f, load ratio %.9f, root of G0 %.9f\n", kind, x, found / load, expected);
    CHECK(fabs(found / load / expected - 1) < (kind == 0 ? 1e-9 : 1e-2));
    CHECK(fabs(told.load_factor / found - 1) < 1e-9);
    bempd_model_free(plain), bempd_model_free(graded);
  }
}

/* A state belongs to the values that it was made with. */
static void states_know_the_values(void) {
  bempd_model *one = strip(1, 2, 1, 7), *other = strip(1, 2, 1, 6), *plain = strip(1, 0, 0, 0),
              *again = strip(1, 2, 1, 7);
  CHECK_OK(one, bempd_step_to_next_event(one, 1e6, NULL));
  bempd_state* state = NULL;
  CHECK_OK(one, bempd_state_save(one, &state));
  CHECK_FAILS(other, BEMPD_ERROR_ARGUMENT, "another scene", bempd_state_restore(other, state));
  CHECK_FAILS(plain, BEMPD_ERROR_ARGUMENT, "another scene", bempd_state_restore(plain, state));
  CHECK_OK(again, bempd_state_restore(again, state));
  CHECK(first_load(one) == first_load(again));
  bempd_state_free(state);
  bempd_model_free(one), bempd_model_free(other), bempd_model_free(plain), bempd_model_free(again);
}

int main(void) {
  wrong_values_are_refused();
  one_value_is_another_material();
  the_place_of_the_tip_counts();
  states_know_the_values();
  return check_finish();
}

/** Load cases: any combination of them, faces that one of them closes, and misuse. */
#include <math.h>

#include "scenes.h"

typedef struct plate {
  bempd_model* model;
  int32_t region, crack, pull, side; /* the last two: load cases */
  int32_t support;
} plate;

/** A square with a slanted crack; the first case pulls it upwards, the second sideways and by a force at a corner. */
static plate new_plate(void) {
  plate p = {new_model(), 0, 0, 0, 0, 0};
  bempd_material material = sound_material();
  material.critical_stretch = 0.0, material.fracture_energy = 1e-6;
  int32_t id = 0, loads[5] = {0};
  CHECK_OK(p.model, bempd_add_material(p.model, &material, &id));
  p.region = add_bem_rectangle(p.model, id, -1.0, -1.0, 1.0, 1.0, 0.5);
  const double line[] = {-0.3, 0.05, 0.3, -0.05}, one = 1.0, minus = -1.0;
  CHECK_OK(p.model, bempd_add_crack(p.model, 2, line, &p.crack));
  CHECK_OK(p.model, bempd_fix_point(p.model, -1.0, -1.0, BEMPD_BOTH, &p.support));
  CHECK_OK(p.model, bempd_fix_point(p.model, 1.0, -1.0, BEMPD_Y, NULL));
  CHECK_OK(p.model, bempd_add_traction(p.model, p.region, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &one, &loads[0]));
  CHECK_OK(p.model, bempd_add_traction(p.model, p.region, 1, 0.0, 1.0, BEMPD_Y, 1, &minus, NULL, &loads[1]));
  CHECK_OK(p.model, bempd_add_traction(p.model, p.region, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &one, &loads[2]));
  CHECK_OK(p.model, bempd_add_traction(p.model, p.region, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &minus, &loads[3]));
  CHECK_OK(p.model, bempd_add_point_force(p.model, 1.0, 1.0, BEMPD_X, 0.0, 0.1, &loads[4]));
  CHECK_OK(p.model, bempd_load_case_add(p.model, 2, loads, 0, NULL, &p.pull));
  CHECK_OK(p.model, bempd_load_case_add(p.model, 3, loads + 2, 0, NULL, &p.side));
  return p;
}

static bempd_crack_tip tip_under(const plate* p, double pull, double side) {
  const double factors[] = {pull, side};
  bempd_crack_tip tip;
  CHECK_OK(p->model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(p->model, bempd_load_case_tip(p->model, 2, factors, 1, &tip));
  return tip;
}

static int64_t pressed_under(const plate* p, double pull, double side) {
  const double factors[] = {pull, side};
  int64_t count = -1;
  CHECK_OK(p->model, bempd_load_case_pressed_faces(p->model, 2, factors, &count));
  return count;
}

static void open_faces_add_up(void) {
  plate p = new_plate();
  int32_t count = 0;
  int64_t tips = 0, before = 0;
  CHECK_OK(p.model, bempd_load_case_count(p.model, &count));
  CHECK(count == 2 && p.pull == 1 && p.side == 2);
  const double one[] = {1.0, 0.0}, other[] = {0.0, 1.0}, both[] = {2.0, 0.5}, place[] = {0.1, 0.6};
  CHECK_OK(p.model, bempd_load_case_tip_count(p.model, 2, both, &tips));
  CHECK(tips == 2);
  const bempd_crack_tip a = tip_under(&p, 1.0, 0.0), b = tip_under(&p, 0.0, 1.0), c = tip_under(&p, 2.0, 0.5);
  CHECK(pressed_under(&p, 1.0, 0.0) == 0 && pressed_under(&p, 2.0, 0.5) == 0);
  /* K come from energies and openings, which adds an error of its own. */
  CHECK_CLOSE(2.0 * a.stress_intensity_1 + 0.5 * b.stress_intensity_1, c.stress_intensity_1, 2e-4);
  CHECK_CLOSE(2.0 * a.stress_intensity_2 + 0.5 * b.stress_intensity_2, c.stress_intensity_2, 2e-4);
  double u[3][2], s[3][3], r[3][2];
  const double* factors[] = {one, other, both};
  bempd_statistics statistics;
  CHECK_OK(p.model, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(p.model, bempd_get_statistics(p.model, &statistics));
  before = statistics.dense_factorizations + statistics.sparse_factorizations;
  for (int k = 0; k < 3; ++k) {
    CHECK_OK(p.model, bempd_load_case_evaluate(p.model, 2, factors[k], 1, place, u[k], s[k]));
    CHECK_OK(p.model, bempd_load_case_reaction(p.model, 2, factors[k], p.support, r[k]));
  }
  CHECK_OK(p.model, bempd_get_statistics(p.model, &statistics));
  CHECK(statistics.dense_factorizations + statistics.sparse_factorizations == before);
  for (int k = 0; k < 3; ++k) CHECK_CLOSE(2.0 * s[0][k] + 0.5 * s[1][k], s[2][k], 1e-9);
  for (int k = 0; k < 2; ++k) CHECK_CLOSE(2.0 * u[0][k] + 0.5 * u[1][k], u[2][k], 1e-12);
  for (int k = 0; k < 2; ++k) CHECK_CLOSE(2.0 * r[0][k] + 0.5 * r[1][k], r[2][k], 1e-9);
  CHECK_CLOSE(r[1][0], -0.1, 1e-9); /* against the force at the corner */
  bempd_model_free(p.model);
}

/** The first case reversed closes the crack: the sum of the cases says K_I < 0, the combination K_I = 0. */
static void closed_faces_are_solved_by_themselves(void) {
  plate p = new_plate();
  const bempd_crack_tip a = tip_under(&p, 1.0, 0.0), b = tip_under(&p, 0.0, 1.0), c = tip_under(&p, -1.0, 3.0);
  CHECK(3.0 * b.stress_intensity_1 - a.stress_intensity_1 < -0.1);
  CHECK(pressed_under(&p, -1.0, 3.0) > 0);
  CHECK_CLOSE(c.stress_intensity_1, 0.0, 1e-12);
  /* A run by values of the loads, and a step, finds the same. */
  const double minus = -1.0, one = 1.0, three = 3.0, minus_three = -3.0, corner = 0.3, zero = 0.0;
  CHECK_OK(p.model, bempd_set_tip_frozen(p.model, p.crack, BEMPD_CRACK_START, 1));
  CHECK_OK(p.model, bempd_set_tip_frozen(p.model, p.crack, BEMPD_CRACK_END, 1));
  CHECK_OK(p.model, bempd_set_load_values(p.model, 1, 1, NULL, &minus));
  CHECK_OK(p.model, bempd_set_load_values(p.model, 2, 1, &zero, &one));
  CHECK_OK(p.model, bempd_set_load_values(p.model, 3, 1, NULL, &three));
  CHECK_OK(p.model, bempd_set_load_values(p.model, 4, 1, NULL, &minus_three));
  CHECK_OK(p.model, bempd_set_load_values(p.model, 5, 1, NULL, &corner));
  bempd_step_report report;
  CHECK_OK(p.model, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(p.model, bempd_step(p.model, 1.0, &report));
  bempd_crack_tip tip;
  CHECK_OK(p.model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(p.model, bempd_tip(p.model, 1, &tip));
  CHECK_CLOSE(tip.stress_intensity_2, c.stress_intensity_2, 1e-9);
  /* The cases keep the values that they had; the run stays where it is. */
  CHECK_CLOSE(tip_under(&p, 1.0, 0.0).stress_intensity_1, a.stress_intensity_1, 1e-12);
  double load_factor = 0.0;
  CHECK_OK(p.model, bempd_load_factor(p.model, &load_factor));
  CHECK(load_factor == 1.0);
  bempd_crack_tip still;
  CHECK_OK(p.model, bempd_crack_tip_init(&still, sizeof still));
  CHECK_OK(p.model, bempd_tip(p.model, 1, &still));
  CHECK(still.stress_intensity_2 == tip.stress_intensity_2);
  bempd_model_free(p.model);
}

static void the_load_of_growth_is_that_of_the_whole_combination(void) {
  plate p = new_plate();
  const bempd_crack_tip once = tip_under(&p, 1.0, 0.2), twice = tip_under(&p, 2.0, 0.4);
  CHECK_CLOSE(once.critical_load_factor, 2.0 * twice.critical_load_factor, 1e-9);
  CHECK_CLOSE(once.energy_release_rate * pow(once.straight_load_factor, 2.0), 1e-6, 1e-12);
  bempd_model_free(p.model);
}

static void misuse_is_refused(void) {
  plate p = new_plate();
  const int32_t none = 9, two[] = {1, 1};
  const double factors[] = {1.0, NAN, 1.0}, place[] = {5.0, 5.0};
  int64_t count = 0;
  double force[2];
#define REFUSED(words, call) CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, words, call)
  REFUSED("neither loads nor supports", bempd_load_case_add(p.model, 0, NULL, 0, NULL, NULL));
  REFUSED("load 9", bempd_load_case_add(p.model, 1, &none, 0, NULL, NULL));
  REFUSED("support 9", bempd_load_case_add(p.model, 0, NULL, 1, &none, NULL));
  REFUSED("twice", bempd_load_case_add(p.model, 2, two, 0, NULL, NULL));
  REFUSED("loads is NULL", bempd_load_case_add(p.model, 1, NULL, 0, NULL, NULL));
  REFUSED("-1 loads", bempd_load_case_add(p.model, -1, NULL, 0, NULL, NULL));
  REFUSED("factor of load case 2 is nan", bempd_load_case_tip_count(p.model, 2, factors, &count));
  REFUSED("3 factors and 2 load cases", bempd_load_case_tip_count(p.model, 3, factors, &count));
  REFUSED("case_count is 0", bempd_load_case_tip_count(p.model, 0, factors, &count));
  REFUSED("factors is NULL", bempd_load_case_tip_count(p.model, 1, NULL, &count));
  REFUSED("count is NULL", bempd_load_case_tip_count(p.model, 1, factors, NULL));
  REFUSED("support 9", bempd_load_case_reaction(p.model, 1, factors, 9, force));
  REFUSED("force is NULL", bempd_load_case_reaction(p.model, 1, factors, p.support, NULL));
  REFUSED("outside", bempd_load_case_evaluate(p.model, 1, factors, 1, place, force, NULL));
  bempd_crack_tip tip;
  CHECK_OK(p.model, bempd_crack_tip_init(&tip, sizeof tip));
  REFUSED("index is 2", bempd_load_case_tip(p.model, 1, factors, 2, &tip));
  CHECK_CLOSE(tip_under(&p, 1.0, 0.0).stress_intensity_1, tip_under(&p, 1.0, 0.0).stress_intensity_1, 0.0);
  bempd_model_free(p.model);
}

int main(void) {
  open_faces_add_up();
  closed_faces_are_solved_by_themselves();
  the_load_of_growth_is_that_of_the_whole_combination();
  misuse_is_refused();
  return check_finish();
}

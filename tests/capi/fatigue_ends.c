/** Ends of growth by cycles: net sections, and a toughness that varies from place to place. */
#include <math.h>

#include "fatigue_scenes.h"

static bempd_fatigue_report grow(const plate* p, double high, const bempd_fatigue* options) {
  const double low = 0.0;
  bempd_fatigue_report report = new_report();
  CHECK_OK(p->model, bempd_grow_fatigue(p->model, 1, &high, &low, NULL, options, &report));
  return report;
}

static double length_of(const plate* p) {
  double length = 0.0;
  CHECK_OK(p->model, bempd_crack_length(p->model, p->crack, &length));
  return length;
}

/** A crack in the middle: what is left bears load W = flow stress (W - 2 a). */
static void a_middle_crack_ends_where_the_ligaments_yield(void) {
  const double flows[] = {1.25, 1.5, 2.0};
  for (int k = 0; k < 3; ++k) {
    const plate p = plate_of(1.0, -0.1, 0.1, 0.25, 0.0);
    const double expected = 2.0 * (1.0 - 1.0 / flows[k]);
    bempd_growth_rate rate = paris();
    bempd_fatigue_report report;
    rate.flow_stress = flows[k];
    CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
    report = grow(&p, 1.0, NULL);
    CHECK(report.stop_reason == BEMPD_FATIGUE_NET_SECTION && report.crack == p.crack && report.end != 0);
    printf("flow stress %g: ends at %.5f, closed form %.5f\n", flows[k], length_of(&p), expected);
    CHECK_CLOSE(length_of(&p), expected, 2e-3);
    /* The plate bears no further cycle, and half of the load for longer. */
    CHECK(grow(&p, 1.0, NULL).steps == 0);
    CHECK(grow(&p, 0.5, NULL).steps > 0);
    bempd_model_free(p.model);
  }
}

/** A crack from the edge: force and moment of an eccentric pull, n^2 + 2 n a / b = 1 with n = load W / (flow stress b),
 * b = W - a. */
static void an_edge_crack_ends_by_force_and_moment(void) {
  const plate p = plate_of(1.0, -1.0, -0.9, 0.25, 0.0);
  bempd_growth_rate rate = paris();
  double low = 0.1, high = 1.9;
  rate.flow_stress = 2.0;
  for (int round = 0; round < 60; ++round) {
    const double a = 0.5 * (low + high), b = 2.0 - a, n = 2.0 / (rate.flow_stress * b);
    if (n * n + 2.0 * n * a / b < 1.0) {
      low = a;
    } else {
      high = a;
    }
  }
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK(grow(&p, 1.0, NULL).stop_reason == BEMPD_FATIGUE_NET_SECTION);
  printf("edge crack: ends at %.5f, closed form %.5f\n", length_of(&p), low);
  CHECK_CLOSE(length_of(&p), low, 2e-3);
  bempd_model_free(p.model);
}

/** Two cracks in a line: both count for the section. A hole counts like a crack. */
static void cracks_and_holes_along_the_line_count(void) {
  const double place[] = {0.5, 0.0}, other[] = {0.45, 0.01, 0.65, 0.01};
  for (int kind = 0; kind < 2; ++kind) {
    const plate p = plate_of(1.0, -0.5, -0.3, 0.25, 0.0);
    bempd_growth_rate rate = paris();
    rate.flow_stress = 1.5; /* 2 / 1.5 has to be left of 2 */
    if (kind == 0) CHECK_OK(p.model, bempd_add_circular_hole(p.model, p.region, place[0], place[1], 0.1, NULL));
    if (kind == 1) CHECK_OK(p.model, bempd_add_crack(p.model, 2, other, NULL));
    CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
    if (kind == 1) {
      CHECK_OK(p.model, bempd_set_tip_frozen(p.model, 2, BEMPD_CRACK_START, 1));
      CHECK_OK(p.model, bempd_set_tip_frozen(p.model, 2, BEMPD_CRACK_END, 1));
    }
    CHECK(grow(&p, 1.0, NULL).stop_reason == BEMPD_FATIGUE_NET_SECTION);
    printf("%s in the line: ends at %.4f\n", kind == 0 ? "hole" : "crack", length_of(&p));
    /* The length would be 2 / 3 less 0.2 without moments; the section is not symmetric, so growth ends before. */
    CHECK(length_of(&p) < 2.0 / 3.0 - 0.2 && length_of(&p) > 0.3);
    bempd_model_free(p.model);
  }
}

/** K_c by place: the tip breaks where its factor meets that of the place, also in the middle of a step. */
static void a_tip_breaks_at_a_weak_place_in_the_middle_of_a_step(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.25, 9.0);
  const bempd_growth_rate rate = paris();
  const double places[] = {-2.0, 0.0, 0.25, 0.0, 0.35, 0.0, 2.0, 0.0}, values[] = {9.0, 9.0, 0.5, 0.5};
  bempd_fatigue_record last;
  CHECK_OK(p.model, bempd_set_toughness_at(p.model, p.region, 4, places, values));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK(grow(&p, 1.0, NULL).stop_reason == BEMPD_FATIGUE_CRITICAL);
  last = last_record(p.model);
  const double energy = 9.0 + (last.x - 0.25) / 0.1 * (0.5 - 9.0);
  printf("breaks at %.5f with K = %.5f, K_c there %.5f\n", last.x, last.highest, sqrt(energy));
  CHECK(last.end == BEMPD_CRACK_END && last.x > 0.25 && last.x < 0.35);
  CHECK_CLOSE(last.highest, sqrt(energy), 5e-3 * last.highest);
  bempd_model_free(p.model);
}

static void wrong_flow_stresses_are_refused(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  bempd_growth_rate rate = paris();
  rate.flow_stress = -1.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "flow_stress is -1", bempd_set_growth_rate(p.model, p.material, &rate));
  rate.flow_stress = NAN;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "flow_stress is nan", bempd_set_growth_rate(p.model, p.material, &rate));
  bempd_model_free(p.model);
}

int main(void) {
  a_middle_crack_ends_where_the_ligaments_yield();
  an_edge_crack_ends_by_force_and_moment();
  cracks_and_holes_along_the_line_count();
  a_tip_breaks_at_a_weak_place_in_the_middle_of_a_step();
  wrong_flow_stresses_are_refused();
  return check_finish();
}

/** Growth by cycles between combinations of load cases, and states in the middle of a spectrum. */
#include <math.h>

#include "fatigue_scenes.h"

/** One case alone is the same as the load factor. */
static void a_case_has_the_life_of_the_load_factor(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.5, 0.0), q = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  const bempd_growth_rate rate = paris();
  const bempd_fatigue options = to_length(0.5);
  const double high[] = {1.0, 0.8}, low[] = {0.2, 0.0}, cycles[] = {300.0, 1000.0};
  const int32_t loads[] = {q.up, q.down};
  bempd_fatigue_report by_factor = new_report(), by_case = new_report();
  double load_factor = -1.0;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(q.model, bempd_set_growth_rate(q.model, q.material, &rate));
  CHECK_OK(q.model, bempd_load_case_add(q.model, 2, loads, 0, NULL, NULL));
  CHECK_OK(p.model, bempd_grow_fatigue(p.model, 2, high, low, cycles, &options, &by_factor));
  CHECK_OK(q.model, bempd_grow_fatigue_cases(q.model, 2, 1, high, low, cycles, &options, &by_case));
  /* K of a combination is within 1e-4, which may divide one step more. */
  CHECK(by_case.stop_reason == BEMPD_FATIGUE_LENGTH && by_case.steps <= by_factor.steps + 1 &&
        by_case.steps >= by_factor.steps - 1);
  CHECK_CLOSE(by_case.cycles, by_factor.cycles, 1e-4 * by_factor.cycles);
  CHECK_OK(q.model, bempd_load_factor(q.model, &load_factor));
  CHECK_CLOSE(load_factor, 0.0, 0.0);
  CHECK_CLOSE(last_record(q.model).range, last_record(p.model).range, 1e-4 * last_record(p.model).range);
  bempd_model_free(p.model);
  bempd_model_free(q.model);
}

/** A pull and a pressure in the crack have the same factor in a wide plate: K = S sqrt(pi a). Blocks of both, apart and
 * together, have the mean rate of a power law. */
static void a_spectrum_of_two_cases_has_the_closed_form(void) {
  const double pi = acos(-1.0), half = 0.01, inside = 1.0;
  const plate p = plate_of(8.0 * half / 0.01, -half, half, 2.0, 0.0);
  const double high[] = {1.0, 0.5, 0.8, 0.0, 0.0, 0.9}, low[] = {0.0, 0.0, 0.0, 0.2, 0.3, 0.0};
  const double cycles[] = {1e3, 2e3, 4e3}, ranges[] = {1.5, 0.6, 0.6};
  const int32_t loads[] = {p.up, p.down};
  const bempd_growth_rate rate = paris();
  const bempd_fatigue options = to_length(0.1);
  bempd_fatigue_report report = new_report();
  int32_t pressure = 0;
  double sum = 0.0, all = 0.0, exact;
  CHECK_OK(p.model, bempd_add_crack_pressure(p.model, p.crack, 0.0, inside, &pressure));
  CHECK_OK(p.model, bempd_load_case_add(p.model, 2, loads, 0, NULL, NULL));
  CHECK_OK(p.model, bempd_load_case_add(p.model, 1, &pressure, 0, NULL, NULL));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(p.model, bempd_grow_fatigue_cases(p.model, 3, 2, high, low, cycles, &options, &report));
  for (int b = 0; b < 3; ++b) sum += cycles[b] * pow(ranges[b], 3.0), all += cycles[b];
  exact = (pow(half, -0.5) - pow(0.05, -0.5)) / (0.5e-6 * pow(pi, 1.5) * sum / all);
  printf("cycles %.6g, closed form %.6g, relative difference %.1e\n", report.cycles, exact,
         report.cycles / exact - 1.0);
  CHECK_CLOSE(report.cycles, exact, 1e-3 * exact);
  bempd_model_free(p.model);
}

/** A combination that presses the crack together has the factor 0 at its end of the cycle. */
static void a_case_that_closes_the_crack_counts_from_zero(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  const int32_t loads[] = {p.up, p.down};
  const double high = 1.0, low = -1.0;
  const bempd_growth_rate rate = paris();
  const bempd_fatigue options = to_length(0.25);
  bempd_fatigue_record record;
  CHECK_OK(p.model, bempd_load_case_add(p.model, 2, loads, 0, NULL, NULL));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(p.model, bempd_grow_fatigue_cases(p.model, 1, 1, &high, &low, NULL, &options, NULL));
  record = last_record(p.model);
  CHECK_CLOSE(record.ratio, 0.0, 1e-6);
  CHECK_CLOSE(record.stress_intensity_1_low, 0.0, 1e-6);
  CHECK(record.stress_intensity_1 > sqrt(acos(-1.0) * 0.125));
  bempd_model_free(p.model);
}

/** A tip turns by the combination under which its factor is largest, which is not that of the first block here. */
static void tips_turn_by_the_leading_combination(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  const double high[] = {0.2, 0.0, 0.0, 1.0}, low[] = {0.0, 0.0, 0.0, 0.0}, cycles[] = {1000.0, 1000.0}, one = 1.0;
  const double shear[] = {0.0, 1.0};
  const int32_t pull[] = {p.up, p.down};
  int32_t sides[4] = {0};
  const bempd_growth_rate rate = paris();
  bempd_fatigue options = to_length(0.0);
  bempd_crack_tip tip;
  bempd_fatigue_record record;
  const double minus = -1.0;
  for (int edge = 1; edge <= 4; ++edge)
    CHECK_OK(p.model, bempd_add_traction(p.model, p.region, edge, 0.0, 1.0, edge % 2 == 1 ? BEMPD_X : BEMPD_Y, 1, NULL,
                                         edge == 1 || edge == 4 ? &minus : &one, &sides[edge - 1]));
  CHECK_OK(p.model, bempd_load_case_add(p.model, 2, pull, 0, NULL, NULL));
  CHECK_OK(p.model, bempd_load_case_add(p.model, 4, sides, 0, NULL, NULL));
  CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(p.model, bempd_load_case_tip(p.model, 2, shear, 1, &tip));
  CHECK(fabs(tip.kink_angle) > 1.2);
  CHECK_OK(p.model, bempd_set_option_text(p.model, "crack.direction", "tip"));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  options.most_steps = 1, options.largest_step = 0.02;
  CHECK_OK(p.model, bempd_grow_fatigue_cases(p.model, 2, 2, high, low, cycles, &options, NULL));
  record = last_record(p.model);
  CHECK_CLOSE(atan2(record.y, record.x - 0.1), tip.kink_angle, 0.1);
  bempd_model_free(p.model);
}

static void wrong_cases_are_refused(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  const int32_t loads[] = {p.up, p.down};
  const double one[] = {1.0, 1.0}, none[] = {0.0, 0.0}, bad = NAN, negative[] = {1.0, -5.0};
  const bempd_growth_rate rate = paris();
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
#define CASES_REFUSED(words, ...) \
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, words, bempd_grow_fatigue_cases(p.model, __VA_ARGS__, NULL, NULL))
  CASES_REFUSED("there are 1 factors and 0 load cases", 1, 1, one, none, NULL);
  CHECK_OK(p.model, bempd_load_case_add(p.model, 2, loads, 0, NULL, NULL));
  CASES_REFUSED("there are 2 factors and 1 load cases", 1, 2, one, none, NULL);
  CASES_REFUSED("case_count is 0", 1, 0, one, none, NULL);
  CASES_REFUSED("block_count is 0", 0, 1, one, none, NULL);
  CASES_REFUSED("high is NULL", 1, 1, NULL, none, NULL);
  CASES_REFUSED("low is NULL", 1, 1, one, NULL, NULL);
  CASES_REFUSED("cycles is NULL", 2, 1, one, none, NULL);
  CASES_REFUSED("block 2 has -5 cycles", 2, 1, one, none, negative);
  CASES_REFUSED("factor of load case 1 in block 1 is nan", 1, 1, &bad, none, NULL);
  bempd_model_free(p.model);
}

/** A state's bytes, restored in another model in the middle of a block, hold the overload that slows the tips down. */
static void states_hold_overloads(void) {
  const double high[] = {2.0, 1.0}, low[] = {0.0, 0.0}, cycles[] = {1.0, 1e9};
  plate p = plate_of(1.0, -0.1, 0.1, 0.5, 0.0), q = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  bempd_growth_rate rate = paris();
  bempd_fatigue options = to_length(0.0);
  bempd_fatigue_report report = new_report();
  bempd_state* state = NULL;
  int64_t size = 0;
  static uint8_t bytes[1 << 20];
  double whole = 0.0, restored = 0.0;
  rate.coefficient = 1e-3, rate.retardation = BEMPD_RETARDATION_WHEELER;
  rate.yield_strength = 3.0, rate.wheeler_exponent = 1.0;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(q.model, bempd_set_growth_rate(q.model, q.material, &rate));
  options.most_cycles = 100.0;
  CHECK_OK(p.model, bempd_grow_fatigue(p.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(p.model, bempd_state_save(p.model, &state));
  CHECK_OK(NULL, bempd_state_to_bytes(state, (int64_t)sizeof bytes, bytes, &size));
  bempd_state_free(state);
  CHECK(size > 0 && size <= (int64_t)sizeof bytes);
  options.first_cycle = report.cycles, options.most_cycles = 200.0;
  CHECK_OK(p.model, bempd_grow_fatigue(p.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &whole));
  /* A model that knows nothing of the overload refuses to go on; with the state it goes on bit for bit. */
  CHECK_FAILS(q.model, BEMPD_ERROR_ARGUMENT, "overloads",
              bempd_grow_fatigue(q.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(q.model, bempd_state_from_bytes(size, bytes, &state));
  CHECK_OK(q.model, bempd_state_restore(q.model, state));
  CHECK_OK(q.model, bempd_grow_fatigue(q.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(q.model, bempd_crack_length(q.model, q.crack, &restored));
  CHECK_CLOSE(restored, whole, 0.0);
  CHECK(whole > 0.21);
  bempd_state_free(state);
  bempd_model_free(p.model);
  bempd_model_free(q.model);
}

int main(void) {
  a_case_has_the_life_of_the_load_factor();
  a_spectrum_of_two_cases_has_the_closed_form();
  a_case_that_closes_the_crack_counts_from_zero();
  tips_turn_by_the_leading_combination();
  wrong_cases_are_refused();
  states_hold_overloads();
  return check_finish();
}

/** Fracture energies by a function of the host, for cracks with boundary elements and for crack lines. */
#include <math.h>

#include "fatigue_scenes.h"

typedef struct host {
  int64_t calls;
  double slope, shear, value; /* G_c = 1 + slope * growth + shear * (K_II / K_I)^2, or `value` if that is not 0 */
  double t_stress, x;         /* of the last call */
  int64_t good;               /* calls before `value` is given */
  bempd_model* cancel;
} host;

static double resistance(int32_t crack, int32_t end, double equivalent, double ratio, double k1, double k2,
                         double t_stress, double length, double x, double y, void* user) {
  host* h = (host*)user;
  CHECK(crack == 1 && (end == BEMPD_CRACK_START || end == BEMPD_CRACK_END) && length >= 0.0 && fabs(y) < 10.0);
  CHECK_CLOSE(ratio, 1.0, 0.0);
  CHECK(equivalent >= k1 * (1.0 - 1e-9));
  h->t_stress = t_stress, h->x = x;
  if (h->cancel != NULL) CHECK_OK(NULL, bempd_request_cancel(h->cancel));
  if (++h->calls > h->good) return h->value;
  return 1.0 + h->slope * length + h->shear * (k1 > 0.0 ? k2 * k2 / (k1 * k1) : 0.0);
}

static host new_host(void) {
  const host h = {0, 0.0, 0.0, 0.0, 0.0, 0.0, INT64_MAX, NULL};
  return h;
}

static plate pulled(int lines, double angle) {
  plate p = {new_model(), 0, 0, 0, 0, 0};
  bempd_material material;
  const double line[] = {-0.3 * cos(angle), -0.3 * sin(angle), 0.3 * cos(angle), 0.3 * sin(angle)}, one = 1.0;
  CHECK_OK(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1.0, material.poisson_ratio = 1.0 / 3.0, material.fracture_energy = 1.0;
  CHECK_OK(p.model, bempd_add_material(p.model, &material, &p.material));
  p.region = lines ? add_pd_rectangle(p.model, p.material, -1.0, -1.0, 1.0, 1.0, 0.05)
                   : add_bem_rectangle(p.model, p.material, -1.0, -1.0, 1.0, 1.0, 0.25);
  CHECK_OK(p.model, bempd_add_crack(p.model, 2, line, &p.crack));
  CHECK_OK(p.model, bempd_fix_edge(p.model, p.region, 1, BEMPD_BOTH, NULL));
  CHECK_OK(p.model, bempd_prescribe_edge(p.model, p.region, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &one, NULL));
  CHECK_OK(p.model, bempd_set_option_text(p.model, "stepping.control", "path"));
  return p;
}

static double next_load(const plate* p) {
  double load = 0.0;
  CHECK_OK(p->model, bempd_step_to_next_event(p->model, 1e9, NULL));
  CHECK_OK(p->model, bempd_load_factor(p->model, &load));
  return load;
}

static double first_load(int lines, double angle, host* h) {
  const plate p = pulled(lines, angle);
  double load;
  if (h != NULL) CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, resistance, h));
  load = next_load(&p);
  bempd_model_free(p.model);
  return load;
}

/** A function that gives the material's number changes nothing; one that rises with K_II / K_I raises the load by the
 * root of what it adds; T and the place are told. */
static void functions_give_the_load(int lines) {
  host same = new_host(), sheared = new_host();
  const double slant = 0.5, plain = first_load(lines, slant, NULL), straight = first_load(lines, 0.0, NULL);
  bempd_crack_tip tip;
  const plate p = pulled(lines, slant);
  double share, least = INFINITY, least_sheared = INFINITY;
  CHECK_CLOSE(first_load(lines, 0.0, &same), straight, 1e-9 * straight);
  CHECK(same.calls > 0 && fabs(same.x) > 0.25 && isfinite(same.t_stress) && same.t_stress < 0.0);
  CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, resistance, &same));
  CHECK_CLOSE(next_load(&p), lines ? first_load(lines, slant, &same) : plain, 1e-6 * plain);
  bempd_model_free(p.model);
  {
    const plate q = pulled(lines, slant);
    CHECK_OK(q.model, bempd_step(q.model, 0.1 * plain, NULL));
    CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
    for (int index = 0; index < 2; ++index) {
      CHECK_OK(q.model, bempd_tip(q.model, index, &tip));
      const double ratio = tip.stress_intensity_2 / tip.stress_intensity_1;
      least = fmin(least, tip.critical_load_factor);
      least_sheared = fmin(least_sheared, tip.critical_load_factor * sqrt(1.0 + 2.0 * ratio * ratio));
    }
    bempd_model_free(q.model);
  }
  sheared.shear = 2.0;
  share = first_load(lines, slant, &sheared) / first_load(lines, slant, &same);
  const double expected = least_sheared / least;
  printf("%s: load by G_c(K_II / K_I) over that by 1: %.4f, of the tip's factors %.4f\n", lines ? "line" : "elements",
         share, expected);
  CHECK_CLOSE(share, expected, (lines ? 0.03 : 2e-3) * expected);
}

/** A function of the growth is the table of a resistance curve. */
static void a_function_of_the_growth_is_a_table(int lines) {
  const double extensions[] = {0.0, 1.0}, energies[] = {1.0, 4.0};
  const plate p = pulled(lines, 0.0), q = pulled(lines, 0.0);
  host rising = new_host();
  rising.slope = 3.0;
  CHECK_OK(p.model, bempd_set_option_text(p.model, "crack.load", "fit"));
  CHECK_OK(q.model, bempd_set_option_text(q.model, "crack.load", "fit"));
  CHECK_OK(p.model, bempd_set_resistance_curve(p.model, p.material, 2, extensions, energies));
  CHECK_OK(q.model, bempd_set_resistance_function(q.model, q.material, resistance, &rising));
  for (int k = 0; k < 6; ++k) {
    const double table = next_load(&p), function = next_load(&q);
    CHECK_CLOSE(function, table, 1e-7 * table);
  }
  bempd_model_free(p.model);
  bempd_model_free(q.model);
}

/** NaN, negative numbers and a request to cancel end the call, and the model is as it was. */
static void bad_values_end_the_call(int lines) {
  const double bad[] = {NAN, -1.0, 0.0, INFINITY};
  const char* words[] = {"nan", "-1", "energy of 0", "inf"};
  for (int k = 0; k < 5; ++k) {
    const plate p = pulled(lines, 0.0);
    host h = new_host();
    double length = 0.0, load = -1.0;
    h.good = k < 4 ? 3 : INT64_MAX;
    h.value = k < 4 ? bad[k] : 0.0;
    CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, resistance, &h));
    if (k < 4)
      CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, words[k], bempd_step_to_next_event(p.model, 1e9, NULL));
    else {
      h.cancel = p.model;
      CHECK_FAILS(p.model, BEMPD_ERROR_CANCELLED, "cancel", bempd_run_to_separation(p.model, 1e9, NULL));
    }
    h = new_host();
    CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &length));
    CHECK_CLOSE(length, 0.6, 0.02);
    CHECK_OK(p.model, bempd_load_factor(p.model, &load));
    CHECK_CLOSE(load, 0.0, 0.0);
    bempd_model_free(p.model);
  }
}

/** Growth by cycles ends where the factor meets that of the function. */
static void growth_by_cycles_ends_there(void) {
  const plate p = plate_of(1.0, -0.1, 0.1, 0.25, 1.0);
  const bempd_growth_rate rate = paris();
  const double high = 1.0, low = 0.0;
  bempd_fatigue_report report = new_report();
  host h = new_host();
  h.slope = 2.0;
  CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, resistance, &h));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(p.model, bempd_grow_fatigue(p.model, 1, &high, &low, NULL, NULL, &report));
  CHECK(report.stop_reason == BEMPD_FATIGUE_CRITICAL);
  const bempd_fatigue_record last = last_record(p.model);
  CHECK_CLOSE(last.highest, sqrt(1.0 + 2.0 * last.growth), 2e-3);
  bempd_model_free(p.model);
}

/** A function that fails amid growth by cycles leaves the model as it was, also between load cases. */
static void failures_amid_growth_by_cycles_are_taken_back(void) {
  for (int by_cases = 0; by_cases < 2; ++by_cases) {
    const plate p = plate_of(1.0, -0.1, 0.1, 0.25, 1.0);
    const bempd_growth_rate rate = paris();
    const double high = 0.5, low = 0.0;
    const int32_t loads[] = {p.up, p.down};
    host h = new_host();
    double length = 0.0;
    int64_t extensions = -1, all;
    CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, resistance, &h));
    CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
    CHECK_OK(p.model, bempd_load_case_add(p.model, 2, loads, 0, NULL, NULL));
    for (int failing = 0; failing < 2; ++failing) {
      const bempd_fatigue options = to_length(0.3);
      all = h.calls;
      h.calls = 0;
      if (failing == 0) {
        const plate q = plate_of(1.0, -0.1, 0.1, 0.25, 1.0);
        const int32_t its_loads[] = {q.up, q.down};
        CHECK_OK(q.model, bempd_set_resistance_function(q.model, q.material, resistance, &h));
        CHECK_OK(q.model, bempd_set_growth_rate(q.model, q.material, &rate));
        CHECK_OK(q.model, bempd_load_case_add(q.model, 2, its_loads, 0, NULL, NULL));
        if (by_cases == 0) CHECK_OK(q.model, bempd_grow_fatigue(q.model, 1, &high, &low, NULL, &options, NULL));
        if (by_cases == 1)
          CHECK_OK(q.model, bempd_grow_fatigue_cases(q.model, 1, 1, &high, &low, NULL, &options, NULL));
        bempd_model_free(q.model);
        continue;
      }
      CHECK(all > 100);
      h.good = all / 2, h.value = NAN;
      if (by_cases == 0)
        CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "nan",
                    bempd_grow_fatigue(p.model, 1, &high, &low, NULL, &options, NULL));
      if (by_cases == 1)
        CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "nan",
                    bempd_grow_fatigue_cases(p.model, 1, 1, &high, &low, NULL, &options, NULL));
      h.good = INT64_MAX;
      CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &length));
      CHECK_CLOSE(length, 0.2, 0.0);
      CHECK_OK(p.model, bempd_extension_count(p.model, &extensions));
      CHECK(extensions == 0);
    }
    bempd_model_free(p.model);
  }
}

static void misuse_is_told(void) {
  const double extensions[] = {0.0, 1.0}, energies[] = {1.0, 4.0};
  const plate p = plate_of(1.0, -0.1, 0.1, 0.5, 1.0), q = plate_of(1.0, -0.1, 0.1, 0.5, 0.0);
  host h = new_host();
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "function is NULL",
              bempd_set_resistance_function(p.model, p.material, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "material", bempd_set_resistance_function(p.model, 7, resistance, &h));
  CHECK_FAILS(q.model, BEMPD_ERROR_ARGUMENT, "no fracture_energy",
              bempd_set_resistance_function(q.model, q.material, resistance, &h));
  CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, resistance, &h));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "resistance function",
              bempd_set_resistance_curve(p.model, p.material, 2, extensions, energies));
  CHECK_OK(p.model, bempd_prepare(p.model));
  CHECK_FAILS(p.model, BEMPD_ERROR_ORDER, "prepared",
              bempd_set_resistance_function(p.model, p.material, resistance, &h));
  bempd_model_free(p.model);
  bempd_model_free(q.model);
}

static double jumping(int32_t crack, int32_t end, double equivalent, double ratio, double k1, double k2,
                      double t_stress, double length, double x, double y, void* user) {
  (void)crack, (void)end, (void)ratio, (void)k1, (void)k2, (void)t_stress, (void)length, (void)x, (void)y, (void)user;
  return equivalent > 1.0 ? 0.25 : 4.0;
}

/** The crack would grow at K = 2 by the energy below K = 1, and at K = 0.5 by that above: at no load. */
static void energies_without_a_load_are_told(void) {
  const plate p = pulled(1, 0.0);
  CHECK_OK(p.model, bempd_set_resistance_function(p.model, p.material, jumping, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "changes too fast", bempd_step_to_next_event(p.model, 1e9, NULL));
  bempd_model_free(p.model);
}

int main(void) {
  for (int lines = 0; lines < 2; ++lines) {
    functions_give_the_load(lines);
    a_function_of_the_growth_is_a_table(lines);
    bad_values_end_the_call(lines);
  }
  growth_by_cycles_ends_there();
  failures_amid_growth_by_cycles_are_taken_back();
  misuse_is_told();
  energies_without_a_load_are_told();
  return check_finish();
}

/** Growth by cycles and by given lengths, and misuse of both. */
#include <float.h>
#include <math.h>

#include "scenes.h"

typedef struct plate {
  bempd_model* model;
  int32_t material, crack, load;
} plate;

/** A plate 2 x 2 with a crack from -0.1 to 0.1 + `off`, pulled by 1 Pa per unit of the load factor. */
static plate new_plate(double fracture_energy, double off) {
  const rectangle square = rectangle_of(-1.0, -1.0, 1.0, 1.0);
  const double crack[] = {-0.1, 0.0, 0.1 + off, 0.0}, up = 1.0, down = -1.0;
  plate made = {new_model(), 0, 0, 0};
  bempd_material material;
  int32_t region = 0;
  CHECK_OK(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1.0;
  material.poisson_ratio = 0.3;
  material.fracture_energy = fracture_energy;
  CHECK_OK(made.model, bempd_add_material(made.model, &material, &made.material));
  CHECK_OK(made.model, bempd_add_bem_region(made.model, made.material, 4, square.vertices, 0.5, &region));
  CHECK_OK(made.model, bempd_add_crack(made.model, 2, crack, &made.crack));
  CHECK_OK(made.model, bempd_fix_point(made.model, -1.0, -1.0, BEMPD_BOTH, NULL));
  CHECK_OK(made.model, bempd_fix_point(made.model, 1.0, -1.0, BEMPD_Y, NULL));
  CHECK_OK(made.model, bempd_add_traction(made.model, region, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &up, &made.load));
  CHECK_OK(made.model, bempd_add_traction(made.model, region, 1, 0.0, 1.0, BEMPD_Y, 1, NULL, &down, NULL));
  return made;
}

static bempd_growth_rate paris(void) {
  bempd_growth_rate rate;
  CHECK_OK(NULL, bempd_growth_rate_init(&rate, sizeof rate));
  rate.coefficient = 1e-6;
  rate.exponent = 3.0;
  return rate;
}

static bempd_fatigue to_length(double length) {
  bempd_fatigue options;
  CHECK_OK(NULL, bempd_fatigue_init(&options, sizeof options));
  options.most_length = length;
  return options;
}

static bempd_fatigue_report grow(const plate* p, const bempd_fatigue* options) {
  const double high = 1.0, low = 0.0;
  bempd_fatigue_report report;
  CHECK_OK(NULL, bempd_fatigue_report_init(&report, sizeof report));
  CHECK_OK(p->model, bempd_grow_fatigue(p->model, 1, &high, &low, NULL, options, &report));
  return report;
}

static bempd_fatigue_record record_at(const bempd_model* model, int64_t index) {
  bempd_fatigue_record record;
  CHECK_OK(NULL, bempd_fatigue_record_init(&record, sizeof record));
  CHECK_OK(model, bempd_get_fatigue_record(model, index, &record));
  return record;
}

static int64_t record_count(const bempd_model* model) {
  int64_t count = -1;
  CHECK_OK(model, bempd_fatigue_record_count(model, &count));
  return count;
}

/** Tips of a centre crack grow alike; the records say by how much, and the history has an event for each step. */
static void records_belong_to_steps(void) {
  const plate p = new_plate(0.0, 0.0);
  const bempd_growth_rate rate = paris();
  const bempd_fatigue options = to_length(0.4);
  bempd_fatigue_report report;
  bempd_fatigue_record last;
  double length = 0.0, load_factor = 0.0;
  int64_t extensions = 0;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK(record_count(p.model) == 0);
  report = grow(&p, &options);
  CHECK(report.stop_reason == BEMPD_FATIGUE_LENGTH && report.crack == p.crack && report.steps > 2);
  CHECK(report.error > 0.0 && report.error < 1e-3);
  CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &length));
  CHECK_CLOSE(length, 0.4, 1e-12);
  CHECK_CLOSE(report.growth, 0.2, 1e-12);
  CHECK_OK(p.model, bempd_load_factor(p.model, &load_factor));
  CHECK_CLOSE(load_factor, 1.0, 0.0);
  CHECK(record_count(p.model) == 2 * (report.steps + 1));
  last = record_at(p.model, record_count(p.model) - 1);
  CHECK(last.step == report.steps && last.crack == p.crack && last.end == BEMPD_CRACK_END && last.event > 0);
  CHECK_CLOSE(last.cycles, report.cycles, 0.0);
  CHECK_CLOSE(last.growth, 0.1, 1e-6);
  CHECK_CLOSE(last.x, 0.2, 1e-6);
  CHECK_CLOSE(last.range, last.stress_intensity_1, 1e-9);
  CHECK_CLOSE(last.ratio, 0.0, 0.0);
  CHECK_CLOSE(last.rate, 1e-6 * pow(last.range, 3.0), 1e-15);
  CHECK_OK(p.model, bempd_extension_count(p.model, &extensions));
  CHECK(extensions == 2 * report.steps);
  bempd_model_free(p.model);
}

/** A run in two calls, the second from where the first came to, is the run in one; so is one after a state. */
static void runs_go_on(void) {
  const plate one = new_plate(0.0, 0.0), two = new_plate(0.0, 0.0);
  const bempd_growth_rate rate = paris();
  const double high[] = {1.0, 0.8}, low[] = {0.2, 0.0}, cycles[] = {3000.0, 10000.0};
  bempd_fatigue options = to_length(0.0);
  bempd_fatigue_report report;
  bempd_state* state = NULL;
  double whole = 0.0, parts = 0.0, again = 0.0, before = 0.0;
  CHECK_OK(NULL, bempd_fatigue_report_init(&report, sizeof report));
  CHECK_OK(one.model, bempd_set_growth_rate(one.model, one.material, &rate));
  CHECK_OK(two.model, bempd_set_growth_rate(two.model, two.material, &rate));
  options.most_cycles = 700000.0;
  CHECK_OK(one.model, bempd_grow_fatigue(one.model, 2, high, low, cycles, &options, &report));
  CHECK(report.stop_reason == BEMPD_FATIGUE_CYCLES && report.cycles == 700000.0);
  CHECK_OK(one.model, bempd_crack_length(one.model, one.crack, &whole));
  options.most_cycles = 301000.0;
  CHECK_OK(two.model, bempd_grow_fatigue(two.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(two.model, bempd_state_save(two.model, &state));
  CHECK_OK(two.model, bempd_crack_length(two.model, two.crack, &before));
  options.first_cycle = report.cycles;
  options.most_cycles = 700000.0;
  CHECK_OK(two.model, bempd_grow_fatigue(two.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(two.model, bempd_crack_length(two.model, two.crack, &parts));
  CHECK(whole > 0.3 && before < whole);
  CHECK_CLOSE(parts - 0.2, whole - 0.2, 2e-3 * (whole - 0.2));
  CHECK_OK(two.model, bempd_state_restore(two.model, state));
  CHECK_OK(two.model, bempd_crack_length(two.model, two.crack, &again));
  CHECK_CLOSE(again, before, 0.0);
  CHECK_OK(two.model, bempd_grow_fatigue(two.model, 2, high, low, cycles, &options, &report));
  CHECK_OK(two.model, bempd_crack_length(two.model, two.crack, &again));
  CHECK_CLOSE(again, parts, 1e-12);
  bempd_state_free(state);
  bempd_model_free(one.model);
  bempd_model_free(two.model);
}

/** Runs end at the critical factor, that of the law or of the material, and below the threshold. */
static void runs_stop(void) {
  const double toughness = 1.0, high = 1.0, low = -1.0, factor = sqrt(acos(-1.0) * 0.1);
  const plate p = new_plate(toughness * toughness, 0.0), compressed = new_plate(0.0, 0.0);
  bempd_growth_rate rate = paris();
  double first;
  bempd_fatigue_report report;
  bempd_fatigue_record last;
  const bempd_fatigue options = to_length(0.0);
  CHECK_OK(NULL, bempd_fatigue_report_init(&report, sizeof report));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  report = grow(&p, &options);
  CHECK(report.stop_reason == BEMPD_FATIGUE_CRITICAL && report.crack == p.crack && report.end != 0);
  last = record_at(p.model, record_count(p.model) - 1);
  CHECK_CLOSE(last.highest, toughness, 1e-3);
  first = report.cycles;
  report = grow(&p, &options);
  CHECK(report.stop_reason == BEMPD_FATIGUE_CRITICAL && report.cycles < 1e-3 * first);
  bempd_model_free(p.model);

  rate.threshold = 1.2 * factor;
  CHECK_OK(compressed.model, bempd_set_growth_rate(compressed.model, compressed.material, &rate));
  report = grow(&compressed, &options);
  CHECK(report.stop_reason == BEMPD_FATIGUE_NONE_GROWS && report.growth == 0.0);
  rate.threshold = 0.0;
  CHECK_OK(compressed.model, bempd_set_growth_rate(compressed.model, compressed.material, &rate));
  /* Faces that are pressed together at the low load have K = 0 there. */
  CHECK_OK(compressed.model, bempd_grow_fatigue(compressed.model, 1, &high, &low, NULL, NULL, &report));
  last = record_at(compressed.model, 0);
  CHECK_CLOSE(last.ratio, 0.0, 1e-9);
  CHECK(last.range > factor && last.range < 1.1 * factor);
  bempd_model_free(compressed.model);
}

/** Tips grow by lengths of their own, at the present load. */
static void cracks_grow_by_lengths(void) {
  const plate p = new_plate(0.0, 0.0);
  const int32_t cracks[] = {p.crack, p.crack}, ends[] = {BEMPD_CRACK_START, BEMPD_CRACK_END};
  const int32_t twice[] = {BEMPD_CRACK_END, BEMPD_CRACK_END};
  const double lengths[] = {0.01, 0.03}, negative[] = {0.01, -0.03};
  bempd_growth growth;
  bempd_crack_extension extension;
  double length = 0.0;
  CHECK_OK(NULL, bempd_growth_init(&growth, sizeof growth));
  CHECK_OK(NULL, bempd_crack_extension_init(&extension, sizeof extension));
  CHECK_OK(p.model, bempd_step(p.model, 2.0, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "count", bempd_extend_cracks(p.model, 0, cracks, ends, lengths, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "NULL", bempd_extend_cracks(p.model, 2, cracks, ends, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "twice", bempd_extend_cracks(p.model, 2, cracks, twice, lengths, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "-0.03", bempd_extend_cracks(p.model, 2, cracks, ends, negative, NULL));
  CHECK_OK(p.model, bempd_extend_cracks(p.model, 2, cracks, ends, lengths, &growth));
  CHECK(growth.tips == 2 && growth.ended == 0 && growth.load_factor == 2.0 && growth.released_energy > 0.0);
  CHECK_CLOSE(growth.length, 0.04, 1e-12);
  CHECK_OK(p.model, bempd_extension(p.model, 1, &extension));
  CHECK_CLOSE(extension.length, 0.03, 1e-12);
  CHECK_CLOSE(extension.x, 0.13, 1e-6);
  CHECK_CLOSE(extension.surface_energy, extension.released_energy, 1e-12);
  CHECK_OK(p.model, bempd_set_tip_frozen(p.model, p.crack, BEMPD_CRACK_END, 1));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "frozen", bempd_extend_cracks(p.model, 2, cracks, ends, lengths, NULL));
  CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &length));
  CHECK_CLOSE(length, 0.24, 1e-12);
  bempd_model_free(p.model);
}

typedef struct host {
  int64_t calls, most;
  double after;
  bempd_model* cancel;
} host;

static double host_rate(int32_t crack, int32_t end, double highest, double ratio, double k1, double k2, double t_stress,
                        double length, double x, double y, void* user) {
  host* h = (host*)user;
  CHECK(crack == 1 && (end == BEMPD_CRACK_START || end == BEMPD_CRACK_END) && ratio < 1.0);
  CHECK_CLOSE(k1, highest, 1e-9);
  CHECK(t_stress < -0.95 && t_stress > -1.15); /* of a pull of 1 across a crack in the middle */
  CHECK(fabs(k2) < 1e-6 && length >= 0.2 - 1e-12 && fabs(x) >= 0.1 - 1e-12 && fabs(y) < 1e-6);
  if (++h->calls <= h->most) return 1e-6 * pow((1.0 - ratio) * highest, 3.0);
  if (h->cancel != NULL) CHECK_OK(NULL, bempd_request_cancel(h->cancel));
  return h->after;
}

static int32_t stop_progress(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)broken_bonds, (void)user;
  return events >= 2;
}

/** What a function of the host gives is a law; NaN, negative numbers and a request to cancel leave the model as it was.
 */
static void hosts_have_laws(void) {
  const plate p = new_plate(0.0, 0.0);
  const double high = 1.0, low = 0.0;
  const bempd_fatigue options = to_length(0.3);
  bempd_growth_rate rate = paris();
  host h = {0, INT64_MAX, 0.0, NULL};
  bempd_fatigue_report known, report;
  double length = 0.0;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(p.model, bempd_set_progress(p.model, stop_progress, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_CANCELLED, "progress",
              bempd_grow_fatigue(p.model, 1, &high, &low, NULL, &options, NULL));
  CHECK_OK(p.model, bempd_set_progress(p.model, NULL, NULL));
  rate.kind = BEMPD_RATE_HOST;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "function", bempd_set_growth_rate(p.model, p.material, &rate));
  rate.function = host_rate;
  rate.user = &h;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  h.most = 100;
  h.after = NAN;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "nan", bempd_grow_fatigue(p.model, 1, &high, &low, NULL, &options, NULL));
  h.calls = 0;
  h.after = -1.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "-1", bempd_grow_fatigue(p.model, 1, &high, &low, NULL, &options, NULL));
  h.calls = 0;
  h.after = 1e-6;
  h.cancel = p.model;
  CHECK_FAILS(p.model, BEMPD_ERROR_CANCELLED, "cancel",
              bempd_grow_fatigue(p.model, 1, &high, &low, NULL, &options, NULL));
  CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &length));
  CHECK_CLOSE(length, 0.2, 0.0);
  CHECK(record_count(p.model) == 0);
  h.calls = 0;
  h.most = INT64_MAX;
  report = grow(&p, &options);
  bempd_model_free(p.model);
  {
    const plate q = new_plate(0.0, 0.0);
    rate = paris();
    CHECK_OK(q.model, bempd_set_growth_rate(q.model, q.material, &rate));
    known = grow(&q, &options);
    CHECK_CLOSE(report.cycles, known.cycles, 1e-6 * known.cycles);
    bempd_model_free(q.model);
  }
}

static void misuse_is_told(void) {
  const plate p = new_plate(0.0, 0.0);
  const double high[] = {1.0, 0.5}, low[] = {0.0, 0.6}, cycles[] = {10.0, -1.0}, one = 1.0, none = 0.0;
  const double infinite = INFINITY;
  bempd_growth_rate rate = paris(), bad = rate;
  bempd_fatigue options = to_length(0.3);
  bempd_fatigue_record record;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "bempd_set_growth_rate",
              bempd_grow_fatigue(p.model, 1, &one, &none, NULL, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "material", bempd_set_growth_rate(p.model, 7, &rate));
  bad.coefficient = -1.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "coefficient", bempd_set_growth_rate(p.model, p.material, &bad));
  bad = rate, bad.exponent = NAN;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "exponent", bempd_set_growth_rate(p.model, p.material, &bad));
  bad = rate, bad.threshold = -1.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "threshold", bempd_set_growth_rate(p.model, p.material, &bad));
  bad = rate, bad.kind = 9;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "kind", bempd_set_growth_rate(p.model, p.material, &bad));
  bad = rate, bad.unit_intensity = 0.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "unit_intensity", bempd_set_growth_rate(p.model, p.material, &bad));
  bad = rate, bad.closure_alpha = 4.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "closure_alpha", bempd_set_growth_rate(p.model, p.material, &bad));
  bad = rate, bad.kind = BEMPD_RATE_FORMAN;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &bad));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "critical_intensity",
              bempd_grow_fatigue(p.model, 1, &one, &none, NULL, NULL, NULL));
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "block_count",
              bempd_grow_fatigue(p.model, 0, high, low, NULL, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "high", bempd_grow_fatigue(p.model, 1, NULL, low, NULL, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "cycles", bempd_grow_fatigue(p.model, 2, high, low, NULL, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "R = low / high",
              bempd_grow_fatigue(p.model, 2, high, low, high, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "-1", bempd_grow_fatigue(p.model, 2, high, high, cycles, NULL, NULL));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "inf", bempd_grow_fatigue(p.model, 1, &infinite, low, NULL, NULL, NULL));
  options.tolerance = 0.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "tolerance",
              bempd_grow_fatigue(p.model, 1, high, low, NULL, &options, NULL));
  options = to_length(-1.0);
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "most_length",
              bempd_grow_fatigue(p.model, 1, high, low, NULL, &options, NULL));
  options = to_length(0.3);
  options.most_steps = 0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "most_steps",
              bempd_grow_fatigue(p.model, 1, high, low, NULL, &options, NULL));
  options = to_length(0.3);
  options.first_cycle = 10.0, options.most_cycles = 5.0;
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "most_cycles",
              bempd_grow_fatigue(p.model, 1, high, low, NULL, &options, NULL));
  CHECK_OK(NULL, bempd_fatigue_record_init(&record, sizeof record));
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "index", bempd_get_fatigue_record(p.model, 0, &record));
  bempd_model_free(p.model);
  {
    bempd_model* block = bem_block();
    CHECK_FAILS(block, BEMPD_ERROR_UNSOLVABLE, "support", bempd_grow_fatigue(block, 1, &one, &none, NULL, NULL, NULL));
    bempd_model_free(block);
  }
}

/** The explanation says after growth by cycles which tip limits the life, and by how much; not where cracks have
 * changed since. */
static void explanation_tells_the_limiting_tip(void) {
  const plate p = new_plate(0.0, 0.4);
  const bempd_growth_rate rate = paris();
  const bempd_fatigue options = to_length(0.7);
  char words[2000] = "";
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  CHECK_OK(p.model, bempd_explain(p.model, 1, NULL, words, sizeof words, NULL));
  CHECK(strstr(words, "By cycles") == NULL);
  grow(&p, &options);
  CHECK_OK(p.model, bempd_explain(p.model, 1, NULL, words, sizeof words, NULL));
  CHECK(strstr(words, "By cycles, crack 1 at its end") != NULL &&
        strstr(words, "times the growth of the next") != NULL);
  const int32_t end = BEMPD_CRACK_END;
  const double length = 0.01;
  CHECK_OK(p.model, bempd_extend_cracks(p.model, 1, &p.crack, &end, &length, NULL));
  CHECK_OK(p.model, bempd_explain(p.model, 1, NULL, words, sizeof words, NULL));
  CHECK(strstr(words, "By cycles") == NULL);
  bempd_model_free(p.model);
}

/** What retardation needs, and what it does not take. */
static void wrong_retardation_is_refused(void) {
  const plate p = new_plate(0.0, 0.0);
  bempd_growth_rate rate = paris();
#define RATE_REFUSED(words) \
  CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, words, bempd_set_growth_rate(p.model, p.material, &rate))
  rate.retardation = 3;
  RATE_REFUSED("retardation is 3");
  rate.retardation = BEMPD_RETARDATION_WHEELER;
  RATE_REFUSED("yield_strength is 0");
  rate.yield_strength = NAN;
  RATE_REFUSED("yield_strength is nan");
  rate.yield_strength = 1.0;
  RATE_REFUSED("wheeler_exponent is 0");
  rate.wheeler_exponent = 1.0, rate.zone_constraint = -1.0;
  RATE_REFUSED("zone_constraint is -1");
  rate.zone_constraint = 0.0, rate.reserved2 = 1;
  RATE_REFUSED("reserved2 is 1");
  rate.reserved2 = 0;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  rate.retardation = BEMPD_RETARDATION_WILLENBORG;
  RATE_REFUSED("shutoff_ratio is 0");
  rate.shutoff_ratio = 2.0;
  RATE_REFUSED("walker = 1");
  rate.walker = 0.5;
  CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
  rate.kind = BEMPD_RATE_SUSTAINED;
  RATE_REFUSED("growth in time");
  bempd_model_free(p.model);
}

/** A call that goes on in the middle of the blocks meets the overload of the call before; without it, it is refused. */
static void overloads_are_taken_up(void) {
  const double high[] = {2.0, 1.0}, low[] = {0.0, 0.0}, cycles[] = {1.0, 1e9};
  bempd_growth_rate rate = paris();
  rate.coefficient = 1e-3;
  rate.retardation = BEMPD_RETARDATION_WHEELER;
  rate.yield_strength = 3.0, rate.wheeler_exponent = 1.0;
  double lengths[2] = {0.0, 0.0};
  for (int parts = 1; parts <= 2; ++parts) {
    const plate p = new_plate(0.0, 0.0);
    bempd_fatigue options = to_length(0.0);
    bempd_fatigue_report report;
    CHECK_OK(NULL, bempd_fatigue_report_init(&report, sizeof report));
    CHECK_OK(p.model, bempd_set_growth_rate(p.model, p.material, &rate));
    for (int part = 1; part <= parts; ++part) {
      options.most_cycles = 200.0 * part / parts;
      CHECK_OK(p.model, bempd_grow_fatigue(p.model, 2, high, low, cycles, &options, &report));
      options.first_cycle = report.cycles;
    }
    CHECK_OK(p.model, bempd_crack_length(p.model, p.crack, &lengths[parts - 1]));
    const int32_t end = BEMPD_CRACK_END;
    const double length = 0.01;
    CHECK_OK(p.model, bempd_extend_cracks(p.model, 1, &p.crack, &end, &length, NULL));
    options.most_cycles = 400.0;
    CHECK_FAILS(p.model, BEMPD_ERROR_ARGUMENT, "overloads",
                bempd_grow_fatigue(p.model, 2, high, low, cycles, &options, &report));
    bempd_model_free(p.model);
  }
  CHECK(lengths[0] > 0.21);
  CHECK_CLOSE(lengths[1], lengths[0], 1e-3 * (lengths[0] - 0.2));
}

int main(void) {
  records_belong_to_steps();
  runs_go_on();
  runs_stop();
  cracks_grow_by_lengths();
  hosts_have_laws();
  misuse_is_told();
  explanation_tells_the_limiting_tip();
  wrong_retardation_is_refused();
  overloads_are_taken_up();
  return check_finish();
}

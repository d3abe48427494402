/*
 * Events are the same on every kind of processor: one writes them, the others compare.
 *   capi_same_events write FILE | compare FILE
 * Bonds are chosen by comparing stretches, so counts would differ where rounding decided between two of them. Rounding
 * is some 1e-13 of a stretch here; the numbers may differ by that and its consequences.
 */
#define CRACK_RULE "bond"
#include "scenes.h"

/* Bond by bond, the first one is the README's first program; the last one the same before boundary elements became
 * smaller towards the ends of supports. */
#define RUNS 4
static const double lengths[RUNS] = {0.0045, 0.0065, 0.0045, 0.0045};
static const int one_by_one[RUNS] = {0, 0, 1, 0};
static const char* const gradings[RUNS] = {"auto", "auto", "auto", "none"};
static const int64_t events[RUNS] = {516, 0, 0, 515}; /* 0: not stated */
static const double ends[RUNS] = {142.73, 0.0, 0.0, 142.72};

typedef struct line {
  int64_t total_broken_bonds;
  double load_factor, released_energy;
} line;

/** The strip of the README, torn, with a crack of some length. */
static bempd_model* torn_strip(double length, int bonds_one_by_one, const char* grading) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  bempd_model* model = strip_with_crack(length, 1, NULL, &pull, &pulled);
  if (bonds_one_by_one) {
    CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 0.0));
    CHECK_OK(model, bempd_set_option(model, "bem.quadrature_tolerance", 1e-15));
  }
  CHECK_OK(model, bempd_set_option_text(model, "bem.grading", grading));
  CHECK_OK(model, bempd_run_to_separation(model, 1e4, NULL));
  return model;
}

static line line_of(bempd_model* model, int64_t index) {
  bempd_history_entry entry;
  line result;
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  CHECK_OK(model, bempd_get_history_entry(model, index, &entry));
  memset(&result, 0, sizeof result);
  result.total_broken_bonds = entry.total_broken_bonds;
  result.load_factor = entry.load_factor;
  result.released_energy = entry.released_energy;
  return result;
}

int main(int count, char** words) {
  const int writes = count == 3 && strcmp(words[1], "write") == 0;
  FILE* file = count == 3 ? fopen(words[2], writes ? "wb" : "rb") : NULL;
  int run;
  if (file == NULL) {
    fprintf(stderr, "usage: capi_same_events write|compare FILE\n");
    return 2;
  }
  for (run = 0; run < RUNS; ++run) {
    bempd_model* model = torn_strip(lengths[run], one_by_one[run], gradings[run]);
    int64_t lines = 0, expected = 0, k;
    CHECK_OK(model, bempd_history_count(model, &lines));
    CHECK(lines > 300);
    if (events[run] > 0) {
      CHECK(lines == events[run]);
      CHECK(fabs(line_of(model, lines - 1).load_factor - ends[run]) <= 0.005);
    }
    expected = lines;
    if (writes) CHECK(fwrite(&lines, sizeof lines, 1, file) == 1);
    if (!writes) CHECK(fread(&expected, sizeof expected, 1, file) == 1 && expected == lines);
    for (k = 0; k < lines && expected == lines; ++k) {
      const line own = line_of(model, k);
      line other = own;
      if (writes) CHECK(fwrite(&own, sizeof own, 1, file) == 1);
      if (!writes) CHECK(fread(&other, sizeof other, 1, file) == 1);
      CHECK(own.total_broken_bonds == other.total_broken_bonds);
      CHECK(fabs(own.load_factor - other.load_factor) <= 1e-10 * fabs(other.load_factor));
      CHECK(fabs(own.released_energy - other.released_energy) <= 1e-10 * fabs(other.released_energy));
    }
    bempd_model_free(model);
  }
  fclose(file);
  return check_finish();
}

/*
 * A plate with a central crack, pulled apart until it is in two: boundary elements left and right, a peridynamic strip
 * where the crack runs. SI units: m, N, Pa, J. Writes its files to out/centre_crack/.
 */
#define _POSIX_C_SOURCE 200809L

#include <bempd.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <time.h>

#define OUTPUT "out/centre_crack/"

static const double mm = 1e-3;

/* The load factor counts the increments of the paper: each moves both ends by this much. */
static const double pull_per_increment = 2e-8;
static const double increment_limit = 1000.0;

static void ensure(const bempd_model* model, bempd_status status) {
  if (status == BEMPD_OK) return;
  fprintf(stderr, "%s: %s\n", bempd_status_name(status), bempd_last_error(model));
  exit(EXIT_FAILURE);
}

static double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Vertices of a part of the plate over its whole height; edges: 1 bottom, 2 right, 3 top, 4 left. */
static void rectangle(double left_mm, double right_mm, double vertices[8]) {
  const double corners_mm[8] = {left_mm, 0.0, right_mm, 0.0, right_mm, 49.5, left_mm, 49.5};
  int k;
  for (k = 0; k < 8; ++k) vertices[k] = corners_mm[k] * mm;
}

static bempd_model* create_plate(void) {
  bempd_model* model = NULL;
  bempd_material material;
  int32_t material_id, left, strip, right;
  double vertices[8];
  const double to_the_left = -pull_per_increment;
  const double to_the_right = pull_per_increment;
  /* Midway between two columns of material points; the tips midway between two rows. */
  const double crack[4] = {25.0 * mm, 19.75 * mm, 25.0 * mm, 29.75 * mm};

  ensure(NULL, bempd_model_create(&model));
  ensure(NULL, bempd_material_init(&material, sizeof material));
  material.young_modulus = 30e9;
  material.poisson_ratio = 1.0 / 3.0;
  material.critical_stretch = 8e-4;
  ensure(model, bempd_add_material(model, &material, &material_id));

  /* Elements of at most 5 mm; on the interfaces they follow the lattice by themselves. */
  rectangle(0.0, 20.75, vertices);
  ensure(model, bempd_add_bem_region(model, material_id, 4, vertices, 5.0 * mm, &left));
  rectangle(20.75, 29.25, vertices);
  ensure(model, bempd_add_pd_region(model, material_id, 4, vertices, 0.5 * mm, 4, &strip));
  rectangle(29.25, 50.0, vertices);
  ensure(model, bempd_add_bem_region(model, material_id, 4, vertices, 5.0 * mm, &right));
  ensure(model, bempd_add_crack(model, 2, crack, NULL));

  ensure(model, bempd_prescribe_edge(model, left, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &to_the_left, NULL));
  ensure(model, bempd_prescribe_edge(model, right, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &to_the_right, NULL));
  /* One pin against sliding, on the line of symmetry. */
  ensure(model, bempd_fix_point(model, 0.0, 24.75 * mm, BEMPD_Y, NULL));
  return model;
}

/* Wall time of building the plate's operators and solving once. */
static double seconds_of_one_elastic_solve(void) {
  bempd_model* model = create_plate();
  const double start = seconds_now();
  double seconds;
  ensure(model, bempd_step(model, 1.0, NULL));
  seconds = seconds_now() - start;
  bempd_model_free(model);
  return seconds;
}

typedef struct crack_run {
  double first_break, complete, seconds;
  int64_t cut_bonds;
  bempd_step_report last;
} crack_run;

static void write_stage(bempd_model* model, const bempd_step_report* report, const char* stage) {
  printf("%-10s increment %8.3f  bonds broken %5" PRId64 "  events %5" PRId64 "\n", stage, report->load_factor,
         report->total_broken_bonds, report->total_events);
  ensure(model, bempd_write_snapshot(model, OUTPUT "centre_crack"));
}

/* Event by event to separation, with a snapshot at the first break, on the way and at the end. */
static crack_run pull_apart(bempd_model* model) {
  const int64_t bonds_between_snapshots = 500;
  int64_t next_snapshot = bonds_between_snapshots;
  crack_run run = {0};
  bempd_statistics statistics;
  const double start = seconds_now();

  ensure(model, bempd_prepare(model));
  run.seconds = seconds_now() - start;
  ensure(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  ensure(model, bempd_get_statistics(model, &statistics));
  run.cut_bonds = statistics.cut_bonds;

  ensure(NULL, bempd_step_report_init(&run.last, sizeof run.last));
  do {
    ensure(model, bempd_step_to_next_event(model, increment_limit, &run.last));
    run.seconds += run.last.seconds_total;
    if (run.last.total_events == 1) {
      run.first_break = run.last.load_factor;
      write_stage(model, &run.last, "first");
    } else if (run.last.total_broken_bonds >= next_snapshot && !run.last.separated) {
      next_snapshot += bonds_between_snapshots;
      write_stage(model, &run.last, "growing");
    }
  } while (run.last.stop_reason == BEMPD_STOP_EVENT && !run.last.separated);
  run.complete = run.last.separated ? run.last.load_factor : 0.0;
  write_stage(model, &run.last, run.last.separated ? "complete" : "stopped");
  ensure(model, bempd_write_history(model, OUTPUT "history.csv"));
  return run;
}

typedef struct summary_row {
  const char* quantity;
  double value;
  const char *unit, *reference, *source;
} summary_row;

static void write_summary(const crack_run* run, double seconds_elastic) {
  const summary_row rows[] = {
      {"cut_bonds", (double)run->cut_bonds, "-", "730", "bonds that meet the closed crack"},
      {"first_break_increment", run->first_break, "-", "278.607", "independent prototype; paper: 278"},
      {"complete_increment", run->complete, "-", "308", "prototype re-solved until stable; paper's stepping: 406"},
      {"broken_bonds", (double)run->last.total_broken_bonds, "-", "", ""},
      {"events", (double)run->last.total_events, "-", "", ""},
      {"energy_balance_error", run->last.energy_balance_error, "-", "0", "first law"},
      {"residual", run->last.residual, "-", "0", "equilibrium"},
      {"seconds_total", run->seconds, "s", "", ""},
      {"seconds_one_elastic_solve", seconds_elastic, "s", "", ""},
  };
  FILE* file = fopen(OUTPUT "summary.csv", "w");
  size_t k;
  if (file == NULL) {
    perror(OUTPUT "summary.csv");
    exit(EXIT_FAILURE);
  }
  fprintf(file, "quantity,value,unit,reference,source\n");
  printf("\n%-26s %14s %4s  %-9s %s\n", "quantity", "value", "unit", "reference", "source");
  for (k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
    const summary_row* row = &rows[k];
    fprintf(file, "%s,%.12g,%s,%s,%s\n", row->quantity, row->value, row->unit, row->reference, row->source);
    printf("%-26s %14.7g %4s  %-9s %s\n", row->quantity, row->value, row->unit, row->reference, row->source);
  }
  if (fclose(file) != 0) {
    perror(OUTPUT "summary.csv");
    exit(EXIT_FAILURE);
  }
}

int main(void) {
  bempd_model* plate = create_plate();
  crack_run run;
  /* They may be there already; where they cannot be made, writing the first file says so. */
  mkdir("out", 0777);
  mkdir("out/centre_crack", 0777);
  run = pull_apart(plate);
  write_summary(&run, seconds_of_one_elastic_solve());
  bempd_model_free(plate);
  return EXIT_SUCCESS;
}

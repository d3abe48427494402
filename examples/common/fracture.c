#include "common/fracture.h"

#include <inttypes.h>
#include <stdio.h>

#include "common/common.h"
#include "common/elastic.h"

void step_as_the_paper(bempd_model* model) {
  ensure(model, bempd_set_option_text(model, "paper.mode", "paper"));
  ensure(model, bempd_set_option(model, "paper.increment", 1.0));
  ensure(model, bempd_set_option_text(model, "contact", "none"));
}

static void write_stage(bempd_model* model, const crack_run* run, const char* stage, const char* prefix) {
  printf("# %-9s load factor %8.3f  bonds broken %5" PRId64 "  events %5" PRId64 "\n", stage, run->complete,
         run->last.total_broken_bonds, run->last.total_events);
  /* Runs of examples are repeated at will. */
  ensure(model, bempd_set_option_text(model, "snapshots.existing", "replace"));
  ensure(model, bempd_write_snapshot(model, prefix));
}

static int64_t count_cut_bonds(const bempd_model* model) {
  bempd_statistics statistics;
  ensure(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  ensure(model, bempd_get_statistics(model, &statistics));
  return statistics.cut_bonds;
}

/* out/EXAMPLE/KIND_CASE.csv */
static const char* table_path(const crack_task* task, const char* kind, char path[256]) {
  snprintf(path, 256, "out/%s/%s_%s.csv", task->example, kind, task->case_name);
  return path;
}

/* Keeps the paths; whether two cracks have met. */
static int follow_paths(const crack_task* task) {
  if (task->paths == NULL) return 0;
  crack_paths_update(task->paths);
  return task->meeting_distance > 0.0 && crack_paths_gap(task->paths) <= task->meeting_distance;
}

/* The next event. 0 when there is none: the load or its limit is used up, the body is in two, or its remains have
 * become a mechanism, which the library refuses to solve and leaves as it was. */
static int take_event(bempd_model* model, double limit, crack_run* run) {
  const int64_t broken_before = run->last.total_broken_bonds;
  const bempd_status status = bempd_step_to_next_event(model, limit, &run->last);
  if (status == BEMPD_ERROR_UNSOLVABLE && broken_before > 0) return 0;
  ensure(model, status);
  run->seconds += run->last.seconds_total;
  if (run->last.total_broken_bonds > broken_before) {
    if (broken_before == 0) run->first_break = run->last.load_factor;
    run->complete = run->last.load_factor;
  }
  return run->last.stop_reason == BEMPD_STOP_EVENT && !run->last.separated;
}

crack_run run_crack(bempd_model* model, const crack_task* task) {
  const int64_t bonds_between_snapshots = 250;
  int64_t next_snapshot = 1;
  crack_run run = {0};
  char prefix[256], path[256];
  int going_on;
  const double start = seconds_now();

  snprintf(prefix, sizeof prefix, "out/%s/%s", task->example, task->case_name);
  ensure(model, bempd_prepare(model));
  run.seconds = seconds_now() - start;
  run.cut_bonds = count_cut_bonds(model);

  ensure(NULL, bempd_step_report_init(&run.last, sizeof run.last));
  do {
    const int unbroken = run.last.total_broken_bonds == 0;
    going_on = take_event(model, task->limit, &run);
    if (follow_paths(task)) going_on = 0;
    if (going_on && run.last.total_broken_bonds >= next_snapshot) {
      next_snapshot = run.last.total_broken_bonds + bonds_between_snapshots;
      write_stage(model, &run, unbroken ? "first" : "growing", prefix);
      if (unbroken) write_grid(model, table_path(task, "grid", path), task->side, task->side, 61, 61);
    }
  } while (going_on);
  write_stage(model, &run, "complete", prefix);
  ensure(model, bempd_write_history(model, table_path(task, "history", path)));
  if (task->paths != NULL) crack_paths_write(task->paths, table_path(task, "path", path));
  return run;
}

double first_break(bempd_model* model, double limit) {
  bempd_step_report report;
  ensure(NULL, bempd_step_report_init(&report, sizeof report));
  ensure(model, bempd_step_to_next_event(model, limit, &report));
  return report.total_broken_bonds > 0 ? report.load_factor : 0.0;
}

void add_run(summary* table, const char* case_name, const char* scheme, const crack_run* run, known_run known) {
  const summary_row rows[] = {
      {.quantity = "first break",
       .unit = "increment",
       .value = run->first_break,
       .paper = known.paper_first_break,
       .reference = known.prototype_first_break},
      {.quantity = "complete",
       .unit = "increment",
       .value = run->complete,
       .paper = known.paper_complete,
       .reference = known.prototype_complete},
      {.quantity = "bonds cut by the crack", .unit = "-", .value = (double)run->cut_bonds},
      {.quantity = "bonds broken", .unit = "-", .value = (double)run->last.total_broken_bonds},
      {.quantity = "events", .unit = "-", .value = (double)run->last.total_events},
      {.quantity = "energy balance error", .unit = "-", .value = run->last.energy_balance_error},
      {.quantity = "residual", .unit = "-", .value = run->last.residual},
  };
  size_t k;
  for (k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
    summary_row row = rows[k];
    row.case_name = case_name;
    row.scheme = scheme;
    row.seconds = run->seconds;
    if (row.reference != 0.0) row.source = "independent prototype";
    summary_add(table, &row);
  }
}

/* What the examples with cracks do: run a model until it is in two, with snapshots on the way, and list what happened.
 */
#ifndef EXAMPLES_FRACTURE_H
#define EXAMPLES_FRACTURE_H

#include <bempd.h>

#include "common/crack_paths.h"
#include "common/summary.h"

typedef struct crack_run {
  double first_break; /* load factor of the first broken bond */
  double complete;    /* load factor of the last one, when the body is in two or the cracks have met */
  double seconds;     /* wall time with the preparation */
  int64_t cut_bonds;  /* bonds cut by the initial cracks */
  bempd_step_report last;
} crack_run;

/* One solution for each increment of the load factor by 1, after which every overstretched bond breaks at once, as the
 * paper has it. Without this the model goes from event to event. */
void step_as_the_paper(bempd_model* model);

typedef struct crack_task {
  const char *example, *case_name;
  double side;             /* of the square body, for the grid */
  double limit;            /* largest load factor */
  crack_paths* paths;      /* to be kept up to date; may be NULL */
  double meeting_distance; /* stop when paths from two tips come so near; 0 for never */
} crack_task;

/* Goes from event to event until separation, the meeting of two cracks, or the limit. The series out/EXAMPLE/CASE.pvd
 * has the first break, the end and the stages between; history_CASE.csv the history, grid_CASE.csv the displacements at
 * the first break, path_CASE.csv the paths. */
crack_run run_crack(bempd_model* model, const crack_task* task);

/* Load factor of the first break, without breaking more. */
double first_break(bempd_model* model, double limit);

/* Increments known from elsewhere; NULL or 0 for none. */
typedef struct known_run {
  const char *paper_first_break, *paper_complete;
  double prototype_first_break, prototype_complete; /* an independent prototype of the same scheme */
} known_run;

/* The rows that every run has. */
void add_run(summary* table, const char* case_name, const char* scheme, const crack_run* run, known_run known);

#endif

/* What the examples with cracks do: run a model until it is in two, with snapshots on the way, and list what happened.
 */
#ifndef EXAMPLES_FRACTURE_H
#define EXAMPLES_FRACTURE_H

#include <bempd.h>

#include "common/crack_paths.h"
#include "common/summary.h"

typedef struct crack_run {
  double first_break; /* load factor of the first broken bond */
  double complete;    /* load factor at separation; 0 without one */
  double seconds;     /* wall time with the preparation */
  int64_t cut_bonds;  /* bonds cut by the initial cracks */
  bempd_step_report last;
} crack_run;

/* One solution for each increment of the load factor by 1, after which every overstretched bond breaks at once, as the
 * paper has it. Without this the model goes from event to event. */
void step_as_the_paper(bempd_model* model);

/* Goes from event to event until separation or the load factor's limit. A snapshot series out/EXAMPLE/CASE.pvd has the
 * first break, the end and the stages between; out/EXAMPLE/history_CASE.csv the history. paths: may be NULL. */
crack_run run_crack(bempd_model* model, const char* example, const char* case_name, double limit, crack_paths* paths);

/* Load factor of the first break, without breaking more. */
double first_break(bempd_model* model, double limit);

/* Numbers that the paper states; 0 for none. */
typedef struct paper_run {
  double first_break, complete;
} paper_run;

/* The rows that every run has. */
void add_run(summary* table, const char* case_name, const char* scheme, const crack_run* run, paper_run paper);

#endif

/* The table that an example prints and writes to out/NAME/summary.csv; paper_tables.py joins those of all examples. */
#ifndef EXAMPLES_SUMMARY_H
#define EXAMPLES_SUMMARY_H

typedef struct summary summary;

/* One number. Zero, or NULL, means that there is none. */
typedef struct summary_row {
  const char *case_name, *scheme, *quantity, *unit;
  double value;
  double reference;          /* what the value should be; the error is relative to it */
  const char* source;        /* where the reference comes from */
  const char* paper;         /* the value as the paper prints it */
  const char* paper_error;   /* the relative error as the paper prints it [%] */
  double seconds;            /* wall time of the run that gave the value */
  const char* paper_seconds; /* time as the paper prints it */
} summary_row;

summary* summary_open(const char* example);
void summary_add(summary* table, const summary_row* row);
void summary_close(summary* table);

#endif

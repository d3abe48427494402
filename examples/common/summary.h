/* The table that an example prints and writes to out/NAME/summary.csv; paper_tables.py joins those of all examples. */
#ifndef EXAMPLES_SUMMARY_H
#define EXAMPLES_SUMMARY_H

typedef struct summary summary;

/* One number. Zero in a number that is not `value`, or NULL in a text, means that there is none. */
typedef struct summary_row {
  const char *case_name, *scheme, *quantity, *unit;
  double value;
  double reference;     /* what the value should be; the error is relative to it */
  const char* source;   /* where the reference comes from */
  double paper;         /* the value that the paper states */
  double paper_error;   /* the relative error that the paper states [%] */
  double seconds;       /* wall time of the run that gave the value */
  double paper_seconds; /* time that the paper states */
} summary_row;

summary* summary_open(const char* example);
void summary_add(summary* table, const summary_row* row);
void summary_close(summary* table);

#endif

#include "common/summary.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct summary {
  const char* example;
  FILE* file;
};

static void stop_at(const char* path) {
  perror(path);
  exit(EXIT_FAILURE);
}

static const char* text_of(const char* text) { return text == NULL ? "" : text; }

/* An empty cell where there is no number. */
static const char* number_of(double number, int digits, char cell[32]) {
  cell[0] = '\0';
  if (number != 0.0) snprintf(cell, 32, "%.*g", digits, number);
  return cell;
}

summary* summary_open(const char* example) {
  summary* table = malloc(sizeof *table);
  char path[256];
  if (table == NULL) stop_at(example);
  snprintf(path, sizeof path, "out/%s/summary.csv", example);
  table->example = example;
  table->file = fopen(path, "w");
  if (table->file == NULL) stop_at(path);
  fprintf(table->file,
          "example,case,scheme,quantity,unit,value,reference,error_percent,source,paper,paper_error_percent,seconds,"
          "paper_seconds\n");
  printf("%-22s %-9s %-42s %14s %-9s %12s %10s %9s %9s\n", "case", "scheme", "quantity", "value", "unit", "reference",
         "error [%]", "paper", "seconds");
  return table;
}

void summary_add(summary* table, const summary_row* row) {
  char reference[32], error[32], paper[32], paper_error[32], seconds[32], paper_seconds[32];
  const double relative = row->reference == 0.0 ? 0.0 : 100.0 * (row->value / row->reference - 1.0);
  number_of(row->reference, 7, reference);
  if (row->reference == 0.0) {
    error[0] = '\0';
  } else {
    snprintf(error, sizeof error, "%.3g", relative);
  }
  number_of(row->paper, 7, paper);
  number_of(row->paper_error, 3, paper_error);
  number_of(row->seconds, 3, seconds);
  number_of(row->paper_seconds, 3, paper_seconds);
  fprintf(table->file, "%s,\"%s\",%s,\"%s\",%s,%.12g,%s,%s,\"%s\",%s,%s,%s,%s\n", table->example, row->case_name,
          row->scheme, row->quantity, row->unit, row->value, reference, error, text_of(row->source), paper, paper_error,
          seconds, paper_seconds);
  if (paper[0] == '\0' && paper_error[0] != '\0') snprintf(paper, sizeof paper, "%s %%", paper_error);
  printf("%-22s %-9s %-42s %14.7g %-9s %12s %10s %9s %9s\n", row->case_name, row->scheme, row->quantity, row->value,
         row->unit, reference, error, paper, seconds);
}

void summary_close(summary* table) {
  if (fclose(table->file) != 0) stop_at("summary.csv");
  free(table);
}

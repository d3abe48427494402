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
  printf("%-22s %-9s %-48s %14s %-9s %12s %10s %9s %9s\n", "case", "scheme", "quantity", "value", "unit", "reference",
         "error [%]", "paper", "seconds");
  return table;
}

/* Relative to the reference, in percent. */
static const char* error_of(const summary_row* row, char cell[32]) {
  cell[0] = '\0';
  if (row->reference != 0.0) snprintf(cell, 32, "%.3g", 100.0 * (row->value / row->reference - 1.0));
  return cell;
}

static void print_row(const summary_row* row, const char* reference, const char* error, const char* seconds) {
  char paper[32];
  if (row->paper == NULL && row->paper_error != NULL) {
    snprintf(paper, sizeof paper, "%s %%", row->paper_error);
  } else {
    snprintf(paper, sizeof paper, "%s", text_of(row->paper));
  }
  printf("%-22s %-9s %-48s %14.7g %-9s %12s %10s %9s %9s\n", row->case_name, row->scheme, row->quantity, row->value,
         row->unit, reference, error, paper, seconds);
}

void summary_add(summary* table, const summary_row* row) {
  char reference[32], error[32], seconds[32];
  number_of(row->reference, 7, reference);
  error_of(row, error);
  number_of(row->seconds, 3, seconds);
  fprintf(table->file, "%s,\"%s\",%s,\"%s\",%s,%.12g,%s,%s,\"%s\",%s,%s,%s,%s\n", table->example, row->case_name,
          row->scheme, row->quantity, row->unit, row->value, reference, error, text_of(row->source),
          text_of(row->paper), text_of(row->paper_error), seconds, text_of(row->paper_seconds));
  print_row(row, reference, error, seconds);
}

void summary_close(summary* table) {
  if (fclose(table->file) != 0) stop_at("summary.csv");
  free(table);
}

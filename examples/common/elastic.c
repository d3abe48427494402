#include "common/elastic.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/common.h"

double solve(bempd_model* model) {
  const double start = seconds_now();
  ensure(model, bempd_step(model, 1.0, NULL));
  return seconds_now() - start;
}

double displacement_at(bempd_model* model, double x, double y, int component) {
  double place[2], displacement[2];
  place[0] = x;
  place[1] = y;
  ensure(model, bempd_evaluate(model, 1, place, displacement, NULL, NULL));
  return displacement[component - 1];
}

void print_statistics(const bempd_model* model, const char* case_name, const char* scheme, double seconds) {
  bempd_statistics statistics;
  ensure(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  ensure(model, bempd_get_statistics(model, &statistics));
  printf("# case %-16s %-9s BE %4" PRId64 "  MP %5" PRId64 "  bonds %6" PRId64 "  seconds %.4f = boundary %.4f + lattice "
         "%.4f + assembly %.4f + factorization %.4f + solve %.4f + rest\n",
         case_name, scheme, statistics.boundary_nodes, statistics.material_points, statistics.bonds, seconds,
         statistics.seconds_boundary, statistics.seconds_lattice, statistics.seconds_assembly,
         statistics.seconds_factorization, statistics.seconds_solve);
}

static FILE* open_table(const char* kind, const char* example, const char* case_name, const char* scheme,
                        const char* header) {
  char path[256];
  FILE* file;
  snprintf(path, sizeof path, "out/%s/%s_%s_%s.csv", example, kind, case_name, scheme);
  file = fopen(path, "w");
  if (file == NULL) {
    perror(path);
    exit(EXIT_FAILURE);
  }
  fprintf(file, "%s\n", header);
  return file;
}

static void close_table(FILE* file) {
  if (fclose(file) == 0) return;
  perror("out");
  exit(EXIT_FAILURE);
}

void write_line(bempd_model* model, const char* example, const char* case_name, const char* scheme, double length,
                double y) {
  enum { places = 41 };
  double points[places][2], displacement[places][2];
  FILE* file = open_table("line", example, case_name, scheme, "x,u1,u2");
  int k;
  for (k = 0; k < places; ++k) {
    points[k][0] = length * k / (places - 1);
    points[k][1] = y;
  }
  ensure(model, bempd_evaluate(model, places, points[0], displacement[0], NULL, NULL));
  for (k = 0; k < places; ++k) {
    fprintf(file, "%.12g,%.12g,%.12g\n", points[k][0], displacement[k][0], displacement[k][1]);
  }
  close_table(file);
}

void write_fields(bempd_model* model, const char* example, const char* case_name, const char* scheme, double length,
                  double height) {
  enum { columns = 101, rows = 21 };
  static double points[columns * rows][2], displacement[columns * rows][2];
  FILE* file = open_table("grid", example, case_name, scheme, "x,y,u1,u2");
  char prefix[256];
  int i, j, k;
  for (j = 0; j < rows; ++j) {
    for (i = 0; i < columns; ++i) {
      points[j * columns + i][0] = length * i / (columns - 1);
      points[j * columns + i][1] = height * j / (rows - 1);
    }
  }
  ensure(model, bempd_evaluate(model, columns * rows, points[0], displacement[0], NULL, NULL));
  for (k = 0; k < columns * rows; ++k) {
    fprintf(file, "%.12g,%.12g,%.12g,%.12g\n", points[k][0], points[k][1], displacement[k][0], displacement[k][1]);
  }
  close_table(file);
  snprintf(prefix, sizeof prefix, "out/%s/case_%s_%s", example, case_name, scheme);
  ensure(model, bempd_write_snapshot(model, prefix));
}

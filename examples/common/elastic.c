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
  printf("# case %-16s %-9s BE %4" PRId64 "  MP %5" PRId64 "  bonds %6" PRId64
         "  seconds %.4f = boundary %.4f + lattice "
         "%.4f + assembly %.4f + factorization %.4f + solve %.4f + rest\n",
         case_name, scheme, statistics.boundary_nodes, statistics.material_points, statistics.bonds, seconds,
         statistics.seconds_boundary, statistics.seconds_lattice, statistics.seconds_assembly,
         statistics.seconds_factorization, statistics.seconds_solve);
}

static void stop_at(const char* path) {
  perror(path);
  exit(EXIT_FAILURE);
}

static FILE* open_table(const char* path, const char* header) {
  FILE* file = fopen(path, "w");
  if (file == NULL) stop_at(path);
  fprintf(file, "%s\n", header);
  return file;
}

/* Displacements at the places, which the caller frees. */
static double* evaluate(bempd_model* model, int count, const double* points) {
  double* displacement = malloc(2 * (size_t)count * sizeof *displacement);
  if (displacement == NULL) stop_at("displacement");
  ensure(model, bempd_evaluate(model, count, points, displacement, NULL, NULL));
  return displacement;
}

void write_line(bempd_model* model, const char* path, double length, double y) {
  enum { places = 41 };
  double points[places][2];
  double* displacement;
  FILE* file = open_table(path, "x,u1,u2");
  int k;
  for (k = 0; k < places; ++k) {
    points[k][0] = length * k / (places - 1);
    points[k][1] = y;
  }
  displacement = evaluate(model, places, points[0]);
  for (k = 0; k < places; ++k) {
    fprintf(file, "%.12g,%.12g,%.12g\n", points[k][0], displacement[2 * k], displacement[2 * k + 1]);
  }
  free(displacement);
  if (fclose(file) != 0) stop_at(path);
}

void write_grid(bempd_model* model, const char* path, double length, double height, int columns, int rows) {
  const int count = columns * rows;
  double* points = malloc(2 * (size_t)count * sizeof *points);
  double* displacement;
  FILE* file = open_table(path, "x,y,u1,u2");
  int k;
  if (points == NULL) stop_at(path);
  for (k = 0; k < count; ++k) {
    points[2 * k] = length * (k % columns) / (columns - 1);
    points[2 * k + 1] = height * (k / columns) / (rows - 1);
  }
  displacement = evaluate(model, count, points);
  for (k = 0; k < count; ++k) {
    fprintf(file, "%.12g,%.12g,%.12g,%.12g\n", points[2 * k], points[2 * k + 1], displacement[2 * k],
            displacement[2 * k + 1]);
  }
  free(displacement);
  free(points);
  if (fclose(file) != 0) stop_at(path);
}

void write_strip(bempd_model* model, const char* example, const char* case_name, const char* scheme, double length,
                 double height) {
  char path[256];
  snprintf(path, sizeof path, "out/%s/line_%s_%s.csv", example, case_name, scheme);
  write_line(model, path, length, 0.5 * height);
  snprintf(path, sizeof path, "out/%s/grid_%s_%s.csv", example, case_name, scheme);
  write_grid(model, path, length, height, 101, 21);
  snprintf(path, sizeof path, "out/%s/case_%s_%s", example, case_name, scheme);
  ensure(model, bempd_set_option_text(model, "snapshots.existing", "replace"));
  ensure(model, bempd_write_snapshot(model, path));
}

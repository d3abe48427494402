#include "common/crack_paths.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/common.h"

typedef struct broken_bond {
  double x, y;
  int tip;
} broken_bond;

struct crack_paths {
  bempd_model* model;
  int32_t region;
  int tip_count;
  double* tips;
  int64_t bond_count;
  int32_t* points; /* [bond_count][2] */
  int32_t* states;
  int32_t* states_before;
  double* positions;
  broken_bond* broken; /* in the order of breaking */
  int64_t broken_count;
  double gap; /* between bonds of different tips */
};

static void* allocate(size_t count, size_t size) {
  void* memory = calloc(count > 0 ? count : 1, size);
  if (memory != NULL) return memory;
  perror("crack paths");
  exit(EXIT_FAILURE);
}

crack_paths* crack_paths_open(bempd_model* model, int32_t region, int tip_count, const double* tips) {
  crack_paths* paths = allocate(1, sizeof *paths);
  int64_t points;
  paths->model = model;
  paths->region = region;
  paths->tip_count = tip_count;
  paths->gap = HUGE_VAL;
  paths->tips = allocate(2 * (size_t)tip_count, sizeof *paths->tips);
  memcpy(paths->tips, tips, 2 * (size_t)tip_count * sizeof *tips);
  ensure(model, bempd_bond_count(model, region, &paths->bond_count));
  ensure(model, bempd_node_count(model, region, &points));
  paths->points = allocate(2 * (size_t)paths->bond_count, sizeof *paths->points);
  paths->states = allocate((size_t)paths->bond_count, sizeof *paths->states);
  paths->states_before = allocate((size_t)paths->bond_count, sizeof *paths->states_before);
  paths->broken = allocate((size_t)paths->bond_count, sizeof *paths->broken);
  paths->positions = allocate(2 * (size_t)points, sizeof *paths->positions);
  ensure(model, bempd_copy_field(model, region, BEMPD_POSITION, 2 * points, paths->positions));
  ensure(model, bempd_copy_bonds(model, region, paths->bond_count, paths->points, paths->states_before));
  return paths;
}

static broken_bond middle_of(const crack_paths* paths, int64_t bond) {
  const double* first = &paths->positions[2 * paths->points[2 * bond]];
  const double* second = &paths->positions[2 * paths->points[2 * bond + 1]];
  broken_bond middle = {0.5 * (first[0] + second[0]), 0.5 * (first[1] + second[1]), 0};
  return middle;
}

/* Square of the distance from a bond to a place. */
static double square_to(const broken_bond* bond, double x, double y) {
  const double across = bond->x - x, up = bond->y - y;
  return across * across + up * up;
}

/* The tip that is nearest itself or through one of the bonds that broke before. */
static int nearest_tip(const crack_paths* paths, const broken_bond* bond, int64_t broken_before) {
  double nearest = HUGE_VAL; /* squares */
  int tip = 0, t;
  int64_t k;
  for (t = 0; t < paths->tip_count; ++t) {
    const double distance = square_to(bond, paths->tips[2 * t], paths->tips[2 * t + 1]);
    if (distance < nearest) nearest = distance, tip = t;
  }
  for (k = 0; k < broken_before; ++k) {
    const double distance = square_to(bond, paths->broken[k].x, paths->broken[k].y);
    if (distance < nearest) nearest = distance, tip = paths->broken[k].tip;
  }
  return tip;
}

/* How near the newest bonds come to those of other tips. */
static void update_gap(crack_paths* paths, int64_t broken_before) {
  double least = HUGE_VAL;
  int64_t i, k;
  for (i = broken_before; i < paths->broken_count; ++i) {
    for (k = 0; k < i; ++k) {
      double square;
      if (paths->broken[i].tip == paths->broken[k].tip) continue;
      square = square_to(&paths->broken[i], paths->broken[k].x, paths->broken[k].y);
      if (square < least) least = square;
    }
  }
  paths->gap = fmin(paths->gap, sqrt(least));
}

void crack_paths_update(crack_paths* paths) {
  const int64_t broken_before = paths->broken_count;
  int64_t bond;
  ensure(paths->model, bempd_copy_bonds(paths->model, paths->region, paths->bond_count, NULL, paths->states));
  for (bond = 0; bond < paths->bond_count; ++bond) {
    if (paths->states[bond] == BEMPD_BOND_BROKEN && paths->states_before[bond] == BEMPD_BOND_INTACT) {
      broken_bond* broken = &paths->broken[paths->broken_count++];
      *broken = middle_of(paths, bond);
      broken->tip = nearest_tip(paths, broken, broken_before);
    }
  }
  update_gap(paths, broken_before);
  memcpy(paths->states_before, paths->states, (size_t)paths->bond_count * sizeof *paths->states);
}

double crack_paths_direction(const crack_paths* paths, int tip, double reach) {
  const double degrees = 180.0 / acos(-1.0);
  double xx = 0.0, xy = 0.0, yy = 0.0, x_sum = 0.0, y_sum = 0.0, angle;
  int64_t k;
  for (k = 0; k < paths->broken_count; ++k) {
    const double x = paths->broken[k].x - paths->tips[2 * tip];
    const double y = paths->broken[k].y - paths->tips[2 * tip + 1];
    if (paths->broken[k].tip != tip) continue;
    if (hypot(x, y) > reach) break;
    xx += x * x, xy += x * y, yy += y * y;
    x_sum += x, y_sum += y;
  }
  /* The main axis of the second moments, pointing to where the bonds are. */
  angle = 0.5 * atan2(2.0 * xy, xx - yy);
  if (x_sum * cos(angle) + y_sum * sin(angle) < 0.0) angle += acos(-1.0);
  return degrees * atan2(sin(angle), cos(angle));
}

double crack_paths_height(const crack_paths* paths, int tip, double x, double width) {
  double sum = 0.0;
  int64_t count = 0, k;
  for (k = 0; k < paths->broken_count; ++k) {
    if (paths->broken[k].tip != tip || fabs(paths->broken[k].x - x) > 0.5 * width) continue;
    sum += paths->broken[k].y;
    ++count;
  }
  return count > 0 ? sum / (double)count : 0.0;
}

double crack_paths_gap(const crack_paths* paths) { return paths->gap; }

void crack_paths_write(const crack_paths* paths, const char* path) {
  FILE* file = fopen(path, "w");
  int64_t k;
  if (file == NULL) {
    perror(path);
    exit(EXIT_FAILURE);
  }
  fprintf(file, "tip,x,y\n");
  for (k = 0; k < paths->broken_count; ++k) {
    fprintf(file, "%d,%.9g,%.9g\n", paths->broken[k].tip + 1, paths->broken[k].x, paths->broken[k].y);
  }
  if (fclose(file) != 0) {
    perror(path);
    exit(EXIT_FAILURE);
  }
}

void crack_paths_close(crack_paths* paths) {
  if (paths == NULL) return;
  free(paths->tips);
  free(paths->points);
  free(paths->states);
  free(paths->states_before);
  free(paths->broken);
  free(paths->positions);
  free(paths);
}

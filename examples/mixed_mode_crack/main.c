/*
 * The paper's second crack example: the crack of centre_crack turned by 45 degrees, so that it opens and slides. SI
 * units. Writes its files to out/mixed_mode_crack/.
 *
 *   example_mixed_mode_crack [symmetric] [paper]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/common.h"
#include "common/cracked_plate.h"
#include "common/fracture.h"
#include "common/summary.h"

#define EXAMPLE "mixed_mode_crack"

static const double mm = 1e-3;

/* Angle between crack and its first growth under KI = KII by the criterion of largest hoop stress (Erdogan and Sih
 * 1963): the root of KI sin a + KII (3 cos a - 1) = 0. */
static const double kink_reference = 53.13;

/* The crack must keep off the material points. With points on the corners of the cells, 101 rows and 42 columns, its
 * line runs between them. With points in the cells the line meets points, which stay bonded to both faces. */
static cracked_plate create_layout(int cells) {
  const double half = 5.0 * mm * sqrt(0.5), centre = 25.0 * mm;
  const double half_strip = (cells ? 10.0 : 10.25) * mm;
  cracked_plate plate;
  plate.height = 50.0 * mm;
  plate.strip_left = centre - half_strip;
  plate.strip_right = centre + half_strip;
  plate.crack[0] = plate.crack[1] = centre - half;
  plate.crack[2] = plate.crack[3] = centre + half;
  return plate;
}

/* Angles at which the crack leaves its own direction, over the first ten spacings. */
static void add_kinks(summary* table, const char* case_name, const char* scheme, const crack_paths* paths) {
  const double reach = 10.0 * cracked_plate_spacing;
  const double lower = fabs(remainder(crack_paths_direction(paths, 0, reach) - -135.0, 360.0));
  const double upper = fabs(remainder(crack_paths_direction(paths, 1, reach) - 45.0, 360.0));
  const summary_row rows[] = {{.quantity = "kink at the lower tip", .value = lower},
                              {.quantity = "kink at the upper tip", .value = upper}};
  int k;
  for (k = 0; k < 2; ++k) {
    summary_row row = rows[k];
    row.case_name = case_name;
    row.scheme = scheme;
    row.unit = "degrees";
    row.reference = kink_reference;
    row.source = "largest hoop stress";
    summary_add(table, &row);
  }
}

static void run(summary* table, const char* scheme, const char* stepping, known_run known) {
  const cracked_plate plate = create_layout(0);
  bempd_model* model = cracked_plate_create(scheme, &plate);
  crack_paths* paths;
  char name[64];
  crack_task task = {.example = EXAMPLE, .case_name = name, .side = plate.height};
  crack_run result;
  if (strcmp(scheme, "paper") == 0) ensure(model, bempd_set_option_text(model, "paper.lattice", "nodal"));
  if (strcmp(stepping, "increments") == 0) step_as_the_paper(model);
  snprintf(name, sizeof name, "%s_%s", stepping, scheme);
  paths = crack_paths_open(model, cracked_plate_strip, 2, plate.crack);
  task.paths = paths;
  task.limit = cracked_plate_increment_limit;
  result = run_crack(model, &task);
  add_run(table, stepping, scheme, &result, known);
  add_kinks(table, stepping, scheme, paths);
  crack_paths_close(paths);
  bempd_model_free(model);
}

/* Scheme paper with its points in the cells, on the crack's line, up to the first increment at which bonds break. */
static void run_bridged(summary* table) {
  const cracked_plate plate = create_layout(1);
  bempd_model* model = cracked_plate_create("paper", &plate);
  const double start = seconds_now();
  summary_row row = {.case_name = "increments, points on the crack",
                     .scheme = "paper",
                     .quantity = "first break",
                     .unit = "increment",
                     .paper = "309"};
  step_as_the_paper(model);
  row.value = first_break(model, cracked_plate_increment_limit);
  row.seconds = seconds_now() - start;
  summary_add(table, &row);
  bempd_model_free(model);
}

int main(int argument_count, char** arguments) {
  const known_run events = {NULL, NULL, 0, 0};
  const known_run symmetric = {"309", "454", 278, 390};
  const known_run uncorrected = {"309", "454", 278, 392};
  const scheme_list schemes = schemes_to_run(argument_count, arguments);
  summary* table;
  int s;
  make_output_folder(EXAMPLE);
  table = summary_open(EXAMPLE);
  for (s = 0; s < schemes.count; ++s) {
    if (strcmp(schemes.names[s], "symmetric") == 0) {
      run(table, "symmetric", "events", events);
      run(table, "symmetric", "increments", symmetric);
    } else {
      run(table, "paper", "increments", uncorrected);
      run_bridged(table);
    }
  }
  summary_close(table);
  return EXIT_SUCCESS;
}

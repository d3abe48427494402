/*
 * The paper's third crack example: two edge cracks, one above the other, grow from opposite sides of a pulled plate and
 * turn towards each other. SI units. Writes its files to out/two_edge_cracks/.
 *
 *   example_two_edge_cracks [symmetric] [paper]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/common.h"
#include "common/crack_paths.h"
#include "common/fracture.h"
#include "common/summary.h"

#define EXAMPLE "two_edge_cracks"

enum { lower_block = 1, band = 2, upper_block = 3 };

static const double mm = 1e-3;
static const double side = 50e-3, spacing = 0.5e-3, young_modulus = 72e9;
/* The load factor counts increments of the traction on the upper edge. */
static const double traction_per_increment = 0.1e6;
static const double increment_limit = 200.0;
/* Our reading of the paper's "fracture toughness 3288.76 N/mm^1.5", which as it stands needs 200 times the paper's
 * load: a fracture energy of 3288.76 mJ/m^2 [J/m^2]. */
static const double fracture_energy = 3.28876;

/* Critical stretch of a fracture energy with the paper's constant (Eq. 15; plane stress). */
static double critical_stretch(double energy) {
  const double pi = acos(-1.0), horizon = 4.0 * spacing;
  return sqrt(1024.0 * pi * energy / (7.0 * (120.0 * pi - 133.0) * young_modulus * horizon));
}

typedef struct layout {
  double band_bottom, band_top;
  double left_crack[4], right_crack[4]; /* from the edge to the tip */
} layout;

/* The cracks run midway between two rows of points. */
static layout create_layout(const char* scheme) {
  const int cells = strcmp(scheme, "paper") == 0;
  const double half_band = (cells ? 8.0 : 7.75) * mm, middle = 0.5 * side, length = 2.0 * mm, half_offset = 1.0 * mm;
  const layout result = {middle - half_band,
                         middle + half_band,
                         {0.0, middle - half_offset, length, middle - half_offset},
                         {side, middle + half_offset, side - length, middle + half_offset}};
  return result;
}

typedef enum lower_edge {
  supported, /* the lower edge does not move in y, as the paper has it */
  balanced   /* it carries the traction of the upper edge, so that half a turn brings the scene onto itself */
} lower_edge;

static void support(bempd_model* model, lower_edge edge) {
  const double downwards = -traction_per_increment;
  ensure(model, bempd_fix_point(model, 0.5 * side, 0.0, BEMPD_X, NULL));
  if (edge == supported) {
    ensure(model, bempd_fix_edge(model, lower_block, 1, BEMPD_Y, NULL));
  } else {
    ensure(model, bempd_add_traction(model, lower_block, 1, 0.0, 1.0, BEMPD_Y, 1, NULL, &downwards, NULL));
    ensure(model, bempd_fix_point(model, 0.5 * side, 0.0, BEMPD_Y, NULL));
    ensure(model, bempd_fix_point(model, 0.5 * side, side, BEMPD_X, NULL));
  }
}

static bempd_model* create_plate(const char* scheme, double energy, lower_edge edge) {
  const double element_length = 5.0 * mm; /* nodes every 2.5 mm */
  const layout plate = create_layout(scheme);
  bempd_model* model = create_model(scheme);
  const int32_t material = add_material(model, young_modulus, critical_stretch(energy));
  double vertices[8];

  rectangle(0.0, 0.0, side, plate.band_bottom, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, element_length, NULL));
  rectangle(0.0, plate.band_bottom, side, plate.band_top, vertices);
  ensure(model, bempd_add_pd_region(model, material, 4, vertices, spacing, 4, NULL));
  rectangle(0.0, plate.band_top, side, side, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, element_length, NULL));
  ensure(model, bempd_add_crack(model, 2, plate.left_crack, NULL));
  ensure(model, bempd_add_crack(model, 2, plate.right_crack, NULL));
  ensure(model, bempd_add_traction(model, upper_block, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &traction_per_increment, NULL));
  support(model, edge);
  return model;
}

static crack_paths* follow(bempd_model* model, const char* scheme) {
  const layout plate = create_layout(scheme);
  double tips[4];
  memcpy(&tips[0], &plate.left_crack[2], 2 * sizeof *tips);
  memcpy(&tips[2], &plate.right_crack[2], 2 * sizeof *tips);
  return crack_paths_open(model, band, 2, tips);
}

/* Heights of both paths over y = 25 mm, each at its distance from its own edge: half a turn maps one on the other. */
static void print_paths(const crack_paths* paths) {
  const double from_edge_mm[] = {3, 7, 11, 15, 19, 22, 23, 24, 24.75};
  size_t k;
  printf("# %-28s %8s %8s\n", "distance from the edge [mm]", "left", "right");
  for (k = 0; k < sizeof from_edge_mm / sizeof from_edge_mm[0]; ++k) {
    const double x = from_edge_mm[k] * mm;
    const double left = crack_paths_height(paths, 0, x, spacing);
    const double right = crack_paths_height(paths, 1, side - x, spacing);
    printf("# %-28g", from_edge_mm[k]);
    if (left > 0.0) printf(" %+8.2f", (left - 0.5 * side) / mm);
    if (right > 0.0) printf(" %+8.2f", (right - 0.5 * side) / mm);
    printf("\n");
  }
}

/* Runs from event to event until the cracks meet. */
static void run_events(summary* table, const char* scheme) {
  const known_run known = {"46", "83", 0, 0};
  bempd_model* model = create_plate(scheme, fracture_energy, balanced);
  crack_paths* paths = follow(model, scheme);
  char name[64];
  crack_task task = {.example = EXAMPLE, .case_name = name, .side = side, .limit = increment_limit, .paths = paths};
  crack_run result;
  snprintf(name, sizeof name, "events_%s", scheme);
  task.meeting_distance = spacing;
  /* Bonds that are nearly as stretched as the worst break with it, so that both cracks go on growing. */
  ensure(model, bempd_set_option(model, "crack.tie_share", 0.02));
  result = run_crack(model, &task);
  add_run(table, "events", scheme, &result, known);
  print_paths(paths);
  crack_paths_close(paths);
  bempd_model_free(model);
}

/* Runs in the paper's way: one solution for each increment. */
static void run_increments(summary* table, const char* scheme) {
  const known_run known = {"46", "83", 47, 81};
  bempd_model* model = create_plate(scheme, fracture_energy, supported);
  crack_paths* paths = follow(model, scheme);
  char name[64];
  crack_task task = {.example = EXAMPLE, .case_name = name, .side = side, .limit = increment_limit, .paths = paths};
  crack_run result;
  snprintf(name, sizeof name, "increments_%s", scheme);
  step_as_the_paper(model);
  result = run_crack(model, &task);
  add_run(table, "increments", scheme, &result, known);
  print_paths(paths);
  crack_paths_close(paths);
  bempd_model_free(model);
}

/* First break under another reading of the paper's toughness, as a traction. */
static void add_reading(summary* table, const char* scheme, const char* reading, double toughness) {
  bempd_model* model = create_plate(scheme, toughness * toughness / young_modulus, supported);
  const double start = seconds_now();
  summary_row row = {
      .case_name = reading, .scheme = scheme, .quantity = "traction at the first break", .unit = "MPa", .paper = "4.6"};
  row.value = first_break(model, 1e9) * traction_per_increment / 1e6;
  row.seconds = seconds_now() - start;
  summary_add(table, &row);
  bempd_model_free(model);
}

int main(int argument_count, char** arguments) {
  const scheme_list schemes = schemes_to_run(argument_count, arguments);
  summary* table;
  int s;
  make_output_folder(EXAMPLE);
  table = summary_open(EXAMPLE);
  for (s = 0; s < schemes.count; ++s) {
    if (strcmp(schemes.names[s], "symmetric") == 0) run_events(table, schemes.names[s]);
    run_increments(table, schemes.names[s]);
    add_reading(table, schemes.names[s], "K = 3288.76 N/mm^1.5", 3288.76 * 1e6 * sqrt(mm));
    add_reading(table, schemes.names[s], "K = 3.28876 MPa m^0.5", 3.28876e6);
  }
  summary_close(table);
  return EXIT_SUCCESS;
}

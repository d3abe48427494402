/*
 * The paper's example 2 (table 3): the strip of example 1, loaded downwards at its right end. SI units. Writes its
 * files to out/shear/.
 *
 *   example_shear [symmetric] [paper]
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/common.h"
#include "common/elastic.h"
#include "common/half_strip.h"
#include "common/summary.h"

enum { case_count = 4 };

static const double force = 100e3;

/* What the paper states of each case [%], [s]. */
static const struct {
  const char *interface_error, *result_error, *seconds;
} paper[case_count] = {
    {"5.99", "0.82", "0.14"}, {"11.11", "0.51", "0.41"}, {"0.86", "0.05", "1.05"}, {"0.48", "0.12", "9.55"}};

/* True u2 at the right end's mid point under a uniform end shear: finite and boundary elements, extrapolated, agree to
 * 2e-6. */
static const double sheared_end = -5.13570e-4;

/* Deflection of the slender cantilever (Eq. 31). */
static double euler_bernoulli(double x) {
  const double height = half_strip_height;
  const double second_moment = height * height * height / 12.0; /* thickness 1 m */
  return -force * x * x * (3.0 * half_strip_length - x) / (6.0 * half_strip_young_modulus * second_moment);
}

/* Deflection with that by shear of a rectangular section, shear coefficient 5/6 (Timoshenko 1921). */
static double timoshenko(double x) {
  const double shear_modulus = half_strip_young_modulus / (2.0 * (1.0 + 1.0 / 3.0));
  return euler_bernoulli(x) - force * x / (5.0 / 6.0 * shear_modulus * half_strip_height);
}

/* The paper's load: a force on the upper right corner. On a lattice of cells the last point lies inside the corner. */
static bempd_model* create_with_corner_force(const char* scheme, const half_strip_case* mesh) {
  bempd_model* model = half_strip_create(scheme, mesh, left_end_clamped);
  const double inset = strcmp(scheme, "paper") == 0 ? 0.5 * mesh->spacing : 0.0;
  ensure(model, bempd_add_point_force(model, half_strip_length - inset, half_strip_height - inset, BEMPD_Y, 0.0, -force,
                                      NULL));
  return model;
}

static bempd_model* create_with_end_shear(const char* scheme, const half_strip_case* mesh) {
  bempd_model* model = half_strip_create(scheme, mesh, left_end_clamped);
  const double traction = -force / half_strip_height;
  ensure(model, bempd_add_traction(model, half_strip_pd, 2, 0.0, 1.0, BEMPD_Y, 1, NULL, &traction, NULL));
  return model;
}

/* Only the centre line is compared: under a point force the corner itself sinks without limit as the mesh is refined.
 */
static void run_corner_force(summary* table, const char* scheme, int index) {
  const half_strip_case* mesh = &half_strip_cases[index];
  bempd_model* model = create_with_corner_force(scheme, mesh);
  const double seconds = solve(model);
  const double middle = 0.5 * half_strip_length, half_height = 0.5 * half_strip_height;
  const double at_interface = displacement_at(model, middle, half_height, 2);
  const double at_end = displacement_at(model, half_strip_length, half_height, 2);
  const summary_row rows[] = {
      {mesh->name, scheme, "corner force: u2 at the interface against Eq. 31", "m", at_interface,
       euler_bernoulli(middle), "Euler-Bernoulli", NULL, paper[index].interface_error, seconds, paper[index].seconds},
      {mesh->name, scheme, "corner force: u2 at the end against Eq. 31", "m", at_end,
       euler_bernoulli(half_strip_length), "Euler-Bernoulli", NULL, paper[index].result_error, seconds,
       paper[index].seconds},
      {mesh->name, scheme, "corner force: u2 at the interface", "m", at_interface, timoshenko(middle), "Timoshenko",
       NULL, NULL, seconds, NULL},
      {mesh->name, scheme, "corner force: u2 at the end", "m", at_end, timoshenko(half_strip_length), "Timoshenko",
       NULL, NULL, seconds, NULL},
  };
  size_t k;
  for (k = 0; k < sizeof rows / sizeof rows[0]; ++k) summary_add(table, &rows[k]);
  print_statistics(model, mesh->name, scheme, seconds);
  write_strip(model, "shear", mesh->name, scheme, half_strip_length, half_strip_height);
  bempd_model_free(model);
}

/* Eqs. 26 and 27 to the letter: t = -b dx at every interface node, and one traction a node also at corners. The other
 * runs of scheme paper add up forces, with two tractions at a corner. */
static void run_literally(summary* table, int index) {
  const half_strip_case* mesh = &half_strip_cases[index];
  bempd_model* model = create_with_corner_force("paper", mesh);
  const double middle = 0.5 * half_strip_length, half_height = 0.5 * half_strip_height;
  char name[32];
  summary_row row = {.case_name = name, .scheme = "paper", .unit = "m", .source = "Euler-Bernoulli"};
  snprintf(name, sizeof name, "%s (literally)", mesh->name);
  ensure(model, bempd_set_option_text(model, "paper.interface", "traction"));
  ensure(model, bempd_set_option_text(model, "paper.corner_tractions", "one"));
  row.seconds = solve(model);
  row.paper_seconds = paper[index].seconds;
  row.quantity = "corner force: u2 at the interface against Eq. 31";
  row.value = displacement_at(model, middle, half_height, 2);
  row.reference = euler_bernoulli(middle);
  row.paper_error = paper[index].interface_error;
  summary_add(table, &row);
  row.quantity = "corner force: u2 at the end against Eq. 31";
  row.value = displacement_at(model, half_strip_length, half_height, 2);
  row.reference = euler_bernoulli(half_strip_length);
  row.paper_error = paper[index].result_error;
  summary_add(table, &row);
  bempd_model_free(model);
}

static void run_end_shear(summary* table, const char* scheme, int index) {
  const half_strip_case* mesh = &half_strip_cases[index];
  bempd_model* model = create_with_end_shear(scheme, mesh);
  const double seconds = solve(model);
  const summary_row row = {mesh->name,
                           scheme,
                           "uniform end shear: u2 at the end",
                           "m",
                           displacement_at(model, half_strip_length, 0.5 * half_strip_height, 2),
                           sheared_end,
                           "plane elasticity",
                           NULL,
                           NULL,
                           seconds,
                           NULL};
  summary_add(table, &row);
  bempd_model_free(model);
}

int main(int argument_count, char** arguments) {
  const scheme_list schemes = schemes_to_run(argument_count, arguments);
  summary* table;
  int s, k;
  make_output_folder("shear");
  table = summary_open("shear");
  for (s = 0; s < schemes.count; ++s) {
    for (k = 0; k < case_count; ++k) {
      run_corner_force(table, schemes.names[s], k);
      run_end_shear(table, schemes.names[s], k);
      if (strcmp(schemes.names[s], "paper") == 0) run_literally(table, k);
    }
  }
  summary_close(table);
  return EXIT_SUCCESS;
}

/*
 * The paper's example 1 (tables 1 and 2): a strip, half boundary elements and half peridynamics, pulled at its right
 * end. SI units. Writes its files to out/tension/.
 *
 *   example_tension [symmetric] [paper]
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/common.h"
#include "common/elastic.h"
#include "common/half_strip.h"
#include "common/summary.h"

/* The load P of 1050 kN acts on an end of 0.2 m x 1 m. */
static const double traction = 5.25e6;

/* What the paper states of each case [%], [s]; it has no errors of cases 1 and 2. */
static const struct {
  const char *interface_error, *result_error, *seconds;
} paper[half_strip_case_count] = {{NULL, NULL, NULL},
                                  {NULL, NULL, NULL},
                                  {"2.90", "0.31", "1.08"},
                                  {"2.89", "0.12", "9.34"},
                                  {"2.65", "0.13", "10.02"}};

/* Elongation at x of a bar (Eq. 29). */
static double bar(double x) { return traction * x / half_strip_young_modulus; }

/* True u1 at the right end's mid point when the left end is clamped: finite and boundary elements, extrapolated, agree
 * to 2e-6. At mid length the field of the clamped end has died out, so there u1 lies a bar's half elongation below. */
static const double clamped_end = 5.23431e-5;

static bempd_model* create_pulled_strip(const char* scheme, const half_strip_case* mesh, left_end support) {
  bempd_model* model = half_strip_create(scheme, mesh, support);
  ensure(model, bempd_add_traction(model, half_strip_pd, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &traction, NULL));
  return model;
}

static void run_clamped(summary* table, const char* scheme, int index) {
  const half_strip_case* mesh = &half_strip_cases[index];
  bempd_model* model = create_pulled_strip(scheme, mesh, left_end_clamped);
  const double seconds = solve(model);
  const double middle = 0.5 * half_strip_length, half_height = 0.5 * half_strip_height;
  const double at_interface = displacement_at(model, middle, half_height, 1);
  const double at_end = displacement_at(model, half_strip_length, half_height, 1);
  const summary_row rows[] = {
      {mesh->name, scheme, "clamped: u1 at the interface against PL/EA", "m", at_interface, bar(middle), "Eq. 29", NULL,
       paper[index].interface_error, seconds, paper[index].seconds},
      {mesh->name, scheme, "clamped: u1 at the end against PL/EA", "m", at_end, bar(half_strip_length), "Eq. 29", NULL,
       paper[index].result_error, seconds, paper[index].seconds},
      {mesh->name, scheme, "clamped: u1 at the interface", "m", at_interface, clamped_end - bar(middle),
       "plane elasticity", NULL, NULL, seconds, NULL},
      {mesh->name, scheme, "clamped: u1 at the end", "m", at_end, clamped_end, "plane elasticity", NULL, NULL, seconds,
       NULL},
  };
  size_t k;
  for (k = 0; k < sizeof rows / sizeof rows[0]; ++k) summary_add(table, &rows[k]);
  print_statistics(model, mesh->name, scheme, seconds);
  write_strip(model, "tension", mesh->name, scheme, half_strip_length, half_strip_height);
  bempd_model_free(model);
}

/* Eqs. 26 and 27 to the letter: t = -b dx at every interface node, and one traction a node also at corners. The other
 * runs of scheme paper add up forces, with two tractions at a corner. */
static void run_literally(summary* table, int index) {
  const half_strip_case* mesh = &half_strip_cases[index];
  bempd_model* model = create_pulled_strip("paper", mesh, left_end_clamped);
  const double middle = 0.5 * half_strip_length, half_height = 0.5 * half_strip_height;
  char name[32];
  summary_row row = {.case_name = name, .scheme = "paper", .unit = "m", .source = "Eq. 29"};
  snprintf(name, sizeof name, "%s (literally)", mesh->name);
  ensure(model, bempd_set_option_text(model, "paper.interface", "traction"));
  ensure(model, bempd_set_option_text(model, "paper.corner_tractions", "one"));
  row.seconds = solve(model);
  row.paper_seconds = paper[index].seconds;
  row.quantity = "clamped: u1 at the interface against PL/EA";
  row.value = displacement_at(model, middle, half_height, 1);
  row.reference = bar(middle);
  row.paper_error = paper[index].interface_error;
  summary_add(table, &row);
  row.quantity = "clamped: u1 at the end against PL/EA";
  row.value = displacement_at(model, half_strip_length, half_height, 1);
  row.reference = bar(half_strip_length);
  row.paper_error = paper[index].result_error;
  summary_add(table, &row);
  bempd_model_free(model);
}

/* Free to contract, the strip is in uniaxial stress and Eq. 29 is exact. */
static void run_on_rollers(summary* table, const char* scheme, int index) {
  const half_strip_case* mesh = &half_strip_cases[index];
  bempd_model* model = create_pulled_strip(scheme, mesh, left_end_on_rollers);
  const double seconds = solve(model);
  const double middle = 0.5 * half_strip_length, half_height = 0.5 * half_strip_height;
  const summary_row rows[] = {
      {mesh->name, scheme, "rollers: u1 at the interface", "m", displacement_at(model, middle, half_height, 1),
       bar(middle), "Eq. 29, exact", NULL, NULL, seconds, NULL},
      {mesh->name, scheme, "rollers: u1 at the end", "m", displacement_at(model, half_strip_length, half_height, 1),
       bar(half_strip_length), "Eq. 29, exact", NULL, NULL, seconds, NULL},
  };
  summary_add(table, &rows[0]);
  summary_add(table, &rows[1]);
  bempd_model_free(model);
}

int main(int argument_count, char** arguments) {
  const scheme_list schemes = schemes_to_run(argument_count, arguments);
  summary* table;
  int s, k;
  make_output_folder("tension");
  for (k = 0; k < half_strip_case_count; ++k) {
    printf("case %s as the paper counts: %d BE, %d MP\n", half_strip_cases[k].name,
           half_strip_boundary_nodes(&half_strip_cases[k]), half_strip_material_points(&half_strip_cases[k]));
  }
  table = summary_open("tension");
  for (s = 0; s < schemes.count; ++s) {
    for (k = 0; k < half_strip_case_count; ++k) {
      run_clamped(table, schemes.names[s], k);
      run_on_rollers(table, schemes.names[s], k);
      if (strcmp(schemes.names[s], "paper") == 0) run_literally(table, k);
    }
  }
  summary_close(table);
  return EXIT_SUCCESS;
}

/*
 * The paper's example 3 (tables 4 and 5): the strip with peridynamics in the middle, both ends moved apart by 1 m. SI
 * units. Writes its files to out/stretching/.
 *
 *   example_stretching [symmetric] [paper]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/common.h"
#include "common/elastic.h"
#include "common/summary.h"

static const double length = 1.0, height = 0.2, pull = 1.0;
/* Peridynamics lies between these. */
static const double first_interface = 0.3, second_interface = 0.7;

static const struct {
  const char* name;
  double spacing;
  /* What the paper states [%], [s]. */
  const char *interface_error, *result_error, *seconds;
} cases[] = {
    {"1", 0.05, "13.28", "0.11", "0.11"},
    {"2", 0.01, "1.36", "0.11", "1.22"},
    {"3", 0.005, "0.19", "0.00", "8.92"},
};
enum { case_count = sizeof cases / sizeof cases[0] };

/* Free to contract, the strip is in uniaxial stress, so u1 is linear whatever the modulus. */
static double linear_field(double x) { return pull * (2.0 * x / length - 1.0); }

/* Free edges and far ends are one quadratic element each; the interfaces follow the lattice. */
static bempd_model* create_stretched_strip(const char* scheme, double spacing) {
  bempd_model* model = create_model(scheme);
  const int32_t material = add_material(model, 100e9, 0.0);
  const double to_the_left = -pull, to_the_right = pull;
  int32_t left, middle, right;
  double vertices[8];
  rectangle(0.0, 0.0, first_interface, height, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, length, &left));
  rectangle(first_interface, 0.0, second_interface, height, vertices);
  ensure(model, bempd_add_pd_region(model, material, 4, vertices, spacing, 4, &middle));
  rectangle(second_interface, 0.0, length, height, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, length, &right));
  ensure(model, bempd_prescribe_edge(model, left, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &to_the_left, NULL));
  ensure(model, bempd_prescribe_edge(model, right, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &to_the_right, NULL));
  /* A corner has a node in any case, so the pin does not split the end's one element. */
  ensure(model, bempd_fix_point(model, 0.0, 0.0, BEMPD_Y, NULL));
  return model;
}

/* Boundary nodes and material points as the paper counts them (table 4). */
static void print_counts(int index) {
  const int rows = (int)lround(height / cases[index].spacing);
  const int columns = (int)lround((second_interface - first_interface) / cases[index].spacing);
  printf("case %s as the paper counts: %d BE, %d MP\n", cases[index].name, 2 * (rows + 6),
         rows * columns + 2 * (rows + 1));
}

/* Largest difference from the linear field along the centre line, relative to the pull. */
static double largest_error(bempd_model* model) {
  double worst = 0.0;
  int k;
  for (k = 0; k <= 40; ++k) {
    const double x = length * k / 40;
    worst = fmax(worst, fabs(displacement_at(model, x, 0.5 * height, 1) - linear_field(x)) / pull);
  }
  return worst;
}

static void add_rows(summary* table, bempd_model* model, const char* name, const char* scheme, int index,
                     double seconds) {
  const double quarter = 0.25 * length, half_height = 0.5 * height;
  const summary_row rows[] = {
      {name, scheme, "u1 at the interface", "m", displacement_at(model, first_interface, half_height, 1),
       linear_field(first_interface), "linear field, exact", NULL, cases[index].interface_error, seconds,
       cases[index].seconds},
      {name, scheme, "u1 at the quarter length", "m", displacement_at(model, quarter, half_height, 1),
       linear_field(quarter), "linear field, exact", NULL, cases[index].result_error, seconds, cases[index].seconds},
      {name, scheme, "largest error of u1 over the pull", "-", largest_error(model), 0, NULL, NULL, NULL, seconds,
       NULL},
  };
  size_t k;
  for (k = 0; k < sizeof rows / sizeof rows[0]; ++k) summary_add(table, &rows[k]);
}

/* literally: Eqs. 26 and 27 to the letter, t = -b dx at every interface node, and one traction a node also at corners.
 * The other runs of scheme paper add up forces, with two tractions at a corner. */
static void run_case(summary* table, const char* scheme, int index, int literally) {
  bempd_model* model = create_stretched_strip(scheme, cases[index].spacing);
  char name[32];
  double seconds;
  snprintf(name, sizeof name, literally ? "%s (literally)" : "%s", cases[index].name);
  if (literally) {
    ensure(model, bempd_set_option_text(model, "paper.interface", "traction"));
    ensure(model, bempd_set_option_text(model, "paper.corner_tractions", "one"));
  }
  seconds = solve(model);
  add_rows(table, model, name, scheme, index, seconds);
  if (!literally) {
    print_statistics(model, name, scheme, seconds);
    write_strip(model, "stretching", name, scheme, length, height);
  }
  bempd_model_free(model);
}
int main(int argument_count, char** arguments) {
  const scheme_list schemes = schemes_to_run(argument_count, arguments);
  summary* table;
  int s, k;
  make_output_folder("stretching");
  for (k = 0; k < case_count; ++k) print_counts(k);
  table = summary_open("stretching");
  for (s = 0; s < schemes.count; ++s) {
    for (k = 0; k < case_count; ++k) {
      run_case(table, schemes.names[s], k, 0);
      if (strcmp(schemes.names[s], "paper") == 0) run_case(table, schemes.names[s], k, 1);
    }
  }
  summary_close(table);
  return EXIT_SUCCESS;
}

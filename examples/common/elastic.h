/* What the three examples without cracks do with a model: solve it, say how large it is and where the time went, and
 * write what the pictures need. */
#ifndef EXAMPLES_ELASTIC_H
#define EXAMPLES_ELASTIC_H

#include <bempd.h>

/* Builds the operators and solves for load factor 1; returns the wall time [s]. */
double solve(bempd_model* model);

/* Displacement at a place; 1 for u1, 2 for u2. */
double displacement_at(bempd_model* model, double x, double y, int component);

/* One line on a solved model: sizes, and seconds a stage. */
void print_statistics(const bempd_model* model, const char* case_name, const char* scheme, double seconds);

/* out/EXAMPLE/line_CASE_SCHEME.csv: x, u1, u2 along a horizontal line. */
void write_line(bempd_model* model, const char* example, const char* case_name, const char* scheme, double length,
                double y);

/* out/EXAMPLE/grid_CASE_SCHEME.csv: x, y, u1, u2 all over a rectangle, and a snapshot beside it. */
void write_fields(bempd_model* model, const char* example, const char* case_name, const char* scheme, double length,
                  double height);

#endif

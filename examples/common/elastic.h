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

/* x, u1, u2 along the horizontal line of a body that begins at x = 0; PATH is the table's name. */
void write_line(bempd_model* model, const char* path, double length, double y);

/* x, y, u1, u2 on a grid all over a rectangle with its lower left corner at the origin. */
void write_grid(bempd_model* model, const char* path, double length, double height, int columns, int rows);

/* Writes the data of the case's pictures, out/EXAMPLE/line_CASE_SCHEME.csv and grid_CASE_SCHEME.csv, and a snapshot
 * for ParaView. */
void write_strip(bempd_model* model, const char* example, const char* case_name, const char* scheme, double length,
                 double height);

#endif

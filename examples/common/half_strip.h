/* The body of the paper's examples 1 and 2: a strip of 1.0 x 0.2 m (E = 100 GPa, nu = 1/3, plane stress, thickness 1 m)
 * whose left half is boundary elements and whose right half is peridynamics. */
#ifndef EXAMPLES_HALF_STRIP_H
#define EXAMPLES_HALF_STRIP_H

#include <bempd.h>

enum { half_strip_bem = 1, half_strip_pd = 2 };

extern const double half_strip_length, half_strip_height, half_strip_young_modulus;

/* A discretization of the paper's Table 1; a node distance d means quadratic elements of length 2 d. */
typedef struct half_strip_case {
  const char* name;
  double vertical_nodes; /* node distance on the left end and on the interface [m] */
  double long_nodes;     /* node distance on the lower and upper edge of the boundary elements [m] */
  double spacing;        /* lattice spacing [m] */
} half_strip_case;

enum { half_strip_case_count = 5 };
extern const half_strip_case half_strip_cases[half_strip_case_count];

/* Numbers as the paper counts them: boundary nodes, and cells plus one point an interface node. */
int half_strip_boundary_nodes(const half_strip_case* mesh);
int half_strip_material_points(const half_strip_case* mesh);

typedef enum left_end { left_end_clamped, left_end_on_rollers } left_end;

/* The strip with its left support; on rollers the left end moves in y but for its mid point. */
bempd_model* half_strip_create(const char* scheme, const half_strip_case* mesh, left_end support);

#endif

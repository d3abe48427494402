/* The plate of the paper's crack examples 1 and 2: 50 mm wide, E = 30 GPa, both ends pulled apart by 2e-8 m an
 * increment, bonds that break at a stretch of 8e-4; boundary elements left and right, a peridynamic strip between them.
 */
#ifndef EXAMPLES_CRACKED_PLATE_H
#define EXAMPLES_CRACKED_PLATE_H

#include <bempd.h>

enum { cracked_plate_left = 1, cracked_plate_strip = 2, cracked_plate_right = 3 };

extern const double cracked_plate_spacing, cracked_plate_pull_per_increment, cracked_plate_increment_limit;

typedef struct cracked_plate {
  double height;                  /* [m] */
  double strip_left, strip_right; /* [m] */
  double crack[4];                /* first tip, second tip [m] */
} cracked_plate;

bempd_model* cracked_plate_create(const char* scheme, const cracked_plate* plate);

#endif

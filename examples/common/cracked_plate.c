#include "common/cracked_plate.h"

#include "common/common.h"

const double cracked_plate_spacing = 0.5e-3;
const double cracked_plate_pull_per_increment = 2e-8;
const double cracked_plate_increment_limit = 500.0;

bempd_model* cracked_plate_create(const char* scheme, const cracked_plate* plate) {
  const double width = 50e-3, element_length = 5e-3; /* nodes every 2.5 mm, on the interfaces as the lattice wants */
  const double to_the_left = -cracked_plate_pull_per_increment, to_the_right = cracked_plate_pull_per_increment;
  bempd_model* model = create_model(scheme);
  const int32_t material = add_material(model, 30e9, 8e-4);
  double vertices[8];

  rectangle(0.0, 0.0, plate->strip_left, plate->height, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, element_length, NULL));
  rectangle(plate->strip_left, 0.0, plate->strip_right, plate->height, vertices);
  ensure(model, bempd_add_pd_region(model, material, 4, vertices, cracked_plate_spacing, 4, NULL));
  rectangle(plate->strip_right, 0.0, width, plate->height, vertices);
  ensure(model, bempd_add_bem_region(model, material, 4, vertices, element_length, NULL));
  ensure(model, bempd_add_crack(model, 2, plate->crack, NULL));

  ensure(model, bempd_prescribe_edge(model, cracked_plate_left, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &to_the_left, NULL));
  ensure(model, bempd_prescribe_edge(model, cracked_plate_right, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &to_the_right, NULL));
  /* One pin against sliding, on the line of symmetry. */
  ensure(model, bempd_fix_point(model, 0.0, 0.5 * plate->height, BEMPD_Y, NULL));
  return model;
}

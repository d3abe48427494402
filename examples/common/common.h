/* What every example does: stop at an error, measure time, make its folder, know which schemes to run. */
#ifndef EXAMPLES_COMMON_H
#define EXAMPLES_COMMON_H

#include <bempd.h>

/* Ends the program with the library's sentence unless the call went well. */
void ensure(const bempd_model* model, bempd_status status);

/* Wall time since some moment. */
double seconds_now(void);

/* Vertices of a rectangle, counter-clockwise; its edges: 1 bottom, 2 right, 3 top, 4 left. */
void rectangle(double left, double bottom, double right, double top, double vertices[8]);

/* Makes out/NAME. */
void make_output_folder(const char* name);

typedef struct scheme_list {
  int count;
  const char* names[2];
} scheme_list;

/* The schemes that the command line names; without any, those the library has: symmetric and, unless it was left out,
 * paper. */
scheme_list schemes_to_run(int argument_count, char** arguments);

/* A new model that uses the scheme. */
bempd_model* create_model(const char* scheme);

/* Plane stress, Poisson's ratio 1/3, thickness 1 m. critical_stretch: 0 for a body that does not break. */
int32_t add_material(bempd_model* model, double young_modulus, double critical_stretch);

#endif

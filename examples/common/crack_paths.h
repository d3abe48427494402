/* Paths of cracks: every broken bond is counted to the crack tip from whose growth it is nearest. */
#ifndef EXAMPLES_CRACK_PATHS_H
#define EXAMPLES_CRACK_PATHS_H

#include <bempd.h>

typedef struct crack_paths crack_paths;

/* tips: shape [tip_count][2]; kept. Prepares the model. */
crack_paths* crack_paths_open(bempd_model* model, int32_t region, int tip_count, const double* tips);

/* Adds the bonds that broke since the last call. */
void crack_paths_update(crack_paths* paths);

/* Direction of growth from a tip, in degrees from the x axis: the line through the tip that the middles of the bonds
 * broken there fit best (least squares of the distances), until one lies `reach` away from the tip. */
double crack_paths_direction(const crack_paths* paths, int tip, double reach);

/* Mean height of the middles of the bonds that broke from a tip, within half a width of x; 0 if none did. */
double crack_paths_height(const crack_paths* paths, int tip, double x, double width);

/* Smallest distance between the middles of bonds that broke from different tips; infinite while there are none. */
double crack_paths_gap(const crack_paths* paths);

/* tip, x, y of every broken bond's middle, in the order of breaking. */
void crack_paths_write(const crack_paths* paths, const char* path);

void crack_paths_close(crack_paths* paths);

#endif

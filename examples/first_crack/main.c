#include <bempd.h>
#include <stdio.h>

int main(void) {
  /* A strip 60 x 20 mm of acrylic glass: boundary elements at the ends, peridynamics where an edge crack will run. */
  const double left[] = {0, 0, 0.02, 0, 0.02, 0.02, 0, 0.02};
  const double middle[] = {0.02, 0, 0.04, 0, 0.04, 0.02, 0.02, 0.02};
  const double right[] = {0.04, 0, 0.06, 0, 0.06, 0.02, 0.04, 0.02};
  const double crack[] = {0.0295, 0, 0.0295, 0.0045};
  const double pull = 1e-6; /* m per unit of load factor */
  int32_t acrylic;
  bempd_material material;
  bempd_step_report report;
  bempd_model* model = NULL;

  bempd_model_create(&model);
  bempd_material_init(&material, sizeof material);
  material.young_modulus = 3e9;
  material.poisson_ratio = 1.0 / 3;
  material.thickness = 0.005;
  material.fracture_energy = 300; /* J/m^2 */
  bempd_add_material(model, &material, &acrylic);
  bempd_add_bem_region(model, acrylic, 4, left, 0.005, NULL);     /* region 1, elements of 5 mm */
  bempd_add_pd_region(model, acrylic, 4, middle, 0.001, 4, NULL); /* region 2, spacing 1 mm, horizon 4 mm */
  bempd_add_bem_region(model, acrylic, 4, right, 0.005, NULL);    /* region 3 */
  bempd_add_crack(model, 2, crack, NULL);
  bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL);                          /* edge 4: the left end */
  bempd_prescribe_edge(model, 3, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL); /* the right end moves */

  bempd_step_report_init(&report, sizeof report);
  if (bempd_run_to_separation(model, 1e4, &report) != BEMPD_OK) {
    printf("%s\n", bempd_last_error(model)); /* an error of any call above shows up here at the latest */
    return 1;
  }
  printf("in two at %.2f micrometres: %d bonds in %d events, %.4f J released\n", report.load_factor,
         (int)report.total_broken_bonds, (int)report.total_events, report.released_energy);
  bempd_model_free(model);
  return 0;
}

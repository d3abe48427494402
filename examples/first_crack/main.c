#include <bempd.h>
#include <stdio.h>

int main(void) {
  const double left[] = {0, 0, 0.02, 0, 0.02, 0.02, 0, 0.02};
  const double middle[] = {0.02, 0, 0.04, 0, 0.04, 0.02, 0.02, 0.02};
  const double right[] = {0.04, 0, 0.06, 0, 0.06, 0.02, 0.04, 0.02};
  const double crack[] = {0.0295, 0, 0.0295, 0.0045}, pull = 1e-6;
  bempd_model* model = NULL;
  bempd_material glass;
  bempd_step_report end;
  int32_t id;

  bempd_model_create(&model);
  bempd_material_init(&glass, sizeof glass);
  glass.young_modulus = 3e9;
  glass.poisson_ratio = 1.0 / 3;
  glass.thickness = 0.005;
  glass.fracture_energy = 300;
  bempd_add_material(model, &glass, &id);
  bempd_add_bem_region(model, id, 4, left, 0.005, NULL);
  bempd_add_pd_region(model, id, 4, middle, 0.001, 4, NULL); /* spacing, horizon */
  bempd_add_bem_region(model, id, 4, right, 0.005, NULL);
  bempd_add_crack(model, 2, crack, NULL);
  bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL);
  bempd_prescribe_edge(model, 3, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL);

  bempd_step_report_init(&end, sizeof end);
  if (bempd_run_to_separation(model, 1e4, &end) != BEMPD_OK) {
    printf("%s\n", bempd_last_error(model)); /* tells errors of earlier calls too */
    return 1;
  }
  printf("in two at %.2f micrometres: ", end.load_factor);
  printf("%d bonds in %d events, ", (int)end.total_broken_bonds, (int)end.total_events);
  printf("%.4f J released\n", end.released_energy);
  bempd_model_free(model);
  return 0;
}

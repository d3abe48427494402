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
  bempd_step_report_init(&end, sizeof end);
  if (bempd_add_material(model, &glass, &id) ||                    /* 0 is good */
      bempd_add_bem_region(model, id, 4, left, 0.005, NULL) ||     /* region 1 */
      bempd_add_pd_region(model, id, 4, middle, 0.001, 4, NULL) || /* region 2 */
      bempd_add_bem_region(model, id, 4, right, 0.005, NULL) ||    /* region 3 */
      bempd_add_crack(model, 2, crack, NULL) ||                    /* 2 points */
      bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL) ||             /* left end */
      bempd_prescribe_edge(model, 3, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL) ||
      bempd_run_to_separation(model, 1e4, &end)) {
    printf("%s\n", bempd_last_error(model));
    return 1;
  }
  printf("in two at %.2f micrometres: ", end.load_factor);
  printf("%d bonds in %d events, ", (int)end.total_broken_bonds, (int)end.total_events);
  printf("%.4f J released\n", end.released_energy);
  bempd_model_free(model);
  return 0;
}

#include <bempd.h>
#include <stdio.h>

int main(void) {
  const double outline[] = {0, 0, 0.06, 0, 0.06, 0.02, 0, 0.02};
  const double crack[] = {0.03, 0, 0.03, 0.005}, pull = 1e-6;
  bempd_model* model = NULL;
  bempd_material glass;
  bempd_step_report end;
  int32_t id, strip;

  bempd_model_create(&model);
  bempd_material_init(&glass, sizeof glass);
  glass.young_modulus = 3e9;
  glass.poisson_ratio = 1.0 / 3;
  glass.thickness = 0.005;
  glass.fracture_energy = 300;
  bempd_step_report_init(&end, sizeof end);
  if (bempd_set_option(model, "error.wanted", 0.01) || /* 0 is good */
      bempd_add_material(model, &glass, &id) ||        /* an id */
      bempd_add_body(model, id, 4, outline, &strip) || /* 4 vertices */
      bempd_add_circular_hole(model, strip, 0.034, 0.013, 0.003, NULL) ||
      bempd_add_crack(model, 2, crack, NULL) ||            /* 2 points */
      bempd_fix_edge(model, strip, 4, BEMPD_BOTH, NULL) || /* left end */
      bempd_prescribe_edge(model, strip, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL) ||
      bempd_run_to_separation(model, 1e4, &end)) {
    printf("%s\n", bempd_last_error(model));
    return 1;
  }
  printf("growth at %.1f micrometres, ", end.load_factor);
  printf("%.0f N\n", end.peak_resistance);
  bempd_model_free(model);
  return 0;
}

#include <bempd.h>
#include <stdio.h>

int main(void) {
  const double sheet[] = {-0.06, -0.12, 0.06, -0.12, 0.06, 0.12, -0.06, 0.12};
  const double crack[] = {-0.004, 0, 0.004, 0}, up = 80e6, down = -80e6;
  const double high[] = {1, 0.7}, low[] = {0.1, 0.2}, cycles[] = {10, 500};
  bempd_model* model = NULL;
  bempd_material aluminium;
  bempd_growth_rate rate;
  bempd_fatigue_report life;
  double length = 0;
  int32_t id;

  bempd_model_create(&model);
  bempd_material_init(&aluminium, sizeof aluminium);
  aluminium.young_modulus = 72e9;
  aluminium.poisson_ratio = 0.33;
  bempd_growth_rate_init(&rate, sizeof rate); /* Paris and Walker, in MPa m^(1/2) and m */
  rate.coefficient = 2e-11;
  rate.exponent = 3;
  rate.unit_intensity = 1e6;
  rate.walker = 0.6;
  rate.critical_intensity = 35;
  bempd_fatigue_report_init(&life, sizeof life);
  if (bempd_add_material(model, &aluminium, &id) ||             /* a status: 0 is good */
      bempd_add_bem_region(model, id, 4, sheet, 0.03, NULL) ||  /* region 1 */
      bempd_add_crack(model, 2, crack, NULL) ||                 /* 2 points */
      bempd_fix_point(model, -0.06, -0.12, BEMPD_BOTH, NULL) || /* lower left corner */
      bempd_fix_point(model, 0.06, -0.12, BEMPD_Y, NULL) ||     /* lower right corner */
      bempd_add_traction(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &up, NULL) ||
      bempd_add_traction(model, 1, 1, 0, 1, BEMPD_Y, 1, NULL, &down, NULL) ||
      bempd_set_growth_rate(model, id, &rate) || /* law of the material */
      bempd_grow_fatigue(model, 2, high, low, cycles, NULL, &life) || bempd_crack_length(model, 1, &length)) {
    printf("%s\n", bempd_last_error(model)); /* of the call that failed */
    return 1;
  }
  printf("breaks after %.0f cycles, at a length of %.1f mm\n", life.cycles, 1e3 * length);
  bempd_model_free(model);
  return 0;
}

/* The option `accuracy` moves the defaults of others, in any order with what is set by hand. */
#include "scenes.h"

static double number_of(const bempd_model* model, const char* name) {
  double value = NAN;
  CHECK_OK(model, bempd_get_option(model, name, &value));
  return value;
}

static void presets_move_defaults_from_fast_to_exact(void) {
  static const char* const names[] = {"bem.quadrature_tolerance", "stepping.tie_band"};
  size_t k;
  for (k = 0; k < sizeof names / sizeof names[0]; ++k) {
    bempd_model* model = new_model();
    const double standard = number_of(model, names[k]);
    double draft, fine;
    CHECK_OK(model, bempd_set_option_text(model, "accuracy", "draft"));
    draft = number_of(model, names[k]);
    CHECK_OK(model, bempd_set_option_text(model, "accuracy", "fine"));
    fine = number_of(model, names[k]);
    CHECK(draft >= standard && standard > fine);
    CHECK_OK(model, bempd_set_option_text(model, "accuracy", "standard"));
    CHECK(number_of(model, names[k]) == standard);
    bempd_model_free(model);
  }
}

static void standard_is_the_default(void) {
  bempd_model* model = new_model();
  int64_t count = 0, k;
  CHECK_OK(model, bempd_set_option_text(model, "accuracy", "standard"));
  CHECK_OK(NULL, bempd_option_count(&count));
  for (k = 0; k < count; ++k) {
    bempd_option_info info;
    memset(&info, 0, sizeof info);
    info.struct_size = (int64_t)sizeof info;
    CHECK_OK(NULL, bempd_option_describe(k, &info));
    if (info.kind == BEMPD_OPTION_NUMBER) CHECK(number_of(model, info.name) == info.default_value);
  }
  bempd_model_free(model);
}

static void values_set_by_hand_stand_before_and_after(void) {
  bempd_model* before = new_model();
  bempd_model* after = new_model();
  CHECK_OK(before, bempd_set_option(before, "stepping.tie_band", 0.25));
  CHECK_OK(before, bempd_set_option_text(before, "accuracy", "draft"));
  CHECK_OK(after, bempd_set_option_text(after, "accuracy", "draft"));
  CHECK_OK(after, bempd_set_option(after, "stepping.tie_band", 0.25));
  CHECK(number_of(before, "stepping.tie_band") == 0.25 && number_of(after, "stepping.tie_band") == 0.25);
  CHECK(number_of(before, "bem.quadrature_tolerance") == number_of(after, "bem.quadrature_tolerance"));
  bempd_model_free(before);
  bempd_model_free(after);
}

static void a_default_set_by_hand_stands_too(void) {
  bempd_model* model = new_model();
  const double tolerance = number_of(model, "bem.quadrature_tolerance");
  CHECK_OK(model, bempd_set_option(model, "bem.quadrature_tolerance", tolerance));
  CHECK_OK(model, bempd_set_option_text(model, "accuracy", "draft"));
  CHECK(number_of(model, "bem.quadrature_tolerance") == tolerance);
  bempd_model_free(model);
}

/** Tractions on a block that is held at its left end; evaluations of the kernels in one step. */
static int64_t evaluations_of(const char* accuracy, int after_the_scene) {
  bempd_model* model = NULL;
  bempd_statistics statistics;
  const double pull = 1.0;
  if (after_the_scene) {
    model = bem_block();
    CHECK_OK(model, bempd_set_option_text(model, "accuracy", accuracy));
  } else {
    model = new_model();
    CHECK_OK(model, bempd_set_option_text(model, "accuracy", accuracy));
    add_bem_rectangle(model, add_sound_material(model), 0.0, 0.0, 10.0, 8.0, 2.0);
  }
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_get_statistics(model, &statistics));
  bempd_model_free(model);
  return statistics.kernel_evaluations;
}

static void presets_reach_the_solver_before_and_after_the_scene(void) {
  const int64_t draft = evaluations_of("draft", 0), standard = evaluations_of("standard", 0);
  CHECK(draft < standard && standard < evaluations_of("fine", 0));
  CHECK(draft == evaluations_of("draft", 1));
}

int main(void) {
  presets_move_defaults_from_fast_to_exact();
  standard_is_the_default();
  values_set_by_hand_stand_before_and_after();
  a_default_set_by_hand_stands_too();
  presets_reach_the_solver_before_and_after_the_scene();
  return check_finish();
}

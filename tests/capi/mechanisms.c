/* Bodies that are not held: the motion left is named, and the missing support can still be added. */
#include "scenes.h"

typedef bempd_model* (*block_maker)(void);

static const block_maker block_makers[2] = {bem_block, pd_block};

#define FREE_TO(words, model) CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, words, bempd_prepare(model))

static void body_without_supports_is_refused(void) {
  int k;
  for (k = 0; k < 2; ++k) {
    bempd_model* model = block_makers[k]();
    FREE_TO("translat", model);
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_prepare(model));
    bempd_model_free(model);
  }
}

static void body_on_rollers_can_translate(void) {
  int k;
  for (k = 0; k < 2; ++k) {
    bempd_model* model = block_makers[k]();
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_X, NULL));
    FREE_TO("translat", model);
    CHECK_OK(model, bempd_fix_point(model, 0.0, 4.0, BEMPD_Y, NULL));
    CHECK_OK(model, bempd_prepare(model));
    bempd_model_free(model);
  }
}

static void body_on_a_pin_can_rotate(void) {
  int k;
  for (k = 0; k < 2; ++k) {
    bempd_model* model = block_makers[k]();
    CHECK_OK(model, bempd_fix_point(model, 0.0, 0.0, BEMPD_BOTH, NULL));
    FREE_TO("rotat", model);
    CHECK_OK(model, bempd_fix_point(model, 10.0, 0.0, BEMPD_X, NULL));
    FREE_TO("rotat", model);
    CHECK_OK(model, bempd_fix_point(model, 10.0, 0.0, BEMPD_Y, NULL));
    CHECK_OK(model, bempd_prepare(model));
    bempd_model_free(model);
  }
}

static void loads_do_not_hold_a_body(void) {
  bempd_model* model = bem_block();
  const double one = 1.0;
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_Y, NULL));
  FREE_TO("translat", model);
  bempd_model_free(model);
}

static void every_separate_body_needs_its_own_supports(void) {
  bempd_model* model = bem_block();
  add_bem_rectangle(model, 1, 20.0, 0.0, 30.0, 8.0, 2.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  FREE_TO("translat|rotat", model);
  CHECK(check_has_word(bempd_last_error(model), "region 2|region(s) 2|regions 2"));
  CHECK_OK(model, bempd_fix_edge(model, 2, 2, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  bempd_model_free(model);
}

static void a_step_finds_the_mechanism_too(void) {
  bempd_model* model = bem_block();
  double load_factor = 1.0;
  const bempd_status status = bempd_step(model, 1.0, NULL);
  CHECK(status == BEMPD_ERROR_UNSOLVABLE);
  CHECK(check_has_word(bempd_last_error(model), "translat|rotat"));
  CHECK_OK(model, bempd_load_factor(model, &load_factor));
  CHECK(load_factor == 0.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  bempd_model_free(model);
}

/** A piece that an initial crack cuts off is not an error: it is reported, stays where it is, and the rest is solved.
 */
static void piece_cut_off_by_a_crack_is_reported(void) {
  bempd_model* model = pd_block();
  const double crack[] = {4.5, 0.0, 4.5, 8.0};
  const double places[] = {2.5, 4.5, 7.5, 4.5};
  const double pull = 1e-3;
  double displacement[4] = {0.0, 0.0, 0.0, 0.0};
  bempd_step_report report;
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 4, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_Y, NULL));
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step(model, 1.0, &report));
  CHECK(report.fragments == 1 && report.broken_bonds == 0);
  CHECK_OK(model, bempd_evaluate(model, 2, places, displacement, NULL, NULL));
  CHECK_CLOSE(displacement[0], pull, 1e-12);
  CHECK_CLOSE(displacement[2], 0.0, 1e-12);
  bempd_model_free(model);
}

int main(void) {
  body_without_supports_is_refused();
  body_on_rollers_can_translate();
  body_on_a_pin_can_rotate();
  loads_do_not_hold_a_body();
  every_separate_body_needs_its_own_supports();
  a_step_finds_the_mechanism_too();
  piece_cut_off_by_a_crack_is_reported();
  return check_finish();
}

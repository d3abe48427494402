/* What comes next, and what holds the rest back: bempd_explain() says what the next step then does. */
#include "scenes.h"

typedef struct explained {
  bempd_explanation next;
  char text[2000];
} explained;

static explained explain(bempd_model* model, int32_t rising) {
  explained e;
  int64_t needed = 0;
  CHECK_OK(NULL, bempd_explanation_init(&e.next, sizeof e.next));
  CHECK_OK(model, bempd_explain(model, rising, &e.next, e.text, sizeof e.text, &needed));
  CHECK(needed == (int64_t)strlen(e.text) + 1);
  return e;
}

static int says(const explained* e, const char* words) { return strstr(e->text, words) != NULL; }

/** The tip of the README's strip grows at the load factor of the next event; the tip is pressed shut on the way down.
 */
static void next_is_what_the_step_does(void) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  bempd_model* model = strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
  bempd_step_report report;
  explained e = explain(model, 0);
  CHECK(e.next.next == BEMPD_NEXT_BOND && e.next.load_factor < 0 && says(&e, "pressed shut"));
  e = explain(model, 1);
  CHECK(e.next.next == BEMPD_NEXT_TIP && e.next.crack == 1 && e.next.end == BEMPD_CRACK_END && e.next.region == 0);
  CHECK_CLOSE(e.next.x, 0.0295, 1e-12);
  CHECK_CLOSE(e.next.y, 0.0045, 1e-12);
  CHECK_CLOSE(e.next.ratio, 0.0, 1e-12);
  CHECK(says(&e, "crack 1 at its end"));
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e4, &report));
  CHECK_CLOSE(report.load_factor, e.next.load_factor, 1e-9 * e.next.load_factor);
  bempd_model_free(model);
}

/** Bond by bond, and on the path of equilibrium behind a first event, the next step does what was told as well. */
static void other_rules_are_told(void) {
  static const char* const options[2][2] = {{"crack.rule", "bond"}, {"stepping.control", "path"}};
  const double pull = 1e-6;
  int32_t pulled = 0;
  int which, event;
  for (which = 0; which < 2; ++which) {
    bempd_model* model = strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
    CHECK_OK(model, bempd_set_option_text(model, options[which][0], options[which][1]));
    for (event = 0; event < 4; ++event) {
      bempd_step_report report;
      const explained e = explain(model, 1);
      CHECK(e.next.next == (which == 0 ? BEMPD_NEXT_BOND : BEMPD_NEXT_TIP));
      CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
      CHECK_OK(model, bempd_step_to_next_event(model, 1e4, &report));
      CHECK_CLOSE(report.load_factor, e.next.load_factor, 1e-9 * e.next.load_factor);
    }
    bempd_model_free(model);
  }
}

/** A frozen tip is named, and a bond comes next. */
static void frozen_tips_are_named(void) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  bempd_model* model = strip_with_crack(0.0045, 1, NULL, &pull, &pulled);
  bempd_step_report report;
  explained e;
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_END, 1));
  e = explain(model, 1);
  CHECK(says(&e, "frozen by bempd_set_tip_frozen()") && e.next.next == BEMPD_NEXT_BOND && e.next.region == 2);
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e6, &report));
  CHECK_CLOSE(report.load_factor, e.next.load_factor, 1e-9 * e.next.load_factor);
  bempd_model_free(model);
}

/** Bodies in which nothing breaks tell why. */
static void reasons_are_told(void) {
  const double pull = 0.01;
  bempd_material tough = sound_material();
  bempd_model* model = bem_block();
  explained e;
  int32_t material = 0;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  e = explain(model, 1);
  CHECK(e.next.next == BEMPD_NEXT_NOTHING && says(&e, "boundary elements alone") && isnan(e.next.load_factor));
  bempd_model_free(model);

  model = new_model();
  tough.critical_stretch = 0.0;
  CHECK_OK(model, bempd_add_material(model, &tough, &material));
  add_pd_rectangle(model, material, 0.0, 0.0, 10.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  e = explain(model, 1);
  CHECK(says(&e, "neither a fracture energy nor a critical stretch") && says(&e, "in proportion to the load factor"));
  bempd_model_free(model);
}

static void misuse(void) {
  bempd_model* model = bem_block();
  char small[4];
  int64_t needed = 0;
  bempd_explanation next;
  CHECK_OK(NULL, bempd_explanation_init(&next, sizeof next));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_explain(model, 1, NULL, NULL, 0, &needed));
  CHECK(needed > 4);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity is 4", bempd_explain(model, 1, NULL, small, 4, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "buffer is NULL", bempd_explain(model, 1, NULL, NULL, 4, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "rising is 2", bempd_explain(model, 2, NULL, NULL, 0, NULL));
  next.struct_size = 3;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_explain(model, 1, &next, NULL, 0, NULL));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model is NULL", bempd_explain(NULL, 1, NULL, NULL, 0, NULL));
  bempd_model_free(model);
}

int main(void) {
  misuse();
  next_is_what_the_step_does();
  other_rules_are_told();
  frozen_tips_are_named();
  reasons_are_told();
  return check_finish();
}

/* A failed call leaves no trace: a run among wrong calls gives the same bits as one without. */
#include "scenes.h"

static int32_t stop_at_once(double x, double y, double* constant, double* proportional, void* user) {
  (void)x, (void)y, (void)constant, (void)proportional, (void)user;
  return 1;
}

#define WRONG(call) CHECK((call) != BEMPD_OK)

static void wrong_while_building(bempd_model* model) {
  const rectangle r = rectangle_of(0.0, 0.0, 4.0, 4.0);
  const double clockwise[] = {0, 0, 0, 4, 4, 4, 4, 0};
  const double outside[] = {-90, 0, -90, 4};
  bempd_material material = sound_material();
  material.poisson_ratio = 0.7;
  WRONG(bempd_add_material(model, &material, NULL));
  WRONG(bempd_add_bem_region(model, 99, 4, r.vertices, 1.0, NULL));
  WRONG(bempd_add_bem_region(model, 1, 4, clockwise, 1.0, NULL));
  WRONG(bempd_add_bem_region(model, 1, 4, r.vertices, NAN, NULL));
  WRONG(bempd_add_pd_region(model, 1, 4, r.vertices, 0.3, 3, NULL));
  WRONG(bempd_add_pd_region(model, 1, 4, r.vertices, 1.0, 17, NULL));
  WRONG(bempd_add_hole(model, 1, 4, r.vertices, NULL));
  WRONG(bempd_set_edge_mesh(model, 1, 1, 1.0, 99.0));
  WRONG(bempd_add_crack(model, 1, outside, NULL));
}

static void wrong_conditions(bempd_model* model) {
  const double never = NAN;
  WRONG(bempd_fix_edge(model, 1, 1, 9, NULL));
  WRONG(bempd_prescribe_edge(model, 1, 1, 0.9, 0.1, BEMPD_X, 1, NULL, NULL, NULL));
  WRONG(bempd_prescribe_edge(model, 1, 1, 0.0, 1.0, BEMPD_X, 1, &never, NULL, NULL));
  WRONG(bempd_add_traction(model, 1, 1, 0.0, 1.0, BEMPD_X, 0, NULL, NULL, NULL));
  WRONG(bempd_add_point_force(model, never, 0.0, BEMPD_X, 1.0, 0.0, NULL));
  WRONG(bempd_set_load_values(model, 5, 1, NULL, NULL));
  WRONG(bempd_set_support_values(model, 50, 1, NULL, NULL));
  WRONG(bempd_set_option(model, "crack.tie_share", -1.0));
  WRONG(bempd_set_option_text(model, "scheme", "best"));
}

static void wrong_questions(bempd_model* model) {
  double values[2];
  int64_t count = 0;
  bempd_history_entry entry;
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  WRONG(bempd_node_count(model, 99, &count));
  WRONG(bempd_copy_field(model, 99, BEMPD_POSITION, 2, values));
  WRONG(bempd_reaction(model, 99, values));
  WRONG(bempd_history(model, 1000000, &entry));
  WRONG(bempd_get_history_support(model, 0, 99, values, NULL, NULL));
  WRONG(bempd_get_history_support(model, 1000000, 1, values, NULL, NULL));
  WRONG(bempd_step(model, NAN, NULL));
  WRONG(bempd_run_to_separation(model, INFINITY, NULL));
  WRONG(bempd_state_restore(model, NULL));
  WRONG(bempd_write_history(model, "no_such_folder/history.csv"));
}

/** The body is not yet held while the supports are missing: preparing fails, and building goes on. */
static void wrong_calls(coupled_plate* plate) {
  wrong_while_building(plate->model);
  wrong_conditions(plate->model);
  wrong_questions(plate->model);
  if (plate->pinned == 0) {
    WRONG(bempd_prepare(plate->model));
    WRONG(bempd_step(plate->model, 0.5, NULL));
    if (plate->left != 0)
      WRONG(bempd_prescribe_edge_function(plate->model, 99, 1, 0.0, 1.0, BEMPD_X, stop_at_once, NULL, NULL));
  }
}

/** Steps below, onto and beyond the first event, then back; wrong calls in between where asked for. */
static outcome run(coupled_plate* plate, double first_event, int with_wrong_calls) {
  const double load_factors[] = {0.5 * first_event, 1.02 * first_event, 1.4 * first_event, 0.3 * first_event};
  size_t k;
  for (k = 0; k < sizeof load_factors / sizeof load_factors[0]; ++k) {
    if (with_wrong_calls) wrong_calls(plate);
    CHECK_OK(plate->model, bempd_step(plate->model, load_factors[k], NULL));
  }
  if (with_wrong_calls) wrong_calls(plate);
  return coupled_plate_outcome(plate);
}

int main(void) {
  const double first_event = coupled_plate_first_event();
  coupled_plate quiet = coupled_plate_create();
  coupled_plate troubled = coupled_plate_build(wrong_calls);
  outcome expected = run(&quiet, first_event, 0);
  outcome seen = run(&troubled, first_event, 1);
  CHECK(outcome_same(&expected, &seen));
  CHECK(quiet.strip == troubled.strip && quiet.pinned == troubled.pinned && quiet.crack == troubled.crack);
  outcome_free(&expected);
  outcome_free(&seen);
  bempd_model_free(quiet.model);
  bempd_model_free(troubled.model);
  return check_finish();
}

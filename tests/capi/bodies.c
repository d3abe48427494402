/* Bodies: regions whose boundary elements the library chooses, with a plan and estimates of errors. */
#include "scenes.h"

static bempd_body_plan plan_of(bempd_model* model) {
  bempd_body_plan plan;
  CHECK_OK(NULL, bempd_body_plan_init(&plan, sizeof plan));
  CHECK_OK(model, bempd_plan(model, &plan));
  return plan;
}

static bempd_errors errors_of(bempd_model* model) {
  bempd_errors errors;
  CHECK_OK(NULL, bempd_errors_init(&errors, sizeof errors));
  CHECK_OK(model, bempd_error_estimate(model, &errors));
  return errors;
}

static void step_to(bempd_model* model, double load_factor) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step(model, load_factor, &report));
}

static int32_t add_rectangle(bempd_model* model, double width, double height) {
  const rectangle r = rectangle_of(0, 0, width, height);
  bempd_material material = sound_material();
  int32_t id = 0, body = 0;
  material.critical_stretch = 0;
  material.fracture_energy = 1e-3;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  CHECK_OK(model, bempd_add_body(model, id, 4, r.vertices, &body));
  return body;
}

/** Clamped arm with a hole and a crack, bent by a traction at its end. Ids: body 1, crack 1, support 1, load 1. */
static bempd_model* arm(double wanted) {
  static const double crack[4] = {1.0, 0.35, 1.2, 0.65};
  const double down = -1;
  bempd_model* model = new_model();
  const int32_t body = add_rectangle(model, 3, 1);
  CHECK_OK(model, bempd_set_option(model, "error.wanted", wanted));
  CHECK_OK(model, bempd_add_circular_hole(model, body, 2, 0.5, 0.2, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, body, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_traction(model, body, 2, 0, 1, BEMPD_Y, 1, NULL, &down, NULL));
  return model;
}

typedef struct answers {
  double deflection[2], intensity[2][2];
} answers;

static answers answers_at(bempd_model* model, double load_factor) {
  static const double end[2] = {3, 0};
  answers found;
  bempd_crack_tip tip;
  int k;
  step_to(model, load_factor);
  CHECK_OK(model, bempd_evaluate(model, 1, end, found.deflection, NULL, NULL));
  for (k = 0; k < 2; ++k) {
    CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
    CHECK_OK(model, bempd_tip(model, k, &tip));
    found.intensity[k][0] = tip.stress_intensity_1;
    found.intensity[k][1] = tip.stress_intensity_2;
  }
  return found;
}

/** Largest difference of two pairs of answers over the largest answer. */
static double off(const double* a, const double* exact, int count) {
  double error = 0, scale = 0;
  int k;
  for (k = 0; k < count; k += 2) {
    error = fmax(error, hypot(a[k] - exact[k], a[k + 1] - exact[k + 1]));
    scale = fmax(scale, hypot(exact[k], exact[k + 1]));
  }
  return error / scale;
}

/** A body under uniform tension is exact, and has the edges, fields and reactions of a region. */
static void a_body_is_a_region(void) {
  const double pull = 2;
  double u[2], force[2], stress[3];
  static const double corner[2] = {2, 1}, inside[2] = {0.7, 0.4};
  int32_t edges = 0, regions = 0;
  int64_t nodes = 0;
  bempd_model* model = new_model();
  const int32_t body = add_rectangle(model, 2, 1);
  CHECK_OK(model, bempd_edge_count(model, body, &edges));
  CHECK_OK(model, bempd_region_count(model, &regions));
  CHECK(edges == 4 && regions == 1 && body == 1);
  CHECK_OK(model, bempd_fix_edge(model, body, 4, BEMPD_X, NULL));
  CHECK_OK(model, bempd_fix_edge(model, body, 1, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, body, 2, 0, 1, BEMPD_X, 1, NULL, &pull, NULL));
  step_to(model, 1);
  CHECK_OK(model, bempd_evaluate(model, 1, corner, u, NULL, NULL));
  CHECK_CLOSE(u[0], 2 * pull / 1000, 1e-12);
  CHECK_CLOSE(u[1], -pull / 3000, 1e-12);
  CHECK_OK(model, bempd_evaluate(model, 1, inside, u, stress, NULL));
  CHECK_CLOSE(stress[0], pull, 1e-8);
  CHECK_OK(model, bempd_reaction(model, 1, force));
  CHECK_CLOSE(force[0], -pull, 1e-9);
  CHECK_OK(model, bempd_node_count(model, body, &nodes));
  CHECK(nodes > 8 && nodes < 200);
  CHECK(errors_of(model).displacement < 1e-9);
  bempd_model_free(model);
}

/** The true errors of displacements and stress intensity factors are below those that are told, and those below what is
 * wanted. */
static void errors_are_bounded(void) {
  static const double wanted[3] = {0.1, 0.01, 0.0005};
  answers exact;
  double elements = 0;
  int k;
  bempd_model* finest = arm(0.01);
  CHECK_OK(finest, bempd_set_option(finest, "test.halvings", 3));
  exact = answers_at(finest, 1e-3);
  bempd_model_free(finest);
  for (k = 0; k < 3; ++k) {
    bempd_model* model = arm(wanted[k]);
    const answers found = answers_at(model, 1e-3);
    const bempd_body_plan plan = plan_of(model);
    const bempd_errors errors = errors_of(model);
    const double moved = off(found.deflection, exact.deflection, 2);
    const double intensity = off(found.intensity[0], exact.intensity[0], 4);
    printf("wanted %g: %lld elements; displacement %.1e told %.1e and %.1e; intensity %.1e told %.1e and %.1e\n",
           wanted[k], (long long)plan.boundary_elements, moved, plan.displacement_error, errors.displacement, intensity,
           plan.intensity_error, errors.stress_intensity);
    CHECK(plan.is_solved == 1 && plan.meets_wish == 1);
    CHECK(moved <= plan.displacement_error && moved <= errors.displacement && moved <= wanted[k]);
    CHECK(intensity <= plan.intensity_error && intensity <= errors.stress_intensity && intensity <= wanted[k]);
    CHECK(plan.displacement_error <= wanted[k] && plan.intensity_error <= wanted[k]);
    CHECK((double)plan.boundary_elements >= elements);
    elements = (double)plan.boundary_elements;
    bempd_model_free(model);
  }
}

/** What the plan promises comes: elements, unknowns, errors, and the load of the first growth. The scene may change
 * between the two. */
static void plans_are_kept(void) {
  static const double wanted[2] = {0.02, 0.0005};
  int k;
  for (k = 0; k < 2; ++k) {
    bempd_model* model = arm(wanted[k]);
    const bempd_body_plan promise = plan_of(model);
    bempd_body_plan came;
    bempd_step_report report;
    bempd_statistics sizes;
    const double twice = -2;
    CHECK(promise.growth_crack == 1 && promise.growth_end > 0 && promise.meets_wish == 1);
    CHECK_OK(model, bempd_prepare(model));
    came = plan_of(model);
    CHECK(came.is_solved == 1 && came.meets_wish == 1);
    CHECK(came.boundary_elements == promise.boundary_elements && came.memory == promise.memory);
    CHECK_CLOSE((double)came.unknowns, (double)promise.unknowns, 0.1 * (double)came.unknowns);
    CHECK(came.displacement_error < 4 * promise.displacement_error && promise.displacement_error <= wanted[k]);
    CHECK_OK(NULL, bempd_statistics_init(&sizes, sizeof sizes));
    CHECK_OK(model, bempd_get_statistics(model, &sizes));
    CHECK(sizes.boundary_elements == came.boundary_elements);
    CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
    CHECK_OK(model, bempd_step_to_next_event(model, 1e6, &report));
    CHECK_CLOSE(report.load_factor, came.growth_load_factor, 1e-9 * came.growth_load_factor);
    CHECK_CLOSE(promise.growth_load_factor, came.growth_load_factor, 0.05 * came.growth_load_factor);
    bempd_model_free(model);
    model = arm(wanted[k]);
    plan_of(model);
    CHECK_OK(model, bempd_set_load_values(model, 1, 1, NULL, &twice));
    CHECK_CLOSE(plan_of(model).growth_load_factor, 0.5 * promise.growth_load_factor, 1e-9 * promise.growth_load_factor);
    bempd_model_free(model);
  }
}

/** The limits on time and memory end the refinement; the errors that are left are told. */
static void limits_are_kept(void) {
  static const struct {
    const char* name;
    double value;
  } limits[2] = {{"memory.limit", 0.15}, {"budget.seconds", 1e-6}};
  int k;
  for (k = 0; k < 2; ++k) {
    bempd_model* model = arm(1e-6);
    bempd_body_plan plan;
    CHECK_OK(model, bempd_set_option(model, limits[k].name, limits[k].value));
    plan = plan_of(model);
    CHECK(plan.meets_wish == 0 && plan.displacement_error > 1e-6);
    CHECK(k != 0 || plan.memory <= 0.15e9);
    step_to(model, 1e-3);
    CHECK(plan_of(model).boundary_elements == plan.boundary_elements);
    bempd_model_free(model);
  }
}

/** Errors of regions with given elements are told, too, down to one element on each edge. */
static void errors_of_given_elements_are_told(void) {
  static const double lengths[3] = {0.5, 0.25, 0.125};
  static const double end[2] = {3, 0};
  const double down = -1;
  double exact[2];
  int k;
  for (k = -1; k < 3; ++k) {
    double u[2];
    int32_t region = 0;
    bempd_model* model = new_model();
    if (k < 0) {
      region = add_rectangle(model, 3, 1);
      CHECK_OK(model, bempd_set_option(model, "test.halvings", 3));
    } else {
      region = add_bem_rectangle(model, add_sound_material(model), 0, 0, 3, 1, lengths[k]);
    }
    CHECK_OK(model, bempd_fix_edge(model, region, 4, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_add_traction(model, region, 2, 0, 1, BEMPD_Y, 1, NULL, &down, NULL));
    step_to(model, 1);
    CHECK_OK(model, bempd_evaluate(model, 1, end, k < 0 ? exact : u, NULL, NULL));
    if (k >= 0) {
      const double true_error = off(u, exact, 2), told = errors_of(model).displacement;
      printf("elements of %g: error %.1e, told %.1e\n", lengths[k], true_error, told);
      CHECK(told >= true_error);
    }
    bempd_model_free(model);
  }
}

/** A run with a body goes on from its saved state in another model. */
static void states_know_bodies(void) {
  bempd_model *model = arm(0.01), *other = arm(0.01);
  bempd_state *state = NULL, *read = NULL;
  int64_t size = 0;
  uint8_t* bytes = NULL;
  answers before, after;
  before = answers_at(model, 1e-3);
  CHECK_OK(model, bempd_state_save(model, &state));
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
  bytes = malloc((size_t)size);
  CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, NULL));
  CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &read));
  CHECK_OK(other, bempd_state_restore(other, read));
  after = answers_at(other, 1e-3);
  CHECK(memcmp(&before, &after, sizeof before) == 0);
  free(bytes);
  bempd_state_free(state);
  bempd_state_free(read);
  bempd_model_free(model);
  bempd_model_free(other);
}

/** Errors of stress at a hole, which shorter elements show, and none where stress is unbounded. */
static void errors_of_stress_are_told(void) {
  static const double places[8] = {2, 0.7, 2, 0.3, 2.5, 0.5, 0, 0}, load = 0.01;
  double u[4], s[4], coarse[12], fine[12], errors[4];
  bempd_model *model = arm(0.02), *finer = arm(1e-3);
  step_to(model, load), step_to(finer, load);
  CHECK_OK(model, bempd_evaluate_errors(model, 4, places, errors, s));
  CHECK_OK(model, bempd_evaluate_errors(model, 4, places, u, NULL));
  CHECK_OK(model, bempd_evaluate(model, 3, places, NULL, coarse, NULL));
  CHECK_OK(finer, bempd_evaluate(finer, 3, places, NULL, fine, NULL));
  for (int k = 0; k < 3; ++k) {
    const double *a = coarse + (ptrdiff_t)3 * k, *b = fine + (ptrdiff_t)3 * k;
    const double xx = a[0] - b[0], yy = a[1] - b[1], xy = a[2] - b[2], apart = sqrt(xx * xx + yy * yy + 2 * xy * xy);
    CHECK(s[k] > 0 && s[k] >= apart && s[k] < 2 * load);
    CHECK(u[k] == errors[k] && u[k] > 0);
  }
  CHECK(isnan(s[3]));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "point 1", bempd_evaluate_errors(model, 1, (const double[2]){9, 9}, u, s));
  bempd_model_free(model), bempd_model_free(finer);
}

static void misuse(void) {
  const rectangle r = rectangle_of(0, 0, 1, 1);
  static const double bulges[4] = {0, 0.2, 0, NAN};
  bempd_body_plan plan;
  bempd_errors errors;
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  CHECK_OK(NULL, bempd_body_plan_init(&plan, sizeof plan));
  CHECK_OK(NULL, bempd_errors_init(&errors, sizeof errors));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "vertices", bempd_add_body(model, material, 2, r.vertices, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "vertices is NULL", bempd_add_body(model, material, 4, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "material", bempd_add_body(model, 7, 4, r.vertices, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bulge",
              bempd_add_body_with_arcs(model, material, 4, r.vertices, bulges, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no body", bempd_plan(model, &plan));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "plan is NULL", bempd_plan(model, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "errors is NULL", bempd_error_estimate(model, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "no region", bempd_error_estimate(model, &errors));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "error.wanted", bempd_set_option(model, "error.wanted", 0));
  CHECK_OK(model, bempd_add_body_with_arcs(model, material, 4, r.vertices, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, "translate", bempd_plan(model, &plan));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_plan(model, &plan));
  CHECK_OK(model, bempd_fix_edge(model, 1, 2, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepared", bempd_add_body(model, material, 4, r.vertices, NULL));
  bempd_model_free(model);
}

int main(void) {
  a_body_is_a_region();
  errors_are_bounded();
  plans_are_kept();
  limits_are_kept();
  errors_of_given_elements_are_told();
  states_know_bodies();
  errors_of_stress_are_told();
  misuse();
  return check_finish();
}

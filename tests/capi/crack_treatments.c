/* Treatments of cracks: lattice patches that are cut out of bodies, cracks that are frozen on the way, and parts. */
#include "scenes.h"

enum { LATTICE = BEMPD_TREATMENT_LATTICE, FROZEN = BEMPD_TREATMENT_FROZEN, AUTOMATIC = BEMPD_TREATMENT_AUTOMATIC };

static const double size = 6, half_length = 0.5, spacing = 0.1;

static int32_t add_tough_material(bempd_model* model) {
  bempd_material material = sound_material();
  int32_t id = 0;
  material.critical_stretch = 0;
  material.fracture_energy = 1e-3;
  material.thermal_expansion = 1e-3;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  return id;
}

/** Square body with a crack in its middle, at an angle to its lower edge, pulled upwards. Ids: body 1, crack 1,
 * supports 1 and 2, load 1. */
static bempd_model* cracked_square(double angle) {
  const rectangle r = rectangle_of(0, 0, size, size);
  const double x = half_length * cos(angle), y = half_length * sin(angle), middle = 0.5 * size, up = 1;
  const double crack[4] = {middle - x, middle - y, middle + x, middle + y};
  bempd_model* model = new_model();
  CHECK_OK(model, bempd_add_body(model, add_tough_material(model), 4, r.vertices, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0, 0, BEMPD_X, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &up, NULL));
  return model;
}

static bempd_model* with_patch(double angle) {
  bempd_model* model = cracked_square(angle);
  CHECK_OK(model, bempd_set_body_lattice(model, 1, spacing, 3));
  CHECK_OK(model, bempd_set_crack_treatment(model, 1, LATTICE));
  return model;
}

static bempd_model_part part_of(bempd_model* model, int64_t index) {
  bempd_model_part part;
  CHECK_OK(NULL, bempd_part_init(&part, sizeof part));
  CHECK_OK(model, bempd_part(model, index, &part));
  return part;
}

static bempd_crack_tip tip_of(bempd_model* model, int64_t index) {
  bempd_crack_tip tip;
  CHECK_OK(NULL, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, index, &tip));
  return tip;
}

static void step_to(bempd_model* model, double load_factor) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step(model, load_factor, &report));
}

static double next_event(bempd_model* model) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e6, &report));
  return report.load_factor;
}

/** Positions of the nodes of a region. */
static double* positions_of(bempd_model* model, int32_t region, int64_t* nodes) {
  int32_t components = 0;
  double* places;
  CHECK_OK(model, bempd_field_size(model, region, BEMPD_POSITION, nodes, &components));
  places = malloc((size_t)(*nodes * components) * sizeof *places);
  CHECK_OK(model, bempd_copy_field(model, region, BEMPD_POSITION, *nodes * components, places));
  return places;
}

/** The body keeps its ids, edges and first nodes; the patch is a region of its own with bonds, points and a crack. */
static void a_patch_is_a_part_of_its_body(void) {
  const double angles[2] = {0, 0.5};
  double force[2], outline[400];
  int32_t regions = 0, edges = 0;
  int64_t parts = 0, bonds = 0, nodes = 0, corners = 0, k;
  int a;
  for (a = 0; a < 2; ++a) {
    bempd_model *plain = cracked_square(angles[a]), *model = with_patch(angles[a]);
    bempd_model_part body, patch;
    double *places, *before;
    int64_t nodes_before = 0;
    CHECK_OK(model, bempd_region_count(model, &regions));
    CHECK(regions == 1);
    step_to(model, 0.1);
    step_to(plain, 0.1);
    CHECK_OK(model, bempd_region_count(model, &regions));
    CHECK_OK(model, bempd_edge_count(model, 1, &edges));
    CHECK_OK(model, bempd_part_count(model, &parts));
    CHECK(regions == 2 && edges > 4 && parts == 2);
    body = part_of(model, 0), patch = part_of(model, 1);
    CHECK(body.kind == BEMPD_PART_ELEMENTS && body.reason == BEMPD_PART_BODY && body.region == 1 && body.loops == 2);
    CHECK(body.boundary_elements > 8 && body.material_points == 0 && isnan(body.growth_load_factor));
    CHECK(patch.kind == BEMPD_PART_LATTICE && patch.reason == BEMPD_PART_CRACK && patch.crack == 1);
    CHECK(patch.body == 1 && patch.region == 2 && patch.horizon_ratio == 3 && patch.material_points > 300);
    CHECK_CLOSE(patch.spacing, spacing, 0);
    printf("angle %g: growth at %g by the patch, %g by elements\n", angles[a], patch.growth_load_factor,
           patch.element_growth_load_factor);
    CHECK_CLOSE(patch.growth_load_factor, patch.element_growth_load_factor, 0.05 * patch.growth_load_factor);
    CHECK_OK(model, bempd_part_outline(model, 1, 0, 200, outline, &corners));
    CHECK(corners >= 4 && corners % 2 == 0 && corners == edges - 4);
    CHECK_OK(model, bempd_bond_count(model, 2, &bonds));
    CHECK(bonds > 3000);
    CHECK_OK(model, bempd_reaction(model, 1, force));
    CHECK_CLOSE(force[1], -0.1 * size, 1e-9);
    CHECK_CLOSE(tip_of(model, 1).stress_intensity_1, tip_of(plain, 1).stress_intensity_1,
                0.03 * tip_of(plain, 1).stress_intensity_1);
    places = positions_of(model, 1, &nodes), before = positions_of(plain, 1, &nodes_before);
    for (k = 0; k < nodes; ++k) {
      const double x = places[2 * k], y = places[2 * k + 1];
      const int on_outline = x == 0 || y == 0 || x == size || y == size;
      CHECK(on_outline || k >= 8);
    }
    free(places), free(before);
    bempd_model_free(model), bempd_model_free(plain);
  }
}

/** Loads on the whole body act in its patch too: weight reaches the supports, and heat causes no stress. */
static void loads_on_the_whole_body_reach_patches(void) {
  static const double inside[2] = {3, 3.3};
  double force[2], u[2], stress[3];
  int32_t region = 0;
  bempd_model* model = with_patch(0);
  CHECK_OK(model, bempd_set_option(model, "error.wanted", 0.05));
  CHECK_OK(model, bempd_add_body_force(model, 1, BEMPD_Y, 0.1, 0, NULL));
  CHECK_OK(model, bempd_add_temperature(model, 1, 10, 0, NULL));
  step_to(model, 0);
  CHECK_OK(model, bempd_reaction(model, 1, force));
  CHECK_CLOSE(force[1], -0.1 * size * size, 1e-8);
  bempd_model_free(model);
  model = with_patch(0);
  CHECK_OK(model, bempd_add_temperature(model, 1, 10, 0, NULL));
  step_to(model, 0);
  CHECK_OK(model, bempd_evaluate(model, 1, inside, u, stress, &region));
  CHECK(region == 2);
  CHECK_CLOSE(stress[0], 0, 1e-6);
  CHECK_CLOSE(stress[1], 0, 1e-6);
  CHECK_CLOSE(u[1], 10 * 1e-3 * inside[1], 1e-9);
  bempd_model_free(model);
}

/** A frozen crack is there, tells of its tips and does not grow; it grows once it is released, between two steps. */
static void frozen_cracks_stay(void) {
  int in_patch;
  for (in_patch = 0; in_patch < 2; ++in_patch) {
    bempd_model* model = in_patch ? with_patch(0) : cracked_square(0);
    double first, length = 0;
    CHECK_OK(model, bempd_prepare(model));
    first = tip_of(model, 0).critical_load_factor;
    CHECK_OK(model, bempd_set_crack_treatment(model, 1, FROZEN));
    step_to(model, 1.3 * first);
    CHECK_OK(model, bempd_crack_length(model, 1, &length));
    CHECK_CLOSE(length, 2 * half_length, 1e-9);
    CHECK(tip_of(model, 0).stress_intensity_1 > 1.2);
    CHECK_OK(model, bempd_set_crack_treatment(model, 1, in_patch ? LATTICE : AUTOMATIC));
    CHECK_CLOSE(next_event(model), 1.3 * first, 1e-9);
    CHECK_OK(model, bempd_crack_length(model, 1, &length));
    CHECK(length > 2 * half_length + 1e-3);
    bempd_model_free(model);
  }
}

/** A crack leaves its patch and goes on in elements, at loads close to those of elements alone. A state of the way goes
 * on with the same numbers. */
static void cracks_leave_patches(void) {
  bempd_model *model = with_patch(0), *other = with_patch(0);
  bempd_state* state = NULL;
  int64_t count = 0;
  int k, grown_in_elements = 0;
  CHECK_OK(model, bempd_set_option_text(model, "stepping.control", "path"));
  CHECK_OK(other, bempd_set_option_text(other, "stepping.control", "path"));
  for (k = 0; k < 60 && grown_in_elements < 1; ++k) {
    bempd_crack_extension last;
    next_event(model);
    CHECK_OK(model, bempd_extension_count(model, &count));
    CHECK_OK(NULL, bempd_crack_extension_init(&last, sizeof last));
    CHECK_OK(model, bempd_extension(model, count - 1, &last));
    if (last.length > 1.6 * spacing) ++grown_in_elements;
    if (k == 4) CHECK_OK(model, bempd_state_save(model, &state));
  }
  printf("%d events, %lld extensions\n", k, (long long)count);
  CHECK(grown_in_elements == 1);
  CHECK(tip_of(model, 0).method == BEMPD_TIP_ELEMENTS);
  CHECK_OK(other, bempd_state_restore(other, state));
  for (k = 5; k < 9; ++k) {
    bempd_crack_extension mine, theirs;
    int64_t reached = 0;
    next_event(other);
    CHECK_OK(other, bempd_extension_count(other, &reached));
    if (reached > count) break;
    CHECK_OK(NULL, bempd_crack_extension_init(&mine, sizeof mine));
    CHECK_OK(NULL, bempd_crack_extension_init(&theirs, sizeof theirs));
    CHECK_OK(other, bempd_extension(other, reached - 1, &theirs));
    CHECK_OK(model, bempd_extension(model, reached - 1, &mine));
    CHECK_CLOSE(theirs.load_factor, mine.load_factor, 1e-8 * mine.load_factor);
    CHECK_CLOSE(theirs.x, mine.x, 1e-7);
    if (reached == count) break;
  }
  bempd_state_free(state);
  bempd_model_free(model), bempd_model_free(other);
}

/** Plate with a crack: in a patch, or in a lattice of the same points. As a line it may grow at its right end only. */
static bempd_model* growing_plate(int in_patch, int by_bonds) {
  const double width = 1.5 * size;
  const rectangle r = rectangle_of(0, 0, width, size);
  const double middle = 0.5 * size + 0.5 * spacing, up = 1;
  const double from = (by_bonds ? 3.7 : 1.5) + 0.5 * spacing;
  const double crack[4] = {from, middle, from + 1, middle};
  bempd_model* model = new_model();
  const int32_t material = add_tough_material(model);
  if (in_patch) {
    CHECK_OK(model, bempd_add_body(model, material, 4, r.vertices, NULL));
  } else {
    add_pd_rectangle(model, material, 0, 0, width, size, spacing);
  }
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  if (in_patch) {
    CHECK_OK(model, bempd_set_body_lattice(model, 1, spacing, 3));
    CHECK_OK(model, bempd_set_crack_treatment(model, 1, LATTICE));
  }
  if (by_bonds) {
    CHECK_OK(model, bempd_set_option_text(model, "crack.rule", "bond"));
  } else {
    CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START, 1));
  }
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &up, NULL));
  CHECK_OK(model, bempd_set_option_text(model, "stepping.control", "path"));
  return model;
}

static bempd_crack_extension last_extension(bempd_model* model) {
  bempd_crack_extension last;
  int64_t count = 0;
  CHECK_OK(NULL, bempd_crack_extension_init(&last, sizeof last));
  CHECK_OK(model, bempd_extension_count(model, &count));
  CHECK(count > 0);
  if (count > 0) CHECK_OK(model, bempd_extension(model, count - 1, &last));
  return last;
}

/** Lines of the history at which no event happened, and the sum of the changes of stored energy there. */
static int64_t layouts_of(bempd_model* model, double* jump) {
  int64_t count = 0, k, found = 0;
  double before = 0;
  *jump = 0;
  CHECK_OK(model, bempd_history_count(model, &count));
  for (k = 0; k < count; ++k) {
    bempd_history_entry line;
    CHECK_OK(NULL, bempd_history_entry_init(&line, sizeof line));
    CHECK_OK(model, bempd_get_history_entry(model, k, &line));
    CHECK(line.energy_balance_error < 1e-8);
    if (line.event == 0) ++found, *jump += fabs(line.stored_energy - before);
    before = line.stored_energy;
  }
  return found;
}

/** The patch gets blocks ahead of a tip, so that the crack stays a line: step by step as in a lattice as large as the
 * body. */
static void patches_follow_tips(void) {
  enum { STEPS = 24 };
  bempd_model *model = growing_plate(1, 0), *whole = growing_plate(0, 0);
  double worst = 0, jump;
  int64_t points, bonds = 0;
  int k;
  CHECK_OK(model, bempd_prepare(model));
  points = part_of(model, 1).material_points;
  for (k = 0; k < STEPS; ++k) {
    bempd_crack_extension mine, theirs;
    next_event(model), next_event(whole);
    mine = last_extension(model), theirs = last_extension(whole);
    CHECK_CLOSE(mine.x, theirs.x, 0.02 * spacing);
    CHECK_CLOSE(mine.y, theirs.y, 0.02 * spacing);
    CHECK_CLOSE(mine.released_energy, theirs.released_energy, 5e-3 * theirs.released_energy);
    worst = fmax(worst, fabs(mine.load_factor / theirs.load_factor - 1));
  }
  CHECK(worst < 1e-3);
  CHECK(part_of(model, 1).material_points > points + 200 && part_of(model, 1).region == 2);
  CHECK_OK(model, bempd_bond_count(model, 2, &bonds));
  CHECK(bonds > 12 * points);
  CHECK(tip_of(model, 1).method == tip_of(whole, 1).method);
  CHECK(layouts_of(model, &jump) >= 1);
  printf("loads off by %g at most; %lld of %lld points at first; stored energy changed by %g\n", worst,
         (long long)points, (long long)part_of(model, 1).material_points, jump);
  bempd_model_free(model), bempd_model_free(whole);
}

static int32_t stop_at(double load_factor, int64_t events, int64_t broken_bonds, void* user) {
  (void)load_factor, (void)broken_bonds;
  return events >= *(const int64_t*)user;
}

/** Middles of the broken bonds of a region, in spacings of half a spacing, one after another. */
static int64_t* broken_places(bempd_model* model, int32_t region, int64_t* count) {
  int64_t nodes, bonds, k;
  double* places = positions_of(model, region, &nodes);
  int32_t *points, *states;
  int64_t* found;
  CHECK_OK(model, bempd_bond_count(model, region, &bonds));
  points = malloc(2 * (size_t)bonds * sizeof *points), states = malloc((size_t)bonds * sizeof *states);
  found = malloc((size_t)bonds * sizeof *found);
  CHECK_OK(model, bempd_copy_bonds(model, region, bonds, points, states));
  for (k = 0, *count = 0; k < bonds; ++k) {
    const double *a = places + 2 * points[2 * k], *b = places + 2 * points[2 * k + 1];
    if (states[k] != BEMPD_BOND_BROKEN) continue;
    found[(*count)++] = llround((a[0] + b[0]) / spacing) * 100000 + llround((a[1] + b[1]) / spacing);
  }
  free(places), free(points), free(states);
  return found;
}

static int in_order(const void* a, const void* b) {
  const int64_t x = *(const int64_t*)a, y = *(const int64_t*)b;
  return (x > y) - (x < y);
}

/** Bond by bond the same bonds break in a patch as in a lattice as large as the body, at the same loads; the patch gets
 * blocks around them. Where the body has no room for these, steps end with each event. */
static void patches_follow_broken_bonds(void) {
  enum { EVENTS = 400 };
  bempd_model *model = growing_plate(1, 1), *whole = growing_plate(0, 1);
  int64_t counts[2], points, k, *mine, *theirs;
  bempd_step_report report;
  bempd_run_errors errors;
  double worst = 0, jump = 0;
  CHECK_OK(model, bempd_prepare(model));
  points = part_of(model, 1).material_points;
  for (k = 0; k < EVENTS; ++k) worst = fmax(worst, fabs(next_event(model) / next_event(whole) - 1));
  mine = broken_places(model, 2, &counts[0]), theirs = broken_places(whole, 1, &counts[1]);
  qsort(mine, (size_t)counts[0], sizeof *mine, in_order), qsort(theirs, (size_t)counts[1], sizeof *theirs, in_order);
  CHECK(counts[0] == counts[1] && counts[0] > EVENTS);
  for (k = 0; k < counts[0] && k < counts[1]; ++k) CHECK(mine[k] == theirs[k]);
  CHECK(worst < 5e-4);
  CHECK(part_of(model, 1).material_points > points + 200 && layouts_of(model, &jump) >= 1);
  CHECK_OK(NULL, bempd_run_errors_init(&errors, sizeof errors));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "bond by bond", bempd_run_error_estimate(model, 1e3, &errors));
  printf("bond by bond: loads off by %g at most; %lld of %lld points at first; stored energy changed by %g\n", worst,
         (long long)points, (long long)part_of(model, 1).material_points, jump);
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_run_to_separation(model, 1e6, &report));
  CHECK(report.stop_reason == BEMPD_STOP_CRACK_STOPPED && !report.separated && report.events > 5);
  printf("stopped after %lld more events\n", (long long)report.events);
  CHECK_OK(model, bempd_run_to_separation(model, 1e6, &report));
  CHECK(report.stop_reason == BEMPD_STOP_CRACK_STOPPED && report.events < 20);
  free(mine), free(theirs);
  bempd_model_free(model), bempd_model_free(whole);
}

/** A cancelled step takes its blocks back, and states have them: a run that is stopped, or goes on in another model
 * from the bytes of its state, has the same loads. A growing crack gets its blocks within `most` events. */
static void growing_patches_are_taken_back_and_saved(int by_bonds, int most) {
  const int64_t cancel_after = most - 4;
  bempd_model *model = growing_plate(1, by_bonds), *other = growing_plate(1, by_bonds);
  bempd_state *early = NULL, *late = NULL, *read = NULL;
  bempd_step_report report;
  bempd_statistics sizes;
  double loads[400], jump;
  uint8_t* bytes;
  int64_t size_of_bytes = 0, points, grown = 0;
  int k;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(NULL, bempd_statistics_init(&sizes, sizeof sizes));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_OK(model, bempd_state_save(model, &early));
  CHECK_OK(model, bempd_get_statistics(model, &sizes));
  points = sizes.material_points;
  CHECK_OK(model, bempd_set_progress(model, stop_at, (void*)&cancel_after));
  CHECK(bempd_run_to_separation(model, 1e6, &report) == BEMPD_ERROR_CANCELLED);
  CHECK_OK(model, bempd_set_progress(model, NULL, NULL));
  CHECK_OK(model, bempd_get_statistics(model, &sizes));
  CHECK(sizes.material_points == points && layouts_of(model, &jump) == 0);
  CHECK_OK(model, bempd_extension_count(model, &grown));
  CHECK(grown == 0);
  for (k = 0; k < most; ++k) {
    loads[k] = next_event(model);
    if (k == most - 5) CHECK_OK(model, bempd_state_save(model, &late));
  }
  CHECK(layouts_of(model, &jump) >= 1);
  CHECK_OK(model, bempd_state_restore(model, early));
  CHECK_OK(model, bempd_get_statistics(model, &sizes));
  CHECK(sizes.material_points == points && layouts_of(model, &jump) == 0);
  for (k = 0; k < most; ++k) CHECK_CLOSE(next_event(model), loads[k], 1e-8 * loads[k]);
  CHECK_OK(NULL, bempd_state_to_bytes(late, 0, NULL, &size_of_bytes));
  bytes = malloc((size_t)size_of_bytes);
  CHECK_OK(NULL, bempd_state_to_bytes(late, size_of_bytes, bytes, &size_of_bytes));
  CHECK_OK(NULL, bempd_state_from_bytes(size_of_bytes, bytes, &read));
  CHECK_OK(other, bempd_state_restore(other, read));
  CHECK(layouts_of(other, &jump) >= 1);
  for (k = most - 4; k < most; ++k) CHECK_CLOSE(next_event(other), loads[k], 1e-8 * loads[k]);
  CHECK_OK(model, bempd_state_restore(model, late));
  for (k = most - 4; k < most; ++k) CHECK_CLOSE(next_event(model), loads[k], 1e-8 * loads[k]);
  free(bytes);
  bempd_state_free(early), bempd_state_free(late), bempd_state_free(read);
  bempd_model_free(model), bempd_model_free(other);
}

/** Patches without room and treatments that cannot be are refused, and the scene is as it was. */
static void what_cannot_be_is_refused(void) {
  static const double edge_crack[4] = {0, 1, 0.2, 1};
  int32_t regions = 0;
  bempd_model* model = with_patch(0);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_set_crack_treatment(model, 2, FROZEN));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 0", bempd_set_crack_treatment(model, 0, LATTICE));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "treatment is 5", bempd_set_crack_treatment(model, 1, 5));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 2", bempd_set_body_lattice(model, 2, 0.1, 4));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "spacing is -0.1", bempd_set_body_lattice(model, 1, -0.1, 4));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "horizon_ratio is 2", bempd_set_body_lattice(model, 1, 0.1, 2));
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 3, 3.9, 0.3, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_prepare(model));
  CHECK_OK(model, bempd_region_count(model, &regions));
  CHECK(regions == 1);
  CHECK_OK(model, bempd_set_crack_treatment(model, 1, AUTOMATIC));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "no lattice patch", bempd_set_crack_treatment(model, 1, LATTICE));
  bempd_model_free(model);
  model = with_patch(0);
  CHECK_OK(model, bempd_add_crack(model, 2, edge_crack, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "lattice patch", bempd_set_crack_treatment(model, 1, BEMPD_TREATMENT_ELEMENTS));
  bempd_model_free(model);
  model = bem_block();
  CHECK_OK(model, bempd_add_crack(model, 2, (const double[4]){3, 4, 7, 4}, NULL));
  CHECK_OK(model, bempd_set_crack_treatment(model, 1, LATTICE));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bempd_add_body", bempd_prepare(model));
  bempd_model_free(model);
  model = with_patch(0);
  CHECK_OK(model, bempd_add_crack(model, 2, (const double[4]){0, 0.5, 1, 0}, NULL));
  CHECK_OK(model, bempd_set_crack_treatment(model, 2, LATTICE));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_prepare(model));
  bempd_model_free(model);
  model = new_model();
  add_pd_rectangle(model, add_tough_material(model), 0, 0, 20, 20, 1);
  CHECK_OK(model, bempd_add_crack(model, 2, (const double[4]){5, 10, 15, 10}, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_set_crack_treatment(model, 1, BEMPD_TREATMENT_ELEMENTS));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bempd_add_body", bempd_prepare(model));
  CHECK_OK(model, bempd_set_crack_treatment(model, 1, AUTOMATIC));
  CHECK_OK(model, bempd_prepare(model));
  bempd_model_free(model);
}

int main(void) {
  a_patch_is_a_part_of_its_body();
  loads_on_the_whole_body_reach_patches();
  frozen_cracks_stay();
  cracks_leave_patches();
  patches_follow_tips();
  patches_follow_broken_bonds();
  growing_patches_are_taken_back_and_saved(0, 20);
  growing_patches_are_taken_back_and_saved(1, 400);
  what_cannot_be_is_refused();
  return check_finish();
}

/* Reactions, values in the body, history and reports say the same. */
#define CRACK_RULE "bond"
#include "scenes.h"

/** A block of both kinds, held on the left on rollers, under a traction on the right edge. */
static int32_t hold_and_pull(bempd_model* model, double traction) {
  int32_t load = 0;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_X, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 4.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &traction, &load));
  return load;
}

/** Uniaxial tension is exact in both kinds of region: stress = traction, u = (t/E x, -nu t/E (y - 4)). */
static void tension_is_uniform(bempd_model* model) {
  const double places[4] = {5.5, 4.25, 8.0, 1.5};
  const double traction = 0.1;
  double displacement[4];
  double stress[6];
  double reaction[2];
  int32_t regions[2] = {0, 0};
  int k;
  hold_and_pull(model, traction);
  CHECK_OK(model, bempd_step(model, 2.0, NULL));
  CHECK_OK(model, bempd_evaluate(model, 2, places, displacement, stress, regions));
  for (k = 0; k < 2; ++k) {
    const double strain = 2.0 * traction / 1000.0;
    CHECK(regions[k] == 1);
    CHECK_CLOSE(displacement[2 * k], strain * places[2 * k], 1e-9);
    CHECK_CLOSE(displacement[2 * k + 1], -strain / 3.0 * (places[2 * k + 1] - 4.0), 1e-9);
    CHECK_CLOSE(stress[3 * k], 2.0 * traction, 1e-6);
    CHECK_CLOSE(stress[3 * k + 1], 0.0, 1e-6);
    CHECK_CLOSE(stress[3 * k + 2], 0.0, 1e-6);
  }
  CHECK_OK(model, bempd_reaction(model, 1, reaction));
  CHECK_CLOSE(reaction[0], -2.0 * traction * 8.0, 1e-8);
  CHECK_CLOSE(reaction[1], 0.0, 1e-8);
  bempd_model_free(model);
}

static void new_load_values_act_from_the_next_step_on(bempd_model* model) {
  const double doubled = 0.2;
  const double dead = 0.05;
  double reaction[2];
  const int32_t load = hold_and_pull(model, 0.1);
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_set_load_values(model, load, 1, &dead, &doubled));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_reaction(model, 1, reaction));
  CHECK_CLOSE(reaction[0], -0.25 * 8.0, 1e-8);
  CHECK_OK(model, bempd_set_support_values(model, 1, 1, &dead, NULL));
  CHECK_OK(model, bempd_step(model, 0.0, NULL));
  CHECK_OK(model, bempd_reaction(model, 1, reaction));
  CHECK_CLOSE(reaction[0], -0.05 * 8.0, 1e-8);
  bempd_model_free(model);
}

static void places_in_the_coupled_plate_name_their_region(const coupled_plate* plate) {
  const double places[6] = {5.0, 4.0, 12.25, 4.0, 25.0, 1.0};
  int32_t regions[3] = {0, 0, 0};
  CHECK_OK(plate->model, bempd_evaluate(plate->model, 3, places, NULL, NULL, regions));
  CHECK(regions[0] == plate->left && regions[1] == plate->strip && regions[2] == plate->right);
  CHECK_OK(plate->model, bempd_evaluate(plate->model, 0, places, NULL, NULL, NULL));
}

static void reactions_balance(const coupled_plate* plate) {
  double left[2], right[2], pin[2];
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pulled_left, left));
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pulled_right, right));
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pinned, pin));
  CHECK(left[0] < 0.0 && right[0] > 0.0);
  CHECK_CLOSE(left[0] + right[0], 0.0, 1e-8 * right[0]);
  CHECK_CLOSE(pin[1], 0.0, 1e-8 * right[0]);
}

static void history_follows_the_events(const coupled_plate* plate, const bempd_step_report* report) {
  bempd_history_entry entry;
  int64_t lines = 0;
  int64_t k;
  int64_t events = 0;
  int64_t broken = 0;
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  CHECK_OK(plate->model, bempd_history_count(plate->model, &lines));
  for (k = 0; k < lines; ++k) {
    CHECK_OK(plate->model, bempd_get_history_entry(plate->model, k, &entry));
    CHECK(entry.total_broken_bonds >= broken);
    if (entry.event != 0) {
      CHECK(entry.event == ++events && entry.total_broken_bonds > broken);
      CHECK(entry.stretch_ratio >= 1.0 - 1e-9);
    }
    CHECK(entry.energy_balance_error < 1e-6 && entry.residual < 1e-6);
    broken = entry.total_broken_bonds;
  }
  if (lines > 0) { /* The same under the name of version 0.1. */
    bempd_history_entry alike;
    CHECK_OK(NULL, bempd_history_entry_init(&alike, sizeof alike));
    CHECK_OK(plate->model, bempd_history(plate->model, lines - 1, &alike));
    CHECK(memcmp(&alike, &entry, sizeof entry) == 0);
  }
  CHECK(events == report->total_events && broken == report->total_broken_bonds);
  CHECK(entry.event == 0 && entry.load_factor == report->load_factor);
  CHECK(entry.stored_energy == report->stored_energy && entry.work == report->work);
}

/** What a support did at the last line, the end of a step: that nothing jumps there, and NULL for what is not asked
 * for. */
static void supports_are_in_the_history(const coupled_plate* plate) {
  double displacement[2] = {-7.0, -7.0}, force[2] = {-7.0, -7.0}, before[2] = {-7.0, -7.0}, reaction[2];
  bempd_history_entry entry;
  int64_t count = 0;
  CHECK_OK(plate->model, bempd_history_count(plate->model, &count));
  CHECK_OK(NULL, bempd_history_entry_init(&entry, sizeof entry));
  CHECK_OK(plate->model, bempd_get_history_entry(plate->model, count - 1, &entry));
  CHECK_OK(plate->model,
           bempd_get_history_support(plate->model, count - 1, plate->pulled_left, displacement, force, before));
  CHECK_OK(plate->model, bempd_get_history_support(plate->model, count - 1, plate->pulled_left, NULL, NULL, NULL));
  CHECK_OK(plate->model, bempd_reaction(plate->model, plate->pulled_left, reaction));
  CHECK(force[0] == reaction[0] && before[0] == force[0] && before[1] == force[1]);
  CHECK(displacement[0] != 0.0 && displacement[0] != -7.0);
  CHECK(entry.event == 0 && entry.resistance == entry.resistance_before && entry.work == entry.work_before);
}

static void run_ends_with_separation(double first_event) {
  const coupled_plate plate = coupled_plate_create();
  bempd_step_report report;
  double reaction[2] = {-7.0, -7.0};
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(plate.model, bempd_step(plate.model, 1.4 * first_event, &report));
  CHECK(report.stop_reason == BEMPD_STOP_LOAD_FACTOR && report.events > 0);
  CHECK(report.load_factor == 1.4 * first_event);
  places_in_the_coupled_plate_name_their_region(&plate);
  reactions_balance(&plate);
  history_follows_the_events(&plate, &report);
  supports_are_in_the_history(&plate);
  CHECK_OK(plate.model, bempd_run_to_separation(plate.model, 1000.0 * first_event, &report));
  CHECK(report.stop_reason == BEMPD_STOP_SEPARATED && report.separated == 1);
  CHECK(report.energy_balance_error < 1e-6 && report.residual < 1e-6);
  CHECK_OK(plate.model, bempd_reaction(plate.model, plate.pulled_left, reaction));
  CHECK_CLOSE(reaction[0], 0.0, 1e-6);
  printf("first event at %.6g, separated at %.6g with %lld broken bonds\n", first_event, report.load_factor,
         (long long)report.total_broken_bonds);
  bempd_model_free(plate.model);
}

static void body_that_cannot_break_has_no_further_event(void) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  bempd_step_report report;
  const double traction = 0.1;
  material.critical_stretch = 0.0;
  CHECK_OK(model, bempd_add_material(model, &material, NULL));
  add_pd_rectangle(model, 1, 0.0, 0.0, 10.0, 8.0, 1.0);
  hold_and_pull(model, traction);
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_run_to_separation(model, 1e6, &report));
  CHECK(report.stop_reason == BEMPD_STOP_NO_FURTHER_EVENT && report.separated == 0 && report.total_events == 0);
  bempd_model_free(model);
}

/** A disc under pressure, and a turned lattice that is pulled: their stress is uniform. */
static void discs_and_turned_lattices_bear_uniform_stress(void) {
  static const double square[8] = {0.0, 0.0, 8.0, 0.0, 8.0, 8.0, 0.0, 8.0};
  const double minus_one = -1.0, one = 1.0, place[4] = {0.3, -0.2, 4.1, 3.7};
  double stress[6];
  int32_t edge;
  bempd_model* model = new_model();
  CHECK_OK(model, bempd_add_bem_disc(model, add_sound_material(model), 0.0, 0.0, 2.0, 0.5, NULL));
  for (edge = 1; edge <= 4; ++edge)
    CHECK_OK(model, bempd_add_pressure(model, 1, edge, 0.0, 1.0, 1, NULL, &minus_one, NULL));
  CHECK_OK(model, bempd_fix_point(model, 2.0, 0.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_fix_point(model, -2.0, 0.0, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_evaluate(model, 1, place, NULL, stress, NULL));
  CHECK_CLOSE(stress[0], 1.0, 1e-8);
  CHECK_CLOSE(stress[1], 1.0, 1e-8);
  CHECK_CLOSE(stress[2], 0.0, 1e-8);
  bempd_model_free(model);

  model = new_model();
  CHECK_OK(model, bempd_add_turned_pd_region(model, add_sound_material(model), 4, square, NULL, 0.5, 4, 0.3, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_X, NULL));
  CHECK_OK(model, bempd_fix_point(model, 0.0, 0.0, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_step(model, 0.01, NULL));
  CHECK_OK(model, bempd_evaluate(model, 1, place + 2, NULL, stress, NULL));
  CHECK_CLOSE(stress[0], 0.01, 1e-10);
  CHECK_CLOSE(stress[1], 0.0, 1e-10);
  bempd_model_free(model);
}

/** The load factors that a lattice bears end where its first bond breaks; a support's moment is that of its force. */
static void admissible_loads_end_at_the_first_event(void) {
  bempd_model* model = pd_block();
  bempd_step_report report;
  double lowest = 1.0, highest = -1.0, force[2], moment = 0.0;
  const double pull = 0.1;
  int32_t held = 0;
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &held));
  CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_admissible_load_factors(model, &lowest, &highest));
  CHECK(lowest < 0.0 && highest > 0.0);
  CHECK_OK(model, bempd_step(model, 0.5 * highest, NULL));
  CHECK_OK(model, bempd_reaction(model, held, force));
  CHECK_OK(model, bempd_reaction_moment(model, held, 0.0, 0.0, &moment));
  CHECK_CLOSE(moment, -4.0 * force[0], 1e-9 * fabs(force[0])); /* at half of the height of 8 */
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e6, &report));
  CHECK_CLOSE(report.load_factor, highest, 1e-9 * highest);
  bempd_model_free(model);
}

/** Stress is unbounded at a tip as one over the root of the distance, and bounded beside it. */
static void stress_is_singular_at_a_tip(void) {
  static const double crack[4] = {3.0, 4.0, 7.0, 4.0}, places[4] = {7.0, 4.0, 5.0, 6.0};
  double orders[2];
  bempd_model* model = bem_block();
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_stress_orders(model, 2, places, orders));
  CHECK_CLOSE(orders[0], 0.5, 1e-9);
  CHECK_CLOSE(orders[1], 0.0, 0.0);
  bempd_model_free(model);
}

int main(void) {
  discs_and_turned_lattices_bear_uniform_stress();
  admissible_loads_end_at_the_first_event();
  stress_is_singular_at_a_tip();
  tension_is_uniform(bem_block());
  tension_is_uniform(pd_block());
  new_load_values_act_from_the_next_step_on(bem_block());
  new_load_values_act_from_the_next_step_on(pd_block());
  run_ends_with_separation(coupled_plate_first_event());
  body_that_cannot_break_has_no_further_event();
  return check_finish();
}

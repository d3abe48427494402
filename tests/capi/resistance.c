/** Resistance by growth and by direction: what is refused, what it means for lines and boundary elements, and states.
 */
#include <math.h>
#include <stdlib.h>

#include "scenes.h"

static const double quarter = 0.78539816339744831;

static void wrong_tables_are_refused(void) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  int32_t sound = 0, tough = 0;
  CHECK_OK(model, bempd_add_material(model, &material, &sound));
  material.critical_stretch = 0.0, material.fracture_energy = 2.0;
  CHECK_OK(model, bempd_add_material(model, &material, &tough));
  const double good[] = {0, 1, 2}, same[] = {0, 1, 1}, negative[] = {-1, 0, 1}, lost[] = {0, NAN, 2},
               wide[] = {0, 1, 3.2}, energies[] = {1, 2, 3}, none[] = {1, 0, 3}, unknown[] = {1, NAN, 3};
#define REFUSED(words, call) CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, words, call)
  REFUSED("no fracture_energy", bempd_set_resistance_curve(model, sound, 3, good, energies));
  REFUSED("material 7", bempd_set_resistance_curve(model, 7, 3, good, energies));
  REFUSED("count is 0", bempd_set_resistance_curve(model, tough, 0, good, energies));
  REFUSED("extensions is NULL", bempd_set_resistance_curve(model, tough, 3, NULL, energies));
  REFUSED("energies is NULL", bempd_set_resistance_curve(model, tough, 3, good, NULL));
  REFUSED("not above the one before", bempd_set_resistance_curve(model, tough, 3, same, energies));
  REFUSED("extension 1 is -1", bempd_set_resistance_curve(model, tough, 3, negative, energies));
  REFUSED("extension 2 is nan", bempd_set_resistance_curve(model, tough, 3, lost, energies));
  REFUSED("energy 2 is 0", bempd_set_resistance_curve(model, tough, 3, good, none));
  REFUSED("energy 2 is nan", bempd_set_resistance_curve(model, tough, 3, good, unknown));
  REFUSED("no fracture_energy", bempd_set_resistance_directions(model, sound, 3, good, energies));
  REFUSED("angles is NULL", bempd_set_resistance_directions(model, tough, 3, NULL, energies));
  REFUSED("half a turn", bempd_set_resistance_directions(model, tough, 3, wide, energies));
  REFUSED("angle 2 is nan", bempd_set_resistance_directions(model, tough, 3, lost, energies));
  REFUSED("not above the one before", bempd_set_resistance_directions(model, tough, 3, same, energies));
  CHECK_OK(model, bempd_set_resistance_curve(model, tough, 3, good, energies));
  CHECK_OK(model, bempd_set_resistance_directions(model, tough, 3, good, energies));
  const int32_t region = add_bem_rectangle(model, tough, 0.0, 0.0, 4.0, 4.0, 2.0);
  CHECK_OK(model, bempd_fix_edge(model, region, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_set_resistance_curve(model, tough, 3, good, energies));
  CHECK_FAILS(model, BEMPD_ERROR_ORDER, "prepare", bempd_set_resistance_directions(model, tough, 3, good, energies));
  bempd_model_free(model);
}

static void bond_by_bond_is_refused(void) {
  bempd_model* model = new_model();
  bempd_material material = sound_material();
  material.critical_stretch = 0.0, material.fracture_energy = 2.0;
  int32_t tough = 0;
  CHECK_OK(model, bempd_add_material(model, &material, &tough));
  const double at = 0.0, energy = 3.0;
  CHECK_OK(model, bempd_set_resistance_curve(model, tough, 1, &at, &energy));
  CHECK_OK(model, bempd_set_option_text(model, "crack.rule", "bond"));
  const int32_t region = add_pd_rectangle(model, tough, 0.0, 0.0, 8.0, 8.0, 1.0);
  CHECK_OK(model, bempd_fix_edge(model, region, 4, BEMPD_BOTH, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "bond by bond", bempd_prepare(model));
  bempd_model_free(model);
}

/* A square pulled at its top, with a crack from its left edge; `curve` and `weak`: the resistance by growth, and that
 * of a plane at 45 degrees, 1 for none. */
static bempd_model* square(int lattice, int curve, double weak) {
  bempd_model* model = new_model();
  CHECK_OK(model, bempd_set_option_text(model, "stepping.control", "path"));
  CHECK_OK(model, bempd_set_option_text(model, "crack.criterion", "energy"));
  bempd_material material = sound_material();
  material.critical_stretch = 0.0, material.fracture_energy = 2.0;
  int32_t tough = 0, crack = 0;
  CHECK_OK(model, bempd_add_material(model, &material, &tough));
  const double growth[] = {0.0, 4.0}, rising[] = {2.0, 6.0};
  const double angles[] = {quarter - 0.01, quarter, quarter + 0.01}, energies[] = {2.0, 2.0 * weak, 2.0};
  if (curve) CHECK_OK(model, bempd_set_resistance_curve(model, tough, 2, growth, rising));
  if (weak != 1.0) CHECK_OK(model, bempd_set_resistance_directions(model, tough, 3, angles, energies));
  const int32_t region = lattice ? add_pd_rectangle(model, tough, 0.0, 0.0, 20.0, 20.0, 1.0)
                                 : add_bem_rectangle(model, tough, 0.0, 0.0, 20.0, 20.0, 2.5);
  if (!lattice) CHECK_OK(model, bempd_set_option(model, "crack.step", 1.0));
  const double line[] = {0.0, 10.5, 8.5, 10.5}, one = 1e-3;
  CHECK_OK(model, bempd_add_crack(model, 2, line, &crack));
  CHECK_OK(model, bempd_fix_edge(model, region, 1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, region, 3, 0.0, 1.0, BEMPD_Y, 1, NULL, &one, NULL));
  return model;
}

static double next_load(bempd_model* model) {
  bempd_step_report report;
  double load_factor = 0.0;
  CHECK_OK(model, bempd_step_report_init(&report, sizeof report));
  CHECK_OK(model, bempd_step_to_next_event(model, 1e9, &report));
  CHECK(report.stop_reason == BEMPD_STOP_EVENT);
  CHECK_OK(model, bempd_load_factor(model, &load_factor));
  return load_factor;
}

static bempd_crack_extension last_extension(bempd_model* model) {
  int64_t count = 0;
  bempd_crack_extension extension;
  CHECK_OK(model, bempd_extension_count(model, &count));
  CHECK_OK(model, bempd_crack_extension_init(&extension, sizeof extension));
  CHECK_OK(model, bempd_extension(model, count - 1, &extension));
  return extension;
}

/* The load after a growth by da is larger by the root of the energy for da over that at first. */
static void growth_raises_the_load(void) {
  for (int lattice = 0; lattice < 2; ++lattice) {
    bempd_model *plain = square(lattice, 0, 1.0), *tougher = square(lattice, 1, 1.0);
    double grown = 0.0;
    for (int step = 0; step < 4; ++step) {
      const double ratio = next_load(tougher) / next_load(plain);
      CHECK_CLOSE(ratio * ratio, 1.0 + grown / 2.0, lattice ? 0.02 : 1e-6);
      CHECK_CLOSE(last_extension(tougher).resistance, 2.0 + grown, 1e-9);
      grown += last_extension(tougher).length;
    }
    bempd_model_free(plain), bempd_model_free(tougher);
  }
}

static void weak_plane_turns_the_crack(void) {
  for (int lattice = 0; lattice < 2; ++lattice) {
    bempd_model *straight = square(lattice, 0, 0.8), *turns = square(lattice, 0, 0.6);
    next_load(straight), next_load(turns);
    CHECK(fabs(last_extension(straight).angle) < 0.1);
    CHECK_CLOSE(last_extension(turns).angle, quarter, 1e-6);
    CHECK_CLOSE(last_extension(turns).resistance, 1.2, 1e-9);
    bempd_model_free(straight), bempd_model_free(turns);
  }
}

/* A run that goes on from the bytes of a state meets the resistance of all growth so far. */
static void states_know_the_growth(void) {
  for (int lattice = 0; lattice < 2; ++lattice) {
    bempd_model *first = square(lattice, 1, 1.0), *again = square(lattice, 1, 1.0), *other = square(lattice, 0, 1.0);
    next_load(first), next_load(first);
    bempd_state *state = NULL, *copy = NULL;
    CHECK_OK(first, bempd_state_save(first, &state));
    int64_t size = 0;
    CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &size));
    unsigned char* bytes = malloc((size_t)size);
    CHECK_OK(NULL, bempd_state_to_bytes(state, size, bytes, &size));
    CHECK_OK(NULL, bempd_state_from_bytes(size, bytes, &copy));
    CHECK_OK(again, bempd_state_restore(again, copy));
    CHECK(next_load(again) == next_load(first));
    CHECK_FAILS(other, BEMPD_ERROR_ARGUMENT, "another scene", bempd_state_restore(other, copy));
    free(bytes);
    bempd_state_free(state), bempd_state_free(copy);
    bempd_model_free(first), bempd_model_free(again), bempd_model_free(other);
  }
}

int main(void) {
  wrong_tables_are_refused();
  bond_by_bond_is_refused();
  growth_raises_the_load();
  weak_plane_turns_the_crack();
  states_know_the_growth();
  return check_finish();
}

/* Growth of cracks in BEM regions: which tips grow and where to, energies, history, states, and what is refused. */
#include "scenes.h"

static const double pi = 3.14159265358979323846;

/** A square plate of half width 1 around the origin, held against rigid motions; no cracks and no loads yet. Both tips
 * of a symmetric crack grow together. */
static bempd_model* square(double thickness) {
  bempd_model* model = new_model();
  bempd_material material;
  int32_t id = 0;
  const double vertices[] = {-1, -1, 1, -1, 1, 1, -1, 1};
  CHECK_OK(model, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1;
  material.poisson_ratio = 0.3;
  material.thickness = thickness;
  material.fracture_energy = 1;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  CHECK_OK(model, bempd_add_bem_region(model, id, 4, vertices, 0.25, NULL));
  CHECK_OK(model, bempd_fix_point(model, -1, -1, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_point(model, 1, -1, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 0.01));
  return model;
}

static void pull(bempd_model* model) {
  const double one = 1, minus = -1;
  CHECK_OK(model, bempd_add_traction(model, 1, 3, 0, 1, BEMPD_Y, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_add_traction(model, 1, 1, 0, 1, BEMPD_Y, 1, NULL, &minus, NULL));
}

static void add_crack(bempd_model* model, double x0, double y0, double x1, double y1) {
  const double points[] = {x0, y0, x1, y1};
  CHECK_OK(model, bempd_add_crack(model, 2, points, NULL));
}

static bempd_crack_tip tip_of(bempd_model* model, int64_t index) {
  bempd_crack_tip tip;
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, index, &tip));
  return tip;
}

static int64_t tip_count(bempd_model* model) {
  int64_t count = -1;
  CHECK_OK(model, bempd_tip_count(model, &count));
  return count;
}

static bempd_crack_extension extension_of(bempd_model* model, int64_t index) {
  bempd_crack_extension extension;
  CHECK_OK(model, bempd_crack_extension_init(&extension, sizeof extension));
  CHECK_OK(model, bempd_extension(model, index, &extension));
  return extension;
}

static int64_t extension_count(bempd_model* model) {
  int64_t count = -1;
  CHECK_OK(model, bempd_extension_count(model, &count));
  return count;
}

static bempd_growth grow(bempd_model* model, double length) {
  bempd_growth growth;
  CHECK_OK(model, bempd_growth_init(&growth, sizeof growth));
  CHECK_OK(model, bempd_grow_cracks(model, length, &growth));
  return growth;
}

static bempd_history_entry last_line(bempd_model* model) {
  bempd_history_entry entry;
  int64_t count = 0;
  CHECK_OK(model, bempd_history_count(model, &count));
  CHECK_OK(model, bempd_history_entry_init(&entry, sizeof entry));
  CHECK_OK(model, bempd_get_history_entry(model, count - 1, &entry));
  return entry;
}

/** The energy that the history has released is the integral of the rates of all tips, and the books balance. */
static void released_energy_is_the_integral_of_the_rates(int faces) {
  const double half = 0.5, quarter = 0.25, thickness = 0.7;
  bempd_model* model = square(thickness);
  double integral = 0, released = 0;
  int64_t events = 0;
  add_crack(model, -0.3, 0.05, 0.2, -0.05);
  pull(model);
  if (faces) {
    CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 1, NULL, &half, NULL));
    CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_SHEAR, 1, NULL, &quarter, NULL));
  }
  CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 1));
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  for (int k = 0; k < 8; ++k) {
    const bempd_growth growth = grow(model, 0.03);
    const bempd_history_entry line = last_line(model);
    CHECK(growth.tips == 2 && growth.ended == 0);
    CHECK_CLOSE(growth.length, 0.06, 1e-12);
    CHECK(line.event == ++events && line.load_factor == growth.load_factor && line.stretch_ratio == 1);
    CHECK(line.energy_balance_error < 1e-9);
    released += growth.released_energy;
    CHECK_CLOSE(line.released_energy, released, 1e-9 * released);
  }
  CHECK(extension_count(model) == 16);
  for (int64_t i = 0; i < 16; ++i) {
    const bempd_crack_extension e = extension_of(model, i);
    CHECK(e.event == i / 2 + 1 && e.crack == 1 && e.ended == 0 && e.count == i / 2 + 1);
    CHECK(e.end == (i % 2 == 0 ? BEMPD_CRACK_START : BEMPD_CRACK_END));
    CHECK_CLOSE(e.length, 0.03, 1e-12);
    CHECK_CLOSE(e.crack_length, hypot(0.5, 0.1) + 0.03 * (double)(i + 1), 1e-12);
    CHECK(e.energy_release_rate_before <= 1 + 1e-9 && e.energy_release_rate_before > 0.4);
    integral += e.released_energy;
  }
  printf("released %.8f, integral of the rates %.8f, difference %.1e\n", released, integral, integral / released - 1);
  CHECK_CLOSE(integral, released, 5e-3 * released);
  bempd_model_free(model);
}

/** The most critical tip has the fracture energy in its direction; without a share it goes alone. */
static void the_most_critical_tip_grows_alone(void) {
  bempd_model* model = square(1);
  bempd_growth growth;
  add_crack(model, -1, -0.3, -0.6, -0.3);
  add_crack(model, 1, 0.3, 0.7, 0.3);
  pull(model);
  growth = grow(model, 0.05);
  CHECK(growth.tips == 1 && extension_of(model, 0).crack == 1);
  CHECK_CLOSE(extension_of(model, 0).energy_release_rate_before, 1, 1e-9);
  bempd_model_free(model);
}

/** Two tips grow together if crack.tie_share allows it, by lengths that follow their rates if crack.exponent says so.
 */
static void lengths_follow_the_rates(void) {
  bempd_model* model = square(1);
  add_crack(model, -1, -0.3, -0.6, -0.3);
  add_crack(model, 1, 0.3, 0.7, 0.3);
  pull(model);
  CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 2));
  CHECK_OK(model, bempd_set_option(model, "crack.exponent", 1.5));
  CHECK(grow(model, 0.05).tips == 2);
  {
    const bempd_crack_extension first = extension_of(model, 0), second = extension_of(model, 1);
    CHECK_CLOSE(first.length, 0.05, 1e-9);
    CHECK(second.energy_release_rate_before < 0.9);
    CHECK_CLOSE(second.length, 0.05 * pow(second.energy_release_rate_before, 1.5), 1e-9);
    CHECK(second.event == first.event);
  }
  bempd_model_free(model);
}

static void frozen_tips_stay(void) {
  bempd_model* model = square(1);
  const double tip = 0.4;
  add_crack(model, -tip, 0, tip, 0);
  pull(model);
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START, 1));
  CHECK(grow(model, 0.05).tips == 1);
  CHECK_CLOSE(tip_of(model, 0).x, -tip, 1e-12);
  CHECK_CLOSE(tip_of(model, 1).x, tip + 0.05, 1e-12);
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_END, 1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "frozen", bempd_grow_cracks(model, 0.05, NULL));
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START, 0));
  CHECK(grow(model, 0.05).tips == 1);
  CHECK_CLOSE(tip_of(model, 0).x, -tip - 0.05, 1e-12);
  bempd_model_free(model);
}

/** Shear turns a crack by 70.5 degrees by the largest hoop stress, by 75.6 by the largest energy release rate. */
static void the_criterion_chooses_the_direction(void) {
  const char* names[] = {"hoop", "energy"};
  const double degrees[] = {70.53, 75.6};
  for (int k = 0; k < 2; ++k) {
    const double one = 1;
    bempd_model* model = square(1);
    add_crack(model, -0.01, 0, 0.01, 0);
    CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_SHEAR, 1, NULL, &one, NULL));
    CHECK_OK(model, bempd_set_option_text(model, "crack.criterion", names[k]));
    CHECK(grow(model, 0.001).tips == 2);
    CHECK_CLOSE(fabs(extension_of(model, 0).angle) * 180 / pi, degrees[k], 0.3);
    CHECK_CLOSE(extension_of(model, 0).energy_release_rate_before, 1, 1e-9);
    bempd_model_free(model);
  }
}

/** A crack runs from the edge into a hole, and goes no further; two in one line join. */
static void tips_end_where_they_meet_something(void) {
  bempd_model* model = square(1);
  bempd_growth growth;
  double hole_radius = 0.2, normal;
  const double middle = 0.5;
  CHECK_OK(model, bempd_add_circular_hole(model, 1, 0, 0, hole_radius, NULL));
  add_crack(model, -1, 0, -0.45, 0);
  pull(model);
  CHECK(grow(model, 0.1).ended == 0);
  growth = grow(model, 0.13);
  CHECK(growth.ended == 1 && tip_count(model) == 0);
  CHECK_CLOSE(extension_of(model, 1).x, -hole_radius, 1e-9);
  CHECK_CLOSE(extension_of(model, 1).length, 0.15, 1e-9);
  CHECK(extension_of(model, 1).ended == 1 && extension_of(model, 1).energy_release_rate_after == 0);
  CHECK_CLOSE(extension_of(model, 1).released_energy, growth.released_energy, 1e-12);
  CHECK_OK(model, bempd_crack_opening(model, 1, 1, &middle, &normal, NULL));
  CHECK(normal > 0);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tip", bempd_grow_cracks(model, 0.1, NULL));
  bempd_model_free(model);

  model = square(1);
  add_crack(model, -0.4, 0, -0.1, 0);
  add_crack(model, 0.1, 0, 0.4, 0);
  pull(model);
  CHECK(tip_count(model) == 4);
  growth = grow(model, 0.12);
  /* The two inner ones: the first to go stops short of the other's crack, which it would hit, and they are one. */
  CHECK(growth.tips == 2 && tip_count(model) <= 3);
  for (int k = 0; k < 3 && tip_count(model) > 2; ++k) grow(model, 0.12);
  CHECK(tip_count(model) == 2);
  CHECK_CLOSE(tip_of(model, 0).x, -tip_of(model, 1).x, 1e-6);
  bempd_model_free(model);
}

/** What grew is as good as a crack that was there from the start. */
static void a_grown_crack_is_a_crack(void) {
  const double long_crack[] = {-0.5, 0, 0.5, 0};
  bempd_model *grown = square(1), *given = square(1);
  add_crack(grown, -0.3, 0, 0.3, 0);
  pull(grown);
  for (int k = 0; k < 4; ++k) grow(grown, 0.05);
  CHECK_OK(given, bempd_add_crack(given, 2, long_crack, NULL));
  pull(given);
  {
    double factor = 0;
    bempd_crack_tip a, b;
    CHECK_OK(grown, bempd_load_factor(grown, &factor));
    CHECK_OK(given, bempd_set_tip_frozen(given, 1, BEMPD_CRACK_START, 1));
    CHECK_OK(given, bempd_set_tip_frozen(given, 1, BEMPD_CRACK_END, 1));
    CHECK_OK(given, bempd_step(given, factor, NULL));
    a = tip_of(grown, 1), b = tip_of(given, 1);
    CHECK_CLOSE(a.stress_intensity_1, b.stress_intensity_1, 1e-4 * b.stress_intensity_1);
    CHECK_CLOSE(a.t_stress, b.t_stress, 1e-2 * fabs(b.t_stress));
    CHECK_CLOSE(a.critical_load_factor, b.critical_load_factor, 1e-4 * b.critical_load_factor);
  }
  bempd_model_free(grown);
  bempd_model_free(given);
}

/** States bring shorter cracks back, in the model that grew and in one that never did, and longer ones. */
static void states_keep_what_has_grown(void) {
  bempd_model *model = square(1), *other = square(1);
  bempd_state *before = NULL, *after = NULL, *read = NULL;
  bempd_model* both[] = {model, other};
  uint8_t bytes[65536];
  int64_t size = 0;
  double first = 0, again = 0, x = 0;
  for (int k = 0; k < 2; ++k) {
    add_crack(both[k], -0.3, 0.1, 0.3, -0.1);
    pull(both[k]);
  }
  grow(model, 0.05);
  CHECK_OK(model, bempd_state_save(model, &before));
  first = grow(model, 0.05).load_factor;
  x = tip_of(model, 1).x;
  CHECK_OK(model, bempd_state_save(model, &after));
  CHECK_OK(model, bempd_state_restore(model, before));
  CHECK(extension_count(model) == 2 && tip_of(model, 1).x < x);
  again = grow(model, 0.05).load_factor;
  CHECK_CLOSE(again, first, 1e-10 * first);
  CHECK_CLOSE(tip_of(model, 1).x, x, 1e-9);
  CHECK_OK(model, bempd_state_to_bytes(after, sizeof bytes, bytes, &size));
  CHECK_OK(other, bempd_state_from_bytes(size, bytes, &read));
  CHECK_OK(other, bempd_state_restore(other, read));
  CHECK(extension_count(other) == 4 && tip_of(other, 1).x == x);
  CHECK_CLOSE(tip_of(other, 1).stress_intensity_1, tip_of(model, 1).stress_intensity_1, 1e-6);
  CHECK_OK(other, bempd_state_restore(other, before));
  CHECK(extension_count(other) == 2);
  bempd_state_free(before);
  bempd_state_free(after);
  bempd_state_free(read);
  bempd_model_free(model);
  bempd_model_free(other);
}

/** Long chords of a curved path end where short ones do. */
static void chords_follow_the_curve(void) {
  const char* names[] = {"tip", "chord"};
  double off[2];
  for (int k = 0; k < 2; ++k) {
    double y[2];
    for (int fine = 0; fine < 2; ++fine) {
      bempd_model* model = square(1);
      add_crack(model, -1, -0.5, -0.7, -0.2);
      pull(model);
      CHECK_OK(model, bempd_set_option_text(model, "crack.direction", names[k]));
      for (int step = 0; step < (fine ? 32 : 4); ++step) grow(model, fine ? 0.01 : 0.08);
      y[fine] = tip_of(model, 0).y;
      bempd_model_free(model);
    }
    off[k] = fabs(y[0] - y[1]);
  }
  printf("four steps end off thirty-two by %.5f along the tip, %.5f by chords\n", off[0], off[1]);
  CHECK(off[1] < 0.4 * off[0]);
}

static void misuse(void) {
  bempd_crack_extension extension;
  int64_t count;
  bempd_model* model = square(1);
  add_crack(model, -0.4, 0, 0.4, 0);
  pull(model);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_set_tip_frozen(model, 2, BEMPD_CRACK_END, 1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 0", bempd_set_tip_frozen(model, 0, BEMPD_CRACK_END, 1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack -1", bempd_set_tip_frozen(model, -1, BEMPD_CRACK_END, 0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "end is 3", bempd_set_tip_frozen(model, 1, 3, 1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "frozen is 2", bempd_set_tip_frozen(model, 1, BEMPD_CRACK_END, 2));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_extension_count(model, NULL));
  CHECK_OK(model, bempd_extension_count(model, &count));
  CHECK(count == 0);
  CHECK_OK(model, bempd_crack_extension_init(&extension, sizeof extension));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_extension(model, 0, &extension));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "extension", bempd_extension(model, 0, NULL));
  grow(model, 0.05);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_extension(model, 2, &extension));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_extension(model, -1, &extension));
  extension.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_extension(model, 0, &extension));
  CHECK(bempd_crack_extension_init(NULL, sizeof extension) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_set_tip_frozen(NULL, 1, BEMPD_CRACK_END, 1) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_extension_count(NULL, &count) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_extension(NULL, 0, &extension) == BEMPD_ERROR_ARGUMENT);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack.tie_share", bempd_set_option(model, "crack.tie_share", -1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack.criterion",
              bempd_set_option_text(model, "crack.criterion", "strain"));
  bempd_model_free(model);
}

int main(void) {
  released_energy_is_the_integral_of_the_rates(0);
  released_energy_is_the_integral_of_the_rates(1);
  the_most_critical_tip_grows_alone();
  lengths_follow_the_rates();
  frozen_tips_stay();
  the_criterion_chooses_the_direction();
  tips_end_where_they_meet_something();
  a_grown_crack_is_a_crack();
  states_keep_what_has_grown();
  chords_follow_the_curve();
  misuse();
  return check_finish();
}

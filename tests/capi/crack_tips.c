/* Cracks in BEM regions: stress intensity factors, openings, loads on faces, and what is refused. */
#include <float.h>

#include "scenes.h"

static const double pi = 3.14159265358979323846;

/** A plate 2 x 6 around the origin with unit modulus and one crack, pulled by 1 in y and held against rigid motions. */
static bempd_model* cracked_plate(int64_t count, const double* points, double fracture_energy) {
  bempd_model* model = new_model();
  bempd_material material;
  int32_t id = 0, region = 0, crack = 0;
  const double vertices[] = {-1, -3, 1, -3, 1, 3, -1, 3};
  const double one = 1, minus = -1;
  CHECK_OK(model, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1;
  material.poisson_ratio = 0.3;
  material.fracture_energy = fracture_energy;
  CHECK_OK(model, bempd_add_material(model, &material, &id));
  CHECK_OK(model, bempd_add_bem_region(model, id, 4, vertices, 0.25, &region));
  CHECK_OK(model, bempd_add_crack(model, count, points, &crack));
  CHECK(crack == 1);
  CHECK_OK(model, bempd_fix_point(model, -1, -3, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_fix_point(model, 1, -3, BEMPD_Y, NULL));
  CHECK_OK(model, bempd_add_traction(model, region, 3, 0, 1, BEMPD_Y, 1, NULL, &one, NULL));
  CHECK_OK(model, bempd_add_traction(model, region, 1, 0, 1, BEMPD_Y, 1, NULL, &minus, NULL));
  return model;
}

static bempd_crack_tip tip_of(bempd_model* model, int64_t index) {
  bempd_crack_tip tip;
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_OK(model, bempd_tip(model, index, &tip));
  return tip;
}

/** A stationary crack, although its material can break. */
static void keep_both_tips(bempd_model* model) {
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_START, 1));
  CHECK_OK(model, bempd_set_tip_frozen(model, 1, BEMPD_CRACK_END, 1));
}

static void a_centre_crack_has_its_factors(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  bempd_model* model = cracked_plate(2, crack, 1);
  int64_t count = 0;
  keep_both_tips(model);
  CHECK_OK(model, bempd_step(model, 2.0, NULL));
  CHECK_OK(model, bempd_tip_count(model, &count));
  CHECK(count == 2);
  for (int k = 0; k < 2; ++k) {
    const bempd_crack_tip tip = tip_of(model, k);
    const double factor = 1.1867 * sqrt(0.5 * pi);
    CHECK(tip.crack == 1 && tip.end == (k == 0 ? BEMPD_CRACK_START : BEMPD_CRACK_END));
    CHECK_CLOSE(tip.x, k == 0 ? -0.5 : 0.5, 1e-15);
    CHECK_CLOSE(tip.direction_x, k == 0 ? -1 : 1, 1e-15);
    CHECK_CLOSE(tip.stress_intensity_1, 2 * factor, 1e-4 * 2 * factor);
    CHECK_CLOSE(tip.stress_intensity_2, 0, 1e-4);
    CHECK_CLOSE(tip.energy_release_rate, 4 * factor * factor, 3e-4 * 4 * factor * factor);
    CHECK_CLOSE(tip.t_stress, 2 * -1.2569, 2e-3);
    CHECK_CLOSE(tip.kink_angle, 0, 1e-4);
    CHECK_CLOSE(tip.critical_load_factor, 1 / factor, 2e-4);
    CHECK(tip.error > 0 && tip.error < 1e-3 * factor);
  }
  bempd_model_free(model);
}

static void an_edge_crack_has_one_tip_and_an_opening(void) {
  const double crack[] = {-1, 0, 0, 0};
  const double fractions[] = {0, 0.5, 1};
  double normal[3], tangential[3];
  bempd_model* model = cracked_plate(2, crack, 0);
  int64_t count = 0;
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_tip_count(model, &count));
  CHECK(count == 1);
  /* Kaya and Erdogan 1987: 2.8246. */
  CHECK_CLOSE(tip_of(model, 0).stress_intensity_1, 2.8246 * sqrt(pi), 2e-4 * 5);
  CHECK(tip_of(model, 0).critical_load_factor == DBL_MAX);
  CHECK_OK(model, bempd_crack_opening(model, 1, 3, fractions, normal, tangential));
  CHECK(normal[0] > normal[1] && normal[1] > 0);
  CHECK_CLOSE(normal[2], 0, 1e-12);
  CHECK_CLOSE(tangential[1], 0, 1e-6 * normal[1]);
  /* The faces at the mouth are displacements of the boundary. */
  {
    const double mouth[] = {-1, 1e-7, -1, -1e-7};
    double u[4];
    CHECK_OK(model, bempd_evaluate(model, 2, mouth, u, NULL, NULL));
    CHECK_CLOSE(u[1] - u[3], normal[0], 1e-5 * normal[0]);
  }
  bempd_model_free(model);
}

static void pressure_opens_and_new_values_follow(void) {
  const double crack[] = {-0.01, 0.3, 0.01, 0.3};
  const double pressure[] = {3, 3}, less[] = {1, 1}, shear = 2;
  bempd_model* model = cracked_plate(2, crack, 0);
  int32_t load = 0;
  CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 2, pressure, NULL, &load));
  CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_SHEAR, 1, &shear, NULL, NULL));
  CHECK_OK(model, bempd_step(model, 0.0, NULL));
  CHECK_CLOSE(tip_of(model, 1).stress_intensity_1, 3 * sqrt(pi * 0.01), 2e-4 * 3 * sqrt(pi * 0.01));
  CHECK_CLOSE(tip_of(model, 1).stress_intensity_2, 2 * sqrt(pi * 0.01), 2e-4 * 2 * sqrt(pi * 0.01));
  CHECK_OK(model, bempd_set_load_values(model, load, 2, less, NULL));
  CHECK_OK(model, bempd_step(model, 0.5, NULL));
  CHECK_CLOSE(tip_of(model, 1).stress_intensity_1, 1.5 * sqrt(pi * 0.01), 2e-4 * 1.5 * sqrt(pi * 0.01));
  bempd_model_free(model);
}

static int warnings = 0;
static void count_overlaps(int32_t level, const char* message, void* user) {
  (void)user;
  if (level == 1 && strstr(message, "the faces of crack 1 overlap by") && strstr(message, " at (")) ++warnings;
}

static void faces_that_overlap_are_warned_of_once(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  bempd_model* model = cracked_plate(2, crack, 0);
  CHECK_OK(model, bempd_set_option_text(model, "contact", "none"));
  CHECK_OK(model, bempd_set_log(model, count_overlaps, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK(warnings == 0);
  CHECK_OK(model, bempd_step(model, -1.0, NULL));
  CHECK_OK(model, bempd_step(model, -2.0, NULL));
  CHECK(warnings == 1);
  CHECK(tip_of(model, 0).stress_intensity_1 < 0);
  bempd_model_free(model);
}

static void faces_that_press_do_not_overlap(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  const double fractions[] = {0.25, 0.5};
  double normal[2];
  bempd_model* model = cracked_plate(2, crack, 0);
  warnings = 0;
  CHECK_OK(model, bempd_set_log(model, count_overlaps, NULL));
  CHECK_OK(model, bempd_step(model, -2.0, NULL));
  CHECK(warnings == 0);
  CHECK(tip_of(model, 0).stress_intensity_1 == 0);
  CHECK_OK(model, bempd_crack_opening(model, 1, 2, fractions, normal, NULL));
  CHECK_CLOSE(normal[0], 0, 1e-9);
  CHECK_CLOSE(normal[1], 0, 1e-9);
  bempd_model_free(model);
}

static void values_beside_the_crack(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  const double tip[] = {0.5, 0}, beside[] = {0.5, 1e-9, 0.1, 1e-9};
  double u[4], stress[6];
  bempd_model* model = cracked_plate(2, crack, 0);
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "infinite", bempd_evaluate(model, 1, tip, u, stress, NULL));
  CHECK_OK(model, bempd_evaluate(model, 1, tip, u, NULL, NULL));
  CHECK_OK(model, bempd_evaluate(model, 2, beside, u, stress, NULL));
  CHECK(fabs(stress[4]) < 0.02);
  bempd_model_free(model);
}

static void snapshots_show_the_openings(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  char name[64];
  char text[4096] = "";
  FILE* file;
  bempd_model* model = cracked_plate(2, crack, 0);
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_set_option_text(model, "snapshots.existing", "replace"));
  CHECK_OK(model, bempd_write_snapshot(model, "crack_tips_snapshot"));
  for (int k = 0; k < 2; ++k) {
    snprintf(name, sizeof name, "crack_tips_snapshot%s", k == 0 ? ".pvd" : "_0000_cracks.vtu");
    file = fopen(name, "rb");
    CHECK(file != NULL);
    if (file == NULL) return;
    CHECK(fread(text, 1, sizeof text - 1, file) > 0);
    fclose(file);
    CHECK(strstr(text, k == 0 ? "_cracks.vtu" : "opening") != NULL);
  }
  bempd_model_free(model);
}

/** A plate of two regions whose interface passes the crack at a tenth of its length: both sides divide their elements
 *  there, and the factors are those of one region. */
static void another_region_beside_the_crack(void) {
  double factors[2];
  for (int split = 0; split < 2; ++split) {
    const double crack[] = {-0.5, 0, 0.5, 0};
    const double low[] = {-1, -3, 1, -3, 1, 0.1, -1, 0.1}, high[] = {-1, 0.1, 1, 0.1, 1, 3, -1, 3};
    const double whole[] = {-1, -3, 1, -3, 1, 3, -1, 3}, up = 1, down = -1;
    bempd_model* model = new_model();
    const int32_t material = add_sound_material(model);
    CHECK_OK(model, bempd_add_bem_region(model, material, 4, split ? low : whole, 0.25, NULL));
    if (split) CHECK_OK(model, bempd_add_bem_region(model, material, 4, high, 0.25, NULL));
    CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
    CHECK_OK(model, bempd_fix_point(model, -1, -3, BEMPD_BOTH, NULL));
    CHECK_OK(model, bempd_fix_point(model, 1, -3, BEMPD_Y, NULL));
    CHECK_OK(model, bempd_add_traction(model, split ? 2 : 1, 3, 0, 1, BEMPD_Y, 1, NULL, &up, NULL));
    CHECK_OK(model, bempd_add_traction(model, 1, 1, 0, 1, BEMPD_Y, 1, NULL, &down, NULL));
    CHECK_OK(model, bempd_step(model, 1.0, NULL));
    factors[split] = tip_of(model, 1).stress_intensity_1;
    bempd_model_free(model);
  }
  CHECK_CLOSE(factors[1], factors[0], 3e-4 * factors[0]);
}

/** A cracked BEM region and a lattice in one scene: its tips come first, whatever the cracks' numbers are. */
static void a_lattice_beside_the_cracked_region(void) {
  const double crack[] = {5, 0, 5, 3};
  coupled_plate plate = coupled_plate_build(NULL);
  int64_t count = 0;
  CHECK_OK(plate.model, bempd_add_crack(plate.model, 2, crack, NULL));
  CHECK_OK(plate.model, bempd_tip_count(plate.model, &count));
  CHECK(count == 2);
  CHECK_OK(plate.model, bempd_step(plate.model, 1e-3, NULL));
  CHECK(tip_of(plate.model, 0).crack == 2 && tip_of(plate.model, 0).stress_intensity_1 > 0);
  CHECK(tip_of(plate.model, 0).method == BEMPD_TIP_ELEMENTS && tip_of(plate.model, 0).contours == 0);
  CHECK(tip_of(plate.model, 1).crack == 1 && tip_of(plate.model, 1).method == BEMPD_TIP_STRESS);
  CHECK_FAILS(plate.model, BEMPD_ERROR_UNSOLVABLE, "fracture_energy", bempd_grow_cracks(plate.model, 1, NULL));
  bempd_model_free(plate.model);
}

static void a_crack_with_loads_cannot_be_removed(void) {
  const double crack[] = {-0.5, 0, 0.5, 0}, one = 1;
  bempd_model* model = cracked_plate(2, crack, 0);
  int32_t load = 0;
  int64_t count = 7;
  CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 1, &one, NULL, &load));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load 3", bempd_remove_crack(model, 1));
  CHECK_OK(model, bempd_remove_load(model, load));
  CHECK_OK(model, bempd_remove_crack(model, 1));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "removed",
              bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 1, &one, NULL, NULL));
  CHECK_OK(model, bempd_tip_count(model, &count));
  CHECK(count == 0);
  bempd_model_free(model);
}

static void cracks_of_1e_8_of_the_body_have_tips(void) {
  const double crack[] = {0.1 - 3e-8, 0.2, 0.1 + 3e-8, 0.2};
  bempd_model* model = cracked_plate(2, crack, 0);
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_CLOSE(tip_of(model, 1).stress_intensity_1 / sqrt(pi * 3e-8), 1, 1e-4);
  bempd_model_free(model);
}

/** An inclined crack turns to go across the pull, until its tips come through the sides. */
static void cracks_grow_until_they_cut_the_plate(void) {
  const double crack[] = {-0.2, -0.15, 0.2, 0.15};
  bempd_model* model = cracked_plate(2, crack, 1);
  bempd_growth growth;
  bempd_status status = BEMPD_OK;
  double first = 0, factor = 0, last_direction = 1, x = 0.2, y = 0.15;
  int64_t pieces = 0;
  int steps = 0;
  /* The tips of the crack grow together, in steps of the host. */
  CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 0.01));
  CHECK_OK(model, bempd_step(model, 0.5, NULL));
  CHECK_OK(model, bempd_growth_init(&growth, sizeof growth));
  {
    const bempd_crack_tip tip = tip_of(model, 1);
    const double turned = atan2(tip.direction_y, tip.direction_x) + tip.kink_angle;
    CHECK_OK(model, bempd_grow_cracks(model, 0.1, &growth));
    CHECK(growth.tips == 2 && growth.ended == 0);
    CHECK_CLOSE(tip_of(model, 1).x, x + 0.1 * cos(turned), 1e-6);
    CHECK_CLOSE(tip_of(model, 1).y, y + 0.1 * sin(turned), 1e-6);
    CHECK_CLOSE(growth.load_factor, tip.critical_load_factor, 1e-9); /* the other tip of a tie */
    CHECK(tip.critical_load_factor < tip.straight_load_factor);
    first = growth.load_factor;
    CHECK_OK(model, bempd_load_factor(model, &factor));
    CHECK(factor == first);
  }
  while (steps < 12 && (status = bempd_grow_cracks(model, 0.1, &growth)) == BEMPD_OK && growth.ended == 0) {
    ++steps;
    CHECK(growth.tips == 2 && growth.load_factor < first);
    CHECK(fabs(tip_of(model, 1).y + tip_of(model, 0).y) < 1e-6);
    /* The crack runs across the pull in the end. */
    last_direction = tip_of(model, 1).direction_y;
  }
  CHECK(steps >= 4 && fabs(last_direction) < 0.05);
  /* The plate is in two. */
  CHECK(status == BEMPD_OK && growth.ended == 2);
  CHECK_OK(model, bempd_piece_count(model, &pieces));
  CHECK(pieces == 2);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tip", bempd_grow_cracks(model, 0.1, NULL));
  bempd_model_free(model);
}

static void growth_that_cannot_be(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  bempd_growth growth;
  bempd_model* model = cracked_plate(2, crack, 0);
  CHECK(bempd_grow_cracks(NULL, 0.1, NULL) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_growth_init(NULL, sizeof growth) == BEMPD_ERROR_ARGUMENT);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "length", bempd_grow_cracks(model, 0, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "length", bempd_grow_cracks(model, NAN, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, "fracture_energy", bempd_grow_cracks(model, 0.1, NULL));
  CHECK_OK(model, bempd_growth_init(&growth, sizeof growth));
  growth.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_grow_cracks(model, 0.1, &growth));
  bempd_model_free(model);
}

static void cracks_that_cannot_be(void) {
  const double cut[] = {-1, 0, 1, 0}, corner[] = {-1, 0, -0.5, 0, -0.5, 1, -1, 1}, leaves[] = {0, 0, 2, 0};
  const double along[] = {-1, 0, -1, 1}, folded[] = {0, 0, 0.5, 0, 0.2, 0};
  struct {
    int64_t count;
    const double* points;
    bempd_status status;
    const char* words;
  } cases[] = {{2, cut, BEMPD_ERROR_UNSOLVABLE, "can translate"},
               {4, corner, BEMPD_ERROR_UNSOLVABLE, "can translate"},
               {2, leaves, BEMPD_ERROR_ARGUMENT, "outside"},
               {2, along, BEMPD_ERROR_ARGUMENT, "not inside"},
               {3, folded, BEMPD_ERROR_ARGUMENT, "along itself"}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
    bempd_model* model = cracked_plate(cases[i].count, cases[i].points, 0);
    CHECK_FAILS(model, cases[i].status, cases[i].words, bempd_prepare(model));
    bempd_model_free(model);
  }
}

static void misuse(void) {
  const double crack[] = {-0.5, 0, 0.5, 0};
  const double one = 1, nan = NAN, fraction = 0.5, beyond = 1.5;
  double opening;
  int64_t count;
  bempd_crack_tip tip;
  bempd_model* model = cracked_plate(2, crack, 0);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "component", bempd_add_crack_traction(model, 1, 3, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2",
              bempd_add_crack_traction(model, 2, BEMPD_PRESSURE, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "finite|nan",
              bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 1, &nan, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "value_count",
              bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 0, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_tip_count(model, NULL));
  CHECK_OK(model, bempd_tip_count(model, &count));
  CHECK_OK(model, bempd_crack_tip_init(&tip, sizeof tip));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_tip(model, count, &tip));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "index", bempd_tip(model, -1, &tip));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "tip", bempd_tip(model, 0, NULL));
  tip.struct_size = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_tip(model, 0, &tip));
  CHECK(bempd_crack_tip_init(NULL, sizeof tip) == BEMPD_ERROR_ARGUMENT);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "fractions", bempd_crack_opening(model, 1, 1, NULL, &opening, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "fraction", bempd_crack_opening(model, 1, 1, &beyond, &opening, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "fraction", bempd_crack_opening(model, 1, 1, &nan, &opening, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack 2", bempd_crack_opening(model, 2, 1, &fraction, &opening, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "count", bempd_crack_opening(model, 1, 0, &fraction, &opening, NULL));
  CHECK_OK(model, bempd_crack_opening(model, 1, 1, &fraction, NULL, NULL));
  CHECK(bempd_tip_count(NULL, &count) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_tip(NULL, 0, &tip) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_crack_opening(NULL, 1, 1, &fraction, &opening, NULL) == BEMPD_ERROR_ARGUMENT);
  CHECK(bempd_add_crack_traction(NULL, 1, BEMPD_PRESSURE, 1, &one, NULL, NULL) == BEMPD_ERROR_ARGUMENT);
  bempd_model_free(model);
}

static void cracks_in_lattices_have_openings(void) {
  const double crack[] = {4.5, 0.0, 4.5, 3.5};
  const double one = 1, fraction = 0.5;
  double opening;
  int64_t count = 7;
  bempd_model* model = pd_block();
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_tip_count(model, &count));
  CHECK(count == 1);
  CHECK_OK(model, bempd_crack_opening(model, 1, 1, &fraction, &opening, NULL));
  CHECK(opening == 0);
  bempd_model_free(model);
  model = pd_block();
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_add_crack_traction(model, 1, BEMPD_PRESSURE, 1, &one, NULL, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "peridynamic", bempd_prepare(model));
  bempd_model_free(model);
}

int main(void) {
  a_centre_crack_has_its_factors();
  an_edge_crack_has_one_tip_and_an_opening();
  pressure_opens_and_new_values_follow();
  faces_that_overlap_are_warned_of_once();
  faces_that_press_do_not_overlap();
  values_beside_the_crack();
  snapshots_show_the_openings();
  another_region_beside_the_crack();
  a_lattice_beside_the_cracked_region();
  a_crack_with_loads_cannot_be_removed();
  cracks_of_1e_8_of_the_body_have_tips();
  cracks_grow_until_they_cut_the_plate();
  growth_that_cannot_be();
  cracks_that_cannot_be();
  misuse();
  cracks_in_lattices_have_openings();
  return check_finish();
}

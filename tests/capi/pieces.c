/* Pieces of a body, and when it counts as separated. */
#define CRACK_RULE "bond"
#include "scenes.h"

static bempd_step_report new_report(void) {
  bempd_step_report report;
  CHECK_OK(NULL, bempd_step_report_init(&report, sizeof report));
  return report;
}

static bempd_piece piece_of(bempd_model* model, int32_t number) {
  bempd_piece piece;
  CHECK_OK(NULL, bempd_piece_init(&piece, sizeof piece));
  CHECK_OK(model, bempd_get_piece(model, number, &piece));
  return piece;
}

static int32_t connected(bempd_model* model, int32_t one, int32_t other) {
  int32_t answer = -1;
  CHECK_OK(model, bempd_are_connected(model, one, other, &answer));
  return answer;
}

/** The strip's points by its own bonds: two points that an intact one joins are of the same piece. */
static void check_bonds_join(bempd_model* model, int32_t region, const int32_t* pieces) {
  int64_t count = 0, k, joined = 0, parted = 0;
  int32_t *points, *states;
  CHECK_OK(model, bempd_bond_count(model, region, &count));
  points = (int32_t*)malloc((size_t)count * 2 * sizeof *points);
  states = (int32_t*)malloc((size_t)count * sizeof *states);
  if (points == NULL || states == NULL) abort();
  CHECK_OK(model, bempd_copy_bonds(model, region, count, points, states));
  for (k = 0; k < count; ++k) {
    const int same = pieces[points[2 * k]] == pieces[points[2 * k + 1]];
    if (states[k] == BEMPD_BOND_INTACT) CHECK(same);
    if (states[k] == BEMPD_BOND_INTACT) ++joined;
    if (!same) ++parted;
  }
  CHECK(joined > 0 && parted > 0);
  free(points);
  free(states);
}

static void a_torn_plate_is_in_pieces(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_step_report report = new_report();
  int64_t count = 0, nodes = 0, k, sum = 0;
  int32_t left = 0, right = 0, pinned = 0;
  int32_t* pieces;
  CHECK_OK(plate.model, bempd_piece_count(plate.model, &count));
  CHECK(count == 1 && connected(plate.model, plate.pulled_left, plate.pulled_right) == 1);
  CHECK_OK(plate.model, bempd_run_to_separation(plate.model, 100.0, &report));
  CHECK(report.stop_reason == BEMPD_STOP_SEPARATED && report.separated == 1 && report.hanging == 0);
  CHECK(report.peak_resistance > 0.0 && report.resistance < 1e-9 * report.peak_resistance);
  CHECK_OK(plate.model, bempd_piece_count(plate.model, &count));
  CHECK(count >= 2 && connected(plate.model, plate.pulled_left, plate.pulled_right) == 0);
  CHECK(connected(plate.model, plate.pulled_left, plate.pinned) == 1);
  CHECK_OK(plate.model, bempd_support_piece(plate.model, plate.pulled_left, &left));
  CHECK_OK(plate.model, bempd_support_piece(plate.model, plate.pulled_right, &right));
  CHECK_OK(plate.model, bempd_support_piece(plate.model, plate.pinned, &pinned));
  CHECK(left >= 1 && left <= 2 && right >= 1 && right <= 2 && left != right && pinned == left);
  CHECK_OK(plate.model, bempd_node_count(plate.model, plate.strip, &nodes));
  pieces = (int32_t*)malloc((size_t)nodes * sizeof *pieces);
  if (pieces == NULL) abort();
  CHECK_OK(plate.model, bempd_copy_node_pieces(plate.model, plate.strip, nodes, pieces));
  check_bonds_join(plate.model, plate.strip, pieces);
  CHECK_OK(plate.model, bempd_node_count(plate.model, plate.left, &nodes));
  pieces = (int32_t*)realloc(pieces, (size_t)nodes * sizeof *pieces);
  if (pieces == NULL) abort();
  CHECK_OK(plate.model, bempd_copy_node_pieces(plate.model, plate.left, nodes, pieces));
  for (k = 0; k < nodes; ++k) CHECK(pieces[k] == left);
  for (k = 1; k <= count; ++k) {
    const bempd_piece piece = piece_of(plate.model, (int32_t)k);
    CHECK(piece.nodes > 0 && (k == 1 || piece.nodes <= sum));
    CHECK(piece.supports == (k == left ? 2 : k == right ? 1 : 0) && piece.loads == 0);
    CHECK(piece.free_motions == (k == left ? 0 : k == right ? 1 : 3)); /* the right one may slide along y */
    sum = piece.nodes;
  }
  free(pieces);
  bempd_model_free(plate.model);
}

/** A block cut in two; the right part is turned by its edge, which a rigid motion gives in closed form. */
static void a_loose_piece_moves_as_its_edge_does(void) {
  const double cut[] = {6.5, 0.0, 6.5, 8.0}, profile[] = {0.01, 0.05}, force = 0.0;
  bempd_model* model = pd_block();
  bempd_piece piece;
  int32_t held = 0, turned = 0, load = 0, both = 0, number = 0;
  CHECK_OK(model, bempd_add_crack(model, 2, cut, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &held));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 2, profile, NULL, &turned));
  CHECK_OK(model, bempd_add_point_force(model, 10.0, 4.0, BEMPD_Y, 0.0, force, &load));
  CHECK_OK(model, bempd_add_traction(model, 1, 3, 0.0, 1.0, BEMPD_Y, 1, &force, NULL, &both));
  CHECK(connected(model, held, turned) == 0);
  CHECK_OK(model, bempd_support_piece(model, held, &number));
  CHECK(number == 1);
  CHECK_OK(model, bempd_load_piece(model, load, &number));
  CHECK(number == 2);
  CHECK_OK(model, bempd_load_piece(model, both, &number));
  CHECK(number == 0); /* the top edge belongs to both */
  piece = piece_of(model, 1);
  CHECK(piece.nodes == 7 * 9 && piece.supports == 1 && piece.loads == 1 && piece.free_motions == 0);
  CHECK(fabs(piece.move_x) + fabs(piece.move_y) + fabs(piece.rotation) + piece.deviation < 1e-14);
  piece = piece_of(model, 2);
  CHECK(piece.nodes == 4 * 9 && piece.supports == 1 && piece.loads == 2 && piece.free_motions == 1);
  CHECK(fabs(piece.x - 8.5) < 1e-12 && fabs(piece.y - 4.0) < 1e-12);
  CHECK(fabs(piece.rotation + 0.005) < 1e-12 && fabs(piece.move_x - 0.03) < 1e-12 && piece.deviation < 1e-12);
  bempd_model_free(model);
}

/** A block cut in two: its halves are held and press, or one of them has nothing but the other to lean on. */
static void pressed_faces_join_nothing(void) {
  const double cut[] = {6.5, 0.0, 6.5, 8.0}, push = -1e-3, none = 0.0;
  double force[2];
  int held;
  for (held = 0; held < 2; ++held) {
    bempd_model* model = pd_block();
    bempd_step_report report = new_report();
    int64_t pieces = 0;
    int32_t left = 0, right = 0;
    CHECK_OK(model, bempd_add_crack(model, 2, cut, NULL));
    CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, &left));
    if (held) {
      CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &push, &right));
      CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_Y, 1, NULL, &none, NULL));
    } else {
      CHECK_OK(model, bempd_add_traction(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &push, NULL));
    }
    CHECK_OK(model, bempd_step(model, 1.0, &report));
    CHECK_OK(model, bempd_piece_count(model, &pieces));
    CHECK_OK(model, bempd_reaction(model, left, force));
    CHECK(pieces == 2);
    CHECK(report.separated == 0);
    if (held) {
      const double pressed = force[0];
      CHECK(report.closed_places > 0 && report.fragments == 0 && pressed > 0.0 && connected(model, left, right) == 0);
      CHECK_OK(model, bempd_step(model, -1.0, &report));
      CHECK_OK(model, bempd_reaction(model, left, force));
      CHECK(report.closed_places == 0 && fabs(force[0]) < 1e-12 * pressed);
    } else {
      CHECK(report.closed_places == 0 && report.fragments == 1 && force[0] == 0.0);
    }
    bempd_model_free(model);
  }
}

static void last_bonds_do_not_decide_the_end(int one_by_one) {
  const double pull = 1e-6;
  int32_t pulled = 0;
  int hinge;
  double force[2];
  bempd_step_report report = new_report(), to_the_last = new_report();
  bempd_model* model = strip_with_crack(0.0065, 1, NULL, &pull, &pulled);
  if (one_by_one) CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 0.0));
  CHECK_OK(model, bempd_run_to_separation(model, 1e4, &report));
  CHECK(report.stop_reason == BEMPD_STOP_SEPARATED && fabs(report.load_factor - 126.6) < 0.01 * 126.6);
  CHECK(report.released_energy > 0.032 && report.released_energy < 0.035);
  CHECK_OK(model, bempd_reaction(model, pulled, force));
  CHECK(fabs(force[0] - report.resistance) < 1e-9 * report.peak_resistance);
  CHECK(report.hanging == connected(model, 1, pulled));
  hinge = report.resistance > 1e-6 * report.peak_resistance;
  if (hinge) {
    CHECK(report.resistance > 1e-4 * report.peak_resistance && report.resistance < 0.02 * report.peak_resistance);
    /* The run goes on to the last bond if it is asked to. */
    CHECK_OK(model, bempd_step(model, 2000.0, &to_the_last));
    CHECK(to_the_last.events > 0 && to_the_last.separated == 1);
  }
  bempd_model_free(model);
  model = strip_with_crack(0.0065, 1, NULL, &pull, &pulled);
  if (one_by_one) CHECK_OK(model, bempd_set_option(model, "crack.tie_share", 0.0));
  CHECK_OK(model, bempd_set_option(model, "stepping.separation_share", 0.0));
  CHECK_OK(model, bempd_run_to_separation(model, 1e4, &to_the_last));
  CHECK(to_the_last.stop_reason == BEMPD_STOP_SEPARATED);
  CHECK(to_the_last.resistance < 1e-9 * to_the_last.peak_resistance);
  CHECK(hinge ? to_the_last.load_factor > 1600.0
              : fabs(to_the_last.load_factor - report.load_factor) <= 1e-9 * report.load_factor);
  bempd_model_free(model);
}

/** Pulls the strip by an uneven profile: as a proportional load, at once, and in steps of a host's own. */
static void constant_values_separate_too(void) {
  const double profile[] = {0.975e-6, 1e-6, 0.975e-6}, none[] = {0.0, 0.0, 0.0};
  bempd_step_report report = new_report(), in_steps = new_report();
  int32_t pulled = 0;
  bempd_model* model = strip_with_crack(0.0045, 3, NULL, profile, &pulled);
  int64_t step = 0;
  CHECK_OK(model, bempd_run_to_separation(model, 1e4, &report));
  CHECK(report.stop_reason == BEMPD_STOP_SEPARATED && report.separated == 1);
  CHECK(fabs(report.load_factor - 144.527) < 1e-2);
  bempd_model_free(model);
  model = strip_with_crack(0.0045, 3, none, NULL, &pulled);
  while (!in_steps.separated && step < 200) {
    double values[3];
    int k;
    ++step;
    for (k = 0; k < 3; ++k) values[k] = profile[k] * (double)step;
    CHECK_OK(model, bempd_set_support_values(model, pulled, 3, values, none));
    CHECK_OK(model, bempd_step_to_values(model, (double)step, BEMPD_UNTIL_SEPARATED, &in_steps));
  }
  CHECK(step == 145 && in_steps.stop_reason == BEMPD_STOP_SEPARATED);
  CHECK(in_steps.total_events == report.total_events && fabs(in_steps.load_factor - report.load_factor) < 1e-6);
  CHECK(fabs(in_steps.peak_resistance - report.peak_resistance) < 1e-6 * report.peak_resistance);
  bempd_model_free(model);
}

static void a_body_without_load_is_not_separated(void) {
  const double pull = 1e-6;
  bempd_step_report report = new_report();
  int32_t pulled = 0;
  bempd_model* model = strip_with_crack(0.0065, 1, NULL, &pull, &pulled);
  CHECK_OK(model, bempd_step(model, 122.5, &report));
  CHECK(report.events > 0 && report.separated == 0 && report.peak_resistance > report.resistance);
  CHECK_OK(model, bempd_step(model, 0.0, &report));
  CHECK(report.events == 0 && report.separated == 0 && report.stop_reason == BEMPD_STOP_LOAD_FACTOR);
  CHECK_OK(model, bempd_step(model, 1.0, &report));
  CHECK(report.events == 0 && report.separated == 0);
  bempd_model_free(model);
}

/** The energy released does not grow without end under a dead load that is out of equilibrium. */
static void dead_loads_release_what_a_body_can(void) {
  const double pull = 1e5;
  bempd_step_report held = new_report(), path = new_report();
  bempd_model* model = strip_with_crack(0.0045, 0, NULL, NULL, NULL);
  CHECK_OK(model, bempd_add_traction(model, 3, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_run_to_separation(model, 1e4, &held));
  bempd_model_free(model);
  model = strip_with_crack(0.0045, 0, NULL, NULL, NULL);
  CHECK_OK(model, bempd_set_option_text(model, "stepping.control", "path"));
  CHECK_OK(model, bempd_add_traction(model, 3, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, NULL));
  CHECK_OK(model, bempd_run_to_separation(model, 1e4, &path));
  CHECK(held.stop_reason == BEMPD_STOP_SEPARATED && held.unstable_event > 0 && path.unstable_event == 0);
  CHECK(held.released_energy >= held.bond_energy && held.released_energy < 1.5 * held.bond_energy);
  CHECK(fabs(held.bond_energy - path.released_energy) < 1e-6 * path.released_energy);
  CHECK(held.energy_balance_error < 1e-6);
  CHECK(fabs(held.work - held.stored_energy - held.released_energy) < 1e-9 + 1e-3 * held.work);
  bempd_model_free(model);
}

static void what_is_no_piece_is_refused(void) {
  const coupled_plate plate = coupled_plate_create();
  bempd_piece piece;
  int32_t answer = 7;
  CHECK_OK(NULL, bempd_piece_init(&piece, sizeof piece));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "piece 2", bempd_get_piece(plate.model, 2, &piece));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "piece 0", bempd_get_piece(plate.model, 0, &piece));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "piece", bempd_get_piece(plate.model, 1, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "support 9", bempd_support_piece(plate.model, 9, &answer));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "NULL", bempd_support_piece(plate.model, 1, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "load 1", bempd_load_piece(plate.model, 1, &answer));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "support 0", bempd_are_connected(plate.model, 1, 0, &answer));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "NULL", bempd_are_connected(plate.model, 1, 2, NULL));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "region 8", bempd_copy_node_pieces(plate.model, 8, 1, &answer));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "capacity",
              bempd_copy_node_pieces(plate.model, plate.strip, 1, &answer));
  CHECK_FAILS(plate.model, BEMPD_ERROR_ARGUMENT, "NULL", bempd_piece_count(plate.model, NULL));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_piece_init(&piece, 2));
  CHECK(answer == 7);
  bempd_model_free(plate.model);
}

/** A crack from elements into a lattice: its mouth lies between two points, so that the elements' ends there are no
 * nodes of the scene. They are of the piece of their side. */
static void nodes_at_a_mouth_are_of_the_body(void) {
  static const double left[] = {0, 0, 10, 0, 10, 12, 0, 12}, right[] = {10, 0, 22, 0, 22, 12, 10, 12};
  static const double crack[] = {7, 6.5, 14, 6.5};
  bempd_model* model = NULL;
  bempd_material steel;
  int32_t material = 0, elements = 0, lattice = 0, k;
  int64_t count = 0, nodes = 0;
  int32_t* pieces;
  CHECK_OK(NULL, bempd_model_create(&model));
  CHECK_OK(model, bempd_material_init(&steel, sizeof steel));
  steel.young_modulus = 1.0;
  steel.poisson_ratio = 1.0 / 3.0;
  steel.fracture_energy = 1.0;
  CHECK_OK(model, bempd_add_material(model, &steel, &material));
  CHECK_OK(model, bempd_add_bem_region(model, material, 4, left, 2.0, &elements));
  CHECK_OK(model, bempd_add_pd_region(model, material, 4, right, 1.0, 3, &lattice));
  CHECK_OK(model, bempd_add_crack(model, 2, crack, NULL));
  CHECK_OK(model, bempd_fix_edge(model, elements, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_piece_count(model, &count));
  CHECK(count == 1);
  CHECK_OK(model, bempd_node_count(model, elements, &nodes));
  pieces = (int32_t*)malloc((size_t)nodes * sizeof *pieces);
  if (pieces == NULL) abort();
  CHECK_OK(model, bempd_copy_node_pieces(model, elements, nodes, pieces));
  for (k = 0; k < nodes; ++k) CHECK(pieces[k] == 1);
  free(pieces);
  bempd_model_free(model);
}

int main(void) {
  a_torn_plate_is_in_pieces();
  nodes_at_a_mouth_are_of_the_body();
  a_loose_piece_moves_as_its_edge_does();
  pressed_faces_join_nothing();
  last_bonds_do_not_decide_the_end(0);
  last_bonds_do_not_decide_the_end(1);
  constant_values_separate_too();
  a_body_without_load_is_not_separated();
  dead_loads_release_what_a_body_can();
  what_is_no_piece_is_refused();
  return check_finish();
}

/* Saved states whose checksum is right and whose arrays are not: refused, whatever stands in them. */
#define CRACK_RULE "bond"
#include "scenes.h"

/* The layout of formats 14 and 15: a head, numbers, then arrays that begin with the count of their entries. */
enum {
  offset_version = 12,
  offset_load_factor = 16 + 3 * 8,
  offset_in_equilibrium = offset_load_factor + 8,
  offset_events = offset_in_equilibrium + 2,
  offset_arrays = offset_events + 3 * 8 + 14 * 8
};
enum {
  displacement,
  total_displacement,
  total_force,
  stages,
  springs,
  unloaded,
  tips,
  history,
  reactions,
  reactions_before,
  support_displacements,
  extensions,
  grown_faces,
  closed_faces,
  closed_inside,
  array_count
};
static const int64_t entry_size[array_count] = {8, 8, 8, 1, 36, 1, 53, 144, 8, 8, 8, 137, 20, 1, 1};

typedef struct bytes {
  uint8_t* data;
  int64_t size;
  int64_t begin[array_count]; /**< of each array's count */
  int64_t count[array_count];
  int64_t begin_values, begin_way, begin_said;
  /** How the run goes on: its numbers; the first zone and node of windows; the factorization, none where 0, with its
   * first stage and its first change; and the window that is open, none where 0, with the tips that there were then. */
  int64_t begin_continuation, zones, zone_count, nodes, node_count, factor, factor_stages, factor_stage_count;
  int64_t factor_springs, changes, change_count, window, window_tips;
} bytes;

static int64_t count_at(const bytes* saved, int64_t place) {
  int64_t count;
  memcpy(&count, saved->data + place, 8);
  return count;
}

/** The place behind an array of numbers, or of such arrays. */
static int64_t behind(const bytes* saved, int64_t place, int64_t size) {
  return place + 8 + size * count_at(saved, place);
}
static int64_t behind_lists(const bytes* saved, int64_t place, int64_t size) {
  int64_t left = count_at(saved, place);
  for (place += 8; left > 0; --left) place = behind(saved, place, size);
  return place;
}

static void find_continuation(bytes* saved) {
  int64_t place = saved->begin_continuation, k;
  saved->zones = place + 12;
  saved->zone_count = count_at(saved, saved->zones);
  saved->nodes = behind(saved, saved->zones, 96);
  saved->node_count = count_at(saved, saved->nodes);
  place = behind(saved, saved->nodes, 4) + 1; /* and whether they are eliminated last */
  place = behind_lists(saved, place, 4);      /* places met */
  place = behind(saved, place, 1) + 8;        /* barred, and springs that bar */
  saved->factor = saved->data[place] ? place : 0;
  if (saved->data[place++]) {
    saved->factor_stages = place;
    saved->factor_stage_count = count_at(saved, place);
    saved->factor_springs = behind(saved, place, 8);
    place = saved->factor_springs + 8;
    for (k = count_at(saved, place), place += 8; k > 0; --k) place = behind(saved, place, 20) + 8;
    place = behind_lists(saved, place, 4);
    saved->changes = place;
    saved->change_count = count_at(saved, place);
    for (k = saved->change_count, place += 8; k > 0; --k)
      place = behind(saved, behind(saved, behind(saved, place + 1, 4), 4), 8);
  }
  saved->window = saved->data[place] ? place : 0;
  if (saved->data[place++]) {
    place += 8 + 4 + 8 + 1 + 8;
    place = behind(saved, place, 8) + 1; /* and whether faces have met in it */
    saved->window_tips = behind(saved, place, 24) + 8 + 3;
    place = behind(saved, saved->window_tips, entry_size[tips]);
  }
  CHECK(place + 8 == saved->size);
}

static bytes copy_of(const bytes* source) {
  bytes copy = *source;
  copy.data = (uint8_t*)malloc((size_t)source->size + 512);
  if (copy.data == NULL) abort();
  memcpy(copy.data, source->data, (size_t)source->size);
  return copy;
}

static bytes bytes_of(bempd_model* model) {
  bempd_state* state = NULL;
  bytes saved;
  int64_t place = offset_arrays;
  int array;
  memset(&saved, 0, sizeof saved);
  CHECK_OK(model, bempd_state_save(model, &state));
  CHECK_OK(NULL, bempd_state_to_bytes(state, 0, NULL, &saved.size));
  saved.data = (uint8_t*)malloc((size_t)saved.size + 512);
  if (saved.data == NULL) abort();
  CHECK_OK(NULL, bempd_state_to_bytes(state, saved.size, saved.data, NULL));
  bempd_state_free(state);
  for (array = 0; array < array_count; ++array) {
    saved.begin[array] = place;
    memcpy(&saved.count[array], saved.data + place, 8);
    place += 8 + entry_size[array] * saved.count[array];
  }
  place = behind_lists(&saved, place, 4); /* terms whose faces wait */
  place = behind(&saved, place, 8);       /* tips that have stopped */
  /* Positions of the members behind the arrays: the values in force of two supports with one each and of no load,
   * where a path of them ends, the acting values, which loads there are, whose values are not contained, and how the
   * run goes on. */
  saved.begin_values = place;
  saved.begin_way = place + 1 + 8 + 2 * (1 + 2 * (8 + 8)) + 8;
  saved.begin_said = saved.begin_way + 1 + 8 + 8 + 2 * (1 + 2 * (8 + 8)) + 8 + 8;
  saved.begin_continuation = saved.begin_said + 1;
  find_continuation(&saved);
  return saved;
}

/** FNV-1a, 64 bits, over all but the last eight bytes. */
static void sign(bytes* altered) {
  uint64_t sum = 14695981039346656037ULL;
  int64_t k;
  for (k = 0; k < altered->size - 8; ++k) sum = (sum ^ altered->data[k]) * 1099511628211ULL;
  memcpy(altered->data + altered->size - 8, &sum, 8);
}

/** Reading or restoring fails as an argument error, and the model goes on as if nothing had been asked. */
static void expect_refusal(bempd_model* model, bytes* altered, const char* what) {
  bempd_state* state = NULL;
  uint8_t* block = (uint8_t*)malloc((size_t)altered->size);
  double before = 0.0, after = 1.0;
  bempd_status status;
  if (block == NULL) abort();
  sign(altered);
  memcpy(block, altered->data, (size_t)altered->size);
  status = bempd_state_from_bytes(altered->size, block, &state);
  free(block);
  CHECK_OK(model, bempd_load_factor(model, &before));
  if (status == BEMPD_OK) status = bempd_state_restore(model, state);
  if (status != BEMPD_ERROR_ARGUMENT) fprintf(stderr, "altered: %s\n", what);
  CHECK(status == BEMPD_ERROR_ARGUMENT);
  CHECK_OK(model, bempd_load_factor(model, &after));
  CHECK(before == after);
  bempd_state_free(state);
  free(altered->data);
}

static void arrays_of_other_lengths_are_refused(bempd_model* model, const bytes* saved) {
  int array;
  int longer;
  for (array = 0; array < array_count; ++array) {
    if (array == springs) continue; /* a piece may be held by any number of them */
    for (longer = 0; longer <= 1; ++longer) {
      bytes altered = copy_of(saved);
      const int64_t size = entry_size[array];
      const int64_t first = saved->begin[array] + 8;
      const int64_t count = saved->count[array] + (longer ? 1 : -1);
      if (count < 0) {
        free(altered.data);
        continue;
      }
      memcpy(altered.data + saved->begin[array], &count, 8);
      if (longer) {
        memmove(altered.data + first + size, altered.data + first, (size_t)(saved->size - first));
        if (saved->count[array] == 0) memset(altered.data + first, 0, (size_t)size);
        altered.size += size;
      } else {
        memmove(altered.data + first, altered.data + first + size, (size_t)(saved->size - first - size));
        altered.size -= size;
      }
      expect_refusal(model, &altered, longer ? "an array with an entry more" : "an array with an entry less");
    }
  }
}

static void huge_counts_are_refused(bempd_model* model, const bytes* saved) {
  const uint64_t counts[] = {UINT64_MAX, (uint64_t)1 << 63, (uint64_t)1 << 61, (uint64_t)saved->size};
  int array;
  size_t k;
  for (array = 0; array < array_count; ++array)
    for (k = 0; k < sizeof counts / sizeof counts[0]; ++k) {
      bytes altered = copy_of(saved);
      memcpy(altered.data + saved->begin[array], &counts[k], 8);
      expect_refusal(model, &altered, "an array with a huge count");
    }
}

static void put_double(bempd_model* model, const bytes* saved, int64_t place, double value, const char* what) {
  bytes altered = copy_of(saved);
  memcpy(altered.data + place, &value, 8);
  expect_refusal(model, &altered, what);
}

static void put_byte(bempd_model* model, const bytes* saved, int64_t place, uint8_t value, const char* what) {
  bytes altered = copy_of(saved);
  altered.data[place] = value;
  expect_refusal(model, &altered, what);
}

static void put_count(bempd_model* model, const bytes* saved, int64_t place, int64_t value, const char* what) {
  bytes altered = copy_of(saved);
  memcpy(altered.data + place, &value, 8);
  expect_refusal(model, &altered, what);
}

static void numbers_have_to_be_finite(bempd_model* model, const bytes* saved) {
  const int arrays[] = {displacement, total_displacement, total_force, reactions};
  size_t k;
  for (k = 0; k < sizeof arrays / sizeof arrays[0]; ++k) {
    const int64_t last = saved->begin[arrays[k]] + 8 * saved->count[arrays[k]];
    put_double(model, saved, saved->begin[arrays[k]] + 8, NAN, "a number that is none");
    put_double(model, saved, last, INFINITY, "an infinite number");
  }
  put_double(model, saved, offset_load_factor, NAN, "the load factor");
  for (k = 2; k < 17; ++k)
    put_double(model, saved, saved->begin[history] + 8 + 8 * (int64_t)k, NAN, "a number of a line of the history");
  for (k = 0; k < 12; ++k) put_double(model, saved, offset_events + 3 * 8 + 8 * (int64_t)k, NAN, "a sum of the run");
  put_double(model, saved, saved->begin[reactions_before] + 8, NAN, "a reaction before an event");
  if (saved->count[extensions] > 0)
    for (k = 0; k < 6; ++k)
      put_double(model, saved, saved->begin[extensions] + 8 + 8 * (int64_t)k, NAN, "a number of an extension");
}

static void flags_and_counts_are_checked(bempd_model* model, const bytes* saved) {
  int64_t k;
  put_byte(model, saved, saved->begin[stages] + 8, 2, "a stage after a bond's last one");
  put_byte(model, saved, saved->begin[unloaded] + 8, 255, "a node's flag");
  if (saved->count[grown_faces] > 0) {
    put_byte(model, saved, saved->begin[closed_faces] + 8, 2, "whether faces press on each other");
    put_count(model, saved, saved->begin[grown_faces] + 8, -1, "the bond of a grown face");
    put_double(model, saved, saved->begin[grown_faces] + 8 + 4, NAN, "the normal of a grown face");
    put_double(model, saved, saved->begin[grown_faces] + 8 + 4, 3.0, "the normal of a grown face");
  }
  put_byte(model, saved, offset_in_equilibrium, 2, "in_equilibrium");
  put_byte(model, saved, offset_in_equilibrium + 1, 17, "separated");
  for (k = 0; k < 3; ++k) put_count(model, saved, offset_events + 8 * k, -1, "a negative count");
  put_count(model, saved, saved->begin[history] + 8, -1, "a negative event");
  /* The number of broken bonds is the one that is counted, with those cut at first. */
  put_count(model, saved, offset_events + 8, 1000, "the count of broken bonds");
  for (k = 0; k < saved->count[stages]; ++k) {
    const int64_t place = saved->begin[stages] + 8 + k;
    if (k % 7 == 0) put_byte(model, saved, place, saved->data[place] ? 0 : 1, "a bond broken or mended");
  }
}

static void springs_are_checked(bempd_model* model, const bytes* saved) {
  const int64_t first = saved->begin[springs] + 8;
  const int32_t nodes[] = {-1, (int32_t)(saved->count[unloaded]), INT32_MAX, INT32_MIN};
  size_t k;
  CHECK(saved->count[springs] > 0);
  for (k = 0; k < sizeof nodes / sizeof nodes[0]; ++k) {
    bytes altered = copy_of(saved);
    memcpy(altered.data + first, &nodes[k], 4);
    expect_refusal(model, &altered, "the node of a spring");
  }
  put_double(model, saved, first + 4, 3.0, "the direction of a spring");
  put_double(model, saved, first + 12, NAN, "the direction of a spring");
  put_double(model, saved, first + 20, -1.0, "the stiffness of a spring");
  put_double(model, saved, first + 20, INFINITY, "the stiffness of a spring");
  put_double(model, saved, first + 28, NAN, "the anchor of a spring");
}

static void values_in_force_are_checked(bempd_model* model, const bytes* saved) {
  const int64_t supports = saved->begin_values + 1, first = supports + 8;
  put_byte(model, saved, saved->begin_values, 2, "whether there are values in force");
  put_byte(model, saved, first, 7, "whether values are numbers");
  put_count(model, saved, supports, INT64_MAX, "a huge count of supports");
  put_count(model, saved, first + 1, -1, "a count of values");
  put_double(model, saved, first + 1 + 8, NAN, "a value in force");
  put_double(model, saved, first + 1 + 16 + 8, INFINITY, "a proportional value in force");
  put_byte(model, saved, saved->begin_said, 2, "whether values of the host are contained");
  put_byte(model, saved, saved->begin_way, 3, "whether values are on a way");
  put_double(model, saved, saved->begin_way + 1, NAN, "where the way ends");
  put_double(model, saved, saved->begin_way + 1 + 8 + 8 + 1 + 8, NAN, "a value that acts");
}

static void put_int(bempd_model* model, const bytes* saved, int64_t place, int32_t value, const char* what) {
  bytes altered = copy_of(saved);
  memcpy(altered.data + place, &value, 4);
  expect_refusal(model, &altered, what);
}

static void ways_to_go_on_are_checked(bempd_model* model, const bytes* saved) {
  const int64_t numbers = saved->begin_continuation;
  put_int(model, saved, numbers, -1, "events of the whole body before a window");
  put_int(model, saved, numbers + 4, 0, "how long a window is waited for");
  put_int(model, saved, numbers + 8, INT32_MAX, "events computed at once");
  put_count(model, saved, saved->zones, INT64_MAX, "a huge count of zones");
  if (saved->zone_count > 0) put_double(model, saved, saved->zones + 8 + 40, NAN, "where a zone ends");
  if (saved->node_count > 1) {
    put_int(model, saved, saved->nodes + 8, -1, "a node of a window");
    put_int(model, saved, saved->nodes + 8, INT32_MAX, "a node of a window");
    bytes altered = copy_of(saved);
    memcpy(altered.data + saved->nodes + 8, altered.data + saved->nodes + 12, 4);
    expect_refusal(model, &altered, "a node of a window twice");
  }
  if (saved->factor == 0) return;
  put_byte(model, saved, saved->factor, 2, "whether there is a factorization");
  put_count(model, saved, saved->factor_springs, 1000, "springs of the factorization");
  if (saved->factor_stage_count > 0) {
    put_int(model, saved, saved->factor_stages + 8, -1, "a bond of the factorization");
    put_int(model, saved, saved->factor_stages + 12, 7, "its stage");
  }
  if (saved->change_count > 0) {
    const int64_t columns = saved->changes + 8 + 1, unknowns = behind(saved, columns, 4);
    put_byte(model, saved, saved->changes + 8, 2, "whether a change adds");
    put_int(model, saved, columns + 8, 100000, "the end of a column");
    put_int(model, saved, unknowns + 8, INT32_MAX, "an unknown of a change");
    put_int(model, saved, unknowns + 8, -1, "an unknown of a change");
    put_double(model, saved, behind(saved, unknowns, 4) + 8, INFINITY, "a weight of a change");
  }
}

static void windows_are_checked(bempd_model* model, const bytes* saved) {
  const int64_t options = saved->window + 1, displacement_then = options + 8 + 4 + 8 + 1 + 8;
  const int64_t looks = behind(saved, displacement_then, 8) + 1, performed = behind(saved, looks, 24);
  put_double(model, saved, options, NAN, "the tie band of a window");
  put_byte(model, saved, options + 20, 9, "what a window holds");
  put_double(model, saved, options + 21, NAN, "where a window was opened");
  put_double(model, saved, displacement_then + 8, NAN, "a displacement with which a window was opened");
  put_byte(model, saved, looks - 1, 2, "whether faces have met in a window");
  put_count(model, saved, looks + 8, 1000000, "events after which a window computed more");
  put_double(model, saved, looks + 8 + 8, INFINITY, "the load factor then");
  put_count(model, saved, performed, -1, "events of a window");
  put_count(model, saved, saved->window_tips, INT64_MAX, "a huge count of tips");
  {
    bytes altered = copy_of(saved);
    const double along = 1.0;
    uint8_t* tip = altered.data + saved->window_tips + 8;
    altered.data[saved->window_tips] = 1;
    memset(tip, 0, (size_t)entry_size[tips]);
    memcpy(tip + 16, &along, 8);
    altered.size += entry_size[tips];
    expect_refusal(model, &altered, "a tip in a window that has none");
  }
}

static void other_versions_are_refused(const bytes* saved) {
  bytes altered = copy_of(saved);
  const uint32_t version = 1;
  bempd_state* state = NULL;
  memcpy(altered.data + offset_version, &version, 4);
  sign(&altered);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "version 1", bempd_state_from_bytes(altered.size, altered.data, &state));
  CHECK(state == NULL);
  free(altered.data);
}

/** A piece that cracks cut off is held by springs, the other one pulled until bonds break; built twice alike. */
static bempd_model* torn_block(const char* solver) {
  bempd_model* model = pd_block();
  const double cuts[] = {7.5, 0.0, 7.5, 8.0};
  const double notch[] = {3.5, 0.0, 3.5, 3.5};
  const double pull = 1.0;
  int k;
  CHECK_OK(model, bempd_set_option_text(model, "test.solver", solver));
  CHECK_OK(model, bempd_add_crack(model, 2, cuts, NULL));
  CHECK_OK(model, bempd_add_crack(model, 2, notch, NULL));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 1, 0.6, 0.7, BEMPD_X, 1, NULL, &pull, NULL));
  for (k = 0; k < 6; ++k) CHECK_OK(model, bempd_step_to_next_event(model, 100.0, NULL));
  return model;
}

/** Nothing of a state comes from what lay in memory before. */
static void equal_states_give_equal_bytes(void) {
  bempd_model* one = torn_block("window");
  bytes of_one = bytes_of(one);
  void* used = malloc(100000);
  bempd_model* other;
  bytes of_other;
  if (used == NULL) abort();
  memset(used, 0xAB, 100000);
  free(used);
  other = torn_block("window");
  of_other = bytes_of(other);
  CHECK(of_one.size == of_other.size && memcmp(of_one.data, of_other.data, (size_t)of_one.size) == 0);
  free(of_one.data);
  free(of_other.data);
  bempd_model_free(one);
  bempd_model_free(other);
}

/** Every byte set to something else: whatever comes of it, it is an answer. */
static void altered_bytes_do_no_harm(bempd_model* model, const bytes* saved) {
  uint32_t seed = 7;
  int64_t k;
  for (k = 16; k < saved->size - 8; k += 1 + saved->size / 400) {
    bytes altered = copy_of(saved);
    bempd_state* state = NULL;
    bempd_status status;
    seed = seed * 1664525u + 1013904223u;
    altered.data[k] = (uint8_t)(seed >> 24);
    sign(&altered);
    status = bempd_state_from_bytes(altered.size, altered.data, &state);
    if (status == BEMPD_OK) status = bempd_state_restore(model, state);
    CHECK(status == BEMPD_OK || status == BEMPD_ERROR_ARGUMENT);
    bempd_state_free(state);
    free(altered.data);
  }
}

/** Checks states in a window and without one, of which only the latter have faces of broken bonds and changes of the
 * factorization. */
static void every_state_is_checked(const char* solver) {
  bempd_model* model = torn_block(solver);
  bytes saved = bytes_of(model);
  const int has_window = strcmp(solver, "window") == 0;
  CHECK((saved.window != 0) == has_window);
  CHECK((saved.count[grown_faces] > 0 && saved.change_count > 0) == !has_window);
  arrays_of_other_lengths_are_refused(model, &saved);
  huge_counts_are_refused(model, &saved);
  numbers_have_to_be_finite(model, &saved);
  flags_and_counts_are_checked(model, &saved);
  springs_are_checked(model, &saved);
  values_in_force_are_checked(model, &saved);
  ways_to_go_on_are_checked(model, &saved);
  if (has_window) windows_are_checked(model, &saved);
  other_versions_are_refused(&saved);
  altered_bytes_do_no_harm(model, &saved);
  free(saved.data);
  bempd_model_free(model);
}

int main(void) {
  every_state_is_checked("window");
  every_state_is_checked("plain");
  equal_states_give_equal_bytes();
  return check_finish();
}

/* Names of regions, edges, supports and loads: in messages, the log, explanations, tables and files. */
#include "scenes.h"

static char heard[4000];

static void hear(int32_t level, const char* message, void* user) {
  (void)level;
  (void)user;
  strncat(heard, message, sizeof heard - strlen(heard) - 1);
  strncat(heard, "\n", sizeof heard - strlen(heard) - 1);
}

static int file_says(const char* path, const char* words) {
  static char text[1 << 20];
  const size_t length = strlen(words);
  FILE* file = fopen(path, "rb");
  size_t size, at;
  if (file == NULL) return 0;
  size = fread(text, 1, sizeof text, file);
  fclose(file);
  for (at = 0; at + length <= size; ++at)
    if (memcmp(text + at, words, length) == 0) return 1;
  return 0;
}

/** A plate whose region, edges, support and load have names. */
static bempd_model* named_plate(void) {
  bempd_model* model = new_model();
  const int32_t material = add_sound_material(model);
  const int32_t plate = add_bem_rectangle(model, material, 0.0, 0.0, 4.0, 4.0, 1.0);
  const double pull = 1.0;
  int32_t support = 0, load = 0;
  CHECK_OK(model, bempd_name_region(model, plate, "pane"));
  CHECK_OK(model, bempd_name_edge(model, plate, 4, "left \"<side>\""));
  CHECK_OK(model, bempd_name_edge(model, plate, 1, "rim"));
  CHECK_OK(model, bempd_name_edge(model, plate, 3, "rim"));
  CHECK_OK(model, bempd_fix_edge(model, plate, 4, BEMPD_BOTH, &support));
  CHECK_OK(model, bempd_add_traction(model, plate, 2, 0.0, 1.0, BEMPD_X, 1, NULL, &pull, &load));
  CHECK_OK(model, bempd_name_support(model, support, "frame, old"));
  CHECK_OK(model, bempd_name_load(model, load, "wind"));
  return model;
}

static void edges_are_found_by_name(void) {
  bempd_model* model = named_plate();
  int32_t edge = 0;
  CHECK_OK(model, bempd_edge_named(model, 1, "left \"<side>\"", &edge));
  CHECK(edge == 4);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "\"rim\" is the name of 2 edges of region 1 (\"pane\"): 1, 3",
              bempd_edge_named(model, 1, "rim", &edge));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "its edges are named \"rim\", \"left \"<side>\"\"",
              bempd_edge_named(model, 1, "lid", &edge));
  CHECK_OK(model, bempd_name_edge(model, 1, 3, ""));
  CHECK_OK(model, bempd_edge_named(model, 1, "rim", &edge));
  CHECK(edge == 1);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 2 does not exist", bempd_edge_named(model, 2, "rim", &edge));
  bempd_model_free(model);
}

static void messages_have_names(void) {
  const double two[] = {1.0, 2.0};
  bempd_model* model = named_plate();
  bempd_statistics statistics;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support 1 (\"frame, old\")",
              bempd_set_support_values(model, 1, 2, two, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 1 (\"pane\")", bempd_remove_region(model, 1));
  CHECK_OK(model, bempd_remove_support(model, 1));
  CHECK_FAILS(model, BEMPD_ERROR_UNSOLVABLE, "region 1 (\"pane\") can", bempd_prepare(model));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support 1 (\"frame, old\") was removed",
              bempd_name_support(model, 1, "again"));
  /* Names are words for readers: they change no result and need no new preparation. */
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prepare(model));
  CHECK_OK(NULL, bempd_statistics_init(&statistics, sizeof statistics));
  CHECK_OK(model, bempd_name_region(model, 1, "sheet"));
  CHECK_OK(model, bempd_get_statistics(model, &statistics));
  CHECK(statistics.boundary_nodes > 0);
  bempd_model_free(model);
}

/** A thin arm of a lattice, of which the log speaks; the explanation names the region of the next bond. */
static void the_log_has_names(void) {
  bempd_model* model = new_model();
  bempd_material tough = sound_material();
  int32_t material = 0;
  bempd_explanation next;
  char text[2000];
  heard[0] = '\0';
  tough.critical_stretch = 0.01;
  CHECK_OK(model, bempd_set_log(model, hear, NULL));
  CHECK_OK(model, bempd_add_material(model, &tough, &material));
  add_pd_rectangle(model, material, 0.0, 0.0, 24.0, 4.0, 1.0);
  CHECK_OK(model, bempd_name_region(model, 1, "arm"));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_prescribe_edge(model, 1, 2, 0.0, 1.0, BEMPD_X, 1, NULL, (const double[]){1e-3}, NULL));
  CHECK_OK(model, bempd_step(model, 0.1, NULL));
  CHECK(strstr(heard, "region 1 (\"arm\") is 4 cells wide") != NULL);
  CHECK_OK(NULL, bempd_explanation_init(&next, sizeof next));
  CHECK_OK(model, bempd_explain(model, 1, &next, text, sizeof text, NULL));
  CHECK(next.next == BEMPD_NEXT_BOND && strstr(text, "region 1 (\"arm\")") != NULL);
  bempd_model_free(model);
}

static void files_have_names(void) {
  bempd_model* model = named_plate();
  CHECK_OK(model, bempd_set_option_text(model, "snapshots.existing", "replace"));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_write_history(model, "named.csv"));
  CHECK(file_says("named.csv", ",\"reaction_x_1 (frame, old)\",") &&
        file_says("named.csv", ",\"displacement_y_1 (frame, old)\""));
  CHECK_OK(model, bempd_write_snapshot(model, "named"));
  CHECK(file_says("named.pvd", "named_0000_edges.vtu"));
  CHECK(file_says("named_0000_boundary.vtu", "Name=\"region 1 (&quot;pane&quot;)\""));
  CHECK(file_says("named_0000_inside.vtu", "Name=\"load 1 (&quot;wind&quot;)\""));
  CHECK(file_says("named_0000_edges.vtu", "support 1 (\"frame, old\")") &&
        file_says("named_0000_edges.vtu", "left \"<side>\""));
  bempd_model_free(model);

  /* Files of a scene without names have no such part. */
  model = bem_block();
  CHECK_OK(model, bempd_set_option_text(model, "snapshots.existing", "replace"));
  CHECK_OK(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, NULL));
  CHECK_OK(model, bempd_step(model, 1.0, NULL));
  CHECK_OK(model, bempd_write_snapshot(model, "nameless"));
  CHECK(!file_says("nameless.pvd", "edges") && file_says("nameless.pvd", "nameless_0000_boundary.vtu"));
  bempd_model_free(model);
}

static void misuse(void) {
  bempd_model* model = bem_block();
  int32_t edge = 0;
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "model is NULL", bempd_name_region(NULL, 1, "a"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "name is NULL", bempd_name_region(model, 1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "without control characters", bempd_name_region(model, 1, "a\nb"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "must be UTF-8", bempd_name_region(model, 1, "\xff"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "region 2 does not exist", bempd_name_region(model, 2, "a"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge", bempd_name_edge(model, 1, 5, "a"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "support 1 does not exist", bempd_name_support(model, 1, "a"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "load 1 does not exist", bempd_name_load(model, 1, "a"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "edge is NULL", bempd_edge_named(model, 1, "a", NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "name is empty", bempd_edge_named(model, 1, "", &edge));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "its edges have no names", bempd_edge_named(model, 1, "a", &edge));
  CHECK_OK(model, bempd_name_region(model, 1, "Träger ½"));
  bempd_model_free(model);
}

int main(void) {
  misuse();
  edges_are_found_by_name();
  messages_have_names();
  the_log_has_names();
  files_have_names();
  return check_finish();
}

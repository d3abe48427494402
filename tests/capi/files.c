/* Files: snapshots for ParaView and the history as a table. */
#include "scenes.h"

/** The text of a file; free it. NULL where it cannot be read. */
static char* text_of(const char* path) {
  FILE* file = fopen(path, "rb");
  char* text = NULL;
  long size;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
    text = (char*)calloc((size_t)size + 1, 1);
    if (text != NULL && fread(text, 1, (size_t)size, file) != (size_t)size) text[0] = '\0';
  }
  fclose(file);
  return text;
}

static int64_t count_of(const char* text, const char* word) {
  int64_t count = 0;
  for (text = strstr(text, word); text != NULL; text = strstr(text + 1, word)) ++count;
  return count;
}

/** Every file="..." that the series names can be read and is VTK. */
static int64_t readable_files_in_series(const char* series) {
  int64_t count = 0;
  const char* place = series;
  while ((place = strstr(place, "file=\"")) != NULL) {
    char name[256];
    char* text;
    const size_t length = strcspn(place + 6, "\"");
    if (length >= sizeof name) return -1;
    memcpy(name, place + 6, length);
    name[length] = '\0';
    text = text_of(name);
    if (text != NULL && strstr(text, "UnstructuredGrid") != NULL) ++count;
    free(text);
    place += 6 + length;
  }
  return count;
}

/** Nothing is left of an earlier run of this test. */
static void clear_snapshots(void) {
  static const char* const parts[] = {"lattice", "boundary", "inside", "cracks"};
  char name[64];
  remove("capi_snapshot.pvd");
  for (int snapshot = 0; snapshot < 6; ++snapshot) {
    for (int part = 0; part < 4; ++part) {
      snprintf(name, sizeof name, "capi_snapshot_%04d_%s.vtu", snapshot, parts[part]);
      remove(name);
    }
  }
}

/** The number of a snapshot's time in the series, in the order of writing. */
static double time_of(const char* series, int snapshot) {
  char name[32];
  const char* at;
  double time = -1.0;
  snprintf(name, sizeof name, "snapshot_%04d_lattice", snapshot);
  at = strstr(series, name);
  while (at != NULL && at > series && strncmp(at, "timestep=\"", 10) != 0) --at;
  if (at != NULL) sscanf(at, "timestep=\"%lf", &time);
  return time;
}

static void snapshots_form_a_series(const coupled_plate* plate) {
  char* series;
  char* lattice;
  CHECK_OK(plate->model, bempd_step(plate->model, 0.1, NULL));
  CHECK_OK(plate->model, bempd_write_snapshot(plate->model, "capi_snapshot"));
  CHECK_OK(plate->model, bempd_step_to_next_event(plate->model, 100.0, NULL));
  CHECK_OK(plate->model, bempd_write_snapshot(plate->model, "capi_snapshot"));
  series = text_of("capi_snapshot.pvd");
  CHECK(series != NULL);
  if (series == NULL) return;
  CHECK(count_of(series, "_lattice.vtu") == 2 && count_of(series, "_boundary.vtu") == 2);
  CHECK(count_of(series, "_inside.vtu") == 2 && count_of(series, "_cracks.vtu") == 2);
  CHECK(readable_files_in_series(series) == 8);
  CHECK(time_of(series, 0) == 0.1 && time_of(series, 1) > 0.1);
  free(series);
  lattice = text_of("capi_snapshot_0000_lattice.vtu");
  if (lattice == NULL) lattice = text_of("capi_snapshot_0001_lattice.vtu");
  CHECK(lattice != NULL);
  if (lattice == NULL) return;
  CHECK(strstr(lattice, "displacement") != NULL && strstr(lattice, "damage") != NULL);
  CHECK(strstr(lattice, "stress") != NULL && strstr(lattice, "nan") == NULL);
  free(lattice);
}

/** Events that share a load factor get times that grow; the load factor itself stands in every file. */
static void times_are_distinct(const coupled_plate* plate) {
  char* series;
  double load_factor = 0.0, before;
  CHECK_OK(plate->model, bempd_load_factor(plate->model, &load_factor));
  CHECK_OK(plate->model, bempd_write_snapshot(plate->model, "capi_snapshot"));
  CHECK_OK(plate->model, bempd_write_snapshot(plate->model, "capi_snapshot"));
  series = text_of("capi_snapshot.pvd");
  CHECK(series != NULL);
  if (series == NULL) return;
  before = time_of(series, 1);
  CHECK(before == load_factor);
  for (int k = 2; k < 4; ++k) {
    CHECK(time_of(series, k) > before && time_of(series, k) < load_factor * (1 + 1e-8));
    before = time_of(series, k);
  }
  free(series);
  series = text_of("capi_snapshot_0003_cracks.vtu");
  CHECK(series != NULL && strstr(series, "\"load_factor\"") != NULL && strstr(series, "\"snapshot\"") != NULL);
  free(series);
}

/** Another model with the same prefix refuses, goes on behind, or begins anew, as it is told; what it cannot read it
 *  leaves. */
static void files_of_other_runs_are_kept(void) {
  const coupled_plate other = coupled_plate_create();
  char* series;
  FILE* foreign;
  CHECK_FAILS(other.model, BEMPD_ERROR_IO, "snapshots.existing", bempd_write_snapshot(other.model, "capi_snapshot"));
  /* The series alone is gone: its files are in the way too. */
  CHECK(rename("capi_snapshot.pvd", "capi_moved.pvd") == 0);
  CHECK_FAILS(other.model, BEMPD_ERROR_IO, "capi_snapshot_0000", bempd_write_snapshot(other.model, "capi_snapshot"));
  CHECK(rename("capi_moved.pvd", "capi_snapshot.pvd") == 0);
  CHECK_FAILS(other.model, BEMPD_ERROR_ARGUMENT, "refuse",
              bempd_set_option_text(other.model, "snapshots.existing", "overwrite"));
  CHECK_OK(other.model, bempd_set_option_text(other.model, "snapshots.existing", "continue"));
  CHECK_OK(other.model, bempd_step(other.model, 0.01, NULL));
  CHECK_OK(other.model, bempd_write_snapshot(other.model, "capi_snapshot"));
  series = text_of("capi_snapshot.pvd");
  CHECK(series != NULL);
  if (series == NULL) return;
  CHECK(count_of(series, "_lattice.vtu") == 5 && time_of(series, 4) > time_of(series, 3));
  free(series);
  foreign = fopen("capi_foreign.pvd", "w");
  CHECK(foreign != NULL);
  if (foreign == NULL) return;
  fputs("not a series", foreign);
  fclose(foreign);
  CHECK_FAILS(other.model, BEMPD_ERROR_IO, "no series", bempd_write_snapshot(other.model, "capi_foreign"));
  series = text_of("capi_foreign.pvd");
  CHECK(series != NULL && strcmp(series, "not a series") == 0);
  free(series);
  bempd_model_free(other.model);
}

static void history_is_a_table(const coupled_plate* plate) {
  int64_t lines = 0;
  int64_t commas;
  char* table;
  CHECK_OK(plate->model, bempd_history_count(plate->model, &lines));
  CHECK_OK(plate->model, bempd_write_history(plate->model, "capi_history.csv"));
  table = text_of("capi_history.csv");
  CHECK(table != NULL);
  if (table == NULL) return;
  CHECK(count_of(table, "\n") == lines + 1);
  CHECK(strstr(table, "load_factor") != NULL);
  commas = count_of(table, ",");
  CHECK(commas > 0 && commas % (lines + 1) == 0);
  free(table);
}

/** A series names its files in XML, which cannot hold everything that a file system can. */
static void names_that_xml_cannot_hold_are_refused(const coupled_plate* plate) {
  CHECK_FAILS(plate->model, BEMPD_ERROR_ARGUMENT, "control characters",
              bempd_write_snapshot(plate->model, "capi_\x1b"));
  CHECK_FAILS(plate->model, BEMPD_ERROR_ARGUMENT, "UTF-8", bempd_write_snapshot(plate->model, "capi_\xff"));
  CHECK(text_of("capi_\x1b.pvd") == NULL && text_of("capi_\xff_0000_lattice.vtu") == NULL);
}

int main(void) {
  const coupled_plate plate = coupled_plate_create();
  clear_snapshots();
  names_that_xml_cannot_hold_are_refused(&plate);
  snapshots_form_a_series(&plate);
  times_are_distinct(&plate);
  files_of_other_runs_are_kept();
  history_is_a_table(&plate);
  bempd_model_free(plate.model);
  return check_finish();
}

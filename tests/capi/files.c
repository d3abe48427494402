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
  CHECK(readable_files_in_series(series) == 4);
  free(series);
  lattice = text_of("capi_snapshot_0000_lattice.vtu");
  if (lattice == NULL) lattice = text_of("capi_snapshot_0001_lattice.vtu");
  CHECK(lattice != NULL);
  if (lattice == NULL) return;
  CHECK(strstr(lattice, "displacement") != NULL && strstr(lattice, "damage") != NULL);
  CHECK(strstr(lattice, "stress") != NULL && strstr(lattice, "nan") == NULL);
  free(lattice);
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
  names_that_xml_cannot_hold_are_refused(&plate);
  snapshots_form_a_series(&plate);
  history_is_a_table(&plate);
  bempd_model_free(plate.model);
  return check_finish();
}

/* A library that was built without the scheme paper has no trace of it: no option, no word, a sentence that says what
 * there is. */
#include "scenes.h"

static void no_option_speaks_of_it(void) {
  int64_t index, count = 0;
  CHECK_OK(NULL, bempd_option_count(&count));
  for (index = 0; index < count; ++index) {
    bempd_option_info info;
    CHECK_OK(NULL, bempd_option_info_init(&info, sizeof info));
    CHECK_OK(NULL, bempd_option_describe(index, &info));
    /* Increments, paper.mode = paper, are a way of stepping that any scheme has. */
    CHECK(strncmp(info.name, "paper.", 6) != 0 || strcmp(info.name, "paper.mode") == 0 ||
          strcmp(info.name, "paper.increment") == 0);
    CHECK(strstr(info.summary, "scheme paper") == NULL && strstr(info.summary, "ollocation") == NULL);
    if (strcmp(info.name, "scheme") == 0) CHECK(strcmp(info.choices, "symmetric") == 0);
  }
}

static void choosing_it_says_what_there_is(void) {
  bempd_model* model = new_model();
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "must be one of: symmetric",
              bempd_set_option_text(model, "scheme", "paper"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "no option", bempd_set_option_text(model, "paper.lattice", "nodal"));
  bempd_model_free(model);
}

int main(void) {
  no_option_speaks_of_it();
  choosing_it_says_what_there_is();
  return check_finish();
}

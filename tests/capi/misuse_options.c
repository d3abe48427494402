/* Options: listed, with defaults and limits that are watched. */
#include "scenes.h"

static bempd_option_info option_at(int64_t index) {
  bempd_option_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = (int64_t)sizeof info;
  CHECK_OK(NULL, bempd_option_describe(index, &info));
  return info;
}

static void unknown_names_list_the_near_ones(void) {
  bempd_model* model = new_model();
  double value = 5.0;
  int64_t needed = 0;
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack.exponent", bempd_set_option(model, "crack.exponnet", 4.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "threads", bempd_set_option(model, "thread", 1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "scheme", bempd_set_option_text(model, "shceme", "symmetric"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "crack.tie_share", bempd_get_option(model, "tie_share", &value));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "scheme", bempd_get_option_text(model, "schema", NULL, 0, &needed));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "option|unknown", bempd_set_option(model, "", 1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "option|unknown", bempd_set_option(model, "\xff\xfe%s%n", 1.0));
  bempd_model_free(model);
}

/** Names of version 0.2 say what to use, hooks of tests are unknown. */
static void removed_names_say_what_to_use(void) {
  static const char* const names[][2] = {{"accuracy", "bem.quadrature_tolerance"},
                                         {"pd.contact", "contact"},
                                         {"bem.contact", "contact"},
                                         {"pd.crack_rule", "crack.rule"},
                                         {"pd.crack_tip", "crack.rule"},
                                         {"growth.criterion", "crack.criterion"},
                                         {"growth.share", "crack.tie_share"},
                                         {"growth.exponent", "crack.exponent"},
                                         {"growth.step", "crack.step"},
                                         {"growth.direction", "crack.direction"},
                                         {"stepping.tie_band", "crack.tie_share"},
                                         {"stepping.mode", "paper.mode"},
                                         {"stepping.increment", "paper.increment"},
                                         {"stepping.solver", "windows"},
                                         {"stepping.window_length", "chooses"},
                                         {"stepping.factorization", "kept"},
                                         {"stepping.max_breaks_per_solve", "limit"},
                                         {"pd.horizon_ratio", "horizon_ratio"},
                                         {"pd.lattice_angle", "bempd_add_turned_pd_region"},
                                         {"pd.outline_points", "slanted"},
                                         {"pd.outline_balance", "stress"},
                                         {"results.singular_stress", "bempd_stress_orders"}};
  static const char* const hooks[] = {"test.solver", "test.window_length", "test.outline_points"};
  bempd_model* model = new_model();
  double value = 0.0;
  size_t k;
  for (k = 0; k < sizeof names / sizeof names[0]; ++k) {
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, names[k][1], bempd_set_option(model, names[k][0], 1.0));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, names[k][1], bempd_set_option_text(model, names[k][0], "word"));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, names[k][1], bempd_get_option(model, names[k][0], &value));
  }
  for (k = 0; k < sizeof hooks / sizeof hooks[0]; ++k) {
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "there is no option", bempd_set_option_text(model, hooks[k], "plain"));
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "there is no option", bempd_get_option(model, hooks[k], &value));
  }
  bempd_model_free(model);
}

static void options_are_described_within_their_count(void) {
  int64_t count = 0;
  bempd_option_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = (int64_t)sizeof info;
  CHECK_OK(NULL, bempd_option_count(&count));
  CHECK(count > 0 && count <= 29);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "index", bempd_option_describe(-1, &info));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "index", bempd_option_describe(count, &info));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "index", bempd_option_describe(INT64_MAX, &info));
  info.struct_size = 0;
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_option_describe(0, &info));
  info.struct_size = -8;
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_option_describe(0, &info));
}

static void number_option_keeps_to_its_limits(bempd_model* model, const bempd_option_info* info) {
  double value = NAN;
  CHECK_OK(model, bempd_get_option(model, info->name, &value));
  CHECK(value == info->default_value && value >= info->minimum && value <= info->maximum);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->name, bempd_set_option(model, info->name, NAN));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->name, bempd_set_option(model, info->name, INFINITY));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->name, bempd_set_option(model, info->name, -INFINITY));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->name,
              bempd_set_option(model, info->name, info->minimum - 1.0 - 0.5 * fabs(info->minimum)));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->name,
              bempd_set_option(model, info->name, info->maximum + 1.0 + 0.5 * fabs(info->maximum)));
  if (info->whole_number && info->maximum > info->minimum)
    CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "whole", bempd_set_option(model, info->name, info->minimum + 0.5));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "number", bempd_set_option_text(model, info->name, "symmetric"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "number", bempd_get_option_text(model, info->name, NULL, 0, NULL));
  CHECK_OK(model, bempd_get_option(model, info->name, &value));
  CHECK(value == info->default_value);
  CHECK_OK(model, bempd_set_option(model, info->name, info->minimum));
  CHECK_OK(model, bempd_get_option(model, info->name, &value));
  CHECK(value == info->minimum);
}

static void text_option_keeps_to_its_words(bempd_model* model, const bempd_option_info* info) {
  char text[64] = "";
  char longer[128];
  double number = 0.0;
  int64_t needed = 0;
  CHECK_OK(model, bempd_get_option_text(model, info->name, NULL, 0, &needed));
  CHECK(needed == (int64_t)strlen(info->default_text) + 1);
  CHECK_OK(model, bempd_get_option_text(model, info->name, text, (int64_t)sizeof text, NULL));
  CHECK(strcmp(text, info->default_text) == 0 && check_has_word(info->choices, text));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity|buffer|bytes",
              bempd_get_option_text(model, info->name, text, 1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "capacity|buffer", bempd_get_option_text(model, info->name, text, -1, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "NULL|buffer", bempd_get_option_text(model, info->name, NULL, 64, NULL));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->default_text, bempd_set_option_text(model, info->name, "nonsense"));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->default_text, bempd_set_option_text(model, info->name, ""));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "text|word|_text", bempd_set_option(model, info->name, 1.0));
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "text|word|_text", bempd_get_option(model, info->name, &number));
  snprintf(longer, sizeof longer, "%s ", info->default_text);
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, info->default_text, bempd_set_option_text(model, info->name, longer));
  CHECK_OK(model, bempd_set_option_text(model, info->name, info->default_text));
}

static void free_text_option_takes_any_text(bempd_model* model, const bempd_option_info* info) {
  static const char* const texts[] = {"", "nonsense", "a | b", "/tmp/with spaces/\xc3\xa4"};
  char text[64] = "?";
  size_t k;
  CHECK(info->default_text[0] == '\0');
  for (k = 0; k < sizeof texts / sizeof *texts; ++k) {
    CHECK_OK(model, bempd_set_option_text(model, info->name, texts[k]));
    CHECK_OK(model, bempd_get_option_text(model, info->name, text, (int64_t)sizeof text, NULL));
    CHECK(strcmp(text, texts[k]) == 0);
  }
  CHECK_FAILS(model, BEMPD_ERROR_ARGUMENT, "text|word|_text", bempd_set_option(model, info->name, 1.0));
  CHECK_OK(model, bempd_set_option_text(model, info->name, ""));
}

static void every_option_is_described_and_watched(void) {
  bempd_model* model = new_model();
  int64_t count = 0;
  int64_t k;
  CHECK_OK(NULL, bempd_option_count(&count));
  for (k = 0; k < count; ++k) {
    const bempd_option_info info = option_at(k);
    CHECK(info.name != NULL && info.summary != NULL && info.unit != NULL && info.choices != NULL);
    CHECK(info.default_text != NULL && info.name[0] != '\0' && info.summary[0] != '\0' && info.unit[0] != '\0');
    CHECK(info.kind == BEMPD_OPTION_NUMBER || info.kind == BEMPD_OPTION_TEXT);
    if (info.kind == BEMPD_OPTION_NUMBER)
      number_option_keeps_to_its_limits(model, &info);
    else if (info.choices[0] == '\0')
      free_text_option_takes_any_text(model, &info);
    else
      text_option_keeps_to_its_words(model, &info);
  }
  bempd_model_free(model);
}

/** A program with a shorter struct gets what it has room for. */
static void descriptions_keep_to_the_struct_s_size(void) {
  bempd_option_info info;
  memset(&info, 0x55, sizeof info);
  CHECK_OK(NULL, bempd_option_info_init(&info, sizeof info));
  CHECK(info.struct_size == (int64_t)sizeof info && info.name == NULL && info.maximum == 0.0);
  CHECK_OK(NULL, bempd_option_info_init(&info, 16));
  CHECK_OK(NULL, bempd_option_describe(0, &info));
  CHECK(info.struct_size == 16 && info.name != NULL && info.summary == NULL);
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "struct_size", bempd_option_info_init(&info, 0));
  CHECK_FAILS(NULL, BEMPD_ERROR_ARGUMENT, "NULL", bempd_option_info_init(NULL, sizeof info));
}

int main(void) {
  unknown_names_list_the_near_ones();
  removed_names_say_what_to_use();
  options_are_described_within_their_count();
  every_option_is_described_and_watched();
  descriptions_keep_to_the_struct_s_size();
  return check_finish();
}

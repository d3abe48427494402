/**
 * Checks for the tests of the C interface. A failed check prints where, what, the status and the message of the
 * library, and is counted; the program goes on. A program that checked nothing fails.
 */
#ifndef BEMPD_TESTS_CAPI_CHECK_H
#define BEMPD_TESTS_CAPI_CHECK_H

#include <bempd.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int check_count = 0;
static int check_failures = 0;

static inline void check_report(int good, const char* text, const char* why, const char* message, const char* file,
                                int line) {
  ++check_count;
  if (good) return;
  ++check_failures;
  fprintf(stderr, "%s:%d: %s\n  %s\n", file, line, text, why);
  if (message != NULL) fprintf(stderr, "  message: \"%s\"\n", message);
}

/** Whether text holds one of the words, which are separated by '|'; capitals do not matter. */
static inline int check_has_word(const char* text, const char* words) {
  while (*words != '\0') {
    const size_t length = strcspn(words, "|");
    const char* start;
    for (start = text; *start != '\0'; ++start) {
      size_t k = 0;
      while (k < length && start[k] != '\0' && tolower((unsigned char)start[k]) == tolower((unsigned char)words[k]))
        ++k;
      if (k == length) return 1;
    }
    words += length;
    if (*words == '|') ++words;
  }
  return 0;
}

/** Whether text holds the name of the function that the expression `call` calls. */
static inline int check_has_name(const char* text, const char* call) {
  char name[64] = "";
  const size_t length = strcspn(call, "( ");
  if (length >= sizeof name) return 0;
  memcpy(name, call, length);
  return strstr(text, name) != NULL;
}

static inline void check_ok(const bempd_model* model, bempd_status status, const char* call, const char* file,
                            int line) {
  char why[128];
  snprintf(why, sizeof why, "came %s, expected BEMPD_OK", bempd_status_name(status));
  check_report(status == BEMPD_OK, call, why, bempd_last_error(model), file, line);
}

static inline void check_message(const bempd_model* model, const char* words, const char* call, const char* file,
                                 int line) {
  const char* message = bempd_last_error(model);
  char why[256];
  check_report(message != NULL && message[0] != '\0', call, "the message is empty", message, file, line);
  if (message == NULL) return;
  check_report(check_has_name(message, call), call, "the message lacks the name of the function", message, file, line);
  snprintf(why, sizeof why, "the message has none of the words %s", words);
  check_report(check_has_word(message, words), call, why, message, file, line);
}

static inline void check_fails(const bempd_model* model, bempd_status expected, const char* words, bempd_status status,
                               const char* call, const char* file, int line) {
  char why[128];
  snprintf(why, sizeof why, "came %s, expected %s", bempd_status_name(status), bempd_status_name(expected));
  check_report(status == expected, call, why, bempd_last_error(model), file, line);
  if (status != BEMPD_OK) check_message(model, words, call, file, line);
}

/** Errors that tell the host to change the scene, where the contract leaves open which of them it is. */
static inline int check_is_refusal(bempd_status status) {
  return status == BEMPD_ERROR_ARGUMENT || status == BEMPD_ERROR_ORDER || status == BEMPD_ERROR_UNSOLVABLE ||
         status == BEMPD_ERROR_MEMORY;
}

static inline void check_refused(const bempd_model* model, const char* words, bempd_status status, const char* call,
                                 const char* file, int line) {
  char why[128];
  snprintf(why, sizeof why, "came %s, expected a refusal", bempd_status_name(status));
  check_report(check_is_refusal(status), call, why, bempd_last_error(model), file, line);
  if (status != BEMPD_OK) check_message(model, words, call, file, line);
}

static inline void check_refused_by_prepare(bempd_model* model, const char* words, bempd_status status,
                                            const char* call, const char* file, int line) {
  if (status == BEMPD_OK)
    check_refused(model, words, bempd_prepare(model), "bempd_prepare", file, line);
  else
    check_refused(model, words, status, call, file, line);
}

static inline void check_close(double value, double reference, double tolerance, const char* text, const char* file,
                               int line) {
  char why[160];
  snprintf(why, sizeof why, "%.17g against %.17g, difference %.3g, allowed %.3g", value, reference, value - reference,
           tolerance);
  check_report(fabs(value - reference) <= tolerance, text, why, NULL, file, line);
}

static inline int check_finish(void) {
  printf("%d checks, %d failed\n", check_count, check_failures);
  return check_count > 0 && check_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/** Something is true. */
#define CHECK(expression) check_report((expression) ? 1 : 0, #expression, "is false", NULL, __FILE__, __LINE__)

/** The call is good. */
#define CHECK_OK(model, ...) check_ok((model), (__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)

/** The call fails with this status and a message that has the function's name and one of the words ("one|another"). */
#define CHECK_FAILS(model, status, words, ...) \
  check_fails((model), (status), (words), (__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)

/** The call fails with a status that tells the host to change the scene, and a message as in CHECK_FAILS. */
#define CHECK_REFUSED(model, words, ...) \
  check_refused((model), (words), (__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)

/** The call is refused, or is good and bempd_prepare() refuses. */
#define CHECK_REFUSED_BY_PREPARE(model, words, ...) \
  check_refused_by_prepare((model), (words), (__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)

/** Two numbers differ by no more than the tolerance. */
#define CHECK_CLOSE(value, reference, tolerance) \
  check_close((value), (reference), (tolerance), #value " = " #reference, __FILE__, __LINE__)

#endif

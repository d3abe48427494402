// What holds for every call, whatever it was given. A check that fails ends the program, which is how a fuzzer is told.
#ifndef BEMPD_TESTS_FUZZ_CHECKS_HPP
#define BEMPD_TESTS_FUZZ_CHECKS_HPP

#include <bempd.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fuzz {

[[noreturn]] inline void report(const char* call, const char* finding, const char* message) {
  std::fprintf(stderr, "%s: %s\n  \"%s\"\n", call, finding, message);
  std::abort();
}

// Whether the environment asks for every call to be named as it is made.
inline bool is_talkative() {
  static const bool asked = std::getenv("BEMPD_FUZZ_VERBOSE") != nullptr;
  return asked;
}

// A failure is one of those that the header knows, none of them a defect, and has a sentence with the name of the call.
inline bool good(const char* call, const bempd_model* model, bempd_status status) {
  const char* message = bempd_last_error(model);
  if (is_talkative()) std::fprintf(stderr, "%s: %s %s\n", call, bempd_status_name(status), status ? message : "");
  if (status == BEMPD_OK) return true;
  if (status > 0 || status < BEMPD_ERROR_INTERNAL) report(call, "an unknown status", message);
  if (status == BEMPD_ERROR_INTERNAL) report(call, "an internal error", message);
  if (message[0] == '\0') report(call, "a failure without a sentence", message);
  if (std::strstr(message, call) == nullptr) report(call, "a sentence without the name of the call", message);
  return false;
}

// The first argument of a call.
template <class... Others>
const bempd_model* model_of(const bempd_model* model, const Others&...) {
  return model;
}

inline void require_finite(const char* call, const double* values, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k)
    if (!std::isfinite(values[k])) {
      std::fprintf(stderr, "number %zu is %g\n", k, values[k]);
      report(call, "success with a number that is not finite", "");
    }
}

inline void require_true(bool condition, const char* call, const char* finding) {
  if (!condition) report(call, finding, "");
}

}  // namespace fuzz

// The call is made and checked; true when it is good.
#define FUZZ_CALL(name, ...) ::fuzz::good(#name, ::fuzz::model_of(__VA_ARGS__), name(__VA_ARGS__))

#endif

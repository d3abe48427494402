#include "capi/guard.hpp"

namespace bempd::capi {

namespace {

// More points than this in one call is a mistaken count.
constexpr std::int64_t most_points = std::int64_t{1} << 31;

}  // namespace

ThreadError& thread_error() {
  thread_local ThreadError error;  // all zeros, and nothing to do at its end
  return error;
}

bempd_status status_of(Failure failure) {
  switch (failure) {
    case Failure::argument:
      return BEMPD_ERROR_ARGUMENT;
    case Failure::order:
      return BEMPD_ERROR_ORDER;
    case Failure::unsolvable:
      return BEMPD_ERROR_UNSOLVABLE;
    case Failure::convergence:
      return BEMPD_ERROR_CONVERGENCE;
    case Failure::cancelled:
      return BEMPD_ERROR_CANCELLED;
    case Failure::io:
      return BEMPD_ERROR_IO;
  }
  return BEMPD_ERROR_INTERNAL;
}

std::vector<Point> points_from(const double* values, std::int64_t count, const char* name) {
  require(count >= 0 && count < most_points, "the number of ", name, " is ", count, "; it must be a count");
  require(values != nullptr || count == 0, name, " is NULL; give an array of shape [n][2]");
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) points[i] = Point(values[2 * i], values[2 * i + 1]);
  return points;
}

}  // namespace bempd::capi

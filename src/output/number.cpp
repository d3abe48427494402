#include "output/number.hpp"

#include <charconv>
#include <cmath>

namespace bempd::output {

namespace {

template <typename Number>
std::string shortest(Number value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

}  // namespace

std::string to_text(double value) {
  if (std::isnan(value)) return "nan";  // no "-nan", which not every reader knows
  return shortest(value);
}

std::string to_text(std::int64_t value) { return shortest(value); }

}  // namespace bempd::output

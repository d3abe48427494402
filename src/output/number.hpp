#pragma once

#include <cstdint>
#include <string>

namespace bempd::output {

// Shortest decimal text that reads back as the same double (at most 17 significant digits), or nan, inf or -inf. The
// decimal sign is a point in every locale.
std::string to_text(double value);
std::string to_text(std::int64_t value);

}  // namespace bempd::output

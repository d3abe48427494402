#pragma once

#include <cstdlib>

namespace bempd_tests {

/// Whether a test takes all of its cases. The default run takes some of each kind; `tests/run.sh long` sets
/// BEMPD_THOROUGH for the entries whose names end with `.thorough`.
inline bool is_thorough() { return std::getenv("BEMPD_THOROUGH") != nullptr; }

/// The number of cases that a loop takes.
inline int cases(int by_default, int all) { return is_thorough() ? all : by_default; }

}  // namespace bempd_tests

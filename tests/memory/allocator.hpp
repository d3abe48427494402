// malloc and its kin of this whole process, which fail when they are told to. Everything that the library takes,
// through operator new, Eigen, CHOLMOD or the C library, goes through them.
#pragma once

#include <cstdint>

namespace allocation {

enum class Mode { once, from_then_on };

constexpr std::int64_t never = -1;

// Starts to count allocations as the library's, until stop(); the `first`-th of them fails, or all from it on.
void start(Mode mode, std::int64_t first);

struct Count {
  std::int64_t asked_for = 0, failed = 0;
  std::int64_t spared = 0;  // would have failed, but for libraries that end the process then (libgomp, OpenBLAS)
};
Count stop();

// Blocks taken and not given back between start() and stop(), since the program began.
std::int64_t blocks_held();

}  // namespace allocation

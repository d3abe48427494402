// One program run with failing allocations, in a process of its own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "allocator.hpp"
#include "programs.hpp"

namespace memory_test {

// Shared with the process that watches: where the trial is, and what has come of it so far.
struct Progress {
  std::size_t call = 0, position = 0;  // of the next failure
  std::int64_t allocation = 0;
  std::int64_t failed = 0;   // calls with a failed allocation
  std::int64_t told = 0;     // they returned BEMPD_ERROR_MEMORY
  std::int64_t went_on = 0;  // they did what they were to do all the same
  std::int64_t spared = 0;   // would have failed in libgomp or OpenBLAS
  std::int64_t wrong_status = 0, lost = 0, other_numbers = 0, leaked = 0, silent = 0;
  bool finished = false;
};

struct Plan {
  allocation::Mode mode = allocation::Mode::once;
  std::int64_t most_per_call = 0;  // failures tried in one call, spread over its allocations; 0: all
};

// Goes on from where `progress` stands.
void run_trial(const Program& program, const Plan& plan, const std::string& folder, Progress& progress);

}  // namespace memory_test

// Small programs as hosts write them, call by call, so that each call can be made to run out of memory and be repeated.
#pragma once

#include <bempd.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace memory_test {

// What a program works on. A call writes into buffers that are there before it begins.
struct Host {
  explicit Host(std::string folder_for_files);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  bempd_model* model = nullptr;
  bempd_state* state = nullptr;
  bempd_state* other_state = nullptr;
  int32_t material = 0, region[3] = {0, 0, 0}, support[4] = {0, 0, 0, 0}, load[3] = {0, 0, 0};
  std::vector<double> numbers;    // what a call gives
  std::vector<int32_t> integers;  // the same
  std::vector<std::uint8_t> bytes;
  int64_t byte_count = 0;
  std::string folder, history_path, snapshot_prefix;
  std::int64_t lines_logged = 0;
};

struct Call {
  const char* name;
  std::function<bempd_status(Host&)> make;
  std::function<std::vector<double>(Host&)> result;  // of a call that has succeeded; or empty
  bempd_status expected = BEMPD_OK;
  bool can_be_repeated = false;  // once it has succeeded, without changing anything
};

struct Program {
  const char* name;
  std::vector<Call> calls;
};

std::vector<Program> all_programs();

// The history, and where the run is: what no failed call may change.
std::vector<double> books(const Host& host);

}  // namespace memory_test

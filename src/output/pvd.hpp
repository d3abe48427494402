#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bempd::output {

// Entry of a time series: a file with its time; several parts may have the same time.
struct PvdEntry {
  double time = 0;
  int part = 0;
  std::string file;    // path relative to the collection's folder, with forward slashes
  std::string name{};  // name of the part
};

// Writes a ParaView collection (.pvd). Throws std::system_error, also for names that XML cannot contain.
void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries);

// Reads the entries of a file that write_pvd() has written; empty if the file is another one.
std::optional<std::vector<PvdEntry>> read_pvd(const std::filesystem::path& path);

}  // namespace bempd::output

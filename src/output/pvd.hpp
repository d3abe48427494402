#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bempd::output {

// File of a time series; several parts may belong to one time.
struct PvdEntry {
  double time = 0;
  int part = 0;
  std::string file;    // relative to the collection's folder, with forward slashes
  std::string name{};  // of the part
};

// Writes a ParaView collection. Throws std::system_error, also for names that XML cannot hold.
void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries);

// Entries of a file that write_pvd() has written; empty if it cannot be read as one.
std::optional<std::vector<PvdEntry>> read_pvd(const std::filesystem::path& path);

}  // namespace bempd::output

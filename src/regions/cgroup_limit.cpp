#include "regions/cgroup_limit.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace bempd::regions {

namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();

// Reads the limit [B] in a control group's file. There is no limit if the file holds no number, for example the word
// "max", or is missing.
double limit_in(const fs::path& file) {
  std::ifstream stream(file);
  double bytes = 0;
  return stream >> bytes && bytes > 0 ? bytes : unlimited;
}

// Least memory limit of a control group and all groups above it. The limit of the mounted folder itself counts too,
// because in a container that folder may be the group's own.
double least_limit(const fs::path& mounted, const std::string& group, const char* file) {
  double least = limit_in(mounted / file);
  for (fs::path path = fs::path(group).relative_path(); !path.empty(); path = path.parent_path())
    least = std::min(least, limit_in(mounted / path / file));
  return least;
}

// Whether a comma-separated list of control group controllers, such as "cpu,memory", contains "memory".
bool has_memory(const std::string& controllers) {
  return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

}  // namespace

double cgroup_memory_limit(const fs::path& membership, const fs::path& root) {
  double least = unlimited;
  std::ifstream stream(membership);
  // Each line of the file is "number:controllers:group". In version 2 of control groups the number is 0 and the list of
  // controllers is empty.
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty()) {
      least =
          std::min({least, least_limit(root, group, "memory.max"), least_limit(root / "unified", group, "memory.max")});
    } else if (has_memory(controllers)) {
      least = std::min(least, least_limit(root / "memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

}  // namespace bempd::regions

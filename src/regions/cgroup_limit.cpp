#include "regions/cgroup_limit.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace bempd::regions {

namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();

// The number in a file; without one, as in "max", unlimited.
double limit_in(const fs::path& file) {
  std::ifstream stream(file);
  double bytes = 0;
  return stream >> bytes && bytes > 0 ? bytes : unlimited;
}

// Least limit of a group and all groups above it. In a container the group's own folder may be the mounted one.
double least_limit(const fs::path& mounted, const std::string& group, const char* file) {
  double least = limit_in(mounted / file);
  for (fs::path path = fs::path(group).relative_path(); !path.empty(); path = path.parent_path())
    least = std::min(least, limit_in(mounted / path / file));
  return least;
}

// Whether a list such as "cpu,memory" names the controller of memory.
bool has_memory(const std::string& controllers) {
  return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

}  // namespace

double cgroup_memory_limit(const fs::path& membership, const fs::path& root) {
  double least = unlimited;
  std::ifstream stream(membership);
  // Lines "number:controllers:group"; version 2 has the number 0 and names no controllers.
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

#pragma once

#include <filesystem>

namespace bempd::regions {

// Memory [B] that the control groups of a process may use, versions 1 and 2: the least limit of its group and of those
// above it. Infinite where there is none. `membership` is a file such as /proc/self/cgroup, `root` where the groups are
// mounted, as a rule /sys/fs/cgroup.
double cgroup_memory_limit(const std::filesystem::path& membership, const std::filesystem::path& root);

}  // namespace bempd::regions

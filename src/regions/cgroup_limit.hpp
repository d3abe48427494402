#pragma once

#include <filesystem>

namespace bempd::regions {

// Memory limit [B] that control groups (Linux cgroups, versions 1 and 2) set for a process: the least limit of the
// process's group and of all groups above that group. Infinite if no limit is set. `membership` is a file such as
// /proc/self/cgroup; `root` is the folder where the groups are mounted, usually /sys/fs/cgroup.
double cgroup_memory_limit(const std::filesystem::path& membership, const std::filesystem::path& root);

}  // namespace bempd::regions

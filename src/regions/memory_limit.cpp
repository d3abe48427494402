#include "regions/memory_limit.hpp"

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include <algorithm>
#include <limits>
#include <string>

#include "error.hpp"
#include "regions/cgroup_limit.hpp"

namespace bempd::regions {

namespace {

constexpr double gigabyte = 1e9;

const scene::OptionGroup memory_group(scene::OptionPlace::general, [] {
  scene::OptionDescription limit = scene::number_option(
      "memory.limit",
      "Memory that preparing may need by estimate, without the sparse factor; scenes that need "
      "more are refused. 0 for all that the machine has, or that the control group of the process (a container, "
      "a batch job) may use.",
      0, 0, 1e9, false);
  limit.unit = "GB";
  return std::vector<scene::OptionDescription>{limit};
});

double memory_of_machine() {
#ifdef _SC_PHYS_PAGES
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && size > 0) return static_cast<double>(pages) * static_cast<double>(size);
#endif
  return std::numeric_limits<double>::infinity();
}

// Memory [B] that the process may use. Containers and batch systems grant less than the machine has.
double memory_of_process() {
  return std::min(memory_of_machine(), cgroup_memory_limit("/proc/self/cgroup", "/sys/fs/cgroup"));
}

}  // namespace

void require_memory(const scene::Scene& scene, const scene::Options& options) {
  scene::SizeEstimate size;
  for (int id : scene.region_ids()) scene.region(id).add_size(size);
  constexpr double most = std::numeric_limits<int>::max();
  require(size.bonds <= most, "the scene comes to about ", size.bonds, " bonds; the limit is ", most,
          ": choose larger spacings or smaller horizon ratios");
  require_memory_for(size.bytes, text(size.bonds, " bonds and ", size.elements, " boundary elements"),
                     "choose larger spacings and elements", options);
}

double memory_allowed(const scene::Options& options) {
  const double wanted = options.number("memory.limit");
  return wanted > 0 ? wanted * gigabyte : memory_of_process();
}

void require_memory_for(double bytes, const std::string& what, const std::string& advice,
                        const scene::Options& options) {
  const double wanted = options.number("memory.limit");
  const double limit = memory_allowed(options);
  require(bytes <= limit, "preparing would need about ", bytes / gigabyte, " GB for ", what, "; ",
          wanted > 0                    ? "the option memory.limit allows "
          : limit < memory_of_machine() ? "the control group of this process allows "
                                        : "the machine has ",
          limit / gigabyte, " GB: ", advice, wanted > 0 ? ", or raise the option" : "");
}

}  // namespace bempd::regions

#pragma once

#include <cstdint>
#include <set>

namespace bempd::regions {

// Sizes and preparation times of regions, added up.
struct RegionStatistics {
  std::int64_t boundary_nodes = 0, boundary_elements = 0, material_points = 0, kernel_evaluations = 0;
  std::int64_t subdomains = 0, cut_nodes = 0;  // parts of regions that are cut, and nodes on the cuts
  double seconds_boundary = 0, seconds_lattice = 0;
  std::set<const void*> counted;  // operators that are counted already: a shared one counts once
};

}  // namespace bempd::regions

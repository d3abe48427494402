#pragma once

namespace bempd::scene {

// Estimated sizes of regions, before any of it is built.
struct SizeEstimate {
  double bonds = 0, elements = 0;
  double bytes = 0;  // that preparing takes at its peak, without the sparse factor
};

}  // namespace bempd::scene

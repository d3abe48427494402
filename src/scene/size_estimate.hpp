#pragma once

namespace bempd::scene {

// What regions come to, before any of it is built.
struct SizeEstimate {
  double bonds = 0, elements = 0;
  double bytes = 0;  // that preparing takes at its peak, without the sparse factor
};

}  // namespace bempd::scene

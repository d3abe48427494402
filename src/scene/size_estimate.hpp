#pragma once

namespace bempd::scene {

// Estimated size of all regions, before any of them is built.
struct SizeEstimate {
  double bonds = 0, elements = 0;
  double bytes = 0;  // largest memory while the scene is prepared, without the sparse factor
};

}  // namespace bempd::scene

#pragma once

#include <vector>

namespace bempd::fracture {

// Contact place that the break of a bond between neighbours has added, with its normal.
struct GrownFace {
  int term;
  double normal_x, normal_y;
};

// Contact state of a run: which places exist and which are closed.
struct FaceState {
  std::vector<GrownFace> grown;
  std::vector<char> closed;  // flags of all constraints: exact ones, places on initial cracks, places that have grown
  // Terms that have broken but whose contact places are not added yet, grouped by event.
  std::vector<std::vector<int>> pending;
};

}  // namespace bempd::fracture

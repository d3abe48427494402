#pragma once

#include <vector>

namespace bempd::fracture {

// A place of faces that the break of a bond between neighbours has made.
struct GrownFace {
  int term;
  double normal_x, normal_y;
};

// What a run knows of the faces of its cracks.
struct FaceState {
  std::vector<GrownFace> grown;
  std::vector<char> closed;  // flags of all constraints: exact ones, places on initial cracks, places that have grown
  // Terms that have broken, by event, whose places have not been looked at yet.
  std::vector<std::vector<int>> pending;
};

}  // namespace bempd::fracture

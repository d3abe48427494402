#pragma once

#include <vector>

namespace bempd::fracture {

// A place of faces that the break of a bond between neighbours has made.
struct GrownFace {
  int term;
  double normal_x, normal_y;
};

// What a run knows of its faces.
struct FaceState {
  std::vector<GrownFace> grown;
  std::vector<char> closed;         // of the initial places, then of the grown ones
  std::vector<char> closed_inside;  // of those inside operators
  // Terms that have broken, by event, whose places have not been looked at yet.
  std::vector<std::vector<int>> pending;
};

}  // namespace bempd::fracture

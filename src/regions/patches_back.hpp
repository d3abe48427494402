#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "regions/patches.hpp"

namespace bempd::regions {

// Patches after one of them has given blocks that a crack's tip has left behind back to the elements of its body, and
// the ways along the crack's path [m] between which it has elements from then on. A patch that falls into two is also
// the last one of the list.
struct GivenBack {
  std::vector<Patch> patches;
  double from, to;
  Blocks blocks;       // given back
  std::size_t number;  // of the patch, in both lists
};

// Lets the patch around a tip give back what lies more than six horizons behind the tip, and behind the crack's other
// end if that is in the patch, too. `paths` are those of all cracks, by id. Empty if this is less than three blocks of
// the path, or where the path would not cross the new border straight and away from corners, or where other cracks are
// near.
std::optional<GivenBack> given_back(const std::vector<Patch>& patches, const std::vector<std::vector<Point>>& paths,
                                    int crack, int end);

}  // namespace bempd::regions

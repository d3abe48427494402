#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "regions/patches.hpp"

namespace bempd::regions {

// Lattice patches after one of them has given back blocks that the tip of a crack has left behind: these blocks become
// part of the body with boundary elements again. The crack then has elements between the distances `from` and `to`
// along its path [m]. If the patch falls into two parts, the second part is the last patch of the list.
struct GivenBack {
  std::vector<Patch> patches;
  double from, to;
  Blocks blocks;       // that the patch gives back
  std::size_t number;  // index of the patch in the lists before and after
};

// Lets the patch around the tip at an end of a crack give back blocks that lie more than six horizons behind the tip.
// If the crack's other end lies in the patch, too, blocks within six horizons of that end stay. `paths` are the paths
// of all cracks, by id. Empty if less than three block lengths of the path lie in the blocks, if the path does not
// cross the new border straight and away from the border's corners, or if other cracks are near.
std::optional<GivenBack> given_back(const std::vector<Patch>& patches, const std::vector<std::vector<Point>>& paths,
                                    int crack, int end);

}  // namespace bempd::regions

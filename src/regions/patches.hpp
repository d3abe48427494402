#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "geometry/blocks.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Lattice of the patches of a body, as the host wants it; 0 where the library chooses.
struct BodyLattice {
  double spacing = 0;
  int horizon_ratio = 0;
};

// Crack that is to run in a lattice, and which of its ends may grow.
struct LatticeCrack {
  int id;
  std::array<bool, 2> grows;

  bool operator==(const LatticeCrack&) const = default;
};

// Piece of a body that becomes a lattice: blocks of 2 x 2 horizons around cracks and ahead of their tips.
struct Patch {
  int body;  // id
  std::vector<Point> outline;
  double spacing;
  int horizon_ratio;
  std::vector<int> cracks;  // ids
  BlockGrid grid;           // the same for all patches of a body
  Blocks blocks;
};

// Patches for cracks that are to run in lattices, by rules that docs/bodies.md states. Cracks in peridynamic regions
// have no need of any. Throws Error (argument) where a patch has no room, or a crack does not lie in one body.
std::vector<Patch> lay_out_patches(const scene::Scene& scene, const std::vector<LatticeCrack>& cracks,
                                   const std::map<int, BodyLattice>& lattices);

// Tip of a crack line after a step, and the unit vector of that step.
struct SteppedTip {
  Point place, direction;
};

// Patches with more blocks around and ahead of a tip in one of them; the others stay. Blocks keep to the grid of the
// patch, and keep the distances from edges, holes, cracks in elements and other patches. Empty if the tip lies in no
// patch, has all the blocks around it that there can be, or has to leave its patch soon.
std::optional<std::vector<Patch>> grown_ahead_of(const scene::Scene& scene, const std::vector<Patch>& patches,
                                                 const SteppedTip& tip);

// Bond that has broken in a patch near its border.
struct BrokenBondNearBorder {
  std::size_t extensions;  // of cracks, before it
  int patch;               // number in the list
  Block block;             // of the patch's grid, which has the middle of the bond
};
// Number below 0 that stands for one, from which it can be told again.
std::int64_t layout_number(const BrokenBondNearBorder& broken);
BrokenBondNearBorder broken_bond_of(std::int64_t number);

// Number of a layout that follows an extension: its place in the list, with a high bit if the patch gives back blocks
// as well (patches_back.hpp).
inline constexpr std::int64_t giving_back = std::int64_t{1} << 62;
inline bool gives_back(std::int64_t layout) { return layout >= giving_back; }
inline std::int64_t extension_of(std::int64_t layout) { return gives_back(layout) ? layout - giving_back : layout; }
// Number of extensions that there were when a patch changed, by a layout of fracture::EvolutionState.
inline std::size_t extensions_before(std::int64_t layout) {
  return layout < 0 ? broken_bond_of(layout).extensions : static_cast<std::size_t>(extension_of(layout)) + 1;
}

// Number of the patch in which a place lies; that of all patches if it lies in none.
std::size_t patch_around(const std::vector<Patch>& patches, const Point& place);

// Whether a place lies in a patch that does not have all blocks within two and a half horizons of it; empty if it does
// not.
std::optional<BrokenBondNearBorder> broken_bond_near_border(const std::vector<Patch>& patches, const Point& place,
                                                            std::size_t extensions);
// Patches with more blocks around a broken bond, otherwise like grown_ahead_of().
std::optional<std::vector<Patch>> grown_around(const scene::Scene& scene, const std::vector<Patch>& patches,
                                               const BrokenBondNearBorder& broken);

// Id of the first region without elements through which a crack runs; 0 if there is none.
int lattice_around(const scene::Scene& scene, int crack);

// Cuts patches out of their bodies and adds them to the scene, as regions with the next ids.
void add_patches(scene::Scene& scene, const std::vector<Patch>& patches);
// Gives the patches, which are behind the `count` other regions, other blocks. Their ids stay; patches that the scene
// does not have get the next ids, and those that are not in the list go.
void move_patches(scene::Scene& scene, const std::vector<Patch>& patches, int count);
// Takes all patches out again; the scene has `count` regions then.
void remove_patches(scene::Scene& scene, int count);

}  // namespace bempd::regions

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/blocks.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Lattice that the host has chosen for the lattice patches of a body; 0 where the library chooses.
struct BodyLattice {
  double spacing = 0;
  int horizon_ratio = 0;
};

// Crack that is to run in a lattice, and for each of its ends whether the end may grow.
struct LatticeCrack {
  int id;
  std::array<bool, 2> grows;

  bool operator==(const LatticeCrack&) const = default;
};

// Lattice patch: part of a body that is discretized as a lattice. It consists of square blocks of 2 x 2 horizons around
// cracks and ahead of the cracks' tips.
struct Patch {
  int body;  // id
  std::vector<Point> outline;
  double spacing;
  int horizon_ratio;
  std::vector<int> cracks;  // ids of the cracks in it
  BlockGrid grid;           // grid of blocks, the same for all patches of a body
  Blocks blocks;
};

// Lays out the lattice patches of cracks that are to run in lattices, by the rules of docs/bodies.md. Cracks in
// peridynamic regions get no patch. Throws Error (argument) where a patch has no room or not enough memory, or a crack
// does not lie in one body.
std::vector<Patch> lay_out_patches(const scene::Scene& scene, const scene::Options& options,
                                   const std::vector<LatticeCrack>& cracks, const std::map<int, BodyLattice>& lattices);

// Tip of a crack in a lattice after a step of its growth, and the unit vector of the step.
struct SteppedTip {
  Point place, direction;
};

// All patches of the scene after the patch around a tip has got more blocks around and ahead of the tip. New blocks lie
// on the patch's grid, and keep the distances from edges, holes, cracks with elements and other patches. Empty if the
// tip lies in no patch, if the patch has enough blocks or can get no more, or if the tip has to leave the patch soon
// because blocks next to it are impossible.
std::optional<std::vector<Patch>> grown_ahead_of(const scene::Scene& scene, const std::vector<Patch>& patches,
                                                 const SteppedTip& tip);

// Bond that has broken near the border of a lattice patch.
struct BrokenBondNearBorder {
  std::size_t extensions;  // number of crack extensions before the bond broke
  int patch;               // index in the list of patches
  Block block;             // block of the patch's grid with the middle of the bond
};
// Number of the layout of patches that follows a broken bond: a negative number that encodes the bond.
std::int64_t layout_number(const BrokenBondNearBorder& broken);
// Broken bond that is encoded in the number of a layout.
BrokenBondNearBorder broken_bond_of(std::int64_t number);

// Bit in the number of a layout of patches that follows a crack extension. The number is the index of the extension in
// the list of all extensions, plus this bit if the patch also gives blocks back (patches_back.hpp).
inline constexpr std::int64_t giving_back = std::int64_t{1} << 62;
inline bool gives_back(std::int64_t layout) { return layout >= giving_back; }
inline std::int64_t extension_of(std::int64_t layout) { return gives_back(layout) ? layout - giving_back : layout; }
// Number of crack extensions before a change of the patches. `layout` is the number of the new layout, as it is stored
// in fracture::EvolutionState.
inline std::size_t extensions_before(std::int64_t layout) {
  return layout < 0 ? broken_bond_of(layout).extensions : static_cast<std::size_t>(extension_of(layout)) + 1;
}

// Index of the patch in which a place lies; the number of patches if the place lies in none.
std::size_t patch_around(const std::vector<Patch>& patches, const Point& place);

// Broken bond with its middle at `place`, if the place lies in a patch that lacks a block within two and a half
// horizons of the place; else empty.
std::optional<BrokenBondNearBorder> broken_bond_near_border(const std::vector<Patch>& patches, const Point& place,
                                                            std::size_t extensions);
// All patches of the scene after the patch around a broken bond has got more blocks around the bond; empty if it can
// get none.
std::optional<std::vector<Patch>> grown_around(const scene::Scene& scene, const std::vector<Patch>& patches,
                                               const BrokenBondNearBorder& broken);

// Id of the first region without boundary elements through which a crack runs; 0 if there is no such region.
int lattice_around(const scene::Scene& scene, int crack);

class BoundaryDescription;

// Descriptions of a scene's bodies with patches cut out, and of the patches, which are the regions with ids above
// `count`. They are made beside the scene. To put them in the place of those in the scene takes no memory, so that this
// can be undone after any failure.
class PatchedBodies {
 public:
  PatchedBodies() = default;
  PatchedBodies(const scene::Scene& scene, const std::vector<Patch>& patches, int count);
  PatchedBodies(PatchedBodies&& other) noexcept;
  PatchedBodies& operator=(PatchedBodies&& other) noexcept;
  ~PatchedBodies();

  // Exchanges these descriptions with those of the scene, whatever patches it has. Refinements of elements stay.
  void exchange(scene::Scene& scene) noexcept;

 private:
  int count_ = 0;
  std::vector<std::unique_ptr<scene::Region>> regions_;                       // null but for patches
  std::vector<std::pair<int, std::unique_ptr<BoundaryDescription>>> bodies_;  // with their ids
};

}  // namespace bempd::regions

#pragma once

#include <array>
#include <map>
#include <vector>

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
};

// Patches for cracks that are to run in lattices, by rules that docs/bodies.md states. Cracks in peridynamic regions
// have no need of any. Throws Error (argument) where a patch has no room, or a crack does not lie in one body.
std::vector<Patch> lay_out_patches(const scene::Scene& scene, const std::vector<LatticeCrack>& cracks,
                                   const std::map<int, BodyLattice>& lattices);

// Id of the first region without elements through which a crack runs; 0 if there is none.
int lattice_around(const scene::Scene& scene, int crack);

// Cuts patches out of their bodies and adds them to the scene, as regions with the next ids.
void add_patches(scene::Scene& scene, const std::vector<Patch>& patches);
// Takes all patches out again; the scene has `count` regions then.
void remove_patches(scene::Scene& scene, int count);

}  // namespace bempd::regions

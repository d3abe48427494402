#pragma once

#include <cstdint>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/bond_family.hpp"
#include "pd/cell_lattice.hpp"

namespace bempd::pd {

// Bond: a pair of material points that pull on each other along their common line, with force = stiffness * elongation.
struct Bond {
  int first, second;
  double stiffness;  // [N/m], thickness included
};

// Bonds of a body. The bonds that build_network() makes reproduce every linear displacement field exactly: under a
// constant strain their forces equal the resultants of the tractions on the faces around each material point,
// everywhere in the body. Bonds alone have Poisson's ratio 1/3 in plane stress and 1/4 in plane strain. Materials of
// other ratios need cell squares (cell_squares.hpp) as well.
struct Network {
  std::vector<BondOffset> offsets;       // step from first to second, its length and direction; few distinct ones
  std::vector<Bond> bonds;               // sorted by (first, second)
  std::vector<std::uint32_t> offset_of;  // index in `offsets` for each bond
  double max_residual = 0;               // largest error of a point's third moments, for C1111 = thickness = 1
  double min_weight_ratio = 1;           // smallest ratio of a bond's stiffness to its bulk stiffness
  bool reduced = false;  // no exact network was found for this horizon, so only nearest neighbours have bonds
};

// Builds the bonds of a lattice, 2 <= horizon_ratio <= 8. Parts of the body that are one cell wide get the network of
// nearest neighbours, and so does the whole body at horizon ratio 2. `threads`: 0 for one per core.
Network build_network(const CellLattice& lattice, int horizon_ratio, const PlaneElasticity& elasticity, int threads = 0,
                      const BondKernel& kernel = quartic_kernel());

}  // namespace bempd::pd

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

// Bonds of a body. Those of build_network() reproduce every linear displacement field exactly: under a constant strain
// their forces equal the resultants of the tractions on the faces around each material point, everywhere in the body.
// Bonds alone have Poisson's ratio 1/3 in plane stress and 1/4 in plane strain. For other ratios cell_squares.hpp adds
// terms.
struct Network {
  std::vector<BondOffset> offsets;       // step from first to second, its length and direction; few distinct ones
  std::vector<Bond> bonds;               // sorted by (first, second)
  std::vector<std::uint32_t> offset_of;  // one a bond: index into `offsets`
  double max_residual = 0;               // largest error of a point's third moments, for C1111 = thickness = 1
  double min_weight_ratio = 1;           // smallest stiffness over that of the same bond in the bulk
  bool reduced = false;                  // no such network was found at this horizon: nearest neighbours only
};

// Builds the bonds of a lattice, 2 <= horizon_ratio <= 8. Parts of the body that are one cell wide, and all of it at
// the ratio 2, get the network of nearest neighbours. `threads`: 0 for one per core.
Network build_network(const CellLattice& lattice, int horizon_ratio, const PlaneElasticity& elasticity, int threads = 0,
                      const BondKernel& kernel = quartic_kernel());

}  // namespace bempd::pd

#pragma once

#include <cstdint>
#include <vector>

#include "pd/cell_grid.hpp"
#include "pd/face_template.hpp"

namespace bempd::pd {

// Bonds while the network is made, for C1111 = thickness = 1.
struct DraftBonds {
  std::vector<int> first, second;  // sorted
  std::vector<int> start;          // of a point's bonds to points with larger numbers, and the end of the last ones
  std::vector<std::uint16_t> offset;
  std::vector<double> stiffness;
  std::vector<std::uint8_t> adjustable;  // 0: not a bond of the thick part
};

// Missing third moments 111, 112, 122, 222 of every material point: what its bonds lack for balance with the tractions
// of every constant stress on the faces there.
std::vector<Eigen::Vector4d> missing_moments(const CellLattice& lattice, const CellGrid& cells,
                                             const std::vector<BondOffset>& family, const DraftBonds& bonds);

struct CornerReport {
  double residual = 0;
  bool positive = true;
};

// Changes stiffnesses around corners by the least amounts after which no point has missing moments. The result does not
// depend on the number of `threads` (0: one per core).
CornerReport close_corners(const CellLattice& lattice, const CellGrid& cells, const LatticeTemplates& templates,
                           DraftBonds& bonds, int threads);

}  // namespace bempd::pd

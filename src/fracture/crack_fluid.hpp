#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/terms.hpp"
#include "geometry/point.hpp"
#include "linalg/adjacency.hpp"
#include "pd/fluid_paths.hpp"

namespace bempd::fracture {

// Pressures in cracks by crack id, constant and proportional part [Pa].
using CrackPressures = std::map<int, Eigen::RowVector2d>;

// Fluid in cracks of lattices. It spreads from the initial faces of a crack to all open facets (pieces of crack face
// between neighbouring points) that are connected to them. The pressure acts in place of broken terms (bonds and cell
// squares): terms that the crack cuts, bonds that cross a facet with fluid, and the followers of both (cell squares
// that break with a bond).
class CrackFluid {
 public:
  CrackFluid() = default;
  // `cut` gives the bonds that each crack (id) cuts at first.
  CrackFluid(pd::FluidPaths paths, std::map<int, std::vector<int>> cut, const coupling::Terms& terms,
             const std::vector<Point>& positions);

  bool empty() const { return cut_.empty(); }

  // Adds the nodal forces of the pressures to `force` [N]. Terms with an unloaded node get no pressure. Where the
  // fluids of several cracks meet on a facet, the pressure of the first crack (smallest id) acts.
  void add_forces(const CrackPressures& pressures, const coupling::Terms& terms, const std::vector<char>& intact,
                  const std::vector<char>& unloaded, coupling::Affine& force) const;

 private:
  using Cell = std::int64_t;
  Cell cell_of(const Point& place) const;
  void reach_facets(int crack, const std::vector<char>& intact, std::vector<int>& owner) const;
  const std::vector<int>& crossed_by(int bond, const coupling::Terms& terms) const;

  pd::FluidPaths paths_;
  std::map<int, std::vector<int>> cut_;
  std::vector<Point> positions_;
  std::vector<int> facet_of_;                                  // facet of each term, or -1
  linalg::Adjacency facets_at_;                                // facets at each place where facets join
  double spacing_ = 1;                                         // length of the shortest facet [m]
  std::unordered_map<Cell, std::vector<int>> facets_in_;       // facets by the grid cells of their middles
  mutable std::unordered_map<int, std::vector<int>> crossed_;  // facets that a broken bond crosses, once asked for
};

}  // namespace bempd::fracture

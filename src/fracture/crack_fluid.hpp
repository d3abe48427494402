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

// Fluid in cracks of lattices. It spreads from a crack's initial faces to all open facets that join on. Its pressure
// acts in place of the broken terms: those that the crack cuts, those that cross a facet that the fluid has reached,
// and their followers.
class CrackFluid {
 public:
  CrackFluid() = default;
  // `cut` gives the bonds that each crack (id) cuts at first.
  CrackFluid(pd::FluidPaths paths, std::map<int, std::vector<int>> cut, const coupling::Terms& terms,
             const std::vector<Point>& positions);

  bool empty() const { return cut_.empty(); }

  // Adds the nodal forces of the pressures [N]. Terms with an unloaded node have none. Where fluids of several cracks
  // have met, the pressure of the first crack acts.
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
  std::vector<int> facet_of_;    // term
  linalg::Adjacency facets_at_;  // place
  double spacing_ = 1;           // the least [m]
  std::unordered_map<Cell, std::vector<int>> facets_in_;
  mutable std::unordered_map<int, std::vector<int>> crossed_;  // facets, of broken bonds
};

}  // namespace bempd::fracture

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

// Constant and proportional part of the pressure in some cracks, by their ids [Pa].
using CrackPressures = std::map<int, Eigen::RowVector2d>;

// A fluid in cracks among bonds. It goes from where a crack is at first wherever open facets join on, and acts in place
// of all terms that are broken there: those that the crack cuts, those that cross a facet that it has reached, and what
// follows these.
class CrackFluid {
 public:
  CrackFluid() = default;
  // `cut`: by crack, the bonds that it parts at first.
  CrackFluid(pd::FluidPaths ways, std::map<int, std::vector<int>> cut, const coupling::Terms& terms,
             const std::vector<Point>& positions);

  bool empty() const { return cut_.empty(); }

  // Adds nodal forces [N]. Beside nodes without loads there are none. Where cracks have met the first of them counts.
  void add_forces(const CrackPressures& pressures, const coupling::Terms& terms, const std::vector<char>& intact,
                  const std::vector<char>& unloaded, coupling::Affine& force) const;

 private:
  using Cell = std::int64_t;
  Cell cell_of(const Point& place) const;
  void reach_facets(int crack, const std::vector<char>& intact, std::vector<int>& owner) const;
  const std::vector<int>& crossed_by(int bond, const coupling::Terms& terms) const;

  pd::FluidPaths ways_;
  std::map<int, std::vector<int>> cut_;
  std::vector<Point> positions_;
  std::vector<int> facet_of_;    // term
  linalg::Adjacency facets_at_;  // place
  double spacing_ = 1;           // the least [m]
  std::unordered_map<Cell, std::vector<int>> facets_in_;
  mutable std::unordered_map<int, std::vector<int>> crossed_;  // facets, of broken bonds
};

}  // namespace bempd::fracture

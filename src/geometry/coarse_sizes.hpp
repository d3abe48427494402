#pragma once

#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "geometry/box_tree.hpp"
#include "geometry/outline.hpp"

namespace bempd {

// Length of the coarsest useful elements of a body with this outline.
double coarsest_element(const Outline& outline);

// Coarsest useful elements on the boundary of a body. Their lengths follow from the body's shape alone: an element is
// no longer than a share of the outline, twice the distance to another part of the boundary, and the distance to a
// shorter neighbouring panel. Meshes of any accuracy follow by halving all elements.
class CoarseSizes {
 public:
  explicit CoarseSizes(const std::vector<std::vector<Panel>>& loops);

  // Ends of the elements of a panel, as fractions of its length. Panels are numbered through all loops.
  std::vector<double> stations(int panel) const;

 private:
  struct Placed {
    Arc arc;
    double length;
    int before, behind;  // neighbouring panels in the loop
  };
  std::vector<int> near(int panel) const;
  double limit(int panel, const std::vector<int>& others, double fraction) const;

  std::vector<Placed> panels_;
  std::vector<Box> boxes_;  // boxes around the panels
  BoxTree tree_;
  double longest_ = 0;
};

}  // namespace bempd

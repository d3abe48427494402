#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/box_tree.hpp"
#include "geometry/segment.hpp"
#include "geometry/subdomain_loops.hpp"

namespace bempd {

// Straight cut through the material between two nodes of a subdomain's boundary, with the ends of its elements.
struct MaterialCut {
  int from, to;       // nodes
  Stations stations;  // from the place of `from` to that of `to`
};

// Whether the elements of a cut are short enough for the cracks near it.
bool is_clear_of(const Stations& cut, const std::vector<Stations>& cracks);

// Search for cuts that divide a subdomain in two halves of about as many elements. The cuts follow a line parallel to
// an axis wherever it lies in the material, and end at ends of elements, where they make no small angle with the
// boundary. The elements of a cut grow with the distance from the boundary and from cracks, off which cuts keep.
class MaterialCutSearch {
 public:
  MaterialCutSearch(const SubdomainLoops& loops, const std::vector<Point>& positions,
                    const std::vector<Stations>& cracks);

  struct Division {
    std::vector<MaterialCut> cuts;
    double cost;  // elements on cuts, and more the less equal the halves are
  };
  // Best of some divisions along lines x = constant (axis 0) or y = constant (axis 1); empty if none was found.
  std::optional<Division> along(int axis) const;
  int longer_axis() const;

 private:
  struct Hit {
    double along;  // coordinate on the line
    int side;
  };
  std::vector<Hit> hits(int axis, double at) const;
  std::vector<int> ends_near(int side) const;
  std::array<Point, 2> directions_at(int side) const;
  // Angle inside the material at the start of a side; then the smaller of the two into which a direction divides it,
  // negative if the direction leads out of the material.
  double corner(int side) const;
  double least_angle(int side, const Point& direction) const;
  std::optional<MaterialCut> cut_between(const Hit& a, const Hit& b, const std::vector<MaterialCut>& others) const;
  std::optional<std::vector<MaterialCut>> cuts_on(int axis, double at) const;
  bool is_clear(int from, int to, const std::vector<MaterialCut>& others) const;
  bool keeps_off_cracks(const Segment& cut) const;
  double element_length_at(const Point& place) const;
  void divide(const Point& from, const Point& to, int depth, std::vector<Point>& stations) const;

  const Point& start(int side) const { return positions_[sides_[side].nodes[0]]; }
  const Point& end(int side) const { return positions_[sides_[side].nodes[2]]; }

  const std::vector<Point>& positions_;
  std::vector<SubdomainSide> sides_;
  std::vector<int> before_, after_, loop_size_;  // of each side
  std::vector<int> uses_;                        // number of sides that start at a node
  BoxTree tree_;
  std::vector<Segment> on_cracks_;  // elements
  Box box_;
};

}  // namespace bempd

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
  int from, to;       // nodes at both ends
  Stations stations;  // ends of elements, from the place of `from` to that of `to`
};

// Whether a cut keeps its distance from all cracks, and its elements are short enough for cracks near the cut.
bool is_clear_of(const Stations& cut, const std::vector<Stations>& cracks);

// Search for cuts that divide a subdomain into two halves with about equal numbers of elements. The cuts follow a
// straight line parallel to an axis wherever this line lies in the material. They end at ends of elements, at no small
// angle with the boundary. The elements of a cut become longer with the distance from the boundary and from cracks, and
// cuts keep a distance from cracks.
class MaterialCutSearch {
 public:
  MaterialCutSearch(const SubdomainLoops& loops, const std::vector<Point>& positions,
                    const std::vector<Stations>& cracks);

  struct Division {
    std::vector<MaterialCut> cuts;
    double cost;  // number of elements on cuts, times a factor for unequal halves
  };
  // Best of the divisions found along lines x = constant (axis 0) or y = constant (axis 1); empty if none was found.
  std::optional<Division> along(int axis) const;
  int longer_axis() const;

 private:
  struct Hit {
    double along;  // coordinate of the crossing along the line
    int side;
  };
  std::vector<Hit> hits(int axis, double at) const;
  std::vector<int> ends_near(int side) const;
  std::array<Point, 2> directions_at(int side) const;
  // Angle inside the material at the corner where a side starts.
  double corner(int side) const;
  // Smaller one of the two angles into which a direction divides the corner at the start of a side; negative if the
  // direction leads out of the material.
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
  std::vector<int> before_, after_, loop_size_;  // per side: neighbours, and number of sides of its loop
  std::vector<int> uses_;                        // number of sides that start at each node
  BoxTree tree_;
  std::vector<Segment> on_cracks_;  // elements on cracks
  Box box_;
};

}  // namespace bempd

#pragma once

#include <vector>

#include "coupling/node_ties.hpp"
#include "geometry/arrangement.hpp"
#include "geometry/point.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Boundary elements along a straight interface with a lattice whose points do not match the elements. The points of the
// lattice follow the elements. `places` and `nodes` have the start of the first element, then the middle and the end of
// every element.
struct LeadingElements {
  int edge;      // number of the edge of the region that has the elements
  int follower;  // id of the other region, whose points follow
  std::vector<Point> places;
  std::vector<int> nodes;  // numbers of the nodes in the scene
};

// Borders of a region with boundary elements, as its neighbours see them.
class ElementBorders {
 public:
  virtual ~ElementBorders() = default;

  // Elements on interfaces with lattices whose points do not match these elements. The function may be called once
  // nodes are numbered.
  virtual std::vector<LeadingElements> leading_elements() const = 0;
  // Places of the region's nodes on interfaces with another region [m]. The function may be called once the region is
  // meshed.
  virtual std::vector<Point> places_facing(int other_region) const = 0;
};

// Borders of a region with material points, as its neighbours see them.
class PointBorders {
 public:
  virtual ~PointBorders() = default;

  // Material points on an interface, in order along this region's edge [m]. Neighbours may call the function before
  // this region is meshed.
  virtual std::vector<Point> interface_points(const Preparation& preparation, const Contact& own) = 0;
  // Ties the region's nodes on an interface to the elements of the region `leader` (an id).
  virtual void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const = 0;
};

}  // namespace bempd::regions

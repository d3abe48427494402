#pragma once

#include <vector>

#include "coupling/node_ties.hpp"
#include "geometry/arrangement.hpp"
#include "geometry/point.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Boundary elements along a straight interface that the nodes of the other region follow, where meshes do not match.
// `places` and `nodes`: the start of the first element, then the middle and the end of every element.
struct LeadingElements {
  int edge;      // of the region that has the elements
  int follower;  // id of the other region
  std::vector<Point> places;
  std::vector<int> nodes;  // of the scene
};

// Borders of a region with boundary elements, as its neighbours see them.
class ElementBorders {
 public:
  virtual ~ElementBorders() = default;

  // Elements on interfaces that do not match, which nodes on the other side follow; known once nodes are numbered.
  virtual std::vector<LeadingElements> leading_elements() const = 0;
  // Places of the region's nodes on interfaces with another region; known once the region is meshed [m].
  virtual std::vector<Point> places_facing(int other_region) const = 0;
};

// Borders of a region with material points, as its neighbours see them.
class PointBorders {
 public:
  virtual ~PointBorders() = default;

  // Material points on an interface, in order along this region's edge [m]. Neighbours may ask before it is meshed.
  virtual std::vector<Point> interface_points(const Preparation& preparation, const Contact& own) = 0;
  // Ties the region's nodes to elements of the region `leader`.
  virtual void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const = 0;
};

}  // namespace bempd::regions

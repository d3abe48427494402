#pragma once

#include <vector>

#include "elasticity/wedge_exponent.hpp"
#include "geometry/box_tree.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Wedge of the sectors around a place that are bonded to each other, of one material or several.
struct MeetingWedge {
  Wedge wedge;
  int region;     // the first one
  bool at_crack;  // a face of a crack is one of its sides
};

// Finds the wedges that meet at a place on the scene's outlines or cracks; their angles and supports give the stress
// singularity there.
class WedgeFinder {
 public:
  WedgeFinder(const scene::Scene& scene, const Discretization& discretization);

  std::vector<MeetingWedge> wedges_at(const Point& place) const;

 private:
  // Ray from the place along a side of a sector: an edge of a region's outline, or a crack.
  struct Ray {
    double angle;
    int held = 0;  // components
    bool crack = false;
  };
  struct Sector {
    int region;
    Ray from, to;
    double opening;
  };
  struct OutlineEdge {
    int region, number;
    Edge edge;
  };

  void add_sectors_of_outlines(const Point& place, std::vector<Sector>& sectors) const;
  void cut_by_cracks(const Point& place, std::vector<Sector>& sectors) const;
  Sector between(int region, const Point& place, const Ray& from, const Ray& to) const;
  int region_at(const Point& place) const;
  int held_on(const OutlineEdge& edge, double fraction) const;

  const scene::Scene& scene_;
  const Discretization& d_;
  std::vector<OutlineEdge> edges_;
  BoxTree tree_;
};

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "elasticity/wedge_exponent.hpp"
#include "geometry/box_tree.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Wedge at a place: the sectors of regions around the place that are bonded to each other, of one material or several.
struct MeetingWedge {
  Wedge wedge;
  int region;     // id of the region of its first sector
  bool at_crack;  // whether a face of a crack bounds a sector
};

// Finds the wedges that meet at a place on the scene's outlines or cracks. The angles and supports of a wedge determine
// the stress singularity at the place.
class WedgeFinder {
 public:
  WedgeFinder(const scene::Scene& scene, const Discretization& discretization);

  std::vector<MeetingWedge> wedges_at(const Point& place) const;

 private:
  // Ray from the place along a side of a sector: an edge of a region's outline, or a crack.
  struct Ray {
    double angle;
    int held = 0;  // components that supports hold: 1 x, 2 y, 3 both
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
  int held_on(const OutlineEdge& edge, double fraction) const;

  const scene::Scene& scene_;
  const Discretization& d_;
  std::vector<OutlineEdge> edges_;
  BoxTree tree_;
};

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Neighbour of a piece of an edge: none, a region whose element ends can be negotiated, or one with nodes at fixed
// places.
enum class Border { free, elements, grid };

// Piece of an edge that a panel of a boundary mesh comes from.
struct PanelSource {
  int edge;         // number in its region
  double from, to;  // fractions of the edge
  Border border;
  int other_region;  // id of the region it borders on, 0 for none
  bool tied;         // at a grid that the elements do not follow: the grid's nodes are tied to them
};

// Panels and elements of one boundary element region, loop by loop.
struct BoundaryPanels {
  std::vector<std::vector<Panel>> loops;
  std::vector<PanelSource> sources;
};

struct MeshingRules {
  // Every node lies on a point of a bordering grid, except the last of an odd number of spacings, and elements of the
  // host's choice need not be tied. Otherwise element ends lie on its points, and the displacement between them is
  // linear.
  bool nodes_on_grids = false;
  // Elements become smaller towards places where stress is singular.
  bool grade_corners = false;
};

// Places where panels end, without mouths of cracks: corners, and ends of supports, loads and interfaces.
std::vector<Point> panel_ends(const Preparation& preparation, int region);

// Meshes the edges of a region; panels also end at `mouths`, where cracks reach the boundary.
BoundaryPanels mesh_edges(const Preparation& preparation, const MeshingRules& rules, int region,
                          const std::vector<Point>& mouths = {});

}  // namespace bempd::regions

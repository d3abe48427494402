#pragma once

#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Kind of neighbour at a piece of an edge: none, a boundary element region, with which element ends are negotiated, or
// a region with nodes at fixed places.
enum class Border { free, elements, grid };

// Origin of a panel of a boundary mesh: a piece of an edge and its neighbour.
struct PanelSource {
  int edge;         // number in its region
  double from, to;  // fractions of the edge
  Border border;
  int other_region;  // id of the region it borders on, 0 for none
  bool tied;         // at a grid that the elements do not follow: the grid's nodes are tied to them
};

// Panels of one boundary element region with their elements: by loops of the outline, and for each panel, in the same
// order, where it comes from.
struct BoundaryPanels {
  std::vector<std::vector<Panel>> loops;
  std::vector<PanelSource> sources;
};

struct MeshingRules {
  // True: elements on the border with a grid are two spacings long, so that all their nodes lie on grid points (but the
  // mid node of the last one does not if the number of spacings is odd). Elements of a length that the host has chosen
  // are not tied to the grid. False: elements are one spacing long, and the displacement along each is linear.
  bool nodes_on_grids = false;
  // Grades elements towards places where stress is singular.
  bool grade_corners = false;
};

// Places where panels of a region end without regard to cracks: corners, and ends of supports, loads and interfaces.
std::vector<Point> panel_ends(const Preparation& preparation, int region);

// Meshes the edges of a region; panels also end at `mouths`, the places where cracks reach the boundary.
BoundaryPanels mesh_edges(const Preparation& preparation, const MeshingRules& rules, int region,
                          const std::vector<Point>& mouths = {});

// Halves or merges the elements of a region as the scene's refinement says. On an interface both regions get the same
// elements; those on the points of a lattice stay.
void halve_elements(const Preparation& preparation, int region, BoundaryPanels& panels);

}  // namespace bempd::regions

#pragma once

#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "regions/preparation.hpp"

namespace bempd::regions {

// Neighbour at a piece of an edge: none (free), a boundary element region, which gets the same element ends there
// (elements), or a region with nodes at fixed places (grid).
enum class Border { free, elements, grid };

// Source of a panel (row of elements) of a boundary mesh: a piece of an edge, and the neighbour at this piece.
struct PanelSource {
  int edge;         // number in its region
  double from, to;  // fractions of the edge
  Border border;
  int other_region;  // id of the neighbour; 0 for none
  bool tied;         // whether the neighbour's nodes do not match the elements and are tied to them
};

// Panels of one boundary element region, by loops of the outline, and the sources of all panels, in the same order.
struct BoundaryPanels {
  std::vector<std::vector<Panel>> loops;
  std::vector<PanelSource> sources;
};

struct MeshingRules {
  // How elements follow the nodes of a grid. True: elements on the border with a grid are two spacings long, so that
  // all their nodes lie on grid points, except the mid node of the last element if the number of spacings is odd. If
  // the host has chosen another element length, grid nodes that miss the element's nodes are not tied to the element.
  // False: elements are one spacing long, and the displacement is linear along each element.
  bool nodes_on_grids = false;
  // Whether elements become shorter towards places where the stress is singular, such as corners.
  bool grade_corners = false;
};

// Places where panels of a region end even without cracks: corners, and ends of supports, loads and interfaces.
std::vector<Point> panel_ends(const Preparation& preparation, int region);

// Meshes the edges of a region; panels also end at `mouths`, the places where cracks reach the boundary.
BoundaryPanels mesh_edges(const Preparation& preparation, const MeshingRules& rules, int region,
                          const std::vector<Point>& mouths = {});

// Halves or merges the elements of a region as often as the scene's refinement says. On an interface of two boundary
// element regions both regions get the same elements. Elements that follow the points of a lattice, or border on a
// lattice patch, stay as they are.
void halve_elements(const Preparation& preparation, int region, BoundaryPanels& panels);

}  // namespace bempd::regions

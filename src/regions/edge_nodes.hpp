#pragma once

#include <vector>

#include "regions/discretization.hpp"

// Nodes on edges of regions, and quantities that belong to such nodes.
namespace bempd::regions {

struct EdgeNode {
  int node;         // number in the scene
  int entry;        // index in fields given at the region's nodes; -1: none
  double fraction;  // place as a fraction of the edge
  double weight;    // integral of the node's shape function along the edge [m]
};

// Nodes on the part `span` of an edge, in order along it, each node once.
std::vector<PlacedNode> nodes_in_order(const Discretization& discretization, int region, const EdgeSpan& span);
// Nodes on a whole edge, in order along it, each node once.
std::vector<EdgeNode> edge_nodes(const scene::Scene& scene, const Discretization& discretization, int region, int edge);
// Cells of a region (boundary elements or lattice cells) that have a side on the edge whose nodes are given, in order
// along the edge.
std::vector<int> edge_cells(const Discretization& discretization, int region, const std::vector<EdgeNode>& nodes);

// Ids of the regions that bonds connect to a region, directly or through other regions, including the region itself. A
// region without bonds is alone.
std::vector<int> regions_of_body(const Discretization& discretization, int region);

// Nodal forces of the loads on some regions (ids), including loads on cracks that have elements in these regions. Loads
// that are built into operators (changes of temperature) are left out.
coupling::Affine loads_on(const scene::Scene& scene, const Discretization& discretization,
                          const std::vector<int>& regions);

// Whether part of an edge is an interface with another region.
bool has_interface(const Discretization& discretization, int region, int edge);

// Nodes on the interfaces that an edge of a region has with regions outside `body` (ids of regions).
std::vector<int> interface_nodes(const scene::Scene& scene, const Discretization& discretization,
                                 const std::vector<int>& body, int region, int edge);

}  // namespace bempd::regions

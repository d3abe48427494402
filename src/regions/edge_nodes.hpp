#pragma once

#include <functional>
#include <vector>

#include "regions/boundary_conditions.hpp"
#include "regions/discretization.hpp"

// Nodes along an edge, and the quantities that belong to them.
namespace bempd::regions {

struct EdgeNode {
  int node;         // of the scene
  int entry;        // in fields of the region's nodes
  double fraction;  // of the edge
  double weight;    // integral of its shape function along the edge [m]
};

// Nodes in order along the part, each once.
std::vector<PlacedNode> nodes_in_order(const Discretization& discretization, int region, const EdgeSpan& span);
// Nodes of a whole edge in order, each once.
std::vector<EdgeNode> edge_nodes(const scene::Scene& scene, const Discretization& discretization, int region, int edge);
// Elements or cells of the region that have a side on the edge, in order along it.
std::vector<int> edge_cells(const Discretization& discretization, int region, const std::vector<EdgeNode>& nodes);

// Regions whose bonds make one body with those of a region, by id; a region without bonds is alone.
std::vector<int> regions_of_body(const Discretization& discretization, int region);

// Forces of the present loads on some regions, with those on cracks that have elements there.
coupling::Affine loads_on(const scene::Scene& scene, const Discretization& discretization,
                          const std::vector<int>& regions);

// Whether an edge has a part in common with another region.
bool is_in_contact(const Discretization& discretization, int region, int edge);

// Nodes that an edge shares with regions outside its body, where it is an interface.
std::vector<int> interface_nodes(const scene::Scene& scene, const Discretization& discretization,
                                 const std::vector<int>& body, int region, int edge);

}  // namespace bempd::regions

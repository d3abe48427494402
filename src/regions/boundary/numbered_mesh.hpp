#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "geometry/boundary_mesh.hpp"
#include "regions/boundary/boundary_meshing.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Mesh of a boundary element region, the sources of its panels, and the numbers of its nodes in the scene. Where
// elements follow the points of a grid, their displacement may be linear between these points, so that a constant
// traction has its exact nodal forces. The mid nodes of such elements are not nodes of the scene.
class NumberedMesh final : public ElementBorders {
 public:
  explicit NumberedMesh(const Region& region) : region_(region) {}

  // Takes the mesh, the sources of its panels, and the places of nodes on cuts between subdomains.
  // `middles_follow_ends`: whether the mid node of an element that follows a grid has the mean displacement of the
  // element's ends.
  void take(BoundaryMesh mesh, std::vector<PanelSource> panels, const std::vector<Point>& on_cuts,
            bool middles_follow_ends);
  // Numbers the nodes, and returns their numbers in the scene. `mouths` has the nodes before and behind the mouth at
  // each joint (place where cracks meet each other or the boundary) of cracks that may continue in a lattice. The first
  // number is negative for a joint inside the region.
  std::vector<int> number(const Preparation& preparation, NodeRegistry& registry,
                          std::span<const std::array<int, 2>> mouths);

  const BoundaryMesh& mesh() const { return mesh_; }
  const std::vector<PanelSource>& panels() const { return panels_; }
  const PanelSource& source_of(const BoundaryElement& element) const {
    return panels_[static_cast<std::size_t>(element.panel)];
  }
  // Places of the mesh's nodes, followed by the places of the nodes on cuts between subdomains.
  const std::vector<Point>& places() const { return places_; }
  // Matrix that gives the displacements at places() from those of the region's nodes.
  const Eigen::SparseMatrix<double>& trace() const { return trace_; }
  // Node of the scene for each node of the mesh; -1 if the node's displacement follows from other nodes.
  const std::vector<int>& scene_nodes() const { return scene_nodes_; }
  // Node of the scene at one of places(); -1 if the displacement there follows from other nodes.
  int node_at(int place) const;

  std::vector<LeadingElements> leading_elements() const override;
  std::vector<Point> places_facing(int other_region) const override;

 private:
  struct NodeRoles;

  NodeRoles roles(std::span<const std::array<int, 2>> mouths) const;
  void follow_rows_to_mouths(std::span<const std::array<int, 2>> mouths, NodeRoles& roles) const;
  std::vector<int> sides_of_cracks(const Preparation& preparation) const;

  const Region& region_;
  BoundaryMesh mesh_;
  std::vector<PanelSource> panels_;
  std::vector<Point> places_;
  bool middles_follow_ends_ = true;
  std::vector<int> scene_nodes_;
  Eigen::SparseMatrix<double> trace_;
};

}  // namespace bempd::regions

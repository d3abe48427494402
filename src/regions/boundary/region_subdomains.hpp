#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <vector>

#include "bem/boundary_operator.hpp"
#include "coupling/operators.hpp"
#include "elasticity/plane_elasticity.hpp"
#include "geometry/edge.hpp"
#include "geometry/subdomains.hpp"
#include "regions/boundary/cracked_part.hpp"
#include "regions/boundary/interior_of_pieces.hpp"
#include "regions/boundary/region_cracks.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"

namespace bempd::regions {

// Estimate of the memory [B] of a boundary operator with this number of elements.
double memory_of_operator(double elements);
// Estimate of the least memory [B] of a region with this number of elements, cut into subdomains if it is large.
double least_memory_of_region(double elements);

// Matrix, stored by rows, that gives the displacements at the places of a region from those of the region's nodes.
using TraceRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Subdomains into which a large region is cut, because the cost of one dense operator grows with the square and cube of
// the number of its nodes. Each subdomain has a boundary operator of its own, and subdomains share the nodes on cuts.
// The region's mesh, fields and loads are those of its outline. The places of the region are those of the mesh's nodes,
// followed by those of the nodes on cuts.
class RegionSubdomains {
 public:
  // Cuts the region with the mesh `body`; null if the region is so small that one operator is enough, or if no cut was
  // found.
  static std::unique_ptr<RegionSubdomains> of(const BoundaryMesh& body, const scene::Options& options);

  // Cuts the region with the mesh `body` around its cracks; `cracks` has the places of element ends on each crack line.
  // Cuts are first chosen for the mesh without cracks, `uncracked`, or taken from `before` (null: none) if that had the
  // same mesh without cracks. Then cuts that meet cracks are replaced. The result is null as in of().
  static std::unique_ptr<RegionSubdomains> around(const std::vector<Stations>& cracks, const BoundaryMesh& body,
                                                  BoundaryMesh uncracked, const scene::Options& options,
                                                  const RegionSubdomains* before);

  RegionSubdomains(Subdivision subdivision, const BoundaryMesh& body);

  // Throws Error (argument) if the operators need more memory than the option memory.limit allows.
  void require_memory(const scene::Options& options) const;

  // Mesh of the region without its cracks; null if the region has none.
  const BoundaryMesh* uncracked() const { return uncracked_ ? &uncracked_->mesh : nullptr; }
  std::size_t count() const { return subdivision_.subdomains.size(); }
  const std::vector<Point>& cut_nodes() const { return subdivision_.cut_nodes; }

  // Meshes the cracks in subdomains. Nodes and elements that cracks add to the mesh of a subdomain are added to the
  // region's mesh `body`, too.
  std::vector<CrackedPart> mesh_cracks(const RegionCracks& cracks, BoundaryMesh& body);
  const BoundaryMesh& mesh_of(std::size_t subdomain) const { return subdivision_.subdomains[subdomain].mesh; }

  // Builds the operators of subdomains without cracks; set_operator() sets the operators of the others. Subdomains
  // whose meshes differ by a translation share one operator, also with subdomains in `before`, which have the same
  // material.
  void build(const PlaneElasticity& elasticity, const bem::AssemblyOptions& assembly,
             const std::vector<const RegionSubdomains*>& before);
  void set_operator(std::size_t subdomain, std::shared_ptr<const bem::BoundaryOperator> its) {
    operators_[subdomain] = std::move(its);
  }

  // Nodes of each operator. `nodes` are the region's nodes by their numbers in the scene. The matrix `trace` gives the
  // displacements of all places of the region from those of these nodes. `rest` has the nodes' rest displacements, or
  // is empty.
  std::vector<OperatorNodes> nodes_of_operators(const std::vector<int>& nodes, const TraceRows& trace,
                                                const coupling::Affine& rest) const;
  // Dense operators of all subdomains; the arguments are those of nodes_of_operators().
  std::vector<coupling::DenseOperator> dense_operators(const std::vector<int>& nodes, const TraceRows& trace,
                                                       const coupling::Affine& rest) const;

  // Matrix that gives the displacements of a subdomain's nodes from those of the nodes of its operator.
  Eigen::SparseMatrix<double> trace_of_subdomain(std::size_t subdomain, const TraceRows& trace) const;

  // Tractions at the traction nodes of the region's mesh, as means over the subdomains that meet at a node. `states`
  // are the states of the parts with cracks, `cracked`.
  Eigen::VectorXd tractions(const Eigen::VectorXd& displacement, const std::vector<CrackedPart>& cracked,
                            const std::vector<bem::CrackedState>& states) const;
  // Nodal forces of a displacement minus the nodal forces of a stress field.
  Eigen::VectorXd forces_less_stress(const Eigen::VectorXd& displacement,
                                     const std::function<Eigen::Vector3d(const Point&)>& stress,
                                     double thickness) const;
  // Adds the evaluators of subdomains without cracks to `all`.
  void add_interiors(const PlaneElasticity& elasticity, const Eigen::VectorXd& displacement,
                     InteriorOfPieces& all) const;
  // Stress (xx, yy, xy) at the three nodes of each element of the region's mesh.
  std::vector<double> element_stress(const PlaneElasticity& elasticity, const Eigen::VectorXd& displacement,
                                     const std::vector<CrackedPart>& cracked,
                                     const std::vector<bem::CrackedState>& states) const;
  void add_statistics(RegionStatistics& statistics) const;

 private:
  // Mesh of the region without its cracks, and the cuts that were chosen for that mesh.
  struct Uncracked {
    BoundaryMesh mesh;
    std::size_t most_elements;
    std::vector<Stations> cuts;
  };

  void number(const BoundaryMesh& body);
  bool has_cracks(std::size_t subdomain) const { return !subdivision_.subdomains[subdomain].cracks.empty(); }
  Eigen::VectorXd values_of(const Subdomain& part, const Eigen::VectorXd& all) const;
  // Calls visit(subdomain, number of an element in the subdomain, its number in the region's mesh) for all elements on
  // the outline.
  void for_each_outline_element(const std::function<void(std::size_t, int, int)>& visit) const;

  Subdivision subdivision_;
  std::vector<std::array<int, 3>> traction_nodes_;  // traction nodes of each element of the region's mesh
  int traction_node_count_ = 0;
  std::shared_ptr<const Uncracked> uncracked_;  // null if the region has no cracks
  std::vector<std::shared_ptr<const bem::BoundaryOperator>> operators_;
};

}  // namespace bempd::regions

#pragma once

#include <memory>
#include <vector>

#include "bem/boundary_operator.hpp"
#include "coupling/solution_method.hpp"
#include "geometry/boundary_mesh.hpp"
#include "regions/boundary/boundary_meshing.hpp"

namespace bempd::regions {

// Elements of a region: their mesh, the sources of the mesh's panels, and the material.
struct ElementsOfRegion {
  int region;  // id
  const BoundaryMesh& mesh;
  const std::vector<PanelSource>& panels;
  const PlaneElasticity& elasticity;
};

// Method of boundary elements: the properties in which schemes differ in boundary element regions.
class BoundaryMethod {
 public:
  virtual ~BoundaryMethod() = default;

  // Whether the method puts elements on cracks.
  virtual bool has_crack_elements() const = 0;
  // Whether the method may cut large regions into subdomains.
  virtual bool cuts_large_regions() const = 0;
  virtual MeshingRules meshing_rules(const scene::Options& options) const = 0;
  virtual BoundaryMesh make_mesh(const std::vector<std::vector<Panel>>& loops) const = 0;
  // Method that solves the linear systems that contain the stiffness of a region.
  virtual const coupling::SolutionMethod& solution_method() const = 0;
  // Builds the operator of a region without cracks. Throws Error (argument) for a material that the method cannot
  // treat.
  virtual std::shared_ptr<const bem::BoundaryOperator> make_operator(const ElementsOfRegion& elements,
                                                                     const bem::AssemblyOptions& assembly) const = 0;
  // Stiffness of a region, if it depends on the neighbours of the region's edges; empty to use the stiffness of
  // `whole`.
  virtual Eigen::MatrixXd own_stiffness(const scene::Scene& /*scene*/, const ElementsOfRegion& /*elements*/,
                                        const bem::BoundaryOperator& /*whole*/) const {
    return {};
  }
};

// Method of the symmetric scheme: symmetric Galerkin boundary elements.
class GalerkinMethod final : public BoundaryMethod {
 public:
  bool has_crack_elements() const override { return true; }
  bool cuts_large_regions() const override { return true; }
  MeshingRules meshing_rules(const scene::Options& options) const override;
  BoundaryMesh make_mesh(const std::vector<std::vector<Panel>>& loops) const override { return mesh_boundary(loops); }
  const coupling::SolutionMethod& solution_method() const override { return coupling::symmetric_solution(); }
  std::shared_ptr<const bem::BoundaryOperator> make_operator(const ElementsOfRegion& elements,
                                                             const bem::AssemblyOptions& assembly) const override;
};

}  // namespace bempd::regions

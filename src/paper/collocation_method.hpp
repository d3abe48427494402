#pragma once

#include "paper/unsymmetric_solution.hpp"
#include "regions/boundary/boundary_method.hpp"

namespace bempd::paper {

struct CollocationRules {
  // Whether the equation of an interface node is t = -b dx, with the traction t of the node, the body force b of its
  // material point and the lattice spacing dx (Yang and Liu 2021, Eqs. 26, 27); else it is the balance of nodal forces.
  bool pointwise_traction = false;
  bool one_traction_at_corners = false;  // false: one traction for each edge
};

// Boundary elements of the scheme `paper` (that of Yang and Liu 2021): collocation, with a material point at every node
// on an interface.
class CollocationMethod final : public regions::BoundaryMethod {
 public:
  explicit CollocationMethod(const CollocationRules& rules) : rules_(rules) {}

  bool has_crack_elements() const override { return false; }
  bool cuts_large_regions() const override { return false; }
  regions::MeshingRules meshing_rules(const scene::Options&) const override { return {true, false}; }
  BoundaryMesh make_mesh(const std::vector<std::vector<Panel>>& loops) const override;
  const coupling::SolutionMethod& solution_method() const override { return unsymmetric_solution(); }
  std::shared_ptr<const bem::BoundaryOperator> make_operator(const regions::ElementsOfRegion& elements,
                                                             const bem::AssemblyOptions& assembly) const override;
  Eigen::MatrixXd own_stiffness(const scene::Scene& scene, const regions::ElementsOfRegion& elements,
                                const bem::BoundaryOperator& whole) const override;

 private:
  CollocationRules rules_;
};

}  // namespace bempd::paper

#pragma once

#include "paper/collocation_operator.hpp"
#include "paper/unsymmetric_solution.hpp"
#include "regions/boundary/boundary_region.hpp"

namespace bempd::paper {

struct CollocationRules {
  // Whether an interface row is t = -b dx for a node and its material point (Yang and Liu 2021, Eqs. 26, 27); else it
  // is the balance of nodal forces.
  bool pointwise_traction = false;
  bool one_traction_at_corners = false;  // false: one traction for each edge
};

// Boundary element region of the scheme `paper`: it uses collocation, and every node on an interface is a material
// point.
class CollocationRegion final : public regions::BoundaryRegion {
 public:
  CollocationRegion(int id, const regions::BoundaryDescription& described, const scene::Material& material,
                    const CollocationRules& rules)
      : BoundaryRegion(id, described, material), rules_(rules) {}

  bool has_crack_elements() const override { return false; }

 protected:
  regions::MeshingRules meshing_rules(const regions::Preparation&) const override { return {true, false}; }
  bool can_be_cut() const override { return false; }
  BoundaryMesh make_mesh(const std::vector<std::vector<Panel>>& loops) const override;
  std::shared_ptr<const bem::BoundaryOperator> make_operator(const regions::Preparation& preparation,
                                                             const bem::AssemblyOptions& assembly) const override;
  const coupling::SolutionMethod& solution_method() const override { return unsymmetric_solution(); }
  Eigen::MatrixXd own_stiffness(const regions::Preparation& preparation) const override;

 private:
  Eigen::MatrixXd balanced_stiffness(const CollocationOperator& collocation) const;
  Eigen::MatrixXd pointwise_stiffness(const scene::Scene& scene, const CollocationOperator& collocation) const;

  CollocationRules rules_;
};

}  // namespace bempd::paper

#pragma once

#include "coupling/unsymmetric_solution.hpp"
#include "regions/boundary/boundary_region.hpp"

namespace bempd::bem {
class CollocationOperator;
}

namespace bempd::regions {

struct CollocationRules {
  // Interface rows are t = -b dx of every node and its point (Yang and Liu 2021, Eqs. 26, 27); else the balance of
  // nodal forces.
  bool pointwise_traction = false;
  CornerTractions corner_tractions = CornerTractions::two;
};

// A boundary element region of the scheme `paper`: collocation, every node on an interface a material point.
class CollocationRegion final : public BoundaryRegion {
 public:
  CollocationRegion(int id, const BoundaryDescription& described, const scene::Material& material,
                    const CollocationRules& rules)
      : BoundaryRegion(id, described, material), rules_(rules) {}

 protected:
  MeshingRules meshing_rules(const Preparation&) const override { return {true, false}; }
  CornerTractions corner_tractions() const override { return rules_.corner_tractions; }
  const coupling::SolutionMethod& solution_method() const override { return coupling::unsymmetric_solution(); }
  std::shared_ptr<const bem::BoundaryOperator> make_operator(const bem::AssemblyOptions& assembly) const override;
  Eigen::MatrixXd own_stiffness(const Preparation& preparation) const override;

 private:
  Eigen::MatrixXd balanced_stiffness(const bem::CollocationOperator& collocation) const;
  Eigen::MatrixXd pointwise_stiffness(const scene::Scene& scene, const bem::CollocationOperator& collocation) const;

  CollocationRules rules_;
};

}  // namespace bempd::regions

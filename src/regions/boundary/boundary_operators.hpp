#pragma once

#include <memory>
#include <vector>

#include "regions/boundary/boundary_parts.hpp"
#include "regions/boundary/boundary_swelling.hpp"

namespace bempd::regions {

// Operators of a boundary element region, as stiffness matrices on its nodes: one operator of the whole region, or one
// of each subdomain. Regions of equal mesh and material share operators. Operators that the growth of cracks does not
// change are kept.
class BoundaryOperators final : public RegionOperators {
 public:
  BoundaryOperators(const Region& region, const BoundaryMethod& method, const NumberedMesh& mesh, BoundaryParts& parts,
                    const BoundarySwelling& swelling)
      : region_(region), method_(method), mesh_(mesh), parts_(parts), swelling_(swelling) {}

  void build(const Preparation& preparation);
  // Parts that the region had before its cracks grew; null if there is no discretization from before.
  const BoundaryParts* parts_before_growth(const Preparation& preparation) const;

  // Operator of the whole region; null if the region is cut into subdomains, which have operators of their own.
  const bem::BoundaryOperator* whole() const { return whole_.get(); }
  // Stiffness of the whole region on the nodes of its mesh.
  const Eigen::MatrixXd& mesh_stiffness() const { return stiffness_.size() > 0 ? stiffness_ : whole_->stiffness(); }
  void add_statistics(RegionStatistics& statistics) const;

  std::vector<coupling::DenseOperator> dense_operators(std::span<const KnownOperator> before) const override;
  std::size_t count() const override { return parts_.subdomains() ? parts_.subdomains()->count() : 1; }
  std::vector<OperatorNodes> nodes_of_operators() const override;
  std::optional<Eigen::VectorXd> outflow(Eigen::Index dof_count) const override;
  double memory_of_preparing(double times) const override;

 private:
  std::vector<const BoundaryOperators*> alike_before(const Preparation& preparation) const;
  bool has_operator_of(const BoundaryOperators& other) const;
  std::shared_ptr<const Eigen::MatrixXd> stiffness_of_nodes() const;

  const Region& region_;
  const BoundaryMethod& method_;
  const NumberedMesh& mesh_;
  BoundaryParts& parts_;
  const BoundarySwelling& swelling_;
  std::shared_ptr<const bem::BoundaryOperator> whole_;  // shared by regions that are alike
  Eigen::MatrixXd stiffness_;                           // on the mesh's nodes; empty if it is that of the operator
};

}  // namespace bempd::regions

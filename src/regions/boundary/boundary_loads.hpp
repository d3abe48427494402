#pragma once

#include "regions/boundary/particular_solutions.hpp"

namespace bempd::regions {

// Nodes of a boundary element region at which supports and loads act, and nodal forces of tractions and body forces.
class BoundaryLoads final : public RegionLoads {
 public:
  BoundaryLoads(const Region& region, const NumberedMesh& mesh, const BoundaryParts& parts,
                const ParticularSolutions& particulars)
      : region_(region), mesh_(mesh), parts_(parts), particulars_(particulars) {}

  std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const override;
  void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                    Eigen::Ref<Eigen::VectorXd> force) const override;
  std::vector<Point> forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                    const FieldsOfRegion& fields) const override;
  void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const override;
  Eigen::Matrix2d work_within(const std::array<BodyForce, 2>& body_force,
                              const std::vector<CrackLoad>& crack_loads) const override;

 private:
  const Region& region_;
  const NumberedMesh& mesh_;
  const BoundaryParts& parts_;
  const ParticularSolutions& particulars_;
};

}  // namespace bempd::regions

#pragma once

#include <array>

#include "regions/boundary/boundary_operators.hpp"

namespace bempd::regions {

// Particular solutions of body forces in a boundary element region: displacement fields that are in equilibrium with a
// body force, whatever the conditions on the boundary.
class ParticularSolutions {
 public:
  ParticularSolutions(const Region& region, const NumberedMesh& mesh, const BoundaryParts& parts,
                      const BoundaryOperators& operators)
      : region_(region), mesh_(mesh), parts_(parts), operators_(operators) {}

  LinearBodyForce of(const BodyForce& body_force) const;
  // Particular solution of the body force that the region has in a solution.
  LinearBodyForce of(const Solution& solution) const { return of(solution.body_force(region_.id())); }
  // Displacements u_p of a particular solution at NumberedMesh::places().
  Eigen::VectorXd displacement(const LinearBodyForce& particular) const;
  // Change of nodal forces by a particular solution u_p: K u_p - f_p, with the stiffness K of the boundary and the
  // nodal forces f_p of the tractions of u_p.
  Eigen::VectorXd force_change(const LinearBodyForce& particular) const;
  // Particular solutions at the nodes and on the crack faces of a part.
  CrackedPart::Particulars in_part(const std::array<BodyForce, 2>& body_force, const CrackedPart& part) const;
  // Part of a body force's work [J] that nodal forces do not include. `other` is the body force of the state on whose
  // displacements the work is done.
  double work(const BodyForce& body_force, const BodyForce& other) const;

 private:
  const Region& region_;
  const NumberedMesh& mesh_;
  const BoundaryParts& parts_;
  const BoundaryOperators& operators_;
};

}  // namespace bempd::regions

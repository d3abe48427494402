#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <vector>

#include "bem/crack_tips.hpp"
#include "bem/cracked_operator.hpp"
#include "bem/normal_openings.hpp"
#include "coupling/operators.hpp"
#include "elasticity/linear_body_force.hpp"
#include "regions/boundary/meshed_cracks.hpp"

namespace bempd::regions {

// Traction of a particular solution on a plane with this normal.
Point traction_of(const LinearBodyForce& particular, const Point& x, const Point& normal);

// Part of a boundary element region with cracks that has an operator of its own: the whole region, or a subdomain.
struct CrackedPart {
  std::unique_ptr<const MeshedCracks> cracks;
  std::size_t subdomain = 0;
  std::vector<int> nodes;  // of each of its nodes: the number among the region's places; empty for the whole region
  std::shared_ptr<const bem::CrackedOperator> body;
  std::shared_ptr<const bem::NormalOpenings> closing;  // null unless cracks close

  // Builds the operator, and what closes the faces if `faces_close`. What it has in common with `before` (null: none),
  // the part with shorter cracks, is taken from there.
  void build(const BoundaryMesh& mesh, const PlaneElasticity& elasticity, const bem::AssemblyOptions& assembly,
             bool faces_close, const CrackedPart* before);
  // Whether a crack has elements in both parts.
  bool shares_crack_with(const CrackedPart& other) const;

  const bem::CrackMesh& elements() const { return cracks->elements(); }
  Eigen::Index openings() const { return 2 * static_cast<Eigen::Index>(elements().nodes.size()); }
  std::size_t constraints() const { return closing ? closing->size() : 0; }
  // Values at the part's nodes (rows), taken from those at all places of the region.
  Eigen::MatrixXd own(const Eigen::MatrixXd& all) const;
  // Adds values at the part's nodes to those at all places of the region.
  void add(const Eigen::VectorXd& own, Eigen::VectorXd& all) const;

  // Pieces into which cracks cut the part; none if they do not. `node_at` gives the scene's node at a place of the
  // region, -1 where nodes follow others.
  std::vector<coupling::BodyPiece> pieces(const std::function<int(int)>& node_at) const;
  // Nodal forces on the openings of cracks: those of a traction on their faces (empty: 0), of a particular solution's
  // tractions, and of loads, constant part (column 0) and proportional part (column 1).
  Eigen::VectorXd forces_of(const bem::FaceTraction& traction) const;
  Eigen::VectorXd forces_of(const LinearBodyForce& particular) const;
  Eigen::MatrixX2d forces_of(const std::vector<CrackLoad>& loads) const;
  // Nodal forces on the boundary that a traction on crack faces causes.
  Eigen::VectorXd on_boundary(const bem::FaceTraction& traction) const;
  // Gaps between faces that close, for displacements of the part's nodes and forces on openings.
  coupling::Affine gaps(const Eigen::MatrixX2d& displacements, const Eigen::MatrixX2d& forces) const;
  // Constraints of crack faces that close, by displacements of the nodes that `trace` refers to; null without them.
  std::shared_ptr<const coupling::ExactConstraints> constraints_for(const Eigen::SparseMatrix<double>& trace) const;
  // Openings and tractions for displacements at all places, a traction on the faces, and faces that are closed.
  bem::CrackedState state(const Eigen::VectorXd& displacements, bem::FaceTraction traction,
                          const std::vector<char>& closed) const;

  // Particular solutions of body forces, of the constant and of the proportional part: displacements of the part's
  // nodes, and the forces of their tractions on crack faces.
  struct Particulars {
    Eigen::MatrixX2d displacements, face_forces;
  };
  // Work of loads inside the body that nodal forces do not include. The stiffness K couples the boundary's
  // displacements u and the openings  w = K_ww^-1 (f - K_wu u)  due to forces f on crack faces. These do the work f.w,
  // of which the nodal forces contain the part that depends on u. A body force has a particular solution u_p with
  // forces f_p on the faces; u and f are then without these. By Betti's theorem a force f does the additional work
  // -v.f, with v = K_ww^-1 (f_p - K_wu u_p).
  Eigen::Matrix2d work_of(const Eigen::MatrixX2d& forces, const Particulars& particular) const;
};

}  // namespace bempd::regions

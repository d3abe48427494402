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

// Traction of a particular solution at a place x on a plane with this normal.
Point traction_of(const LinearBodyForce& particular, const Point& x, const Point& normal);

// Part with cracks of a boundary element region, which has an operator of its own: a subdomain, or the whole region.
struct CrackedPart {
  std::unique_ptr<const MeshedCracks> cracks;
  std::size_t subdomain = 0;
  std::vector<int> nodes;  // numbers of its nodes among the region's places; empty for the whole region
  std::shared_ptr<const bem::CrackedOperator> body;
  std::shared_ptr<const bem::NormalOpenings> closing;  // null if crack faces cannot close

  // Builds the operator and, if `faces_close`, the contact constraints of crack faces. `before` is the part before its
  // cracks grew (null: none), from which the unchanged matrices are taken.
  void build(const BoundaryMesh& mesh, const PlaneElasticity& elasticity, const bem::AssemblyOptions& assembly,
             bool faces_close, const CrackedPart* before);
  // Whether some crack has elements in this part and in `other`.
  bool shares_crack_with(const CrackedPart& other) const;

  const bem::CrackMesh& elements() const { return cracks->elements(); }
  Eigen::Index openings() const { return 2 * static_cast<Eigen::Index>(elements().nodes.size()); }
  std::size_t constraints() const { return closing ? closing->size() : 0; }
  // Values at the part's nodes (rows), taken from those at all places of the region.
  Eigen::MatrixXd own(const Eigen::MatrixXd& all) const;
  // Adds values at the part's nodes to those at all places of the region.
  void add(const Eigen::VectorXd& own, Eigen::VectorXd& all) const;

  // Pieces into which cracks cut the part; none if the part stays in one piece. `node_at` gives the scene's node at a
  // place of the region, or -1 if the displacement there follows from other nodes.
  std::vector<coupling::BodyPiece> pieces(const std::function<int(int)>& node_at) const;
  // Nodal forces, on the openings of cracks, of a traction on crack faces; zeros if the traction is empty.
  Eigen::VectorXd forces_of(const bem::FaceTraction& traction) const;
  // Nodal forces, on the openings of cracks, of the tractions of a particular solution.
  Eigen::VectorXd forces_of(const LinearBodyForce& particular) const;
  // Nodal forces, on the openings of cracks, of loads: constant part (column 0) and proportional part (column 1).
  Eigen::MatrixX2d forces_of(const std::vector<CrackLoad>& loads) const;
  // Nodal forces on the boundary that a traction on crack faces causes.
  Eigen::VectorXd on_boundary(const bem::FaceTraction& traction) const;
  // Gaps at the contact constraints of crack faces, for displacements of the part's nodes and forces on the openings
  // (columns: constant and proportional part) [m].
  coupling::Affine gaps(const Eigen::MatrixX2d& displacements, const Eigen::MatrixX2d& forces) const;
  // Contact constraints of crack faces, in terms of the displacements of nodes; null if crack faces cannot close. The
  // matrix `trace` gives the displacements of the part's nodes from those of these nodes.
  std::shared_ptr<const coupling::ExactConstraints> constraints_for(const Eigen::SparseMatrix<double>& trace) const;
  // State (openings and tractions) of the part for displacements at all places of the region, a traction on crack
  // faces, and flags of the contact constraints that are closed.
  bem::CrackedState state(const Eigen::VectorXd& displacements, bem::FaceTraction traction,
                          const std::vector<char>& closed) const;

  // Particular solutions of the constant and of the proportional part of a body force (columns): displacements of the
  // part's nodes, and nodal forces of the solutions' tractions on crack faces.
  struct Particulars {
    Eigen::MatrixX2d displacements, face_forces;
  };
  // Work of loads inside the body that nodal forces do not include. The boundary's displacements u and forces f on the
  // crack faces cause the openings
  //   w = K_ww^-1 (f - K_wu u),
  // where the blocks K_ww and K_wu of the stiffness act on openings and on displacements. The forces f do the work f.w
  // on the openings. The nodal forces account for the part of this work that depends on u, so that f.K_ww^-1 f is left.
  // If there is a body force, its particular solution u_p, with the forces f_p on the faces, is subtracted from u and f
  // first. By Betti's theorem the work then has in addition the terms
  //   v.f_p - f.v - v.f,  v = K_ww^-1 (f_p - K_wu u_p).
  Eigen::Matrix2d work_of(const Eigen::MatrixX2d& forces, const Particulars& particular) const;
};

}  // namespace bempd::regions

#pragma once

#include <Eigen/Core>
#include <vector>

#include "bem/cracked_operator.hpp"

namespace bempd::bem {

// Gaps (normal openings) between crack faces at the nodes of crack elements; frictionless contact keeps them from
// becoming negative. With the displacements u of the boundary, the openings w, the stiffness K, forces f on openings,
// and one contact force q per gap,
//   gaps = G u + S q + gaps of f,   G = C_u - C_w K_ww^-1 K_wu,   S = C_w K_ww^-1 C_w^T,
// where C gives the gaps from the unknowns (u, w) of the operator. A gap at a crack mouth depends on displacements
// alone.
class NormalOpenings {
 public:
  explicit NormalOpenings(const CrackedOperator& body);

  std::size_t size() const { return places_.size(); }
  std::vector<Point> places(const CrackedOperator& body) const;                  // `body`: as in the constructor
  const Eigen::MatrixXd& of_displacements() const { return of_displacements_; }  // G
  const Eigen::MatrixXd& of_forces() const { return of_forces_; }                // S

  // Gaps at all places [m] from all openings; 0 at places where the crack cuts the body.
  Eigen::VectorXd gaps(const Eigen::VectorXd& openings) const;

  // Openings after contact forces have closed the gaps at the `closed` places; the given `openings` are those without
  // contact forces.
  Eigen::VectorXd held_shut(const Eigen::VectorXd& openings, const std::vector<char>& closed) const;

  // Flags of the opening nodes: 1 if a place at the node is closed.
  std::vector<char> closed_nodes(const std::vector<char>& closed) const;

 private:
  struct Place {
    int node;                   // opening node; -1 where the crack cuts the body and faces are parts of the boundary
    Point normal;               // unit normal to the left of the crack
    int left = -1, right = -1;  // boundary nodes of the two faces if `node` is -1
    bool at_joint = false;
  };

  void add_places(const CrackMesh& cracks);
  void add_places_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks);
  // Weights of the operator's unknowns in the gap at a place.
  Eigen::VectorXd gap_function(const CrackMesh& cracks, const Place& place) const;
  // Removes duplicates of gaps: two lines that meet at a joint in the same direction have one gap there.
  void drop_doubles(const CrackMesh& cracks);
  Eigen::MatrixXd normals() const;  // one column per place over all openings; zero where the crack cuts the body

  std::vector<Place> places_;
  Eigen::Index components_;   // number of components of all openings
  Eigen::MatrixXd response_;  // openings per contact force, with displacements held
  Eigen::MatrixXd of_displacements_, of_forces_;
};

}  // namespace bempd::bem

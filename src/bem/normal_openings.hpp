#pragma once

#include <Eigen/Core>
#include <vector>

#include "bem/cracked_operator.hpp"

namespace bempd::bem {

// How far the faces of cracks are open, at the nodes of their elements: what may not become negative where faces press
// on each other without friction. With displacements u of the boundary, forces f on openings and forces q that press
// at these places, of which each opens its own,
//   gaps = G u + S q + gaps of f,   G = C_u - C_w K_ww^-1 K_wu,   S = C_w K_ww^-1 C_w^T,
// C giving gaps from the unknowns (u, w) of the operator. A gap at a mouth is one of displacements alone.
class NormalOpenings {
 public:
  explicit NormalOpenings(const CrackedOperator& body);

  std::size_t size() const { return places_.size(); }
  const Eigen::MatrixXd& of_displacements() const { return of_displacements_; }  // G
  const Eigen::MatrixXd& of_forces() const { return of_forces_; }                // S

  // All openings [m]; 0 where the crack cuts the body.
  Eigen::VectorXd gaps(const Eigen::VectorXd& openings) const;

  // Openings where these places are held shut, from those where nothing presses.
  Eigen::VectorXd held_shut(const Eigen::VectorXd& openings, const std::vector<char>& closed) const;

  // Nodes of openings at which one of the places is closed.
  std::vector<char> closed_nodes(const std::vector<char>& closed) const;

 private:
  struct Place {
    int node;      // of openings, or -1 where the crack cuts the body: there faces are a part of the boundary
    Point normal;  // to the left of the crack
    int left = -1, right = -1;  // then the boundary's nodes
    bool at_joint = false;
  };

  void add_places(const CrackMesh& cracks);
  void add_places_on_cuts(const BoundaryMesh& mesh, const CrackMesh& cracks);
  // The gap of a place as a function of the operator's unknowns.
  Eigen::VectorXd gap_function(const CrackMesh& cracks, const Place& place) const;
  // Two lines that meet at a joint in one direction have one gap there.
  void drop_doubles(const CrackMesh& cracks);
  Eigen::MatrixXd normals() const;  // of all openings, one column a place; none where the crack cuts the body

  std::vector<Place> places_;
  Eigen::Index components_;   // of all openings
  Eigen::MatrixXd response_;  // all openings from forces at the places, displacements held
  Eigen::MatrixXd of_displacements_, of_forces_;
};

}  // namespace bempd::bem

#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "coupling/rigid_motion.hpp"
#include "fracture/connectivity.hpp"
#include "geometry/point.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::fracture {

// Parts that broken terms (bonds and cell squares) have freed: the springs that hold the parts, and the nodes whose
// loads have to be removed, so that the equilibrium stays unique.
struct FreedParts {
  std::vector<coupling::HoldingSpring> springs;
  std::vector<int> nodes_with_lost_loads;  // nodes of free parts that their loads push, so that these are removed
  std::int64_t fragments = 0;              // pieces that have come free of all supports
};

// Whether `forces` push a piece that can move: they do work on a free motion of the piece, which has the nodes `nodes`,
// so that there is no equilibrium.
bool is_pushed(const coupling::RigidMotion& motion, const std::vector<Point>& positions, const std::vector<int>& nodes,
               const coupling::Affine& forces);

// Finds parts of a body that can move freely: pieces cut off from supports, and points whose remaining terms (bonds and
// cell squares) act along one line. Such parts are held at their place by springs that carry no force.
class FreedPartFinder {
 public:
  FreedPartFinder(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions);

  // Free parts of the whole body under its present loads. Parts that springs hold already get no more springs, but lose
  // loads that push them. New springs hold a part where it is in `displacement`.
  FreedParts all_pieces(const Eigen::VectorXd& displacement) const;

  // Parts that the terms `removed` have freed, which are broken in the system.
  FreedParts after_break(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const;

  // Whether after_break() would find no freed part; in most cases this is known without a search of the whole body.
  bool frees_nothing(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const;

  // Parts that springs hold. `nodes` has flags of the nodes of pieces that have springs but no support, and of points
  // whose terms act along one line. `springs_in_supported_pieces` are the other springs: they hold motions within
  // pieces that have supports as well.
  struct PartsOnSprings {
    std::vector<char> nodes;
    std::vector<coupling::HoldingSpring> springs_in_supported_pieces;
  };
  PartsOnSprings held_parts() const;

  // Spring against a motion that met no resistance. It acts on the largest component of `motion`, and holds this
  // component at its value in `displacement`.
  coupling::HoldingSpring spring_against(const Eigen::VectorXd& motion, const Eigen::VectorXd& displacement) const;

 private:
  // Stiffness of a point against displacement, by its terms and supports. A point is loose if its stiffness in the
  // weakest direction is almost zero.
  struct Resistance {
    linalg::SymmetricModes modes;
    bool has_terms;
    bool is_loose() const;
  };
  Resistance resistance_of(int node) const;
  void hold_loose_point(int node, const Eigen::VectorXd& displacement, FreedParts& found) const;
  void hold_piece(const std::vector<int>& nodes, const Eigen::VectorXd& displacement, FreedParts& found) const;
  coupling::HoldingSpring spring(int node, double cosine, double sine, const Eigen::VectorXd& displacement) const;

  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  Connectivity connectivity_;
  double spring_stiffness_;
};

}  // namespace bempd::fracture

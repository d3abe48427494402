#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "coupling/rigid_motion.hpp"
#include "fracture/connectivity.hpp"
#include "geometry/point.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::fracture {

// Parts that broken terms have freed: the springs that hold them and the loads that are removed, so that the
// equilibrium stays unique.
struct FreedParts {
  std::vector<coupling::HoldingSpring> springs;
  std::vector<int> nodes_with_lost_loads;  // their loads push a free part for which there is no equilibrium
  std::int64_t fragments = 0;              // pieces that have come free of all supports
};

// Whether forces on all nodes have no equilibrium on a piece that can move: they do work on a free motion of it.
bool is_pushed(const coupling::RigidMotion& motion, const std::vector<Point>& positions, const std::vector<int>& nodes,
               const coupling::Affine& forces);

// Finds parts that can move freely: pieces cut off from supports, and points whose remaining terms act along one line.
// They are held at their place by springs that carry no force.
class FreedPartFinder {
 public:
  FreedPartFinder(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions);

  // All free parts of the body under its present loads, including those that springs hold already; `displacement` is
  // where new springs hold them.
  FreedParts all_pieces(const Eigen::VectorXd& displacement) const;

  // Parts that the terms `removed`, broken in the system, have freed.
  FreedParts after_break(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const;

  // Whether after_break() would find nothing; in most cases without a search of the whole body.
  bool frees_nothing(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const;

  // Parts held by springs: nodes of pieces that springs but no support hold, and of held points whose terms act along
  // one line. `springs_in_supported_pieces` are springs that hold only part of a piece.
  struct PartsOnSprings {
    std::vector<char> nodes;
    std::vector<coupling::HoldingSpring> springs_in_supported_pieces;
  };
  PartsOnSprings held_parts() const;

  // Spring that holds the largest component of a motion that met no resistance, where it is in `displacement`.
  coupling::HoldingSpring spring_against(const Eigen::VectorXd& motion, const Eigen::VectorXd& displacement) const;

 private:
  // Resistance of a point by its terms and supports; in a loose point the weakest direction has almost none.
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

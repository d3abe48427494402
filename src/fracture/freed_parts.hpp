#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "coupling/rigid_motion.hpp"
#include "fracture/connectivity.hpp"
#include "geometry/point.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::fracture {

// What has to be held so that equilibrium stays unique after terms have broken.
struct FreedParts {
  std::vector<coupling::HoldingSpring> springs;
  std::vector<int> nodes_with_lost_loads;  // their loads push a free part for which there is no equilibrium
  std::int64_t fragments = 0;              // pieces that have come free of all supports
};

// Whether forces on all nodes have no equilibrium on a piece that can move.
bool is_pushed(const coupling::RigidMotion& motion, const std::vector<Point>& positions, const std::vector<int>& nodes,
               const coupling::Affine& forces);

// Finds parts that can move freely: pieces cut off from supports, and points whose remaining terms pull on one line.
// They are held where they are by springs that carry no force.
class FreedPartFinder {
 public:
  FreedPartFinder(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions);

  // All parts of the scene as it is under its present loads, also those that springs hold already; `displacement`
  // anchors new springs.
  FreedParts all_pieces(const Eigen::VectorXd& displacement) const;

  // Parts that these terms free, which are broken in the system.
  FreedParts after_break(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const;

  // True if after_break() would find nothing; mostly without a look at the whole body.
  bool frees_nothing(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const;

  // Nodes of pieces that springs hold and no support does, and held points whose terms pull on one line; and springs
  // that hold a part of another piece.
  struct Held {
    std::vector<char> nodes;
    std::vector<coupling::HoldingSpring> others;
  };
  Held held_parts() const;

  // A spring against the largest component of a motion that met no resistance.
  coupling::HoldingSpring against(const Eigen::VectorXd& motion, const Eigen::VectorXd& displacement) const;

 private:
  // What terms and supports of a point resist with; its weakest direction has next to nothing in a loose point.
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

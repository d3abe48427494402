#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/solution_method.hpp"
#include "coupling/terms.hpp"
#include "geometry/point.hpp"

namespace bempd::coupling {

// Data that regions contribute to the equilibrium of all nodes, and holding springs. Degrees of freedom are numbered 2
// * node + component.

// Piece of a body that cracks have cut into several. `holdable` are two of its nodes that lie far apart, on which
// holding springs can act.
struct BodyPiece {
  std::vector<int> nodes;
  std::array<int, 2> holdable;
};

// Exact unilateral constraints inside a dense operator: gaps between crack faces at a number of places, none of which
// may be negative. With the displacements u of the operator's nodes (2 * node of its list + component, less the rest
// displacements) and the multipliers q, which are contact forces,
//   gaps = of_displacements u + of_forces q + gaps due to loads inside the body.
// A closed constraint has the gap zero and q >= 0, an open constraint has q = 0. The stiffness of the operator counts
// all constraints as open.
struct ExactConstraints {
  Eigen::MatrixXd of_displacements, of_forces;
  std::vector<Point> places;  // places of the gaps

  bool operator==(const ExactConstraints& other) const {
    const auto same = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
    };
    return places == other.places && same(of_forces, other.of_forces) && same(of_displacements, other.of_displacements);
  }
};

// Dense stiffness matrix [N/m] of some nodes, such as that of a boundary element region; positive semidefinite if
// symmetric.
struct DenseOperator {
  std::vector<int> nodes;
  std::shared_ptr<const Eigen::MatrixXd> stiffness;  // equal operators share one matrix
  const SolutionMethod* method = &symmetric_solution();
  // Rest displacement of the nodes (2 * node of the list + component): the displacement that needs no force, as in a
  // body that swells. The force is stiffness * (displacement - rest). Empty: 0.
  Affine rest = Affine(0, 2);
  std::shared_ptr<const ExactConstraints> constraints = nullptr;  // null: no cracks that can close
  std::vector<BodyPiece> pieces = {};                             // separate pieces of the body; empty: one piece
};

// Stress-free state of terms and operators: rest elongations of terms and rest displacements of operators, each with
// constant and proportional parts.
struct Rests {
  std::array<std::vector<double>, 2> of_terms;
  std::vector<Affine> of_operators;

  bool operator==(const Rests& other) const {
    const auto same = [](const Affine& a, const Affine& b) { return a.rows() == b.rows() && a == b; };
    return of_terms == other.of_terms && std::equal(of_operators.begin(), of_operators.end(),
                                                    other.of_operators.begin(), other.of_operators.end(), same);
  }
};

// Spring from the ground along a direction at a node. It holds a motion that nothing else resists, so that in
// equilibrium it carries no force. `anchor` is the displacement along the direction at which the spring was attached
// [m].
struct HoldingSpring {
  int node;
  double cosine, sine;
  double stiffness;  // [N/m]
  double anchor;
  bool operator==(const HoldingSpring&) const = default;
};

}  // namespace bempd::coupling

#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/condensed_operators.hpp"
#include "coupling/constraints.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "coupling/system_solver.hpp"
#include "coupling/terms.hpp"
#include "coupling/unknowns.hpp"
#include "geometry/point.hpp"

namespace bempd::coupling {

class SubstructureFactor;

// Sources of a system's matrix: operators, energy terms, closed constraints and holding springs, whose stiffnesses add
// up to the matrix.
struct MatrixSources {
  const CondensedOperators& operators;
  const Terms& terms;
  const NodeTies& ties;
  const Constraints& constraints;
  std::span<const HoldingSpring> springs;
  double largest_stiffness;
};

// Factors by nested substructures (SubstructureFactor) for systems of many operators and nothing else, such as large
// regions that are cut into subdomains. Each factor copies unchanged substructures from the previous factor, even if
// that factor belongs to a scene with shorter cracks.
class Substructures {
 public:
  void place(const std::vector<Point>& positions) { positions_ = positions; }  // positions of the nodes
  const std::vector<Point>& positions() const { return positions_; }
  void take_over(const Substructures& before) { last_ = before.last_; }
  // Makes solver_of() return null from this call on, for callers that need a Cholesky factor of the whole matrix.
  // Returns whether solver_of() has returned a solver since the last call of disable().
  bool disable();
  // Solver with a factor of the matrix. Null if the system is of another kind, if disable() was called, if another
  // solver was chosen, or if the matrix is not positive definite.
  std::unique_ptr<SystemSolver> solver_of(const MatrixSources& sources, const Unknowns& unknowns);

 private:
  bool suits(const MatrixSources& sources) const;

  std::vector<Point> positions_;
  std::shared_ptr<const SubstructureFactor> last_;
  bool has_served_ = false, is_disabled_ = false;
};

}  // namespace bempd::coupling

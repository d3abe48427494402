#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <vector>

#include "coupling/factor_origin.hpp"
#include "coupling/solution_method.hpp"
#include "coupling/solver_counters.hpp"
#include "coupling/unknowns.hpp"
#include "linalg/nested_dissection.hpp"

namespace bempd::coupling {

// State of the factor relative to the present matrix.
enum class FactorState : char {
  none,        // nothing
  factorized,  // the present matrix, as it was factorized
  updated,     // the present matrix, after low-rank changes
  stale        // factor of an earlier matrix, which only preconditions
};

// Factor of a system's sparse matrix, which follows it through low-rank changes, and solutions by it.
class SystemFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  SystemFactor(const SolutionMethod& method, const Unknowns& unknowns, SolverCounters& counters)
      : method_(method), unknowns_(unknowns), counters_(counters) {}

  // Sets the graph from which an order of elimination with less fill follows.
  void set_graph(linalg::NodeGraph graph) { graph_ = std::make_unique<linalg::NodeGraph>(std::move(graph)); }

  // Makes the next factorization eliminate the unknowns of these nodes last.
  void keep_last(std::vector<int> nodes);
  int kept() const { return kept_; }  // unknowns
  bool keeps(const std::vector<int>& nodes) const;
  const std::vector<int>& kept_nodes() const { return kept_nodes_; }

  FactorState state() const { return state_; }
  bool exists() const { return state_ != FactorState::none; }
  bool is_current() const { return state_ == FactorState::factorized || state_ == FactorState::updated; }
  void forget() {
    if (exists()) forgotten_ = state_;
    state_ = FactorState::none;
  }
  // Takes back the last forget() if no other factor has been made since and the factor had undergone just these
  // changes; the caller knows that the matrix is the same.
  bool recall(const std::vector<FactorChange>& changes);
  void lose() { forgotten_ = FactorState::none; }  // for good

  // Throws Error (unsolvable) if the matrix is singular.
  void factorize(const Matrix& matrix);

  // Changes an existing factor: the matrix changes by plus or minus columns * columns^T.
  void change(const Matrix& columns, linalg::Change change);
  // All changes since the factorization, up to the first one that the factor could not follow.
  const std::vector<FactorChange>& changes() const { return changes_; }
  void repeat(const FactorChange& change);

  // Solves once; asks for the present matrix if the present factor is not good enough. Throws Error (unsolvable).
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs, const SystemSolver::Apply& apply,
                        const std::function<const Matrix&()>& assemble);

  // Whether no pivot is so small that a motion may have lost its resistance. The factor must be current.
  bool pivots_are_sound() const;

  // Cholesky factor of a solver with a symmetric matrix, factorized.
  const linalg::SparseCholesky& cholesky() const { return *solver_->cholesky(); }

 private:
  void choose_order();

  const SolutionMethod& method_;
  const Unknowns& unknowns_;
  SolverCounters& counters_;
  std::unique_ptr<linalg::NodeGraph> graph_;
  std::vector<int> kept_nodes_;
  int kept_ = 0;
  std::unique_ptr<SystemSolver> solver_;
  FactorState state_ = FactorState::none, forgotten_ = FactorState::none;
  std::vector<int> kept_when_made_;
  std::vector<FactorChange> changes_;
  double largest_diagonal_ = 0;  // of the matrix last factorized
};

// Diagonal of the matrix, with a tiny value where it has none.
Eigen::VectorXd stiff_diagonal(const Eigen::SparseMatrix<double>& matrix);

// Solver of the matrix plus a small share of that diagonal, which does not depend on units or stiff neighbours. So a
// singular matrix can be factorized without hiding its null space behind motions that are merely soft, such as those of
// slender parts. Throws Error (unsolvable).
std::unique_ptr<SystemSolver> shifted_solver(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                                             const Eigen::VectorXd& diagonal);

// Vector that a matrix hardly resists, largest entry 1, by inverse iteration.
Eigen::VectorXd softest_vector(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                               double& resistance);

}  // namespace bempd::coupling

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

// What the factor of a sparse system is of.
enum class FactorState : char {
  none,        // nothing
  factorized,  // the present matrix, as it was factorized
  updated,     // the present matrix, after low-rank changes
  stale        // an earlier matrix: it only preconditions
};

// The factor of a system's sparse matrix, which follows it through low-rank changes, and solutions by it.
class SystemFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  SystemFactor(const SolutionMethod& method, const Unknowns& unknowns, SolverCounters& counters)
      : method_(method), unknowns_(unknowns), counters_(counters) {}

  // Gives the unknowns an order of elimination with less fill.
  void set_graph(linalg::NodeGraph graph) { graph_ = std::make_unique<linalg::NodeGraph>(std::move(graph)); }

  // The unknowns of these nodes are eliminated last, from the next factorization on.
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
  // Takes back the last forget() if no other factor has been made since, and this one had come about so; the caller
  // knows of which matrix.
  bool recall(const std::vector<FactorChange>& changes);
  void lose() { forgotten_ = FactorState::none; }  // for good

  // Throws Error (unsolvable) if the matrix is singular.
  void factorize(const Matrix& matrix);

  // Of a factor that exists: the matrix changes by plus or minus columns * columns^T.
  void change(const Matrix& columns, linalg::Change change);
  // All of them since it was factorized, up to the first that it could not follow.
  const std::vector<FactorChange>& changes() const { return changes_; }
  void repeat(const FactorChange& change);

  // One solution; asks for the present matrix if the factor at hand does not reach it. Throws Error (unsolvable).
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs, const SystemSolver::Apply& apply,
                        const std::function<const Matrix&()>& assemble);

  // False if some pivot is so small that a motion may have lost its resistance. The factor is current.
  bool pivots_are_sound() const;

  // Of a solver with a symmetric matrix, factorized.
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

// The diagonal, next to nothing where it has none.
Eigen::VectorXd stiff_diagonal(const Eigen::SparseMatrix<double>& matrix);

// Of the matrix and a small share of that diagonal, which neither units nor stiff neighbours spoil: a singular matrix
// can be factorized so, without hiding its null space behind motions that are merely soft, such as those of slender
// parts. Throws Error (unsolvable).
std::unique_ptr<SystemSolver> shifted_solver(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                                             const Eigen::VectorXd& diagonal);

// A vector that a matrix hardly resists, largest entry 1: inverse iteration.
Eigen::VectorXd softest_vector(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                               double& resistance);

}  // namespace bempd::coupling

#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <vector>

#include "coupling/factor_origin.hpp"
#include "coupling/solution_method.hpp"
#include "coupling/solver_counters.hpp"
#include "coupling/substructures.hpp"
#include "coupling/unknowns.hpp"
#include "linalg/nested_dissection.hpp"

namespace bempd::coupling {

// State of the factor relative to the present matrix.
enum class FactorState : char {
  none,        // no factor
  factorized,  // factor of the present matrix, as it was factorized
  updated,     // factor of the present matrix, after low-rank changes
  stale        // factor of an earlier matrix, good as a preconditioner only
};

// Factor of a system's sparse matrix with low-rank changes when the matrix changes, and solutions with this factor.
class SystemFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  SystemFactor(const SolutionMethod& method, const Unknowns& unknowns, SolverCounters& counters)
      : method_(method), unknowns_(unknowns), counters_(counters) {}

  // Sets the function that makes the graph of the nodes, from which an order of elimination with less fill follows. The
  // graph is made when an order is first chosen, because factors by substructures need none.
  void set_graph(std::function<linalg::NodeGraph()> make) {
    make_graph_ = std::move(make);
    graph_.reset();
  }

  // Makes the next factorization eliminate the unknowns of these nodes last.
  void keep_last(std::vector<int> nodes);
  int kept() const { return kept_; }  // number of unknowns that are eliminated last
  bool keeps(const std::vector<int>& nodes) const;
  const std::vector<int>& kept_nodes() const { return kept_nodes_; }

  bool exists() const { return state_ != FactorState::none; }
  bool is_current() const { return state_ == FactorState::factorized || state_ == FactorState::updated; }
  void forget() {
    if (exists()) forgotten_ = state_;
    state_ = FactorState::none;
    ++counters_.matrices;
  }
  // Undoes the last forget() and returns true, if no other factor has been made since and the forgotten factor had
  // undergone exactly the changes `changes`; else returns false. The caller must know that the matrix is the same.
  bool recall(const std::vector<FactorChange>& changes);
  void drop_forgotten() { forgotten_ = FactorState::none; }  // recall() fails then
  // Frees the factor and its solver; the next factorization makes a solver again.
  void release() {
    forget();
    drop_forgotten();
    solver_.reset();
    is_of_substructures_ = false;
  }

  // Factorizes the matrix. Throws Error (unsolvable) if it is singular.
  void factorize(const Matrix& matrix);

  // Factorizes a matrix by its substructures, without a Cholesky factor of the whole matrix; false if that is not
  // possible.
  bool factorize(Substructures& substructures, const MatrixSources& sources);

  // Changes an existing factor to that of the matrix plus or minus columns * columns^T.
  void change(const Matrix& columns, linalg::Change change);
  // Changes since the factorization, up to the first change that the factor could not follow.
  const std::vector<FactorChange>& changes() const { return changes_; }
  void repeat(const FactorChange& change);

  // Solves for one right-hand side by the preconditioned iteration; `apply` multiplies by the present matrix. If the
  // factor is not good enough, a fresh one is made from the matrix that `assemble` returns. Throws Error (unsolvable).
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs, const SystemSolver::Apply& apply,
                        const std::function<const Matrix&()>& assemble);

  // Whether all pivots are so large that no motion can have lost its resistance. The factor must be current.
  bool pivots_are_sound() const;

  // Cholesky factor of a symmetric matrix that has been factorized as a whole.
  const linalg::SparseCholesky& cholesky() const { return *solver_->cholesky(); }

 private:
  void choose_order();
  void count_new_factor();

  const SolutionMethod& method_;
  const Unknowns& unknowns_;
  SolverCounters& counters_;
  std::function<linalg::NodeGraph()> make_graph_;
  std::unique_ptr<linalg::NodeGraph> graph_;
  std::vector<int> kept_nodes_;
  int kept_ = 0;
  std::unique_ptr<SystemSolver> solver_;
  bool is_of_substructures_ = false;  // whether solver_ has a factor by substructures only
  FactorState state_ = FactorState::none, forgotten_ = FactorState::none;
  std::vector<int> kept_when_made_;
  std::vector<FactorChange> changes_;
  double largest_diagonal_ = 0;  // largest entry of the diagonal of the matrix last factorized
};

// Diagonal of a matrix, with a tiny positive value in place of zeros.
Eigen::VectorXd stiff_diagonal(const Eigen::SparseMatrix<double>& matrix);

// Solver of `matrix` plus a small multiple of `diagonal` (stiff_diagonal()), a shift that does not depend on units or
// stiff neighbours. With the shift a singular matrix can be factorized, and its free motions stay softer than motions
// with little resistance, such as bending of slender parts. Throws Error (unsolvable).
std::unique_ptr<SystemSolver> shifted_solver(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                                             const Eigen::VectorXd& diagonal);

// Vector (largest entry 1) that a matrix resists least, by inverse iteration. `resistance` is set to the ratio of the
// vector's energy with the matrix to its energy with the diagonal of the matrix alone.
Eigen::VectorXd softest_vector(const SolutionMethod& method, const Eigen::SparseMatrix<double>& matrix,
                               double& resistance);

}  // namespace bempd::coupling

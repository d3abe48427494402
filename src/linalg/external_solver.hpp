#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bempd::linalg {

// Sparse direct solver from outside the library, which stores factors under numbers. It eliminates all unknowns of a
// symmetric positive definite matrix except the last `kept` unknowns of a given order of elimination. Without a given
// order the solver may choose an order. All functions throw Error or std::bad_alloc.
class ExternalSolver {
 public:
  using Matrix = Eigen::SparseMatrix<double>;  // a lower triangle, compressed

  // Settings of a factor, given when the pattern of its matrix is analysed.
  struct Plan {
    std::vector<int> order;  // entry k: unknown eliminated as the k-th; empty: the solver chooses
    int kept = 0;
    std::string scratch;  // folder for the factor; empty: in memory
  };
  // Results of a factorization.
  struct Outcome {
    Eigen::MatrixXd schur;  // Schur complement on the kept unknowns, both triangles
    double smallest_pivot = 1;
    std::int64_t entries = 0;
  };

  virtual ~ExternalSolver() = default;

  virtual void analyse(std::int64_t factor, const Matrix& lower, const Plan& plan) = 0;
  // Factorizes a matrix under the number `factor`. Returns false if the block of the eliminated unknowns is not
  // positive definite.
  virtual bool factorize(std::int64_t factor, const Matrix& lower, int kept, Outcome& outcome) = 0;
  // Solves for the eliminated unknowns while the kept unknowns are 0; entries of kept unknowns are neither read nor
  // set.
  virtual void solve(std::int64_t factor, Eigen::MatrixXd& values) = 0;
  // First half of a solution: reduces the right-hand sides `values` to those of the kept unknowns.
  virtual void reduce(std::int64_t factor, Eigen::MatrixXd& values, Eigen::MatrixXd& kept) = 0;
  // Second half of a solution, right after reduce(): finds all unknowns from the kept ones.
  virtual void expand(std::int64_t factor, const Eigen::MatrixXd& kept, Eigen::MatrixXd& values) = 0;
  virtual void forget(std::int64_t factor) noexcept = 0;
  // Ends the solver. Later requests of objects that refer to it throw.
  virtual void end() noexcept = 0;
};

// Sparse solver of the present call, and settings of the library's own solver.
struct SolverChoice {
  std::shared_ptr<ExternalSolver> external;  // null: the library's own solver
  std::string scratch;                       // folder for factors; empty: in memory
  bool wide_indices = false;                 // whether indices have 64 bits even where 32 bits are enough
};

// Scope in which make_sparse_cholesky() makes the solver that a SolverChoice names, in the same thread.
class SolverScope {
 public:
  explicit SolverScope(const SolverChoice& choice) : before_(current()) { current() = &choice; }
  ~SolverScope() { current() = before_; }
  SolverScope(const SolverScope&) = delete;
  SolverScope& operator=(const SolverScope&) = delete;

  static const SolverChoice*& current() {
    thread_local const SolverChoice* choice = nullptr;
    return choice;
  }

 private:
  const SolverChoice* before_;
};

}  // namespace bempd::linalg

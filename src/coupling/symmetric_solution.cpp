// Solution of symmetric positive definite systems.
#include <Eigen/Cholesky>
#include <utility>

#include "coupling/solution_method.hpp"
#include "linalg/conjugate_gradient.hpp"

namespace bempd::coupling {

namespace {

constexpr int most_iterations = 40;

class SymmetricElimination final : public Elimination {
 public:
  SymmetricElimination(Stiffness stiffness, std::vector<DofKind> kind)
      : Elimination(std::move(stiffness), std::move(kind)) {
    if (private_.empty()) return;
    cholesky_.compute((*stiffness_)(private_, private_));
    if (cholesky_.info() != Eigen::Success) fail_singular();
    if (shared_.empty()) return;
    const Eigen::MatrixXd coupling = (*stiffness_)(private_, shared_);
    const Eigen::MatrixXd half = cholesky_.matrixL().solve(coupling);
    schur_.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose(), -1.0);
    schur_.triangularView<Eigen::StrictlyUpper>() = schur_.transpose();
    transfer_ = cholesky_.matrixU().solve(half);
  }

  Affine solve_private(const Affine& force) const override { return cholesky_.solve(force); }
  double reciprocal_condition() const override { return private_.empty() ? 1 : cholesky_.rcond(); }

 private:
  Eigen::LLT<Eigen::MatrixXd> cholesky_;  // of the private block
};

class SymmetricSolver final : public SystemSolver {
 public:
  linalg::SparseFactorization& factorization() override { return *cholesky_; }
  linalg::SparseCholesky* cholesky() override { return cholesky_.get(); }

  linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                               Eigen::VectorXd& x) const override {
    const auto precondition = [this](Eigen::VectorXd& r) { cholesky_->solve_in_place(r); };
    return linalg::conjugate_gradient(apply, precondition, rhs, x, {tolerance, most_iterations});
  }

  Eigen::VectorXd multiply(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& x) const override {
    return matrix.selfadjointView<Eigen::Lower>() * x;
  }

 private:
  std::unique_ptr<linalg::SparseCholesky> cholesky_ = linalg::make_sparse_cholesky();
};

class SymmetricSolution final : public SolutionMethod {
 public:
  bool needs_symmetry() const override { return true; }
  std::shared_ptr<const Elimination> eliminate(Elimination::Stiffness stiffness,
                                               std::vector<DofKind> kind) const override {
    return std::make_shared<const SymmetricElimination>(std::move(stiffness), std::move(kind));
  }
  std::unique_ptr<SystemSolver> make_solver() const override { return std::make_unique<SymmetricSolver>(); }
};

}  // namespace

const SolutionMethod& symmetric_solution() {
  static const SymmetricSolution method;
  return method;
}

}  // namespace bempd::coupling

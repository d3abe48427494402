// Solution of symmetric positive definite systems.
#include <utility>

#include "coupling/solution_method.hpp"
#include "linalg/conjugate_gradient.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::coupling {

namespace {

constexpr int most_rounds = 40;

class SymmetricSchurComplement final : public SchurComplement {
 public:
  SymmetricSchurComplement(Stiffness stiffness, std::vector<DofKind> kind)
      : SchurComplement(std::move(stiffness), std::move(kind)) {
    if (private_.empty()) return;
    Eigen::MatrixXd own = (*stiffness_)(private_, private_);
    check_cancelled();
    cholesky_.compute(std::move(own));
    check_cancelled();
    if (cholesky_.info() != Eigen::Success) fail_singular();
    reciprocal_condition_ = cholesky_.rcond();
    if (shared_.empty()) return;
    Eigen::MatrixXd half = (*stiffness_)(private_, shared_);
    linalg::solve_lower(cholesky_.lower(), half);
    linalg::add_square(matrix_, half.transpose(), -1.0);
    matrix_.triangularView<Eigen::StrictlyUpper>() = matrix_.transpose();
    linalg::solve_upper(cholesky_.lower(), half);
    transfer_ = std::move(half);
  }

  Affine solve_private(const Affine& force) const override { return cholesky_.solve(force); }
  double reciprocal_condition() const override { return reciprocal_condition_; }

 private:
  linalg::DenseCholesky cholesky_;  // factor of the private block
  double reciprocal_condition_ = 1;
};

class SymmetricSolver final : public SystemSolver {
 public:
  linalg::SparseFactorization& factorization() override { return *cholesky_; }
  linalg::SparseCholesky* cholesky() override { return cholesky_.get(); }

  linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                               Eigen::VectorXd& x) const override {
    const auto precondition = [this](Eigen::VectorXd& r) { cholesky_->solve_in_place(r); };
    return linalg::conjugate_gradient(apply, precondition, rhs, x, {tolerance, most_rounds});
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
  std::shared_ptr<const SchurComplement> schur_complement(SchurComplement::Stiffness stiffness,
                                                          std::vector<DofKind> kind) const override {
    return std::make_shared<const SymmetricSchurComplement>(std::move(stiffness), std::move(kind));
  }
  std::unique_ptr<SystemSolver> make_solver() const override { return std::make_unique<SymmetricSolver>(); }
};

}  // namespace

const SolutionMethod& symmetric_solution() {
  static const SymmetricSolution method;
  return method;
}

}  // namespace bempd::coupling

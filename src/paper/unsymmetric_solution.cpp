#include "paper/unsymmetric_solution.hpp"

#include <utility>

#include "linalg/dense_parts.hpp"
#include "paper/low_rank_update.hpp"
#include "paper/refinement.hpp"
#include "paper/sparse_lu.hpp"

namespace bempd::paper {

using namespace coupling;

namespace {

// Largest number of low-rank changes of a factor; more changes would cost more in each solution than a fresh factor.
constexpr int most_updates = 120;
// Largest number of steps of iterative refinement. If the factor has missed changes of the matrix, more steps hardly
// ever converge.
constexpr int most_refinements = 4;

// Reciprocal condition number of a dense block below which a solution with it has no correct digit.
constexpr double singular_condition = 1e-16;

class UnsymmetricSchurComplement final : public SchurComplement {
 public:
  UnsymmetricSchurComplement(Stiffness stiffness, std::vector<DofKind> kind)
      : SchurComplement(std::move(stiffness), std::move(kind)) {
    if (private_.empty()) return;
    lu_.compute((*stiffness_)(private_, private_));
    if (!(lu_.rcond() > singular_condition)) fail_singular();
    if (shared_.empty()) return;
    transfer_ = linalg::solve_in_parts(lu_, (*stiffness_)(private_, shared_));
    linalg::add_product(matrix_, Eigen::MatrixXd((*stiffness_)(shared_, private_)), transfer_, -1);
  }

  Affine solve_private(const Affine& force) const override { return lu_.solve(force); }
  double reciprocal_condition() const override { return private_.empty() ? 1 : lu_.rcond(); }

 private:
  linalg::DenseLU lu_;  // factors of the private block
};

class UnsymmetricSolver final : public SystemSolver {
 public:
  linalg::SparseFactorization& factorization() override { return *lu_; }

  linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                               Eigen::VectorXd& x) const override {
    const auto solve = [this](Eigen::VectorXd& r) { lu_->solve_in_place(r); };
    return refine(apply, solve, rhs, x, tolerance, most_refinements);
  }

  Eigen::VectorXd multiply(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& x) const override {
    return matrix * x;
  }

 private:
  std::unique_ptr<linalg::SparseFactorization> lu_ = with_low_rank_updates(make_sparse_lu(), most_updates);
};

class UnsymmetricSolution final : public SolutionMethod {
 public:
  bool needs_symmetry() const override { return false; }
  std::shared_ptr<const SchurComplement> schur_complement(SchurComplement::Stiffness stiffness,
                                                          std::vector<DofKind> kind) const override {
    return std::make_shared<const UnsymmetricSchurComplement>(std::move(stiffness), std::move(kind));
  }
  std::unique_ptr<SystemSolver> make_solver() const override { return std::make_unique<UnsymmetricSolver>(); }
};

}  // namespace

const SolutionMethod& unsymmetric_solution() {
  static const UnsymmetricSolution method;
  return method;
}

}  // namespace bempd::paper

#include <memory>
#include <utility>
#include <vector>

#include "linalg/cholmod_cholesky.hpp"

namespace bempd::linalg {

namespace {

// Factorization with indices of 32 bits. Once a factor has more entries than these indices can count, indices have 64
// bits, which need more memory, and more time for changes.
class SuiteSparseCholesky final : public SparseCholesky {
 public:
  explicit SuiteSparseCholesky(bool wide) {
    if (wide) widen();
  }

  void set_elimination_order(std::vector<int> order, int kept_last) override {
    order_ = order;
    kept_last_ = kept_last;
    chosen_->set_elimination_order(std::move(order), kept_last);
  }

  bool factorize(const Eigen::SparseMatrix<double>& lower) override {
    try {
      return chosen_->factorize(lower);
    } catch (const TooLargeForIndices&) {
      if (is_wide_) throw;
    }
    widen();
    return chosen_->factorize(lower);
  }

  const std::vector<int>& elimination_order() const override { return chosen_->elimination_order(); }
  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override { chosen_->solve_in_place(rhs); }
  void solve_forward(Eigen::Ref<Eigen::MatrixXd> rhs) const override { chosen_->solve_forward(rhs); }
  void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const override {
    chosen_->solve_backward(transposed, known);
  }
  void solve_backward_at(const std::vector<int>& places, Eigen::Ref<Eigen::MatrixXd> transposed,
                         int known) const override {
    chosen_->solve_backward_at(places, transposed, known);
  }
  Eigen::MatrixXd inverse_block(const std::vector<int>& unknowns) const override {
    return chosen_->inverse_block(unknowns);
  }
  Eigen::MatrixXd trailing_factor(int size) const override { return chosen_->trailing_factor(size); }
  bool update(const Eigen::SparseMatrix<double>& columns, Change change) override {
    return chosen_->update(columns, change);
  }
  double smallest_pivot_ratio() const override { return chosen_->smallest_pivot_ratio(); }
  std::int64_t factor_nonzeros() const override { return chosen_->factor_nonzeros(); }

 private:
  void widen() {
    chosen_.reset();  // before more memory is asked for
    chosen_ = std::make_unique<CholmodCholesky<SuiteSparse_long>>();
    chosen_->set_elimination_order(order_, kept_last_);
    is_wide_ = true;
  }

  std::unique_ptr<SparseCholesky> chosen_ = std::make_unique<CholmodCholesky<int>>();
  std::vector<int> order_;
  int kept_last_ = 0;
  bool is_wide_ = false;
};

}  // namespace

std::unique_ptr<SparseCholesky> own_cholesky(bool wide_indices) {
  return std::make_unique<SuiteSparseCholesky>(wide_indices);
}

const char* backend_name() { return "suitesparse"; }

}  // namespace bempd::linalg

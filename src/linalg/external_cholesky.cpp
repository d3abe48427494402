#include "linalg/external_cholesky.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "cancellation.hpp"
#include "linalg/dense_parts.hpp"
#include "linalg/low_rank_change.hpp"
#include "linalg/sparsity_pattern.hpp"
#include "phase.hpp"

namespace bempd::linalg {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr Eigen::Index most_sides_at_once = 64;  // right-hand sides given to the solver at once

std::int64_t next_number() {
  static std::atomic<std::int64_t> last{0};
  return ++last;
}

// Factor by an outside solver, which gets D A D. The diagonal D brings diagonal entries between 1/2 and 2, so that a
// pivot is its ratio to the diagonal entry within a factor of two. D has powers of two: scaling rounds nothing.
class ExternalCholesky final : public SparseCholesky {
 public:
  ExternalCholesky(std::shared_ptr<ExternalSolver> solver, std::string scratch) : solver_(std::move(solver)) {
    plan_.scratch = std::move(scratch);
  }
  ~ExternalCholesky() override { solver_->forget(number_); }
  ExternalCholesky(const ExternalCholesky&) = delete;
  ExternalCholesky& operator=(const ExternalCholesky&) = delete;

  void set_elimination_order(std::vector<int> order, int kept_last) override {
    if (order == plan_.order && kept_last == plan_.kept) return;
    plan_.order = std::move(order);
    plan_.kept = kept_last;
    pattern_.clear();
  }

  const std::vector<int>& elimination_order() const override { return order_; }

  bool factorize(const SparseMatrix& lower) override {
    assert(lower.rows() == lower.cols());
    if (!lower.isCompressed()) {
      SparseMatrix compressed = lower;
      compressed.makeCompressed();
      return factorize(compressed);
    }
    has_factor_ = false;
    change_.clear();
    entries_ = 0;
    smallest_pivot_ = 1;
    if (lower.rows() == 0) return has_factor_ = true;
    if (!lower.coeffs().allFinite() || !(lower.diagonal().array() > 0).all()) return false;
    choose_scale(lower);
    const SparseMatrix scaled = scale_.asDiagonal() * lower * scale_.asDiagonal();
    analyse(scaled);
    return has_factor_ = eliminate(scaled) && smallest_pivot_ > singular_pivot_ratio;
  }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_);
    solve_unchanged(rhs);  // with the matrix that was factorized
    change_.correct(rhs);
  }

  // The result has the given right-hand sides of the eliminated unknowns (the solver keeps their reduced values), then
  // L^-1 times those of the kept unknowns, reduced; L is the factor of the kept unknowns' Schur complement.
  void solve_forward(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    assert(has_factor_);
    for (Eigen::Index first = 0; first < rhs.cols(); first += most_sides_at_once) {
      auto part = rhs.middleCols(first, std::min(most_sides_at_once, rhs.cols() - first));
      const Eigen::MatrixXd ordered = part(order_, Eigen::all);
      part.topRows(eliminated_count()) = ordered.topRows(eliminated_count());
      if (plan_.kept == 0) continue;
      Eigen::MatrixXd values(ordered.rows(), ordered.cols());
      values(order_, Eigen::all) = ordered;
      values = scale_.asDiagonal() * values;
      Eigen::MatrixXd kept = reduced(values);
      solve_lower(schur_.lower(), kept);
      part.bottomRows(plan_.kept) = kept;
      check_cancelled();
    }
  }

  void solve_backward(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const override {
    assert(has_factor_ && known <= plan_.kept);
    if (known < plan_.kept) finish_kept(transposed, known);
    if (eliminated_count() == 0) return;
    for (Eigen::Index first = 0; first < transposed.rows(); first += most_sides_at_once) {
      auto part = transposed.middleRows(first, std::min(most_sides_at_once, transposed.rows() - first));
      Eigen::MatrixXd values(part.cols(), part.rows());
      values(order_, Eigen::all) = part.transpose();
      values = scale_.asDiagonal() * values;
      if (plan_.kept > 0) {
        Eigen::MatrixXd last = part.rightCols(plan_.kept).transpose();
        last = scale_(kept_unknowns(), Eigen::all).cwiseInverse().asDiagonal() * last;
        values -= coupling_ * last;
      }
      solver_->solve(number_, values);
      values = scale_.asDiagonal() * values;
      part.leftCols(eliminated_count()) = values(order_, Eigen::all).topRows(eliminated_count()).transpose();
      check_cancelled();
    }
  }

  void solve_backward_at(const std::vector<int>&, Eigen::Ref<Eigen::MatrixXd> transposed, int known) const override {
    solve_backward(transposed, known);
  }

  Eigen::MatrixXd eliminated_products(const Eigen::MatrixXd& a, const TwoColumns& b, int known) const override {
    assert(has_factor_ && known == plan_.kept);
    Eigen::MatrixXd solutions = b.transpose();
    solutions.rightCols(known).setZero();
    solve_backward(solutions, known);
    return a.topRows(eliminated_count()).transpose() * solutions.leftCols(eliminated_count()).transpose();
  }

  Eigen::MatrixXd inverse_block(const std::vector<int>& unknowns) const override {
    if (change_.is_empty())
      if (std::optional<Eigen::MatrixXd> block = inverse_block_of_kept(unknowns)) return *std::move(block);
    const auto size = static_cast<Eigen::Index>(unknowns.size());
    Eigen::MatrixXd block(size, size);
    for (Eigen::Index first = 0; first < size; first += most_sides_at_once) {
      const Eigen::Index count = std::min(most_sides_at_once, size - first);
      Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(scale_.size(), count);
      for (Eigen::Index k = 0; k < count; ++k) columns(unknowns[static_cast<std::size_t>(first + k)], k) = 1;
      solve_in_place(columns);
      block.middleCols(first, count) = columns(unknowns, Eigen::all);
    }
    return block;
  }

  Eigen::MatrixXd trailing_factor(int size) const override {
    assert(has_factor_ && size <= plan_.kept);
    const Eigen::MatrixXd lower = schur_.lower().triangularView<Eigen::Lower>();
    const Eigen::VectorXd unscaled = scale_(kept_unknowns()).cwiseInverse();
    return (unscaled.asDiagonal() * lower).bottomRightCorner(size, size);
  }

  // The solver cannot change its factor, so the change is stored beside the factor.
  bool update(const SparseMatrix& columns, Change change) override {
    if (columns.nonZeros() == 0) return true;
    if (!has_factor_ || !change_.has_room_for(columns.cols(), scale_.size(), entries_)) return false;
    return change_.add(columns, change, [this](Eigen::Ref<Eigen::MatrixXd> sides) { solve_unchanged(sides); });
  }
  double smallest_pivot_ratio() const override { return std::min(smallest_pivot_, change_.least_resistance_ratio()); }
  std::int64_t factor_nonzeros() const override { return entries_; }

 private:
  Eigen::Index eliminated_count() const { return static_cast<Eigen::Index>(order_.size()) - plan_.kept; }
  std::vector<int> kept_unknowns() const { return {order_.end() - plan_.kept, order_.end()}; }

  void solve_unchanged(Eigen::Ref<Eigen::MatrixXd> rhs) const {
    for (Eigen::Index first = 0; first < rhs.cols(); first += most_sides_at_once) {
      auto part = rhs.middleCols(first, std::min(most_sides_at_once, rhs.cols() - first));
      Eigen::MatrixXd values = scale_.asDiagonal() * part;
      if (plan_.kept == 0) {
        solver_->solve(number_, values);
      } else {
        Eigen::MatrixXd kept = reduced(values);
        solve_lower(schur_.lower(), kept);
        solve_upper(schur_.lower(), kept);
        expand(kept, values);
      }
      part = scale_.asDiagonal() * values;
      check_cancelled();
    }
  }

  void choose_scale(const SparseMatrix& lower) {
    scale_ = lower.diagonal().unaryExpr([](double d) { return std::exp2(-std::round(std::log2(d) / 2)); });
  }

  void analyse(const SparseMatrix& scaled) {
    if (pattern_.matches(scaled)) return;
    pattern_.clear();
    solver_->forget(number_);
    number_ = next_number();
    order_ = plan_.order;
    if (order_.empty()) {
      order_.resize(static_cast<std::size_t>(scaled.rows()));
      std::iota(order_.begin(), order_.end(), 0);
    }
    if (eliminated_count() > 0) {
      const Phase phase("analysis of the sparse system");
      check_cancelled();
      solver_->analyse(number_, scaled, plan_);
    }
    pattern_.assign(scaled);
  }

  bool eliminate(const SparseMatrix& scaled) {
    const Phase phase("sparse factorization");
    check_cancelled();
    ExternalSolver::Outcome outcome;
    if (eliminated_count() > 0) {
      if (!solver_->factorize(number_, scaled, plan_.kept, outcome)) return false;
    } else {
      outcome.schur = SparseMatrix(scaled.selfadjointView<Eigen::Lower>());
      outcome.schur = outcome.schur(order_, order_).eval();
    }
    check_cancelled();
    smallest_pivot_ = outcome.smallest_pivot;
    entries_ = outcome.entries + static_cast<std::int64_t>(plan_.kept) * (plan_.kept + 1) / 2;
    if (plan_.kept == 0) return true;
    collect_coupling(scaled);
    schur_.compute(std::move(outcome.schur));
    if (schur_.info() != Eigen::Success) return false;
    const Eigen::VectorXd diagonal = scaled.diagonal()(kept_unknowns());
    for (Eigen::Index k = 0; k < plan_.kept; ++k) {
      const double root = schur_.lower()(k, k), ratio = root * root / diagonal[k];
      if (!(ratio >= smallest_pivot_)) smallest_pivot_ = ratio;  // a NaN wins
    }
    return true;
  }

  // Block of A^-1, a block of the Schur complement's inverse, if all `unknowns` are kept; empty if some are eliminated.
  std::optional<Eigen::MatrixXd> inverse_block_of_kept(const std::vector<int>& unknowns) const {
    std::vector<int> place(order_.size(), -1), places;
    for (int k = 0; k < plan_.kept; ++k) place[order_[static_cast<std::size_t>(eliminated_count() + k)]] = k;
    for (const int unknown : unknowns) {
      if (place[unknown] < 0) return std::nullopt;
      places.push_back(place[unknown]);
    }
    Eigen::MatrixXd half = Eigen::MatrixXd::Zero(plan_.kept, static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t k = 0; k < places.size(); ++k) half(places[k], static_cast<Eigen::Index>(k)) = scale_[unknowns[k]];
    solve_lower(schur_.lower(), half);
    return half.transpose() * half;
  }

  // Stores the coupling block of the matrix: columns of the kept unknowns, rows of the eliminated unknowns.
  void collect_coupling(const SparseMatrix& scaled) {
    std::vector<int> column_of(order_.size(), -1);
    for (int k = 0; k < plan_.kept; ++k) column_of[order_[static_cast<std::size_t>(eliminated_count() + k)]] = k;
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < scaled.outerSize(); ++j)
      for (SparseMatrix::InnerIterator it(scaled, j); it; ++it) {
        const int row = static_cast<int>(it.row());
        if (column_of[row] < 0 && column_of[j] >= 0) entries.emplace_back(row, column_of[j], it.value());
        if (column_of[row] >= 0 && column_of[j] < 0) entries.emplace_back(j, column_of[row], it.value());
      }
    coupling_.resize(scaled.rows(), plan_.kept);
    coupling_.setFromTriplets(entries.begin(), entries.end());
  }

  // Reduces scaled right-hand sides to the kept unknowns.
  Eigen::MatrixXd reduced(Eigen::MatrixXd& values) const {
    if (eliminated_count() == 0) return values(order_, Eigen::all);
    Eigen::MatrixXd kept(plan_.kept, values.cols());
    solver_->reduce(number_, values, kept);
    return kept;
  }

  void expand(const Eigen::MatrixXd& kept, Eigen::MatrixXd& values) const {
    if (eliminated_count() > 0) solver_->expand(number_, kept, values);
    values(kept_unknowns(), Eigen::all) = kept;
  }

  // Solves L^T x = b for the kept unknowns x, the last `known` of which are given; L is their Cholesky factor.
  void finish_kept(Eigen::Ref<Eigen::MatrixXd> transposed, int known) const {
    const Eigen::MatrixXd factor = trailing_factor(plan_.kept);
    const Eigen::Index open = plan_.kept - known;
    auto kept = transposed.rightCols(plan_.kept);
    Eigen::MatrixXd sides = kept.leftCols(open).transpose();
    sides -= factor.bottomLeftCorner(known, open).transpose() * kept.rightCols(known).transpose();
    factor.topLeftCorner(open, open).triangularView<Eigen::Lower>().transpose().solveInPlace(sides);
    kept.leftCols(open) = sides.transpose();
  }

  std::shared_ptr<ExternalSolver> solver_;
  std::int64_t number_ = next_number();
  ExternalSolver::Plan plan_;
  std::vector<int> order_;
  Eigen::VectorXd scale_;         // D
  SparsityPattern<int> pattern_;  // pattern that was analysed
  SparseMatrix coupling_;         // block of D A D between eliminated (rows) and kept unknowns
  DenseCholesky schur_;           // factor of the Schur complement of D A D
  LowRankChange change_;          // change since the factorization
  double smallest_pivot_ = 1;
  std::int64_t entries_ = 0;
  bool has_factor_ = false;
};

}  // namespace

std::unique_ptr<SparseCholesky> external_cholesky(std::shared_ptr<ExternalSolver> solver, std::string scratch) {
  return std::make_unique<ExternalCholesky>(std::move(solver), std::move(scratch));
}

}  // namespace bempd::linalg

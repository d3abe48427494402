#include "coupling/bordered_factor.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "linalg/conjugate_gradient.hpp"

namespace bempd::coupling {

namespace {

// Largest number of unknowns of the dense system, and its largest share of all.
constexpr std::size_t most_on_border = 4000;
constexpr double largest_share_on_border = 0.4;
// Distance below which nodes are the same, over the size of their operator.
constexpr double same_place = 1e-10;
constexpr int most_iterations = 40;

// What two systems have in common. Unknowns of a system that belong to operators which the other one does not have are
// its border, those on equal operators too, and the rest of them.
struct Comparison {
  std::vector<int> base_of;                                // of each unknown: that of the base, or -1
  std::vector<const MatrixPart*> only_here, only_in_base;  // parts
};

bool is_same(const MatrixPart& a, const MatrixPart& b) {
  if (a.schur != b.schur || a.has_constraints || b.has_constraints) return false;
  const double size = a.places.empty() ? 0 : (a.places.front() - a.places.back()).norm();
  double extent = size;
  for (const Point& place : a.places) extent = std::max(extent, (place - a.places.front()).norm());
  return std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                    [&](const Point& p, const Point& q) { return (p - q).norm() <= same_place * extent; });
}

std::optional<Comparison> compare(const FactorBase& base, const std::vector<MatrixPart>& parts, Eigen::Index unknowns) {
  std::multimap<const SchurComplement*, std::size_t> with;
  for (std::size_t i = 0; i < base.parts().size(); ++i) with.emplace(base.parts()[i].schur.get(), i);
  Comparison found{std::vector<int>(static_cast<std::size_t>(unknowns), -1), {}, {}};
  std::vector<int> here(static_cast<std::size_t>(base.unknowns()), -1);
  std::vector<char> used(base.parts().size(), 0);
  for (const MatrixPart& part : parts) {
    const auto [first, last] = with.equal_range(part.schur.get());
    const auto same = std::find_if(
        first, last, [&](const auto& one) { return !used[one.second] && is_same(part, base.parts()[one.second]); });
    if (same == last) {
      found.only_here.push_back(&part);
      continue;
    }
    used[same->second] = 1;
    const std::vector<int>& theirs = base.parts()[same->second].unknowns;
    for (std::size_t k = 0; k < theirs.size(); ++k) {
      int& of_own = found.base_of[static_cast<std::size_t>(part.unknowns[k])];
      int& of_base = here[static_cast<std::size_t>(theirs[k])];
      const bool agrees = (of_own < 0 || of_own == theirs[k]) && (of_base < 0 || of_base == part.unknowns[k]);
      if (!agrees) return std::nullopt;
      of_own = theirs[k], of_base = part.unknowns[k];
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) found.only_in_base.push_back(&base.parts()[i]);
  return found;
}

// Sum of the matrices of parts; `place` gives the row of an unknown.
Eigen::MatrixXd sum_of(const std::vector<const MatrixPart*>& parts, const std::vector<int>& place, Eigen::Index size) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const MatrixPart* part : parts) {
    std::vector<int> rows;
    for (const int unknown : part->unknowns) rows.push_back(place[static_cast<std::size_t>(unknown)]);
    sum(rows, rows) += part->entries();
  }
  return sum;
}

// Eliminates all unknowns but the first `kept` ones; empty if the others can move freely.
std::optional<Eigen::MatrixXd> condensed(const Eigen::MatrixXd& matrix, Eigen::Index kept) {
  const Eigen::Index others = matrix.rows() - kept;
  Eigen::MatrixXd rest = matrix.topLeftCorner(kept, kept);
  if (others == 0) return rest;
  linalg::DenseCholesky factor;
  factor.compute(matrix.bottomRightCorner(others, others));
  if (factor.info() != Eigen::Success) return std::nullopt;
  Eigen::MatrixXd half = matrix.bottomLeftCorner(others, kept);
  linalg::solve_lower(factor.lower(), half);
  linalg::add_square(rest, half.transpose(), -1.0);
  rest.triangularView<Eigen::StrictlyUpper>() = rest.transpose();
  return rest;
}

// Factor by that of the base. Unknowns on the border, which have equal operators beside others, and new ones belong to
// the dense system
//   (S - B + N) x = b + S y,   with y the solution of the base for loads elsewhere,
// where S is the base's Schur complement on the border, B and N what operators add there that only one of the systems
// has. The base with the forces S (x - y) on the border then has the displacements of the system elsewhere.
class BorderedFactor final : public linalg::SparseFactorization {
 public:
  BorderedFactor(std::shared_ptr<const FactorBase> base, Comparison comparison, std::vector<int> border,
                 std::vector<int> added)
      : base_(std::move(base)),
        base_of_(std::move(comparison.base_of)),
        border_(std::move(border)),
        added_(std::move(added)) {
    for (const int unknown : border_) on_base_.push_back(base_of_[static_cast<std::size_t>(unknown)]);
    for (const int unknown : border_) base_of_[static_cast<std::size_t>(unknown)] = -1;
  }

  // Sets the dense matrix; false if it is not positive definite. It replaces N by the whole.
  bool set(Eigen::MatrixXd only_here, const Eigen::MatrixXd& only_in_base) {
    schur_ = base_->schur_on(on_base_);
    if (!schur_) return false;
    const auto size = static_cast<Eigen::Index>(border_.size());
    only_here.topLeftCorner(size, size) += *schur_ - only_in_base;
    const Eigen::VectorXd diagonal = only_here.diagonal();
    dense_.compute(std::move(only_here));
    if (dense_.info() != Eigen::Success) return false;
    const Eigen::VectorXd ratios = dense_.lower().diagonal().cwiseAbs2().cwiseQuotient(diagonal);
    smallest_pivot_ratio_ =
        std::min(base_->cholesky().smallest_pivot_ratio(), ratios.size() > 0 ? ratios.minCoeff() : 1);
    return smallest_pivot_ratio_ > linalg::singular_pivot_ratio;
  }

  const std::vector<int>& on_base() const { return on_base_; }

  bool factorize(const Eigen::SparseMatrix<double>&) override { return false; }

  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override {
    const auto size = static_cast<Eigen::Index>(border_.size()), added = static_cast<Eigen::Index>(added_.size());
    Eigen::MatrixXd elsewhere = Eigen::MatrixXd::Zero(base_->unknowns(), rhs.cols());
    for (std::size_t u = 0; u < base_of_.size(); ++u)
      if (base_of_[u] >= 0) elsewhere.row(base_of_[u]) = rhs.row(static_cast<Eigen::Index>(u));
    base_->cholesky().solve_in_place(elsewhere);
    const Eigen::MatrixXd there = elsewhere(on_base_, Eigen::all);
    Eigen::MatrixXd dense(size + added, rhs.cols());
    dense.topRows(size) = rhs(border_, Eigen::all) + *schur_ * there;
    dense.bottomRows(added) = rhs(added_, Eigen::all);
    dense = dense_.solve(dense).eval();
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(base_->unknowns(), rhs.cols());
    moved(on_base_, Eigen::all) = *schur_ * (dense.topRows(size) - there);
    base_->cholesky().solve_in_place(moved);
    moved += elsewhere;
    for (std::size_t u = 0; u < base_of_.size(); ++u)
      if (base_of_[u] >= 0) rhs.row(static_cast<Eigen::Index>(u)) = moved.row(base_of_[u]);
    rhs(border_, Eigen::all) = dense.topRows(size);
    rhs(added_, Eigen::all) = dense.bottomRows(added);
  }

  bool update(const Eigen::SparseMatrix<double>& columns, linalg::Change) override { return columns.nonZeros() == 0; }
  double smallest_pivot_ratio() const override { return smallest_pivot_ratio_; }
  std::int64_t factor_nonzeros() const override { return base_->cholesky().factor_nonzeros(); }

 private:
  std::shared_ptr<const FactorBase> base_;
  std::vector<int> base_of_;  // -1 on the border too
  std::vector<int> border_, added_, on_base_;
  std::shared_ptr<const Eigen::MatrixXd> schur_;
  linalg::DenseCholesky dense_;
  double smallest_pivot_ratio_ = 1;
};

class BorderedSolver final : public SystemSolver {
 public:
  explicit BorderedSolver(std::unique_ptr<BorderedFactor> factor) : factor_(std::move(factor)) {}

  linalg::SparseFactorization& factorization() override { return *factor_; }

  linalg::KrylovResult iterate(const Apply& apply, const Eigen::VectorXd& rhs, double tolerance,
                               Eigen::VectorXd& x) const override {
    const auto precondition = [this](Eigen::VectorXd& r) { factor_->solve_in_place(r); };
    return linalg::conjugate_gradient(apply, precondition, rhs, x, {tolerance, most_iterations});
  }

  Eigen::VectorXd multiply(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& x) const override {
    return matrix.selfadjointView<Eigen::Lower>() * x;
  }

 private:
  std::unique_ptr<BorderedFactor> factor_;
};

}  // namespace

FactorBase::FactorBase(std::shared_ptr<SystemSolver> solver, std::vector<MatrixPart> parts, Eigen::Index unknowns)
    : solver_(std::move(solver)), parts_(std::move(parts)), unknowns_(unknowns) {}

std::shared_ptr<const Eigen::MatrixXd> FactorBase::schur_on(const std::vector<int>& unknowns) const {
  if (schur_ && known_ == unknowns) return schur_;
  linalg::DenseCholesky flexibility;
  flexibility.compute(cholesky().inverse_block(unknowns));
  if (flexibility.info() != Eigen::Success) return nullptr;
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  schur_ = std::make_shared<const Eigen::MatrixXd>(
      linalg::solve_in_parts(flexibility, Eigen::MatrixXd::Identity(size, size)));
  known_ = unknowns;
  return schur_;
}

std::unique_ptr<SystemSolver> bordered_solver(std::shared_ptr<const FactorBase> base,
                                              const std::vector<MatrixPart>& parts,
                                              const std::vector<SpringEntry>& springs, Eigen::Index unknowns) {
  std::optional<Comparison> found = compare(*base, parts, unknowns);
  if (!found) return nullptr;
  std::vector<char> beside(static_cast<std::size_t>(unknowns), 0), beside_in_base(base->unknowns(), 0);
  for (const MatrixPart* part : found->only_here)
    for (const int unknown : part->unknowns) beside[static_cast<std::size_t>(unknown)] = 1;
  for (const SpringEntry& spring : springs)
    beside[static_cast<std::size_t>(spring.row)] = beside[static_cast<std::size_t>(spring.column)] = 1;
  for (const MatrixPart* part : found->only_in_base)
    for (const int unknown : part->unknowns) beside_in_base[static_cast<std::size_t>(unknown)] = 1;
  std::vector<int> border, added;
  for (int unknown = 0; unknown < static_cast<int>(unknowns); ++unknown) {
    const int theirs = found->base_of[static_cast<std::size_t>(unknown)];
    if (theirs < 0) added.push_back(unknown);
    const bool on_border =
        theirs >= 0 && (beside[static_cast<std::size_t>(unknown)] || beside_in_base[static_cast<std::size_t>(theirs)]);
    if (on_border) border.push_back(unknown);
  }
  const std::size_t dense = border.size() + added.size();
  if (dense > most_on_border || static_cast<double>(dense) > largest_share_on_border * static_cast<double>(unknowns))
    return nullptr;
  std::sort(border.begin(), border.end(), [&](int a, int b) { return found->base_of[a] < found->base_of[b]; });

  // Places in the dense system: the border, then what only one of the systems has.
  std::vector<int> place(static_cast<std::size_t>(unknowns), -1), place_in_base(base->unknowns(), -1);
  int count = 0, count_in_base = 0;
  for (const int unknown : border) {
    place[static_cast<std::size_t>(unknown)] = count++;
    place_in_base[static_cast<std::size_t>(found->base_of[static_cast<std::size_t>(unknown)])] = count_in_base++;
  }
  for (const int unknown : added) place[static_cast<std::size_t>(unknown)] = count++;
  for (std::size_t unknown = 0; unknown < beside_in_base.size(); ++unknown)
    if (beside_in_base[unknown] && place_in_base[unknown] < 0) place_in_base[unknown] = count_in_base++;

  Eigen::MatrixXd only_here = sum_of(found->only_here, place, count);
  for (const SpringEntry& spring : springs)
    only_here(place[static_cast<std::size_t>(spring.row)], place[static_cast<std::size_t>(spring.column)]) +=
        spring.value;
  const std::optional<Eigen::MatrixXd> only_in_base =
      condensed(sum_of(found->only_in_base, place_in_base, count_in_base), static_cast<Eigen::Index>(border.size()));
  if (!only_in_base) return nullptr;
  auto factor =
      std::make_unique<BorderedFactor>(std::move(base), *std::move(found), std::move(border), std::move(added));
  if (!factor->set(std::move(only_here), *only_in_base)) return nullptr;
  return std::make_unique<BorderedSolver>(std::move(factor));
}

}  // namespace bempd::coupling

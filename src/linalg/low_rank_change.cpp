#include "linalg/low_rank_change.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

namespace bempd::linalg {

namespace {

constexpr double singular_resistance_ratio = 1e-9;

// Room for the stored solutions A^-1 U, in entries: the larger of `always_room_for` and `share_of_factor` times the
// number of the factor's entries.
constexpr double always_room_for = 8e6, share_of_factor = 0.25;
constexpr Eigen::Index most_columns = 256;  // more columns cost more than they save

Eigen::SparseMatrix<double> side_by_side(const Eigen::SparseMatrix<double>& left,
                                         const Eigen::SparseMatrix<double>& right) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [part, first] : {std::pair{&left, Eigen::Index{0}}, std::pair{&right, left.cols()}})
    for (int j = 0; j < part->outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(*part, j); it; ++it)
        entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(first) + j, it.value());
  Eigen::SparseMatrix<double> both(right.rows(), left.cols() + right.cols());
  both.setFromTriplets(entries.begin(), entries.end());
  return both;
}

}  // namespace

bool LowRankChange::has_room_for(Eigen::Index columns, Eigen::Index unknowns, std::int64_t factor_entries) const {
  const Eigen::Index all = size() + columns;
  const double room = std::max(always_room_for, share_of_factor * static_cast<double>(factor_entries));
  return all <= most_columns && static_cast<double>(all) * static_cast<double>(unknowns) <= room;
}

bool LowRankChange::add(const Eigen::SparseMatrix<double>& columns, Change change, const Solve& solve) {
  LowRankChange next;
  next.sides_ = sides_;
  next.sides_.insert(next.sides_.end(), static_cast<std::size_t>(columns.cols()), change);
  next.columns_ = side_by_side(columns_, columns);
  next.answers_.resize(columns.rows(), next.size());
  next.answers_.leftCols(size()) = answers_;
  auto fresh = next.answers_.rightCols(columns.cols());
  fresh = columns;
  solve(fresh);
  Eigen::MatrixXd middle = next.columns_.transpose() * next.answers_;
  middle = (0.5 * (middle + middle.transpose())).eval();
  for (Eigen::Index k = 0; k < next.size(); ++k)
    middle(k, k) += next.sides_[static_cast<std::size_t>(k)] == Change::add ? 1 : -1;
  next.least_resistance_ratio_ = next.least_resistance_ratio_of(middle);
  if (!(next.least_resistance_ratio_ >= singular_resistance_ratio)) return false;
  next.middle_.compute(middle);
  *this = std::move(next);
  return true;
}

// Smallest ratio of the resistance (energy) of a motion in the changed matrix to that in B, by an eigenvalue problem. B
// is the matrix A plus the added columns. With the removed columns R, these ratios are the eigenvalues of 1 - R^T B^-1
// R.
double LowRankChange::least_resistance_ratio_of(const Eigen::MatrixXd& middle) const {
  std::vector<Eigen::Index> added, removed;
  for (Eigen::Index k = 0; k < size(); ++k)
    (sides_[static_cast<std::size_t>(k)] == Change::add ? added : removed).push_back(k);
  if (removed.empty()) return 1;
  Eigen::MatrixXd kept = -middle(removed, removed);
  if (!added.empty()) {
    const Eigen::MatrixXd across = middle(added, removed);
    kept += across.transpose() * middle(added, added).llt().solve(across);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(kept, Eigen::EigenvaluesOnly);
  return modes.info() == Eigen::Success ? modes.eigenvalues()[0] : 0;
}

void LowRankChange::correct(Eigen::Ref<Eigen::MatrixXd> solutions) const {
  if (is_empty()) return;
  const Eigen::MatrixXd along = columns_.transpose() * solutions;
  solutions -= answers_ * middle_.solve(along);
}

}  // namespace bempd::linalg

#pragma once

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <vector>

#include "linalg/sparse_factorization.hpp"

namespace bempd::linalg {

// Change of a matrix A to A + U D U^T, where the factor of A stays as it is. D is diagonal with entries 1 (added
// columns of U) and -1 (removed columns). Solutions follow from those with A (Woodbury 1950):
//   (A + U D U^T)^-1 = A^-1 - A^-1 U (D + U^T A^-1 U)^-1 U^T A^-1.
class LowRankChange {
 public:
  using Solve = std::function<void(Eigen::Ref<Eigen::MatrixXd>)>;  // overwrites b by A^-1 b

  void clear() { *this = {}; }
  bool is_empty() const { return sides_.empty(); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(sides_.size()); }

  // Whether `columns` further columns of `unknowns` rows take little memory and time, compared with a factor of
  // `factor_entries` entries.
  bool has_room_for(Eigen::Index columns, Eigen::Index unknowns, std::int64_t factor_entries) const;

  // Adds further columns to the change. Returns false, with the change as it was, if the changed matrix would be nearly
  // singular: some motion would lose so much resistance that rounding errors hide the rest.
  bool add(const Eigen::SparseMatrix<double>& columns, Change change, const Solve& solve);

  // Turns solutions with A into solutions with the changed matrix.
  void correct(Eigen::Ref<Eigen::MatrixXd> solutions) const;

  // Smallest ratio, over all motions, of the resistance (energy) of the changed matrix to that of A with the added
  // columns only.
  double least_resistance_ratio() const { return least_resistance_ratio_; }

 private:
  double least_resistance_ratio_of(const Eigen::MatrixXd& middle) const;

  Eigen::SparseMatrix<double> columns_;  // U
  Eigen::MatrixXd answers_;              // A^-1 U
  std::vector<Change> sides_;            // D
  Eigen::PartialPivLU<Eigen::MatrixXd> middle_;
  double least_resistance_ratio_ = 1;
};

}  // namespace bempd::linalg

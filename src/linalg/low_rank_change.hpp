#pragma once

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <vector>

#include "linalg/sparse_factorization.hpp"

namespace bempd::linalg {

// Change of a matrix A, whose factor stays as it is, to A + U D U^T, where D is diagonal with entries 1 (added columns)
// and -1 (removed ones). Solutions follow from those with A (Woodbury 1950):
//   (A + U D U^T)^-1 = A^-1 - A^-1 U (D + U^T A^-1 U)^-1 U^T A^-1.
class LowRankChange {
 public:
  using Solve = std::function<void(Eigen::Ref<Eigen::MatrixXd>)>;  // with A

  void clear() { *this = {}; }
  bool is_empty() const { return sides_.empty(); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(sides_.size()); }

  // Whether this number of further columns, of `unknowns` rows each, takes little memory and time beside a factor with
  // `factor_entries` entries.
  bool has_room_for(Eigen::Index columns, Eigen::Index unknowns, std::int64_t factor_entries) const;

  // Changes the matrix further. Returns false, with the change as it was, if some motion would keep next to nothing of
  // its resistance: rounding of the answers hides what remains.
  bool add(const Eigen::SparseMatrix<double>& columns, Change change, const Solve& solve);

  // Makes solutions with A those with the changed matrix.
  void correct(Eigen::Ref<Eigen::MatrixXd> solutions) const;

  // Smallest ratio, over all motions, of the resistance (energy) that is left to that with A and the added columns.
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

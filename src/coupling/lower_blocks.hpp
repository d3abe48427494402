#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace bempd::coupling {

// Lower triangle of a symmetric matrix, stored column by column in half the memory of the full matrix.
struct PackedLower {
  std::vector<double> entries;

  void take(const Eigen::MatrixXd& full) {
    entries.clear();
    entries.reserve(static_cast<std::size_t>(full.rows() * (full.rows() + 1) / 2));
    for (Eigen::Index j = 0; j < full.cols(); ++j)
      entries.insert(entries.end(), full.col(j).data() + j, full.col(j).data() + full.rows());
  }
};

// Lower triangle of a symmetric matrix that is a sum of smaller ones, in three blocks: of the unknowns to be
// eliminated, of the remaining unknowns, and the coupling block between them.
struct LowerBlocks {
  Eigen::MatrixXd eliminated, coupling, remaining;

  LowerBlocks(Eigen::Index first, Eigen::Index rest)
      : eliminated(zero_below(first)), coupling(Eigen::MatrixXd::Zero(rest, first)), remaining(zero_below(rest)) {}

  // Adds the lower triangle of a symmetric matrix; `places` are the places of its unknowns in the sum.
  void add(const Eigen::MatrixXd& matrix, const std::vector<int>& places) {
    for (std::size_t j = 0; j < places.size(); ++j) add_column(matrix.data() + j * (places.size() + 1), j, places);
  }
  void add(const PackedLower& matrix, const std::vector<int>& places) {
    const double* column = matrix.entries.data();
    for (std::size_t j = 0; j < places.size(); ++j) {
      add_column(column, j, places);
      column += places.size() - j;
    }
  }

 private:
  // Square matrix whose lower triangle is zero; memory above the diagonal is not touched.
  static Eigen::MatrixXd zero_below(Eigen::Index size) {
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index j = 0; j < size; ++j) matrix.col(j).tail(size - j).setZero();
    return matrix;
  }
  // Adds the entries of column j, from the diagonal downwards.
  void add_column(const double* entries, std::size_t j, const std::vector<int>& places) {
    const Eigen::Index first = eliminated.cols(), column = places[j];
    for (std::size_t i = j; i < places.size(); ++i) {
      const Eigen::Index row = places[i];
      const Eigen::Index high = std::max(row, column), low = std::min(row, column);
      (low >= first    ? remaining(high - first, low - first)
       : high >= first ? coupling(high - first, low)
                       : eliminated(high, low)) += *entries++;
    }
  }
};

}  // namespace bempd::coupling

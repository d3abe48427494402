#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "coupling/operator_schur_complement.hpp"
#include "geometry/point.hpp"
#include "linalg/sparse_factorization.hpp"

namespace bempd::coupling {

// Part of a system's matrix: a condensed operator, or a holding spring at a node.
struct MatrixPart {
  std::shared_ptr<const void> source;                   // operator's Schur complement with all constraints open
  std::shared_ptr<const ExactConstraints> constraints;  // null if all are open
  std::vector<Eigen::Index> closed;                     // numbers of the closed constraints
  Eigen::MatrixXd own;                                  // matrix of a spring; empty for an operator
  const Eigen::MatrixXd* matrix;                        // null: `own`
  std::vector<int> unknowns;
  Point centre;
  bool changes = false;  // whether the part changes while cracks grow

  const Eigen::MatrixXd& entries() const { return matrix ? *matrix : own; }
  // Whether both parts have the same source (or equal springs) and equal closed constraints, so that their matrices are
  // equal bit by bit.
  bool is_made_as(const MatrixPart& other) const {
    const bool same_constraints =
        constraints && other.constraints ? *constraints == *other.constraints : constraints == other.constraints;
    return source == other.source && closed == other.closed && same_constraints && own.rows() == other.own.rows() &&
           own == other.own;
  }
};

struct Substructure;

// Factor of a matrix that is a sum of parts, by nested substructures (multifrontal method). The parts in a box are
// divided into two halves by place, each half into halves again, and so on. From the smallest substructures on, each
// substructure eliminates the unknowns that nothing outside of it has, and passes the Schur complement of its other
// unknowns to the next larger substructure. A few parts that change are kept out of the halves and joined last, so that
// a step of crack growth costs little more than the elimination of their own unknowns. If many parts change, they stay
// in the halves, and all substructures around them are computed again. Unchanged substructures are copied from an
// earlier factor; they are equal bit by bit to what would be computed.
class SubstructureFactor final : public linalg::SparseFactorization {
 public:
  // Factorizes the sum of `parts`, which lie in `box`. Substructures that are the same in `before` (null: none) are
  // copied. Null if the matrix is not positive definite or nearly singular.
  static std::unique_ptr<SubstructureFactor> of(std::vector<MatrixPart> parts, const std::array<Point, 2>& box,
                                                Eigen::Index unknowns, const SubstructureFactor* before);

  bool factorize(const Eigen::SparseMatrix<double>&) override { return false; }
  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> rhs) const override;
  bool update(const Eigen::SparseMatrix<double>& columns, linalg::Change) override { return columns.nonZeros() == 0; }
  double smallest_pivot_ratio() const override { return smallest_pivot_ratio_; }
  std::int64_t factor_nonzeros() const override;

  std::size_t substructures() const { return steps_.size(); }
  std::size_t taken_over() const { return taken_over_; }

 private:
  // Elimination in one substructure; the steps of the substructure's halves come before this step.
  struct Step {
    std::shared_ptr<const Substructure> result;
    std::vector<int> unknowns;  // unknowns of the substructure, the eliminated ones first
  };
  class Builder;

  std::vector<Step> steps_;
  std::multimap<const void*, std::shared_ptr<const Substructure>> known_;  // substructures by their first component
  double smallest_pivot_ratio_ = 1;
  std::size_t taken_over_ = 0;
};

}  // namespace bempd::coupling

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "coupling/operator_schur_complement.hpp"
#include "coupling/system_solver.hpp"
#include "geometry/point.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::coupling {

// Operator as a part of a system's matrix.
struct MatrixPart {
  std::shared_ptr<const SchurComplement> schur;
  std::vector<int> unknowns;     // of its matrix
  std::vector<Point> places;     // of their nodes
  bool has_constraints = false;  // which may be closed: `matrix` is then its own
  Eigen::MatrixXd matrix = {};   // empty: that of `schur`

  const Eigen::MatrixXd& entries() const { return matrix.size() > 0 ? matrix : schur->matrix(); }
};

// Entry that a spring adds to a matrix.
struct SpringEntry {
  int row, column;
  double value;
};

// Factor of a matrix that consists of operators. It serves for other systems that differ in some of the operators, as
// while cracks grow in a large body.
class FactorBase {
 public:
  FactorBase(std::shared_ptr<SystemSolver> solver, std::vector<MatrixPart> parts, Eigen::Index unknowns);

  const std::vector<MatrixPart>& parts() const { return parts_; }
  Eigen::Index unknowns() const { return unknowns_; }
  linalg::SparseCholesky& cholesky() const { return *solver_->cholesky(); }
  // Inverse of the block of the inverse matrix for these unknowns: the Schur complement on them. Null if rounding
  // leaves it not positive definite. The last one is kept.
  std::shared_ptr<const Eigen::MatrixXd> schur_on(const std::vector<int>& unknowns) const;

 private:
  std::shared_ptr<SystemSolver> solver_;
  std::vector<MatrixPart> parts_;
  Eigen::Index unknowns_;
  mutable std::vector<int> known_;
  mutable std::shared_ptr<const Eigen::MatrixXd> schur_;
};

// Solver of the system with these parts and springs, by the factor of `base`: where both systems have the same
// operators that factor serves, and the rest is a dense system. Null if they differ in too much.
std::unique_ptr<SystemSolver> bordered_solver(std::shared_ptr<const FactorBase> base,
                                              const std::vector<MatrixPart>& parts,
                                              const std::vector<SpringEntry>& springs, Eigen::Index unknowns);

}  // namespace bempd::coupling

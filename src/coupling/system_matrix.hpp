#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "coupling/factor_origin.hpp"
#include "coupling/stiffness_assembly.hpp"
#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// Sparse matrix of a system's unknowns in its present state. Its operators must be condensed before.
class SystemMatrix {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  explicit SystemMatrix(const SystemParts& parts) : parts_(parts) {}

  // Sums the matrix (lower triangle only if it is symmetric); for factorization and tests.
  const Matrix& assemble() const;
  // Sums the matrix with all constraints open.
  const Matrix& assemble_without_constraints() const;
  // Product with the matrix, computed without summing the matrix.
  Eigen::VectorXd multiply(const Eigen::VectorXd& unknowns) const;

  // Nodes between which closed penalties have needed entries of the matrix so far (null: none). These entries stay in
  // the pattern, because rounding depends on the pattern.
  const std::shared_ptr<const PlacesMet>& shared_places() const { return places_; }
  PlacesMet places_met() const { return places_ ? *places_ : PlacesMet(); }
  void set_places_met(PlacesMet places);
  // Assembly of a matrix with entries for `places`: the assembly of the present matrix if `places` is shared_places(),
  // else a new one.
  std::shared_ptr<StiffnessAssembly> assembly_with(const std::shared_ptr<const PlacesMet>& places) const;

 private:
  std::shared_ptr<StiffnessAssembly> new_assembly(const PlacesMet* places) const;

  const SystemParts& parts_;
  mutable std::shared_ptr<StiffnessAssembly> assembly_;  // null until needed
  mutable std::shared_ptr<const PlacesMet> places_;
};

}  // namespace bempd::coupling

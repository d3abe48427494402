#pragma once

#include <memory>
#include <vector>

#include "coupling/schur_complement.hpp"
#include "coupling/system_solver.hpp"

namespace bempd::coupling {

// Method that solves equations with the matrices of a kind of operator. Every operator names its method; a system takes
// the one, of its operators' methods, that requires the least of the matrix.
class SolutionMethod {
 public:
  virtual ~SolutionMethod() = default;

  // Whether matrices must be symmetric and positive semidefinite, so that one triangle is enough.
  virtual bool needs_symmetry() const = 0;

  // Eliminates the private unknowns. Throws Error (unsolvable) if the private part is singular.
  virtual std::shared_ptr<const SchurComplement> schur_complement(SchurComplement::Stiffness stiffness,
                                                                  std::vector<DofKind> kind) const = 0;

  virtual std::unique_ptr<SystemSolver> make_solver() const = 0;
};

// Method with Cholesky factors and conjugate gradients.
const SolutionMethod& symmetric_solution();

}  // namespace bempd::coupling

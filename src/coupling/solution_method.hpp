#pragma once

#include <memory>
#include <vector>

#include "coupling/schur_complement.hpp"
#include "coupling/system_solver.hpp"

namespace bempd::coupling {

// Method of solving equations with the matrices of one kind of dense operator. Every operator names its method. A
// system uses the least demanding method among them: one that needs no symmetry, if there is one.
class SolutionMethod {
 public:
  virtual ~SolutionMethod() = default;

  // Whether matrices must be symmetric and positive semidefinite; one triangle is then enough.
  virtual bool needs_symmetry() const = 0;

  // Eliminates the private unknowns of a stiffness. Throws Error (unsolvable) if the private block is singular.
  virtual std::shared_ptr<const SchurComplement> schur_complement(SchurComplement::Stiffness stiffness,
                                                                  std::vector<DofKind> kind) const = 0;

  virtual std::unique_ptr<SystemSolver> make_solver() const = 0;
};

// Method for symmetric matrices, with Cholesky factors and conjugate gradients.
const SolutionMethod& symmetric_solution();

}  // namespace bempd::coupling

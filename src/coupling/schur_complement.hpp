#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "coupling/affine.hpp"

namespace bempd::coupling {

enum class DofKind : char { prescribed, private_free, shared_free, tied };

// Schur complement of a dense stiffness on its shared unknowns. The private unknowns, which are free and belong to no
// other part, are eliminated. Degrees of freedom are numbered as in the stiffness.
class SchurComplement {
 public:
  using Stiffness = std::shared_ptr<const Eigen::MatrixXd>;

  virtual ~SchurComplement() = default;

  bool is_of(const Stiffness& stiffness, const std::vector<DofKind>& kind) const {
    return stiffness_ == stiffness && kind_ == kind;
  }
  const Eigen::MatrixXd& stiffness() const { return *stiffness_; }
  const std::vector<int>& private_dofs() const { return private_; }
  const std::vector<int>& shared_dofs() const { return shared_; }
  const Eigen::MatrixXd& matrix() const { return matrix_; }
  // Matrix X that gives the private displacements u_private = -X u_shared where no forces act on them.
  const Eigen::MatrixXd& transfer() const { return transfer_; }
  // Private displacements that private forces cause while the shared unknowns are held at 0.
  virtual Affine solve_private(const Affine& force) const = 0;
  // Estimated reciprocal condition number of the block of private unknowns (those that no other part has); 1 if there
  // are none.
  virtual double reciprocal_condition() const = 0;

 protected:
  // Sorts the degrees of freedom into private and shared ones. The derived class eliminates the private ones, if any.
  SchurComplement(Stiffness stiffness, std::vector<DofKind> kind);

  // Throws Error (unsolvable), because the private block is singular.
  [[noreturn]] static void fail_singular();

  Stiffness stiffness_;
  std::vector<DofKind> kind_;
  std::vector<int> private_, shared_;
  Eigen::MatrixXd transfer_, matrix_;
};

}  // namespace bempd::coupling

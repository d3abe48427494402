#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

namespace bempd::bem {

struct AssemblyOptions {
  // Relative error of each integral; the error of the stiffness is some ten times larger.
  double quadrature_tolerance = 1e-14;
  int threads = 0;       // 0: one thread per core
  bool compact = false;  // whether operators use less memory and take longer to build

  // Number of threads that a boundary of this many elements can use.
  int threads_for(std::size_t elements) const;
};

// Elastic body described by its boundary. The layers above use the stiffness and the tractions of its boundary nodes
// through this interface.
class BoundaryOperator {
 public:
  virtual ~BoundaryOperator() = default;

  // Stiffness: nodal forces [N] from nodal displacements [m], thickness included; degree of freedom 2 * node +
  // component.
  virtual const Eigen::MatrixXd& stiffness() const = 0;

  // Boundary tractions [Pa], row 2 * traction_node + component, for displacements [m] of the boundary nodes; each
  // column of `displacements` gives a column of the result.
  virtual Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const = 0;

  virtual std::int64_t kernel_evaluations() const = 0;
};

}  // namespace bempd::bem

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

namespace bempd::bem {

struct AssemblyOptions {
  double quadrature_tolerance = 1e-14;  // of every integral; the stiffness is some ten times as far off
  int threads = 0;                      // 0: one a core

  // Threads worth waking for a boundary of this many elements.
  int threads_for(std::size_t elements) const;
};

// What the layers above know of one elastic body that is described by its boundary.
class BoundaryOperator {
 public:
  virtual ~BoundaryOperator() = default;

  // Nodal forces [N] of nodal displacements [m], thickness included; degree of freedom 2 * node + component.
  virtual const Eigen::MatrixXd& stiffness() const = 0;

  // Boundary tractions [Pa], row 2 * traction_node + component, one column per column of displacements [m].
  virtual Eigen::MatrixXd tractions(const Eigen::Ref<const Eigen::MatrixXd>& displacements) const = 0;

  virtual std::int64_t kernel_evaluations() const = 0;
};

}  // namespace bempd::bem

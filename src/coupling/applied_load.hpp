#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/unknowns.hpp"

namespace bempd::coupling {

// Loads of a system: forces on free degrees of freedom [N] and displacements of prescribed ones [m], 2 * node +
// component, each with a constant and a proportional part.
class AppliedLoad {
 public:
  explicit AppliedLoad(int node_count)
      : force_(Affine::Zero(2 * node_count, 2)), prescribed_(Affine::Zero(2 * node_count, 2)) {}
  // Replaces the loads. `prescribed` is ignored at degrees of freedom that `kind` does not name prescribed. Forces on
  // tied nodes are moved to their masters.
  void set(Affine force, Affine prescribed, const std::vector<DofKind>& kind, const NodeTies& ties);

  const Affine& force() const { return force_; }
  const Affine& prescribed() const { return prescribed_; }
  bool is_zero(int part) const { return force_.col(part).isZero(0) && prescribed_.col(part).isZero(0); }

  // Largest displacement of a support [m]: of the proportional part, then at a load factor. It is asked for at every
  // event.
  double support_motion() const;
  double support_motion(double load_factor) const;
  // Magnitude of the loads as |constant part| + |load factor * proportional part|, because the two may nearly cancel:
  // the largest of a support displacement [m], then the sum of the largest forces in either part [N].
  double parts_of_support_motion(double load_factor) const;
  double parts_of_force(double load_factor) const { return force_parts_[0] + std::abs(load_factor) * force_parts_[1]; }

 private:
  Affine force_, prescribed_;
  std::vector<std::array<double, 2>> support_motions_;  // each once, of the prescribed ones that are not 0
  double force_parts_[2] = {0, 0};                      // largest in each part
};

}  // namespace bempd::coupling

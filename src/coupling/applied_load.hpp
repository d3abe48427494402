#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/schur_complement.hpp"

namespace bempd::coupling {

// Loads of a system: forces [N] on free degrees of freedom and displacements [m] of prescribed ones (2 * node +
// component), each with a constant part and a part that is proportional to the load factor.
class AppliedLoad {
 public:
  explicit AppliedLoad(int node_count)
      : force_(Affine::Zero(2 * node_count, 2)), prescribed_(Affine::Zero(2 * node_count, 2)) {}
  // Replaces the loads. `prescribed` is ignored at degrees of freedom whose `kind` is not prescribed. Forces on tied
  // nodes are moved to their masters.
  void set(Affine force, Affine prescribed, const std::vector<DofKind>& kind, const NodeTies& ties);

  const Affine& force() const { return force_; }
  const Affine& prescribed() const { return prescribed_; }
  bool is_zero(int part) const { return force_.col(part).isZero(0) && prescribed_.col(part).isZero(0); }

  // Largest displacement of a support [m] in the proportional part, that is per unit of the load factor; cheap enough
  // to be asked for at every event.
  double support_motion() const;
  double support_motion(double load_factor) const;  // at a load factor
  // Largest value of |constant part| + |load factor * proportional part| over the displacements of all supports [m].
  // Magnitudes are added because the two parts may nearly cancel.
  double parts_of_support_motion(double load_factor) const;
  // Largest force in the constant part plus the largest force in |load factor * proportional part| [N].
  double parts_of_force(double load_factor) const { return force_parts_[0] + std::abs(load_factor) * force_parts_[1]; }

 private:
  Affine force_, prescribed_;
  std::vector<std::array<double, 2>> support_motions_;  // different prescribed displacements (both parts) other than 0
  double force_parts_[2] = {0, 0};                      // largest force in each part
};

}  // namespace bempd::coupling

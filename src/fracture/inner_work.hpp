#pragma once

#include <Eigen/Core>

#include "coupling/equilibrium_system.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Work that the system's nodal forces do not include: that of loads inside dense operators, and that of the contact
// forces which these eliminate (closed exact constraints). The loads' part is (1, f) W (1, f)^T / 2 with a matrix W at
// the load factor f. All of this work counts as stored energy, so that it does not disturb the balance of energies.
class InnerWork {
 public:
  // The displacements are those of `state`.
  InnerWork(const coupling::EquilibriumSystem& system, const BodyState& state) : system_(system), state_(state) {}

  const Eigen::Matrix2d& form() const { return form_; }
  void set_form(const Eigen::Matrix2d& form) { form_ = form; }

  double at(double load_factor) const;  // [J]
  // Least scale of the energies that at() returns: where the parts of the loads cancel, these are known only up to a
  // share of the energies of the parts.
  double least_scale(double load_factor) const;

 private:
  const coupling::EquilibriumSystem& system_;
  const BodyState& state_;
  Eigen::Matrix2d form_ = Eigen::Matrix2d::Zero();
};

}  // namespace bempd::fracture

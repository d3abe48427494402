#pragma once

#include <Eigen/Core>

#include "coupling/equilibrium_system.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Work that the system's nodal forces do not include: the work of loads inside dense operators (boundary element
// regions), and of the contact forces that these operators eliminate (closed exact constraints). At the load factor f
// the loads contribute (1, f) W (1, f)^T / 2 with a matrix W [J]. All of this work counts as stored energy too, so that
// the balance of energies is not disturbed.
class InnerWork {
 public:
  // Inner work of a system at the displacements of `state`.
  InnerWork(const coupling::EquilibriumSystem& system, const BodyState& state) : system_(system), state_(state) {}

  const Eigen::Matrix2d& form() const { return form_; }
  void set_form(const Eigen::Matrix2d& form) { form_ = form; }

  double at(double load_factor) const;  // inner work [J]
  // Lower bound for the scale by which errors of at() are divided [J]. Where the constant and the proportional part of
  // the loads cancel, at() is accurate only to a share of the energies of these parts.
  double least_scale(double load_factor) const;

 private:
  const coupling::EquilibriumSystem& system_;
  const BodyState& state_;
  Eigen::Matrix2d form_ = Eigen::Matrix2d::Zero();
};

}  // namespace bempd::fracture

#pragma once

#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "coupling/support_dofs.hpp"
#include "fracture/body_loads.hpp"
#include "fracture/evolution_state.hpp"

namespace bempd::fracture {

// Reactions of supports at the present load factor, and the force that the body carries.
class SupportForces {
 public:
  SupportForces(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const BodyState& state,
                const BodyLoads& loads, coupling::SupportDofs dofs)
      : system_(system), positions_(positions), state_(state), loads_(loads), dofs_(std::move(dofs)) {
    dofs_.shared.resize(dofs_.own.size());
  }

  const coupling::SupportDofs& dofs() const { return dofs_; }
  Eigen::Vector2d reaction(std::size_t support) const;
  double reaction_moment(std::size_t support, const Point& about) const;  // moment about a place [N m]
  double reaction_at(int dof) const;      // reaction at a degree of freedom that is held [N]
  std::vector<double> reactions() const;  // x and y of every support [N]
  // Prescribed displacements of supports at the present load factor: x and y of each support, as the mean over its
  // nodes; NaN for a component that is not prescribed.
  std::vector<double> displacements() const;
  // Force that the body carries at a load factor [N]: half the sum of the magnitudes of `reactions` and of the nodal
  // loads.
  double resistance(const std::vector<double>& reactions, double load_factor) const;
  double resistance(const std::vector<double>& reactions) const { return resistance(reactions, state_.load_factor); }

 private:
  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  const BodyState& state_;
  const BodyLoads& loads_;
  coupling::SupportDofs dofs_;
};

}  // namespace bempd::fracture

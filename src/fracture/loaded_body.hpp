#pragma once

#include <cstdint>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/body_loads.hpp"
#include "fracture/body_response.hpp"
#include "fracture/contact/body_contact.hpp"
#include "fracture/contact/crack_faces.hpp"
#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/freed_parts.hpp"
#include "fracture/part_holder.hpp"
#include "fracture/support_forces.hpp"

namespace bempd::fracture {

// Whole body under its loads: owns the parts of the body (response, crack faces, loads, supports, contact), and does
// what needs several of them.
class LoadedBody {
 public:
  // The bonds `cut` are broken from the start. `state` belongs to the caller, who saves and restores it.
  LoadedBody(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
             std::vector<double> critical_stretch, const std::vector<int>& cut, coupling::SupportDofs supports,
             ContactPlan contact, BodyState& state);
  LoadedBody(const LoadedBody&) = delete;
  LoadedBody& operator=(const LoadedBody&) = delete;

  coupling::EquilibriumSystem& system() { return system_; }
  const coupling::EquilibriumSystem& system() const { return system_; }
  const std::vector<Point>& positions() const { return positions_; }
  BodyState& state() { return state_; }
  const FreedPartFinder& freed_parts() const { return freed_parts_; }
  CrackFaces& faces() { return faces_; }
  const CrackFaces& faces() const { return faces_; }
  BodyResponse& response() { return response_; }
  const BodyResponse& response() const { return response_; }
  BodyLoads& loads() { return loads_; }
  const SupportForces& supports() const { return supports_; }
  PartHolder& holder() { return holder_; }
  BodyContact& contact() { return contact_; }

  // Replaces the loads by others that are equal at the present load factor. If the new loads have no proportional part,
  // the body stays in equilibrium; otherwise find_equilibrium() has to follow.
  void take_over(const coupling::Affine& force, const coupling::Affine& prescribed, const CrackPressures& pressures);

  struct FirstEquilibrium {
    double work;
    std::int64_t fragments;  // parts cut off by initial cracks, or pushed by new loads
    std::vector<int> held;   // nodes of parts that could move freely
    std::int64_t switches;   // contact places that have closed or opened
    LostBalance lost_balance;
  };
  // Finds the equilibrium under new loads at the present load factor. With `tells_work` the result contains the work of
  // the loads, which costs more where faces are closed; otherwise the work is given as 0.
  FirstEquilibrium find_equilibrium(bool tells_work);

  void restore();  // adapts system and ratios to the state, which the caller has replaced

 private:
  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  BodyState& state_;
  FreedPartFinder freed_parts_;
  BodyResponse response_;
  CrackFaces faces_;
  BodyLoads loads_;
  SupportForces supports_;
  PartHolder holder_;
  BodyContact contact_;
};

}  // namespace bempd::fracture

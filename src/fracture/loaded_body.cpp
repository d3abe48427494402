#include "fracture/loaded_body.hpp"

#include <algorithm>

namespace bempd::fracture {

using coupling::Affine;

LoadedBody::LoadedBody(coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                       std::vector<double> critical_stretch, const std::vector<int>& cut,
                       coupling::SupportDofs supports, ContactPlan contact, BodyState& state)
    : system_(system),
      positions_(positions),
      state_(state),
      freed_parts_(system, positions),
      response_(system, std::move(critical_stretch), state),
      faces_(system, positions, std::move(contact), cut),
      loads_(system, positions, state),
      supports_(system, positions, state, loads_, std::move(supports)),
      holder_(system, positions, state, freed_parts_, response_, loads_),
      contact_(system, positions, state, faces_, response_, holder_) {
  const Eigen::Index dofs = 2 * system.node_count();
  state_.displacement = Affine::Zero(dofs, 2);
  state_.total_displacement = state_.total_force = Eigen::VectorXd::Zero(dofs);
  state_.unloaded.assign(system.node_count(), 0);
  system_.factor().place_nodes(positions);
  system_.commit(system_.stages().breaking(cut), {});
  state_.stages = system_.stages().numbers();
  state_.springs = system_.springs();
  state_.faces.closed = system_.constraints().closed();
  response_.enter_stages();
  if (!system_.response().has_offsets()) return;
  system_.condense();
  state_.total_force = system_.response().internal_force(state_.total_displacement, state_.load_factor);
}

void LoadedBody::take_over(const Affine& force, const Affine& prescribed, const CrackPressures& pressures) {
  const bool was_in_equilibrium = state_.in_equilibrium;
  loads_.set(force, prescribed, pressures);
  const bool constant = system_.load().force().col(1).isZero(0) && loads_.prescribed().col(1).isZero(0) &&
                        !system_.response().has_offsets();
  if (!was_in_equilibrium || !constant) return;
  state_.displacement.col(0) = state_.total_displacement;
  state_.displacement.col(1).setZero();
  response_.update_ratios();
  state_.first_unit_energy = 0;
  state_.in_equilibrium = true;
}

LoadedBody::FirstEquilibrium LoadedBody::find_equilibrium(bool tells_work) {
  const Eigen::VectorXd before = state_.total_displacement;
  const double unbalanced_before = loads_.unbalanced_share();
  double stored_before = 0;
  if (tells_work) {  // loads on closed faces may have changed since the state's forces were computed
    stored_before = system_.response().has_offsets() ? system_.response().energy(before, state_.load_factor)
                                                     : response_.stored_energy();
  }
  contact_.update_faces();
  FreedParts freed = freed_parts_.all_pieces(before);
  system_.commit({}, freed.springs);
  if (!freed.nodes_with_lost_loads.empty()) loads_.drop(freed.nodes_with_lost_loads);
  FirstEquilibrium result{0, freed.fragments, {}, 0, {}};
  for (const coupling::HoldingSpring& spring : freed.springs) result.held.push_back(spring.node);
  const bool cracked = std::find(system_.stages().intact().begin(), system_.stages().intact().end(), 0) !=
                       system_.stages().intact().end();
  if (cracked) {
    if (!system_.factor().is_current()) system_.factor().forget();  // a factor of another matrix does not show hinges
    const HeldMotions held = holder_.solve({}, before, [&] { return !response_.is_balanced(); });
    result.fragments += held.fragments;
    result.held.insert(result.held.end(), held.nodes.begin(), held.nodes.end());
  } else {
    response_.solve();  // a free motion without cracks is an error of the host
  }
  const bool had_contact = system_.constraints().closed_count() > 0;
  const BodyContact::Settled settled = contact_.settle(0);
  result.switches = settled.switched;
  result.fragments += settled.fragments;
  result.held.insert(result.held.end(), settled.held.begin(), settled.held.end());
  if (result.fragments > 0) result.lost_balance = {unbalanced_before, loads_.unbalanced_share()};
  state_.springs = system_.springs();
  holder_.exclude_from_fluid();
  response_.update_ratios();
  result.work = response_.absorb(state_.load_factor);
  // The trapezoidal rule for the work holds only if no faces close or open on the way from the previous loads. If some
  // do, the work is the change of the stored energy.
  if (had_contact || result.switches > 0) result.work = response_.stored_energy() - stored_before;
  if (!tells_work) result.work = 0;
  if (state_.first_unit_energy < 0) state_.first_unit_energy = response_.unit_energy();
  state_.in_equilibrium = true;
  return result;
}

void LoadedBody::restore() {
  system_.restore(state_.stages, state_.springs);
  faces_.restore(state_.faces);
  loads_.apply();
  response_.update_ratios();
}

}  // namespace bempd::fracture

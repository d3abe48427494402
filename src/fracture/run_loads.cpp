#include "fracture/run_loads.hpp"

#include <algorithm>

#include "fracture/balance.hpp"
#include "number_range.hpp"

namespace bempd::fracture {

using coupling::Affine;

void RunLoads::set(const Affine& force, const Affine& prescribed, const Eigen::Matrix2d& work_within,
                   const CrackPressures& pressures) {
  sources_.refresh();
  sources_.settle();
  body_.loads().set(force, prescribed, pressures);
  inner_work_.set_form(work_within);
}

void RunLoads::take_over(const Affine& force, const Affine& prescribed, const Eigen::Matrix2d& work_within,
                         const CrackPressures& pressures) {
  sources_.refresh();
  sources_.settle();
  body_.take_over(force, prescribed, pressures);
  inner_work_.set_form(work_within);
}

RunLoads::SavedLoads RunLoads::present() {
  sources_.refresh();
  return {body_.loads().acting(), inner_work_.form(), sources_.resumption().present()};
}

void RunLoads::restore(SavedLoads loads) noexcept {
  body_.loads().restore(std::move(loads.acting));
  inner_work_.set_form(loads.work_within);
  sources_.abandon();
  sources_.resumption().await(std::move(loads.continuation));
}

RunLoads::Heat RunLoads::heat(coupling::Rests rests) {
  sources_.refresh();
  sources_.settle();
  system_.condense();
  const Eigen::VectorXd& u = state_.total_displacement;
  const double f = state_.load_factor, before = system_.response().energy(u, f);
  system_.stress_free().exchange(rests);
  Eigen::VectorXd force;
  double work = 0;
  try {
    force = system_.response().internal_force(u, f);
    work = in_range(system_.response().energy(u, f) - before);
  } catch (...) {
    system_.stress_free().exchange(rests);
    throw;
  }
  state_.total_force.swap(force);
  state_.work += work;
  state_.in_equilibrium = false;
  state_.first_unit_energy = -1;
  return {std::move(rests), std::move(force), work};
}

void RunLoads::restore_rest_lengths(Heat heat) noexcept {
  system_.stress_free().exchange(heat.rests);
  state_.total_force.swap(heat.total_force);
  state_.work -= heat.work;
}

RunLoads::FaceLoads RunLoads::load_faces(Affine offsets) {
  sources_.refresh();
  sources_.settle();
  const Eigen::VectorXd& u = state_.total_displacement;
  const bool presses = system_.constraints().closed_exact_count() > 0;
  const double before = presses ? system_.response().energy(u, state_.load_factor) : 0;
  system_.contact().exchange_gap_offsets(offsets);
  const double work = presses ? in_range(system_.response().energy(u, state_.load_factor) - before) : 0;
  state_.work += work;
  return {std::move(offsets), work};
}

void RunLoads::unload_faces(FaceLoads loads) noexcept {
  system_.contact().exchange_gap_offsets(loads.offsets);
  state_.work -= loads.work;
}

void RunLoads::find_equilibrium() {
  sources_.refresh();
  if (state_.in_equilibrium) return;
  BodyState before = state_;
  try {
    LoadedBody::FirstEquilibrium found = body_.find_equilibrium(true);
    require_balance(body_.response().residual(), 0);
    records_.book(std::move(found));
  } catch (...) {
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    throw;
  }
}

}  // namespace bempd::fracture

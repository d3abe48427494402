#include <algorithm>
#include <cmath>

#include "fracture/balance.hpp"
#include "fracture/crack_evolution.hpp"
#include "number_range.hpp"

// New loads of a run.
namespace bempd::fracture {

using coupling::Affine;

void CrackEvolution::set_load(const Affine& force, const Affine& prescribed, const Eigen::Matrix2d& work_within,
                              const CrackPressures& pressures) {
  sources_.refresh();
  sources_.settle();
  body_.set_load(force, prescribed, pressures);
  work_within_ = work_within;
}

void CrackEvolution::take_over(const Affine& force, const Affine& prescribed, const Eigen::Matrix2d& work_within,
                               const CrackPressures& pressures) {
  sources_.refresh();
  sources_.settle();
  body_.take_over(force, prescribed, pressures);
  work_within_ = work_within;
}

void CrackEvolution::restore_loads(Loads loads) noexcept {
  body_.restore_loads(std::move(loads.acting));
  work_within_ = loads.work_within;
  sources_.abandon();
  sources_.continue_with(std::move(loads.way_on));
}

CrackEvolution::Heat CrackEvolution::heat(coupling::Rests rests) {
  sources_.refresh();
  sources_.settle();
  system_.condense();
  const Eigen::VectorXd& u = state_.total_displacement;
  const double f = state_.load_factor, before = system_.energy(u, f);
  system_.exchange_rests(rests);
  Eigen::VectorXd force;
  double work = 0;
  try {
    force = system_.internal_force(u, f);
    work = in_range(system_.energy(u, f) - before);
  } catch (...) {
    system_.exchange_rests(rests);
    throw;
  }
  state_.total_force.swap(force);
  state_.work += work;
  state_.in_equilibrium = false;
  state_.first_unit_energy = -1;
  return {std::move(rests), std::move(force), work};
}

void CrackEvolution::restore_rest_lengths(Heat heat) noexcept {
  system_.exchange_rests(heat.rests);
  state_.total_force.swap(heat.total_force);
  state_.work -= heat.work;
}

CrackEvolution::FaceLoads CrackEvolution::load_faces(Affine offsets) {
  sources_.refresh();
  sources_.settle();
  const Eigen::VectorXd& u = state_.total_displacement;
  const bool presses = system_.constraints().closed_exact_count() > 0;
  const double before = presses ? system_.energy(u, state_.load_factor) : 0;
  system_.exchange_gap_offsets(offsets);
  const double work = presses ? in_range(system_.energy(u, state_.load_factor) - before) : 0;
  state_.work += work;
  return {std::move(offsets), work};
}

void CrackEvolution::unload_faces(FaceLoads loads) noexcept {
  system_.exchange_gap_offsets(loads.offsets);
  state_.work -= loads.work;
}

double CrackEvolution::within(double load_factor) const {
  const Eigen::Vector2d loads(1, load_factor);
  const double open = 0.5 * loads.dot(work_within_ * loads);
  if (system_.constraints().closed_exact_count() == 0) return open;
  const Eigen::VectorXd u = coupling::evaluate(state_.displacement, load_factor);
  return open + system_.operators().work_due_to_multipliers(u, load_factor);
}

double CrackEvolution::least_scale_within(double load_factor) const {
  constexpr double accuracy = 1e-9;
  const Eigen::Vector2d loads(1, std::abs(load_factor));
  return accuracy * 0.5 * loads.dot(work_within_.cwiseAbs() * loads);
}

// Loads may leave the body as it was, so the largest work so far is the measure of energy errors.
void CrackEvolution::measure_work() { state_.largest_work = std::max(state_.largest_work, std::abs(work())); }

double CrackEvolution::work() const { return in_range(state_.work + within(state_.load_factor)); }

void CrackEvolution::find_equilibrium() {
  sources_.refresh();
  if (state_.in_equilibrium) return;
  BodyState before = state_;
  try {
    LoadedBody::FirstEquilibrium found = body_.find_equilibrium();
    require_balance(body_.residual(), 0);
    held_ = std::move(found.held);
    state_.fragments += found.fragments;
    state_.contact_switches += found.switches;
    state_.work = in_range(state_.work + found.work);
    measure_work();
  } catch (...) {
    static_cast<BodyState&>(state_) = std::move(before);
    sources_.abandon();
    throw;
  }
}

}  // namespace bempd::fracture

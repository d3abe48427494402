#pragma once

#include <Eigen/Core>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"

namespace bempd::fracture {

// True if nothing resists the proportional load any more, given its energy and that in the undamaged scene.
bool is_separated(const coupling::EquilibriumSystem& system, double unit_energy, double first_unit_energy);

// True if a part has taken its loads along and nothing but supports balances those that stay, which loads alone had
// balanced before: what carried load from the ones to the others is gone.
bool is_balance_lost(const LostBalance& balance);

[[noreturn]] void fail_out_of_range();

// Largest force at a free node that internal forces leave over, relative to the largest one met so far.
double residual(const coupling::EquilibriumSystem& system, const Eigen::VectorXd& internal_force, double load_factor,
                double largest_force);

// No result is given out whose residual or energy balance is off by more (bempd.h says so).
constexpr double most_residual = 1e-6, most_imbalance = 1e-6;

// What forces, and energies, are measured by at least: where supports move, or parts of loads cancel.
double least_force_scale(const coupling::EquilibriumSystem& system, double load_factor);
double least_energy_scale(const coupling::EquilibriumSystem& system, double load_factor);

// Throws Error (unsolvable) for what is off by more.
void require_balance(double residual, double energy_balance_error);

}  // namespace bempd::fracture

#pragma once

#include <Eigen/Core>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"

namespace bempd::fracture {

// Whether nothing resists the proportional load any more: `unit_energy` is its energy now, `first_unit_energy` that in
// the undamaged scene.
bool is_separated(const coupling::EquilibriumSystem& system, double unit_energy, double first_unit_energy);

// Whether the part that carried load has failed: a fragment has taken loads with it that had balanced the other loads,
// so that only supports balance these now.
bool is_balance_lost(const LostBalance& balance);

[[noreturn]] void fail_out_of_range();

// Residual: largest unbalanced force at a free node, relative to the largest internal force so far.
double residual(const coupling::EquilibriumSystem& system, const Eigen::VectorXd& internal_force, double load_factor,
                double largest_force);

// Largest residual and energy balance error of a result; larger ones are an error for the host (see bempd.h).
constexpr double most_residual = 1e-6, most_imbalance = 1e-6;

// Least scales by which forces and energies are measured, for bodies with moving supports, or with loads that partly
// cancel.
double least_force_scale(const coupling::EquilibriumSystem& system, double load_factor);
double least_energy_scale(const coupling::EquilibriumSystem& system, double load_factor);

// Throws Error (unsolvable) if the residual exceeds most_residual or the energy balance error exceeds most_imbalance.
void require_balance(double residual, double energy_balance_error);

}  // namespace bempd::fracture

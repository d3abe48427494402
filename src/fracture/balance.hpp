#pragma once

#include <Eigen/Core>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"

namespace bempd::fracture {

// Whether nothing resists the proportional load any more, from its energy and that in the undamaged scene.
bool is_separated(const coupling::EquilibriumSystem& system, double unit_energy, double first_unit_energy);

// Whether a fragment has taken loads along that had balanced the other loads, so that only supports balance these now:
// the part that carried load between them has failed.
bool is_balance_lost(const LostBalance& balance);

[[noreturn]] void fail_out_of_range();

// Largest unbalanced force at a free node, relative to the largest internal force so far.
double residual(const coupling::EquilibriumSystem& system, const Eigen::VectorXd& internal_force, double load_factor,
                double largest_force);

// Largest residual and energy balance error of a result; a result beyond them is an error (bempd.h says so).
constexpr double most_residual = 1e-6, most_imbalance = 1e-6;

// Least scales of forces and energies, for bodies whose supports move, or whose loads cancel in part.
double least_force_scale(const coupling::EquilibriumSystem& system, double load_factor);
double least_energy_scale(const coupling::EquilibriumSystem& system, double load_factor);

// Throws Error (unsolvable) if one of them is larger.
void require_balance(double residual, double energy_balance_error);

}  // namespace bempd::fracture

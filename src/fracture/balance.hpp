#pragma once

#include <Eigen/Core>

#include "coupling/equilibrium_system.hpp"
#include "fracture/event_source.hpp"

namespace bempd::fracture {

// Whether nothing in the body resists the proportional load. `unit_energy` is the elastic energy of the proportional
// load in the present body, `first_unit_energy` its value when the load was given.
bool is_separated(const coupling::EquilibriumSystem& system, double unit_energy, double first_unit_energy);

// Whether the loads have lost their balance: a fragment has come free together with its loads, which balanced the other
// loads, so that only supports balance the remaining loads.
bool is_balance_lost(const LostBalance& balance);

[[noreturn]] void fail_out_of_range();

// Residual: largest unbalanced force at an unsupported degree of freedom, divided by `largest_force`, the largest
// internal nodal force of the run so far.
double residual(const coupling::EquilibriumSystem& system, const Eigen::VectorXd& internal_force, double load_factor,
                double largest_force);

// Largest residual and largest energy balance error [-] with which a result is accepted. Beyond these limits the host
// gets an error (bempd.h).
constexpr double most_residual = 1e-6, most_imbalance = 1e-6;

// Lower bounds of the scales of forces [N] and energies [J] by which residuals and energy errors are divided. The
// bounds matter where supports move the body without stress, or where the constant and the proportional part of the
// loads nearly cancel.
double least_force_scale(const coupling::EquilibriumSystem& system, double load_factor);
double least_energy_scale(const coupling::EquilibriumSystem& system, double load_factor);

// Throws Error (unsolvable) if the residual exceeds most_residual or the energy balance error exceeds most_imbalance.
void require_balance(double residual, double energy_balance_error);

}  // namespace bempd::fracture

#include "fracture/balance.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace bempd::fracture {

namespace {

// Elastic energy of the proportional load over that of the undamaged scene, below which nothing resists the load any
// more.
constexpr double separated_energy_ratio = 1e-10;

// Share of the loads that supports may bear while they only keep a body from moving; with a larger one they carry load
// by purpose. A spall removes less than this share of the loads, half of a plate all of it.
constexpr double bystanders_share = 0.1;

// Energy due to moving supports, over what it would be with the largest stiffness, below which nothing resists the
// motion up to rounding.
constexpr double energy_rounding = 1e-14;

// Least scale of forces and energies where supports move a body, relative to what this motion would cause with the
// largest stiffness. If they move it without stress, all forces are rounding of about 1e-14 of that. Ordinary scenes
// have larger forces: a strip in tension 1 / (number of elements along it).
constexpr double scale_without_stress = 1e-5;

// Least scale of forces where the constant and the proportional part of the loads cancel, relative to these parts; for
// energies its square. All forces are then rounding, about 1e-14 of the parts, as in a load program that is at rest at
// zero. Loads that rise from zero at some time exceed this scale after some 1e-6 of that time.
constexpr double scale_of_parts = 1e-6;

constexpr char causes_of_rounding[] =
    "look for strips that are very thin for their length, also those that holes, cracks and edges leave between "
    "them, and for parts that supports or a few bonds hardly hold";

// Largest displacement of the body by supports, and by springs that hold parts that have come free.
double moved_by_holds(const coupling::EquilibriumSystem& system, double load_factor) {
  double largest =
      std::max(system.load().support_motion(load_factor), system.stress_free().largest_motion(load_factor));
  for (const coupling::HoldingSpring& spring : system.springs()) largest = std::max(largest, std::abs(spring.anchor));
  return largest;
}

double force_of_parts(const coupling::EquilibriumSystem& system, double load_factor) {
  const double by_supports = system.stiffness_range().largest * system.load().parts_of_support_motion(load_factor);
  return scale_of_parts * (system.load().parts_of_force(load_factor) + by_supports);
}

}  // namespace

bool is_separated(const coupling::EquilibriumSystem& system, double unit_energy, double first_unit_energy) {
  const double moved = std::max(system.load().support_motion(), system.stress_free().largest_motion());
  const double rounding = energy_rounding * system.stiffness_range().largest * moved * moved;
  return unit_energy < std::max(separated_energy_ratio * first_unit_energy, std::min(rounding, first_unit_energy));
}

bool is_balance_lost(const LostBalance& balance) {
  return balance.before <= bystanders_share && balance.after > bystanders_share;
}

void fail_out_of_range() {
  fail(Failure::unsolvable,
       "displacements or forces are beyond the range of numbers; choose other units or smaller loads");
}

double residual(const coupling::EquilibriumSystem& system, const Eigen::VectorXd& internal_force, double load_factor,
                double largest_force) {
  double unbalanced = 0;
  const Eigen::VectorXd load = coupling::evaluate(system.load().force(), load_factor);
  for (Eigen::Index dof = 0; dof < load.size(); ++dof) {
    if (system.unknowns().is_prescribed(static_cast<int>(dof))) continue;
    unbalanced = std::max(unbalanced, std::abs(internal_force[dof] - load[dof]));
  }
  return largest_force > 0 ? unbalanced / largest_force : unbalanced;
}

double least_force_scale(const coupling::EquilibriumSystem& system, double load_factor) {
  const double of_motion =
      scale_without_stress * system.stiffness_range().largest * moved_by_holds(system, load_factor);
  return std::max(of_motion, force_of_parts(system, load_factor));
}

double least_energy_scale(const coupling::EquilibriumSystem& system, double load_factor) {
  const double moved = moved_by_holds(system, load_factor), stiffness = system.stiffness_range().largest;
  const double of_parts = force_of_parts(system, load_factor);
  return std::max(scale_without_stress * stiffness * moved * moved,
                  stiffness > 0 ? of_parts * of_parts / stiffness : 0);
}

void require_balance(double residual, double energy_balance_error) {
  if (residual > most_residual) {
    fail(Failure::unsolvable, "forces are out of balance by ", residual,
         " of the largest one: rounding is as large in this body; ", causes_of_rounding);
  }
  if (energy_balance_error > most_imbalance) {
    fail(Failure::unsolvable, "work and energies differ by ", energy_balance_error,
         " of the largest work: rounding is as large in this body; ", causes_of_rounding);
  }
}

}  // namespace bempd::fracture

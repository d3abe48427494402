#include "fracture/balance.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace bempd::fracture {

namespace {

// Least ratio of the elastic energy of the proportional load to its value when the load was given. A smaller ratio
// means that nothing in the body resists the load.
constexpr double separated_energy_ratio = 1e-10;

// Largest share of the loads that supports bear if they only keep a body with balanced loads from moving. Supports with
// a larger share carry load by purpose. A spall that breaks off takes less than this share of the loads along, a half
// of a plate takes all loads.
constexpr double bystanders_share = 0.1;

// Least ratio of the elastic energy that moving supports cause to the energy of the same motion against the largest
// stiffness. A smaller ratio is rounding: nothing resists the motion.
constexpr double energy_rounding = 1e-14;

// Lower bound for the scale by which residuals are divided where supports move a body: this share of the force of the
// same motion against the largest stiffness (for energies, of its energy). If supports move a body without stress, all
// forces are rounding errors, about 1e-14 of that force. Ordinary scenes have larger forces: in a strip in tension the
// share is 1 / (number of elements along the strip).
constexpr double scale_without_stress = 1e-5;

// Lower bound for the scale by which residuals are divided where the constant and the proportional part of the loads
// cancel: this share of the force of each part (for energies, the square of this share). All forces are then rounding
// errors, about 1e-14 of the parts, as while a load program rests at zero load. Loads that rise from zero at some time
// exceed this scale after some 1e-6 of that time.
constexpr double scale_of_parts = 1e-6;

constexpr char causes_of_rounding[] =
    "look for strips that are very thin for their length, also those that holes, cracks and edges leave between "
    "them, and for parts that supports or a few bonds hardly hold";

// Largest displacement that supports, free swelling, or the springs that hold freed parts impose on the body.
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

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/operators.hpp"
#include "crack/extension.hpp"
#include "fracture/contact/face_state.hpp"
#include "fracture/line/growing_tip.hpp"

namespace bempd::fracture {

// Line of the history: an event, or (event 0) the end of a step.
struct HistoryEntry {
  std::int64_t event = 0;
  std::int64_t total_broken_bonds = 0;
  double load_factor = 0;
  double stretch_ratio = 0;  // largest stretch over critical stretch just before the break; 1 where cracks grew
  double stored_energy = 0;
  double released_energy = 0;
  double work = 0;
  double energy_balance_error = 0;
  double residual = 0;
  // Load factor of the equilibrium path at which the bonds of the event just reach their critical stretch, and the
  // energy stored there after the event. At the end of a step: `load_factor` and `stored_energy`.
  double critical_load_factor = 0;
  double critical_stored_energy = 0;
  double bond_energy = 0;  // released by then, had each event happened there
  // Values just before the event; at the end of a step those at its end.
  double load_factor_before = 0;
  double stored_energy_before = 0;
  double work_before = 0;
  double resistance_before = 0;  // in equilibrium: what would be borne beyond it is divided by the stretch ratio [N]
  double resistance = 0;         // after it [N]
  std::int64_t ties = 0;         // others that would have grown at the event as soon
};

using CrackExtension = crack::Extension;

// State of the body at a load factor.
struct BodyState {
  double load_factor = 0;
  bool in_equilibrium = false;  // false before the first solution and after the host changed loads
  bool separated = false;
  double first_unit_energy = -1;       // energy of the proportional load alone when it was given; < 0: not known yet
  double largest_force = 0;            // largest internal nodal force met on the way: the measure of residuals
  coupling::Affine displacement;       // 2 * node + component
  Eigen::VectorXd total_displacement;  // at load_factor
  Eigen::VectorXd total_force;         // internal nodal forces at load_factor
  std::vector<std::uint8_t> stages;    // of every term in its law
  std::vector<coupling::HoldingSpring> springs;
  std::vector<char> unloaded;         // nodes whose loads have gone with a piece that came free
  std::vector<GrowingTip> tips;       // of cracks that grow as lines
  FaceState faces;                    // of cracks, where they can close
  std::vector<crack::TipId> stopped;  // tips with elements that cannot go on
};

// Resistance: the force that the body carries, as the pull in a tensile test. It is half the sum of the magnitudes of
// all support forces and nodal loads.
struct Resistance {
  double present = 0;    // after the last event [N]
  double peak = 0;       // the largest that was borne in equilibrium just before an event [N]
  double stiffness = 1;  // share that events have left of it, each at the loads of its own
};

// Counts and sums of a run.
struct Sums {
  std::int64_t events = 0;
  std::int64_t broken_bonds = 0;
  std::int64_t fragments = 0;
  double released_energy = 0;
  double bond_energy = 0;  // of it, what broken terms take; the rest would have become motion
  double work = 0;
  double largest_work = 0;
  double worst_energy_balance_error = 0;
  double residual = 0;  // at the last line of the history
  Resistance resistance;
  std::int64_t contact_switches = 0;  // places of faces that have closed or opened
  std::int64_t ties = 0;              // tips or places that would have grown at events as soon as those that did
  double work_out_of_balance = 0;     // of loads since equilibrium was lost, as far as it is stored
};

// Everything that a run changes: a copy saves the run. A Continuation is needed as well to continue with the same
// digits.
struct EvolutionState : BodyState, Sums {
  std::vector<HistoryEntry> history;
  // Values of supports, an x and a y for each support and line of the history. `reactions`: forces of the supports at
  // the line, `reactions_before`: just before its event [N]. `support_displacements`: mean prescribed displacement of
  // its nodes, NaN where a component is not prescribed [m].
  std::vector<double> reactions, reactions_before, support_displacements;
  std::vector<CrackExtension> extensions;
  // What lattice patches have followed: extensions by their places in the list, with a high bit if elements have got
  // what lies behind them (regions::gives_back), or broken bonds, each a number below 0
  // (regions::BrokenBondNearBorder).
  std::vector<std::int64_t> layouts;
};

}  // namespace bempd::fracture

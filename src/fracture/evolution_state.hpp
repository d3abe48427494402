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

// Entry of the history: an event, or the end of a step (event 0).
struct HistoryEntry {
  std::int64_t event = 0;
  std::int64_t total_broken_bonds = 0;
  double load_factor = 0;
  // Largest stretch over critical stretch of the event's bonds, or equivalent stress intensity factor over toughness of
  // its tip, just before the event.
  double stretch_ratio = 0;
  double stored_energy = 0;
  double released_energy = 0;
  double work = 0;
  double energy_balance_error = 0;
  double residual = 0;
  // Load factor on the equilibrium path at which the event's bonds or tip just become critical; in an entry for the end
  // of a step, the load factor of the entry.
  double critical_load_factor = 0;
  // Stored energy after the event, at the critical load factor [J]; in an entry for the end of a step, the stored
  // energy.
  double critical_stored_energy = 0;
  double bond_energy = 0;  // energy released so far, had each event happened at its critical load factor [J]
  // Load factor, and energies [J], just before the event; in an entry for the end of a step, the present values.
  double load_factor_before = 0;
  double stored_energy_before = 0;
  double work_before = 0;
  double resistance_before = 0;  // in equilibrium: a force out of equilibrium is divided by the stretch ratio [N]
  double resistance = 0;         // after the event [N]
  std::int64_t ties = 0;         // other tips or places that would have grown at the same load factor
};

using CrackExtension = crack::Extension;

// State of the body at a load factor.
struct BodyState {
  double load_factor = 0;
  bool in_equilibrium = false;  // false before the first solution, and after the host has changed loads
  bool separated = false;
  double first_unit_energy = -1;       // energy of the proportional load alone when it was given; < 0: not known yet
  double largest_force = 0;            // largest internal nodal force so far [N], by which residuals are measured
  coupling::Affine displacement;       // row 2 * node + component
  Eigen::VectorXd total_displacement;  // at the load factor
  Eigen::VectorXd total_force;         // internal nodal forces at the load factor
  std::vector<std::uint8_t> stages;    // damage stage of every term
  std::vector<coupling::HoldingSpring> springs;  // springs that hold freed parts
  std::vector<char> unloaded;                    // flags of nodes whose loads have gone with a piece that came free
  std::vector<GrowingTip> tips;                  // tips of crack lines (cracks that grow in a lattice by steps)
  FaceState faces;                               // contact state of crack faces
  std::vector<crack::TipId> stopped;             // tips in boundary elements that cannot grow
};

// Resistance: the force that the body carries, half the sum of the magnitudes of all support forces and nodal loads. In
// a tensile test it is the tensile force.
struct Resistance {
  double present = 0;  // resistance after the last event [N]
  double peak = 0;     // largest resistance in equilibrium just before an event [N]
  // Share of the body's stiffness that events have left: product over all events of the resistance after the event
  // divided by the resistance before.
  double stiffness = 1;
};

// Counts of events and breaks, and sums of energies [J], over a run.
struct Sums {
  std::int64_t events = 0;
  std::int64_t broken_bonds = 0;
  std::int64_t fragments = 0;
  double released_energy = 0;
  double bond_energy = 0;  // part of the released energy that broken terms take
  double work = 0;
  double largest_work = 0;
  double worst_energy_balance_error = 0;
  double residual = 0;  // at the last entry of the history
  Resistance resistance;
  std::int64_t contact_switches = 0;  // contact places that have closed or opened
  std::int64_t ties = 0;              // tips or places that would have grown at the same load factor as an event
  // Work of the loads since equilibrium was lost, less the part that became kinetic energy [J].
  double work_out_of_balance = 0;
};

// State of a run: everything that the run changes, so that a copy saves it. To continue with the same digits, a run
// needs its Continuation as well.
struct EvolutionState : BodyState, Sums {
  std::vector<HistoryEntry> history;
  // Values of supports at each entry of the history: an x and a y for each support. `reactions` are the forces of the
  // supports at the entry, `reactions_before` those just before its event [N]. `support_displacements` are the mean
  // prescribed displacements of the nodes of the support, NaN where a component is not prescribed [m].
  std::vector<double> reactions, reactions_before, support_displacements;
  std::vector<CrackExtension> extensions;
  // Enlargements of lattice patches (lattices that follow cracks), in order. An entry is the place in `extensions` of
  // the extension that a patch has followed, with a high bit if boundary elements have replaced the lattice behind the
  // tip (regions::gives_back); or a number below 0 for broken bonds near the border of a patch
  // (regions::BrokenBondNearBorder).
  std::vector<std::int64_t> layouts;
};

}  // namespace bempd::fracture

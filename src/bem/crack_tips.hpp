#pragma once

#include <Eigen/Core>
#include <vector>

#include "bem/crack_forces.hpp"
#include "bem/cracked_operator.hpp"
#include "bem/interior.hpp"
#include "elasticity/griffith.hpp"

namespace bempd::bem {

// Solution for a cracked body.
struct CrackedState {
  Eigen::VectorXd displacements;  // [m]
  Eigen::VectorXd openings;       // [m], all of them
  Eigen::VectorXd tractions;      // [Pa], of the boundary
  FaceTraction face_traction;     // of the cracks, if there is any
  bool faces_press = false;       // where they meet: factors K_I are >= 0
  std::vector<char> closed = {};  // nodes of openings where they do
};

// Energy release rate and stress intensity factors of a tip. Axes at a tip are the direction in which the crack would
// go straight on, and the one to the left of it.
struct StressIntensity {
  double energy_release_rate;  // [J/m^2]
  Point factors;               // K_I, K_II [Pa m^(1/2)]; K_I < 0: faces would overlap
};

// Stress intensities of every tip in each of `states`, as [tip][state]. The energy release rate is the derivative of
// the energy by the position a of the tip with everything else held: a virtual crack extension (deLorenzi, Eng. Fract.
// Mech. 21, 1985) with the forms of the boundary elements,
//   G = -(1/h) d/da [1/2 u^T K u - f^T u] = -G_shear [1/2 u^T D' u + t^T B' u] + f'^T u / h.
// G is split between the modes in the ratio of the squared openings next to the tip.
std::vector<std::vector<StressIntensity>> stress_intensities(const CrackedOperator& body,
                                                             const std::vector<CrackedState>& states);

// Evaluator of displacement and stress inside a cracked body in the given state. It serves for all pieces on the
// boundary, whose elements have their numbers in the body's mesh.
InteriorEvaluator interior_of_body(const CrackedOperator& body, const CrackedState& state);

// Evaluator of displacement and stress inside one piece of a cracked body in the given state.
InteriorEvaluator interior_of_piece(const CrackedOperator& body, const CrackedState& state, int piece);

// T-stress [Pa] of every tip: the constant stress along the crack, besides the singular field. On the line of a
// straight crack its own openings give equal stresses along and across it. So T is the difference of the stresses along
// and across that all other sources give at the tip, plus the normal stress of loads on the faces.
std::vector<double> stresses_along_crack(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

#pragma once

#include <Eigen/Core>
#include <vector>

#include "bem/crack_forces.hpp"
#include "bem/cracked_operator.hpp"
#include "bem/interior.hpp"
#include "elasticity/griffith.hpp"

namespace bempd::bem {

// State of a cracked body.
struct CrackedState {
  Eigen::VectorXd displacements;  // [m]
  Eigen::VectorXd openings;       // [m], all of them
  Eigen::VectorXd tractions;      // [Pa], of the boundary
  FaceTraction face_traction;     // of the cracks, if there is any
  bool faces_press = false;       // where they meet: factors K_I are >= 0
  std::vector<char> closed = {};  // nodes of openings where they do
};

// Energy release rate and stress intensity factors of a tip. Its axes are the direction in which it leads on, and the
// one to the left of that.
struct StressIntensity {
  double energy_release_rate;  // [J/m^2]
  Point factors;               // K_I, K_II [Pa m^(1/2)]; K_I < 0: faces would overlap
};

// Stress intensities of every tip in each of some states. The energy release rate is the derivative of the energy with
// respect to the position of the tip, everything else held (virtual crack extension, deLorenzi, Eng. Fract. Mech. 21,
// 1985, with the boundary's own forms):
//   G = -(1/h) d/da [1/2 u^T K u - f^T u] = -G_shear [1/2 u^T D' u + t^T B' u] + f'^T u / h.
// The modes share G in the ratio of the squared openings next to the tip.
std::vector<std::vector<StressIntensity>> stress_intensities(const CrackedOperator& body,
                                                             const std::vector<CrackedState>& states);

// Evaluator of displacement and stress inside one piece of a body in such a state.
InteriorEvaluator interior_of_piece(const CrackedOperator& body, const CrackedState& state, int piece);

// T-stress [Pa] of every tip: the constant stress along the crack beside the singular field. On the line of a straight
// crack its own openings give equal stresses along and across it. So T is the difference of the two stresses that all
// other sources give at the tip, plus the normal stress of loads on the faces.
std::vector<double> stresses_along_crack(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

#pragma once

#include <Eigen/Core>
#include <vector>

#include "bem/crack_forces.hpp"
#include "bem/cracked_operator.hpp"
#include "bem/interior.hpp"

namespace bempd::bem {

// Solution for a cracked body: displacements, openings and tractions.
struct CrackedState {
  Eigen::VectorXd displacements;  // [m]
  Eigen::VectorXd openings;       // [m], of all opening nodes
  Eigen::VectorXd tractions;      // [Pa], of the boundary's traction nodes
  FaceTraction face_traction;     // traction on crack faces; empty: none
  bool faces_press = false;       // whether closed faces press on each other instead of overlapping: K_I >= 0
  std::vector<char> closed = {};  // flags of the opening nodes at which faces press
};

// Energy release rate and stress intensity factors of a tip, and the axes to which they belong: the direction of
// straight growth, and the direction to its left.
struct StressIntensity {
  double energy_release_rate;  // [J/m^2]
  Point factors;               // K_I, K_II [Pa m^(1/2)]; K_I < 0: faces would overlap
};

// Stress intensities of every tip in each of `states`, as [tip][state]. The energy release rate G is the derivative of
// the energy by the position a of the tip with the solution held: a virtual crack extension (deLorenzi, Eng. Fract.
// Mech. 21, 1985) with the boundary element matrices,
//   G = -(1/h) d/da [1/2 u^T K u - f^T u] = -G_shear [1/2 u^T D' u + t^T B' u] + f'^T u / h.
// u are displacements and openings, f forces, t scaled tractions; K is the stiffness, D the hypersingular matrix, B the
// double layer, h the thickness and G_shear the shear modulus; primes are derivatives by a. G is split between the
// modes in the ratio of the squared openings next to the tip.
std::vector<std::vector<StressIntensity>> stress_intensities(const CrackedOperator& body,
                                                             const std::vector<CrackedState>& states);

// Evaluator of displacement and stress in a cracked body in the given state. In a body that is cut into pieces it
// serves for places on the boundary, whose elements have the numbers of the body's mesh; interior_of_piece() serves for
// places inside.
InteriorEvaluator interior_of_body(const CrackedOperator& body, const CrackedState& state);

// Evaluator of displacement and stress inside one piece of a cracked body in the given state.
InteriorEvaluator interior_of_piece(const CrackedOperator& body, const CrackedState& state, int piece);

// T-stress [Pa] of every tip: the constant stress along the crack, besides the singular field. On the line of a
// straight crack, its own openings give equal stresses along and across the crack. T is therefore the stress along the
// crack less the stress across it, both due to all other sources, plus the normal traction of loads on the faces.
std::vector<double> stresses_along_crack(const CrackedOperator& body, const CrackedState& state);

}  // namespace bempd::bem

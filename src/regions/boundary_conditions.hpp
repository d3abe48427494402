#pragma once

#include <map>
#include <vector>

#include "coupling/affine.hpp"
#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Uniform pressure of a fluid on the faces of a crack that cuts bonds, as an affine function of the load factor [Pa].
struct CrackPressure {
  int crack;                 // id
  Eigen::RowVector2d value;  // constant and proportional part
};

// Supports and loads of the scene as values on its degrees of freedom, numbered 2 * node + component.
struct DofConditions {
  std::vector<char> prescribed;        // per degree of freedom
  coupling::Affine displacement;       // of prescribed degrees of freedom [m]
  coupling::Affine force;              // [N]
  coupling::Affine body_force;         // x, y, growth of every region, from 3 * (region - 1) on; part of `force`
  std::vector<CrackLoad> crack_loads;  // their effect on nodes is part of `force`
  std::vector<CrackPressure> crack_pressures;   // follow as cracks grow; not part of `force`
  std::vector<std::vector<int>> reaction_dofs;  // per support; a shared degree of freedom counts for the first one

  // Swelling strains that temperature loads cause, by region id; their effect is not part of `force`.
  std::map<int, std::vector<Swelling>> swelling;

  std::vector<std::vector<int>> held_dofs;  // degrees of freedom of each support, also those that count for another one

  // Gaps of crack faces due to loads inside regions (body forces, loads on faces), for the exact contact constraints of
  // all regions, one region after the other [m].
  coupling::Affine face_offsets{0, 2};

  // Work of the loads that `force` does not include, as a quadratic form W: at the load factor f it is (1, f) W (1,
  // f)^T / 2 [J].
  Eigen::Matrix2d work_within = Eigen::Matrix2d::Zero();

  // Body forces at a load factor, one for each region id from 1 on.
  std::vector<BodyForce> body_forces(double load_factor) const;
};

// Body force of one region (an id) out of `all`, which is DofConditions::body_force: parts[0] times its constant part
// plus parts[1] times its proportional part.
BodyForce body_force_of(const coupling::Affine& all, int region, const Eigen::Vector2d& parts);

// Applies all supports and loads of the scene. Throws Error (argument) for supports that contradict each other,
// tractions on interfaces, and places without a node.
DofConditions apply_conditions(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

#pragma once

#include <map>
#include <vector>

#include "coupling/affine.hpp"
#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Pressure of a fluid in a crack among bonds [Pa].
struct CrackPressure {
  int crack;                 // id
  Eigen::RowVector2d value;  // constant and proportional part
};

// Supports and loads as values on the degrees of freedom of the scene's nodes (2 * node + component).
struct DofConditions {
  std::vector<char> prescribed;        // per degree of freedom
  coupling::Affine displacement;       // of prescribed degrees of freedom [m]
  coupling::Affine force;              // [N]
  coupling::Affine body_force;         // x, y, growth of every region, from 3 * (region - 1) on; part of `force`
  std::vector<CrackLoad> crack_loads;  // their effect on nodes is part of `force`
  std::vector<CrackPressure> crack_pressures;   // follow as cracks grow; not part of `force`
  std::vector<std::vector<int>> reaction_dofs;  // per support; a shared degree of freedom counts for the first one

  // Swelling of materials, by the ids of regions; it is not part of `force`.
  std::map<int, std::vector<Swelling>> swelling;

  std::vector<std::vector<int>> held_dofs;  // degrees of freedom of each support, also those that count for another one

  // Gaps that loads inside regions cause at cracks that can close, by regions.
  coupling::Affine face_offsets{0, 2};

  // Work of loads that `force` does not include: half of (1, f) within (1, f) at the load factor f [J].
  Eigen::Matrix2d work_within = Eigen::Matrix2d::Zero();

  // Body forces of all regions at a load factor.
  std::vector<BodyForce> body_forces(double load_factor) const;
};

// Body force of one region in DofConditions::body_force: the sum of its two parts times `parts`.
BodyForce body_force_of(const coupling::Affine& all, int region, const Eigen::Vector2d& parts);

// Applies supports and loads. Throws Error (argument) for contradictory supports, tractions on interfaces, and places
// without a node.
DofConditions apply_conditions(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

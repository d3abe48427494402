#pragma once

#include <map>
#include <vector>

#include "coupling/affine.hpp"
#include "elasticity/free_swelling.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Uniform pressure of a fluid on the faces of a crack that cuts bonds, as an affine function of the load factor [Pa].
struct CrackPressure {
  int crack;                 // id of the crack
  Eigen::RowVector2d value;  // constant part, and part proportional to the load factor
};

// Supports and loads of the scene as values on its degrees of freedom, numbered 2 * node + component.
struct DofConditions {
  std::vector<char> prescribed;        // flag of each degree of freedom: 1 if a support prescribes its displacement
  coupling::Affine displacement;       // displacements of prescribed degrees of freedom [m]
  coupling::Affine force;              // nodal forces [N]
  coupling::Affine body_force;         // BodyForce (x, y, growth) of region r from row 3 (r - 1) on; part of `force`
  std::vector<CrackLoad> crack_loads;  // on cracks with elements; their nodal forces are part of `force`

  // Pressures of fluids in cracks that cut bonds, not part of `force`. A pressure also acts on the faces that growth of
  // its crack adds.
  std::vector<CrackPressure> crack_pressures;

  // Degrees of freedom whose reactions count for a support, by support. A degree of freedom of several supports counts
  // for the first of them.
  std::vector<std::vector<int>> reaction_dofs;

  // Swelling strains due to temperature loads, by region id; `force` does not include their effect.
  std::map<int, std::vector<Swelling>> swelling;

  // All degrees of freedom that a support holds, by support. Unlike in `reaction_dofs`, one that several supports hold
  // is listed for each of them.
  std::vector<std::vector<int>> held_dofs;

  // Gaps of crack faces due to loads inside regions (body forces, loads on crack faces), one for each exact contact
  // constraint [m]. The constraints are ordered by region.
  coupling::Affine face_offsets{0, 2};

  // Work of the loads that `force` does not include [J], as the matrix W of a quadratic form: at the load factor f, and
  // with the column c = (1, f), the work is c^T W c / 2.
  Eigen::Matrix2d work_within = Eigen::Matrix2d::Zero();

  // Body forces at a load factor, one for each region id from 1 on.
  std::vector<BodyForce> body_forces(double load_factor) const;
};

// Body force of the region with the id `region`, taken from `all` (DofConditions::body_force): parts[0] times its
// constant part plus parts[1] times its proportional part.
BodyForce body_force_of(const coupling::Affine& all, int region, const Eigen::Vector2d& parts);

// Applies all supports and loads of the scene. Throws Error (argument) for supports that contradict each other,
// tractions on interfaces, and places without a node.
DofConditions apply_conditions(const scene::Scene& scene, const Discretization& discretization);

}  // namespace bempd::regions

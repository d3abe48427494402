#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Any isotropic material on a lattice. Central bonds alone have one Poisson's ratio, that of lambda = mu. Here the
// bonds have lambda = mu = beta = min(mu, (lambda + mu) / 2), and the rest of the energy is squares of what the four
// corners of a cell do (d1, d2: elongations of its diagonals; a, b: of its horizontal and its vertical edges; h:
// thickness):
//   lambda > mu: h (lambda - mu) / 4 (d1 + d2)^2
//   lambda < mu: h m / 4 (d1 - d2)^2 + h m / 8 (a1 + a2 - b1 - b2)^2,  m = (mu - lambda) / 2
// since d1 + d2 is the dilatation at the cell's centre times sqrt(2) and the spacing, d1 - d2 twice the shear strain
// times the same, and a1 + a2 - b1 - b2 the difference of the normal strains times two spacings. Under a constant
// strain the forces of the cells around a point add up to the stress times its surface vector: so faces, corners, holes
// and interfaces need no correction. All stiffnesses are positive for every ratio above -1.
//
// Docs: materials.md.

// Whether bonds alone make the material, up to 1e-6 of Poisson's ratio (a ratio typed with six digits is enough).
bool is_bond_based(const PlaneElasticity& elasticity);

// Modulus beta of the bonds, per volume [Pa].
double bond_modulus(const PlaneElasticity& elasticity);

// C1111 of the bonds [Pa].
double bond_c1111(const PlaneElasticity& elasticity);

// Stress (xx, yy, xy) of the bonds alone under a strain.
Eigen::Vector3d bond_stress(const Eigen::Vector3d& strain, const PlaneElasticity& elasticity);

// Square term k/2 (sum of pull . u)^2 over the corners of a cell: lower left, lower right, upper left, upper right.
struct CellSquare {
  std::array<Eigen::Vector2d, 4> pull;
  double stiffness;  // k [N/m], thickness included
};

// Mean over the cell of the stress (xx, yy, xy) that a unit of force in the square makes, for spacing and thickness 1.
Eigen::Vector3d unit_stress(const CellSquare& square);

// Squares of one cell, the same for every cell; none for a bond-based material.
std::vector<CellSquare> cell_squares(const PlaneElasticity& elasticity);

// Cell with its own bonds, along edges and diagonals. When the first of these breaks, the squares of the cell are lost.
struct Cell {
  Eigen::Vector2i lower_left;
  std::array<int, 4> corners;
  std::vector<int> bonds;
};

std::vector<Cell> cells_with_bonds(const CellLattice& lattice, const std::vector<Bond>& bonds);

}  // namespace bempd::pd

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/network.hpp"

namespace bempd::pd {

// Isotropic materials of any Poisson's ratio on a lattice. Central bonds alone can have only one Poisson's ratio, that
// of lambda = mu. Here the bonds have lambda = mu = beta = min(mu, (lambda + mu) / 2). The rest of the energy of a
// lattice cell consists of cell squares: energy terms that are squares of combinations of the displacements of its four
// corners,
//   lambda > mu: h (lambda - mu) / 4 (d1 + d2)^2
//   lambda < mu: h m / 4 (d1 - d2)^2 + h m / 8 (a1 + a2 - b1 - b2)^2,  m = (mu - lambda) / 2
// with the elongations d1, d2 of the diagonals, a1, a2 of the horizontal and b1, b2 of the vertical edges, and the
// thickness h. The sum d1 + d2 is the dilatation at the cell's centre times sqrt(2) and the spacing, d1 - d2 is twice
// the shear strain times the same factors, and a1 + a2 - b1 - b2 is the difference of the normal strains times two
// spacings. Under a constant strain the forces of the cells around a point add up to the stress times the point's
// surface vector. Faces, corners, holes and interfaces therefore need no correction. All stiffnesses are positive for
// every ratio above -1.
//
// Docs: materials.md.

// Whether bonds alone represent the material, without cell squares: its Poisson's ratio is that of lambda = mu up to
// 1e-6, so that a ratio given with six digits is recognized.
bool is_bond_based(const PlaneElasticity& elasticity);

// Modulus beta of the bonds: Lame's constants lambda and mu of a material of the bonds alone, which are equal [Pa].
double bond_modulus(const PlaneElasticity& elasticity);

// Elastic constant C1111 of the bonds alone [Pa].
double bond_c1111(const PlaneElasticity& elasticity);

// Stress (xx, yy, xy) of the bonds alone under a strain (xx, yy, xy).
Eigen::Vector3d bond_stress(const Eigen::Vector3d& strain, const PlaneElasticity& elasticity);

// Cell square: energy term k/2 (p1 . u1 + p2 . u2 + p3 . u3 + p4 . u4)^2 of a lattice cell. The corners, with the
// displacements u1 to u4, are lower left, lower right, upper left and upper right. The vectors p1 to p4 (`pull`) are
// the forces on the corners per unit of the square's tension, which is k times the sum.
struct CellSquare {
  std::array<Eigen::Vector2d, 4> pull;
  double stiffness;  // k [N/m], thickness included
};

// Mean stress (xx, yy, xy) in a cell whose cell square has the tension 1, for spacing 1 and thickness 1.
Eigen::Vector3d unit_stress(const CellSquare& square);

// Cell squares of one cell, the same for every cell of the material; none for a bond-based material.
std::vector<CellSquare> cell_squares(const PlaneElasticity& elasticity);

// Lattice cell with its own bonds, which lie along its edges and diagonals. When the first of these bonds breaks, the
// cell loses its cell squares.
struct Cell {
  Eigen::Vector2i lower_left;
  std::array<int, 4> corners;
  std::vector<int> bonds;
};

std::vector<Cell> cells_with_bonds(const CellLattice& lattice, const std::vector<Bond>& bonds);

}  // namespace bempd::pd

#pragma once

#include <span>
#include <vector>

#include "pd/outlined/outlined_body.hpp"

namespace bempd::pd {

// Gradient stencils of patches (groups of cells, cell_patches.hpp) for a body with any outline, in units of the
// spacing. A stencil consists of vectors G_i such that the sum of G_i u_i^T is the patch's area times the mean gradient
// of the displacement; this is exact for linear displacements. In a single cell G_i is the surface vector of the cell's
// polygon at the point. Over all patches, the G of a point add up to the point's surface vector, so that a constant
// stress is balanced by its tractions on the chords. If surface vectors have factors (surface_balance.hpp), patches at
// the outline also use points of neighbouring patches, so that the sums include the factors.
struct CellStencils {
  std::vector<std::size_t> start{0}, bond_start{0};  // first point and bond of each patch, and the end of the last
  std::vector<int> point;                            // points of each patch, its own before those of neighbours
  std::vector<Eigen::Vector2d> gradient;             // the vectors G of these points
  std::vector<double> share;                         // part of the patch's area that belongs to the point
  std::vector<double> area;
  std::vector<int> bond;  // bonds of each patch; a patch loses its squares when its first bond breaks
  double max_residual = 0;

  std::size_t count() const { return area.size(); }
  std::span<const int> points(std::size_t patch) const { return of(patch, start, point); }
  std::span<const Eigen::Vector2d> gradients(std::size_t patch) const { return of(patch, start, gradient); }
  std::span<const double> shares(std::size_t patch) const { return of(patch, start, share); }
  std::span<const int> bonds(std::size_t patch) const { return of(patch, bond_start, bond); }
  // Whether there are no stencils, because bonds alone reproduce the elasticity of the material.
  bool empty() const { return area.empty(); }

 private:
  template <class Value>
  static std::span<const Value> of(std::size_t patch, const std::vector<std::size_t>& starts,
                                   const std::vector<Value>& values) {
    return {values.data() + starts[patch], starts[patch + 1] - starts[patch]};
  }
};

// Makes the stencils of all patches: whole lattice cells, and groups of two or three triangles. Stencils of single
// triangles would be too many constraints, with which nearly incompressible bodies could hardly deform.
CellStencils cell_stencils(const OutlinedBody& body);

// Cell square of a patch of any shape: energy term k/2 (sum of p_i . u_i)^2, with the displacements u_i of the points
// of the patch's stencil. The vectors p_i (`pull`) are the forces on the points per unit of the square's tension, which
// is k times the sum (as in cell_squares.hpp).
struct StencilSquare {
  std::vector<Eigen::Vector2d> pull;
  double stiffness;  // k [N/m], thickness included
};
std::vector<StencilSquare> squares_of(const CellStencils& stencils, std::size_t patch,
                                      const PlaneElasticity& elasticity);

}  // namespace bempd::pd

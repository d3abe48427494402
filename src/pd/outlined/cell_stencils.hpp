#pragma once

#include <span>
#include <vector>

#include "pd/cell_squares.hpp"
#include "pd/outlined/outlined_body.hpp"

namespace bempd::pd {

// What cells of a body with any outline feel of a displacement, in units of the spacing: G_i with
// sum of G_i u_i^T = the cell's area times the mean gradient of the displacement, exact for linear ones. For a polygon
// between its points G_i is its surface vector at the point. Over all cells the G of a point add up to its surface
// vector: a stress that is the same in all cells is balanced by its traction on the chords. Where the surface vectors
// have factors (surface_balance.hpp) cells at the outline feel a little of their neighbours' points as well, so that
// they add up to those.
struct CellStencils {
  std::vector<std::size_t> start{0}, bond_start{0};  // per cell, and the end of the last
  std::vector<int> point, corners;                   // corners: how many of a cell's points are its own; they come first
  std::vector<Eigen::Vector2d> gradient;             // G
  std::vector<double> area;
  std::vector<int> bond;  // with the first of which what a cell carries is gone
  double max_residual = 0;

  std::size_t count() const { return area.size(); }
  std::span<const int> points(std::size_t cell) const {
    return {point.data() + start[cell], start[cell + 1] - start[cell]};
  }
  std::span<const Eigen::Vector2d> gradients(std::size_t cell) const {
    return {gradient.data() + start[cell], start[cell + 1] - start[cell]};
  }
  std::span<const int> bonds(std::size_t cell) const {
    return {bond.data() + bond_start[cell], bond_start[cell + 1] - bond_start[cell]};
  }
  // Empty if bonds alone make the material.
  bool empty() const { return area.empty(); }
};

// In the order of the body's cells.
CellStencils cell_stencils(const OutlinedBody& body);

// The squares of cells (cell_squares.hpp) of any shape: k/2 (sum of pull_i . u_i)^2 over the points of a stencil.
struct StencilSquare {
  std::vector<Eigen::Vector2d> pull;
  double stiffness;  // k [N/m], thickness included
};
std::vector<StencilSquare> squares_of(const CellStencils& stencils, std::size_t cell, const PlaneElasticity& elasticity);

}  // namespace bempd::pd

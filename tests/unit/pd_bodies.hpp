#pragma once

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <string>
#include <vector>

#include "pd/cell_squares.hpp"
#include "pd/face_loads.hpp"
#include "pd/network.hpp"

// Bodies and a plain solver that the tests of the peridynamic layer share.
namespace bempd::pd::test {

using Eigen::Vector2i;
using Loop = std::vector<Vector2i>;

inline Loop rectangle(int x, int y, int width, int height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}
inline Loop hole(int x, int y, int width, int height) {
  Loop loop = rectangle(x, y, width, height);
  std::reverse(loop.begin(), loop.end());
  return loop;
}
// Steps of `step` cells going down from the upper left to the lower right on a base of the given height.
inline Loop staircase(int steps, int step, int base) {
  const int width = steps * step + base;
  Loop loop{{0, 0}, {width, 0}, {width, base}};
  for (int k = 0; k < steps; ++k) {
    loop.push_back({width - (k + 1) * step, base + k * step});
    loop.push_back({width - (k + 1) * step, base + (k + 1) * step});
  }
  loop.push_back({0, base + steps * step});
  return loop;
}

struct Body {
  std::string name;
  std::vector<Loop> loops;
};

inline std::vector<Body> bodies() {
  return {{"square", {rectangle(-3, 5, 24, 24)}},
          {"rectangle", {rectangle(0, 0, 40, 13)}},
          {"three cells wide", {rectangle(0, 0, 3, 30)}},
          {"two cells wide", {rectangle(0, 0, 30, 2)}},
          {"one cell wide", {rectangle(0, 0, 1, 20)}},
          {"three by three", {rectangle(0, 0, 3, 3)}},
          {"one cell", {rectangle(0, 0, 1, 1)}},
          {"L", {{{0, 0}, {24, 0}, {24, 11}, {10, 11}, {10, 26}, {0, 26}}}},
          {"thin L", {{{0, 0}, {24, 0}, {24, 3}, {2, 3}, {2, 26}, {0, 26}}}},
          {"rectangular hole", {rectangle(0, 0, 30, 24), hole(9, 8, 8, 7)}},
          {"inner slit", {rectangle(0, 0, 30, 24), hole(9, 12, 12, 1)}},
          {"edge slit", {{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 11}, {8, 11}, {8, 10}, {0, 10}}}},
          {"fine staircase", {staircase(10, 1, 6)}},
          {"coarse staircase", {staircase(4, 3, 8)}},
          {"plate with a tail", {{{0, 0}, {14, 0}, {14, 14}, {8, 14}, {8, 24}, {7, 24}, {7, 14}, {0, 14}}}}};
}

inline std::vector<Point> points_of(const CellLattice& lattice, const Point& shift = {0, 0}) {
  std::vector<Point> points;
  for (int i = 0; i < lattice.point_count(); ++i) points.push_back(lattice.point(i).cast<double>() + shift);
  return points;
}

inline PlaneElasticity bond_based(double young_modulus, PlaneState state, double thickness) {
  return {young_modulus, bond_based_poisson_ratio(state), state, thickness};
}

// The squares of all cells of a material, none by default: visit(corners, square).
template <class Visit>
void each_square(const CellLattice& lattice, const std::vector<CellSquare>& squares, const Visit& visit) {
  for (int i = 0; i < lattice.point_count() && !squares.empty(); ++i) {
    if (!lattice.has_cell(lattice.point(i))) continue;
    for (const CellSquare& square : squares) visit(lattice.cell_corners(lattice.point(i)), square);
  }
}

inline Eigen::SparseMatrix<double> stiffness_matrix(const CellLattice& lattice, const Network& network,
                                                    const std::vector<CellSquare>& squares = {}) {
  std::vector<Eigen::Triplet<double>> entries;
  each_square(lattice, squares, [&](const std::array<int, 4>& corners, const CellSquare& square) {
    for (int r = 0; r < 8; ++r) {
      for (int c = 0; c < 8; ++c)
        entries.emplace_back(2 * corners[r / 2] + r % 2, 2 * corners[c / 2] + c % 2,
                             square.stiffness * square.pull[r / 2][r % 2] * square.pull[c / 2][c % 2]);
    }
  });
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const Bond& bond = network.bonds[b];
    const Eigen::Vector2d e = network.offsets[network.offset_of[b]].direction;
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) {
        const double k = bond.stiffness * e[r] * e[c];
        entries.emplace_back(2 * bond.first + r, 2 * bond.first + c, k);
        entries.emplace_back(2 * bond.second + r, 2 * bond.second + c, k);
        entries.emplace_back(2 * bond.first + r, 2 * bond.second + c, -k);
        entries.emplace_back(2 * bond.second + r, 2 * bond.first + c, -k);
      }
    }
  }
  const int n = 2 * lattice.point_count();
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// f - K u, bond by bond and in extended precision: slender bodies magnify the rounding of an assembled matrix.
inline Eigen::VectorXd unbalanced_forces(const CellLattice& lattice, const Network& network,
                                         const std::vector<CellSquare>& squares, const Eigen::VectorXd& forces,
                                         const Eigen::VectorXd& u) {
  Eigen::Matrix<long double, Eigen::Dynamic, 1> rest = forces.cast<long double>();
  for (const Bond& bond : network.bonds) {
    const Eigen::Matrix<long double, 2, 1> step =
        (lattice.point(bond.second) - lattice.point(bond.first)).cast<long double>();
    const Eigen::Matrix<long double, 2, 1> difference =
        u.segment<2>(2 * bond.second).cast<long double>() - u.segment<2>(2 * bond.first).cast<long double>();
    const Eigen::Matrix<long double, 2, 1> force = bond.stiffness * step.dot(difference) / step.squaredNorm() * step;
    rest.segment<2>(2 * bond.first) += force;
    rest.segment<2>(2 * bond.second) -= force;
  }
  each_square(lattice, squares, [&](const std::array<int, 4>& corners, const CellSquare& square) {
    long double elongation = 0;
    for (int k = 0; k < 4; ++k)
      elongation += square.pull[k].cast<long double>().dot(u.segment<2>(2 * corners[k]).cast<long double>());
    for (int k = 0; k < 4; ++k)
      rest.segment<2>(2 * corners[k]) -= square.stiffness * elongation * square.pull[k].cast<long double>();
  });
  return rest.cast<double>();
}

// Solves K u = f with three displacement components fixed at given values, which prevent rigid motions.
inline Eigen::VectorXd solve_pinned(const CellLattice& lattice, const Network& network, const Eigen::VectorXd& forces,
                                    const Eigen::VectorXd& known, const std::vector<CellSquare>& squares = {}) {
  // The third component holds the rotation with the longest lever: the far end of the lower or of the left face.
  const Vector2i p = lattice.point(0);
  int right = 0, top = 0;
  for (int i = 0; i < lattice.point_count(); ++i) {
    if (lattice.point(i).y() == p.y() && lattice.point(i).x() > lattice.point(right).x()) right = i;
    if (lattice.point(i).x() == p.x() && lattice.point(i).y() > lattice.point(top).y()) top = i;
  }
  const bool wide = (lattice.point(right) - p).x() >= (lattice.point(top) - p).y();
  std::vector<char> fixed(forces.size(), 0);
  fixed[0] = fixed[1] = fixed[wide ? 2 * right + 1 : 2 * top] = 1;
  Eigen::SparseMatrix<double> matrix = stiffness_matrix(lattice, network, squares);
  matrix.prune([&](Eigen::Index r, Eigen::Index c, double) { return r == c || (!fixed[r] && !fixed[c]); });
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(forces.size());
  for (Eigen::Index d = 0; d < u.size(); ++d) u[d] = fixed[d] ? known[d] : 0;
  for (int round = 0; round < 4; ++round) {
    Eigen::VectorXd rest = unbalanced_forces(lattice, network, squares, forces, u);
    for (Eigen::Index d = 0; d < u.size(); ++d) rest[d] = fixed[d] ? 0 : rest[d];
    u += factor.solve(rest);
  }
  return u;
}

// Nodal forces of a stress field on all faces of a body, in units of thickness and spacing.
template <class Stress>
Eigen::VectorXd boundary_forces(const CellLattice& lattice, const std::vector<Loop>& loops, const Stress& stress) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * lattice.point_count());
  for (const Loop& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point a = loop[k].cast<double>(), b = loop[(k + 1) % loop.size()].cast<double>();
      const Point along = (b - a).normalized(), normal(along.y(), -along.x());
      add_face_forces(
          lattice, a, b, [&](const Point& x) { return Point(stress(x) * normal); }, forces);
    }
  }
  return forces;
}

}  // namespace bempd::pd::test

#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/edge.hpp"
#include "geometry/smooth_curve.hpp"
#include "pd/cell_squares.hpp"
#include "pd/outlined/cell_stencils.hpp"
#include "pd/outlined/outlined_body.hpp"

// Outlines of every kind, for bodies with points on them.
namespace bempd::pd::test {

using Loops = std::vector<std::vector<Arc>>;

inline constexpr double degree = std::numbers::pi / 180;

inline std::vector<Arc> polygon(const std::vector<Point>& vertices) {
  std::vector<Arc> loop;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    loop.push_back({vertices[k], vertices[(k + 1) % vertices.size()], 0});
  return loop;
}

inline std::vector<Arc> circle(const Point& centre, double radius, bool hole) {
  std::vector<Arc> loop;
  const double turn = hole ? -1 : 1;
  const auto at = [&](int k) {
    const double angle = turn * k * 90 * degree;
    return Point(centre + radius * Point(std::cos(angle), std::sin(angle)));
  };
  for (int k = 0; k < 4; ++k) loop.push_back({at(k), at((k + 1) % 4), turn * 90 * degree});
  return loop;
}

inline std::vector<Arc> smooth_loop(const std::vector<Point>& points) {
  std::vector<Arc> loop;
  for (const Edge& edge : smooth_curve(points, true))
    for (int k = 0; k < edge.piece_count(); ++k) loop.push_back(edge.piece(k));
  return loop;
}

inline Point turned(const Point& p, double angle) {
  return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

inline std::vector<Point> turned(std::vector<Point> points, double angle) {
  for (Point& p : points) p = turned(p, angle);
  return points;
}

inline std::vector<Point> box(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

// A triangle's tip of the given angle at the origin, its other corners cut to more than 90 degrees.
inline std::vector<Point> wedge(double alpha, double length) {
  const Point a(length, 0), b(length * std::cos(alpha), length * std::sin(alpha));
  const Point out = Point(std::cos(0.5 * alpha), std::sin(0.5 * alpha));
  return {{0, 0}, a, a + 0.6 * length * out, b + 0.6 * length * out, b};
}

// A square with a notch whose re-entrant corner has the given angle.
inline std::vector<Point> notched(double alpha) {
  const double half = 0.5 * (2 * std::numbers::pi - alpha), depth = 9;
  const double opening = depth * std::tan(std::min(half, 80 * degree));
  return {{-opening - 8, 0}, {-opening - 8, -20}, {opening + 8, -20}, {opening + 8, 0},
          {opening, 0},      {0, -depth},         {-opening, 0}};
}

struct NamedOutline {
  std::string name;
  Loops loops;
};

// C1111 = thickness = 1.
inline constexpr PlaneElasticity bonds_alone{8.0 / 9, 1.0 / 3, PlaneState::stress, 1};

inline OutlinedBody body_of(const Loops& loops, const LatticePlace& place, int m,
                            const PlaneElasticity& elasticity = bonds_alone) {
  return build_outlined_body(make_chords(loops), place, m, elasticity, 1);
}

// Forces of the squares of cells under a displacement.
inline void add_forces_of_squares(const CellStencils& stencils, const PlaneElasticity& elasticity,
                                  const std::vector<Point>& displacement, std::vector<Point>& forces) {
  for (std::size_t c = 0; c < stencils.count(); ++c) {
    const std::span<const int> at = stencils.points(c);
    for (const StencilSquare& square : squares_of(stencils, c, elasticity)) {
      double elongation = 0;
      for (std::size_t k = 0; k < at.size(); ++k) elongation += square.pull[k].dot(displacement[at[k]]);
      for (std::size_t k = 0; k < at.size(); ++k) forces[at[k]] -= square.stiffness * elongation * square.pull[k];
    }
  }
}

// Largest error of the forces that a linear displacement makes against those of its constant stress on the chords, from
// scratch and over the elastic constant.
inline double patch_error(const OutlinedBody& body, const PlaneElasticity& elasticity = bonds_alone) {
  double largest = 0;
  CellStencils stencils;
  if (!is_bond_based(elasticity)) stencils = cell_stencils(body);
  for (const Eigen::Vector3d& strain : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    Eigen::Matrix2d gradient, stress;
    gradient << strain.x(), strain.z(), strain.z(), strain.y();
    stress =
        elasticity.c12() * gradient.trace() * Eigen::Matrix2d::Identity() + 2 * elasticity.shear_modulus() * gradient;
    std::vector<Point> rest(body.points.size(), Point::Zero()), displacement;
    for (const Point& p : body.points) displacement.emplace_back(gradient * p);
    add_forces_of_squares(stencils, elasticity, displacement, rest);
    for (const Bond& bond : body.network.bonds) {
      const Point step = body.points[bond.second] - body.points[bond.first];
      const Point force = bond.stiffness * step.dot(gradient * step) / step.squaredNorm() * step;
      rest[bond.first] += force, rest[bond.second] -= force;
    }
    for (int i = 0; i < body.chords.count(); ++i) rest[i] += body.factors[i] * (stress * body.chords.surface_vector(i));
    for (const Point& r : rest) largest = std::max(largest, r.lpNorm<Eigen::Infinity>());
  }
  return largest / elasticity.c11();
}

}  // namespace bempd::pd::test

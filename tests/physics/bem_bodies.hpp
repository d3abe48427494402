#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bem/boundary_loads.hpp"
#include "dense.hpp"
#include "elasticity/plane_elasticity.hpp"
#include "geometry/boundary_mesh.hpp"

// Bodies and reference fields shared by the tests of the boundary element layer.
namespace bempd::bem_test {

using Field = std::function<Point(const Point&)>;

// Polygon with about `target` long elements; `grading` > 1 refines towards the corners.
inline std::vector<Panel> polygon(const std::vector<Point>& corners, double target, double grading = 1) {
  std::vector<Panel> loop;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point &from = corners[k], &to = corners[(k + 1) % corners.size()];
    loop.push_back({from, to, element_stations((to - from).norm(), target, grading)});
  }
  return loop;
}

inline std::vector<Panel> rectangle(double length, double height, double target, double grading = 1,
                                    const Point& low = Point::Zero()) {
  return polygon({low, low + Point(length, 0), low + Point(length, height), low + Point(0, height)}, target, grading);
}

struct Body {
  std::string name;
  std::vector<std::vector<Panel>> loops;
  Point inside;  // some interior point

  std::vector<Panel> panels() const {
    std::vector<Panel> all;
    for (const auto& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
    return all;
  }
};

inline std::vector<Body> bodies() {
  const std::vector<Point> l_shape{{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
  const std::vector<Point> wedge{{0, 0}, {1, 0}, {0.9, 0.25}};
  const std::vector<Point> notched{{-1, -1}, {1, -1}, {1, 1}, {0.15, 1}, {0, 0}, {-0.15, 1}, {-1, 1}};
  // A hole's loop runs clockwise.
  const std::vector<Point> hole{{0.3, 0.3}, {0.3, 0.6}, {0.7, 0.6}, {0.7, 0.3}};
  std::vector<Body> all;
  all.push_back({"rectangle", {rectangle(1, 0.2, 0.1)}, {0.43, 0.08}});
  all.push_back({"L-shape", {polygon(l_shape, 0.2)}, {0.2, 0.31}});
  all.push_back({"plate with square hole", {rectangle(1, 1, 0.2), polygon(hole, 0.15)}, {0.2, 0.2}});
  all.push_back({"graded rectangle 1:128", {rectangle(1, 0.6, 1.0 / 15, 2.0)}, {0.5, 0.3}});
  all.push_back({"wedge of 15.5 degrees", {polygon(wedge, 0.12)}, {0.7, 0.1}});
  all.push_back({"notched plate", {polygon(notched, 0.25)}, {0.5, 0.1}});
  all.push_back({"coarse thin strip 1:50", {rectangle(1, 0.02, 0.1)}, {0.5, 0.01}});
  return all;
}

// Linear displacement field u = shift + gradient x and its stress.
struct LinearField {
  Point shift;
  Eigen::Matrix2d gradient, stress;

  LinearField(const PlaneElasticity& elasticity, const Point& u0, const Eigen::Matrix2d& h) : shift(u0), gradient(h) {
    const double shear = elasticity.shear_modulus() * (h(0, 1) + h(1, 0));
    stress << elasticity.c11() * h(0, 0) + elasticity.c12() * h(1, 1), shear, shear,
        elasticity.c11() * h(1, 1) + elasticity.c12() * h(0, 0);
  }
  Point displacement(const Point& x) const { return shift + gradient * x; }
  Point traction(const Point& normal) const { return stress * normal; }
};

inline Point outward_normal(const Panel& panel) {
  const Point along = (panel.end - panel.start).normalized();
  return {along.y(), -along.x()};
}

inline Eigen::VectorXd nodal_values(const BoundaryMesh& mesh, const Field& field) {
  Eigen::VectorXd values(2 * mesh.nodes.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) values.segment<2>(2 * n) = field(mesh.nodes[n]);
  return values;
}

// Tractions of a stress field on the traction nodes.
inline Eigen::VectorXd nodal_tractions(const BoundaryMesh& mesh, const std::vector<Panel>& panels,
                                       const std::function<Eigen::Matrix2d(const Point&)>& stress) {
  Eigen::VectorXd values(2 * mesh.traction_node_count);
  for (const BoundaryElement& e : mesh.elements)
    for (int k = 0; k < 3; ++k)
      values.segment<2>(2 * e.traction_nodes[k]) = stress(mesh.nodes[e.nodes[k]]) * outward_normal(panels[e.panel]);
  return values;
}

inline Eigen::VectorXd nodal_forces(const BoundaryMesh& mesh, const std::vector<Panel>& panels,
                                    const std::function<Eigen::Matrix2d(const Point&)>& stress, double thickness) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * mesh.nodes.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Point normal = outward_normal(panels[p]);
    bem::add_traction_forces(
        mesh, static_cast<int>(p), [&](const Point& x) -> Point { return stress(x) * normal; }, thickness, forces);
  }
  return forces;
}

// Solves K u = f with the given values where `fixed`.
inline Eigen::VectorXd solve_supported(const Eigen::MatrixXd& k, const Eigen::VectorXd& f,
                                       const std::vector<bool>& fixed, const Eigen::VectorXd& values) {
  // Held rows become those of the identity: the matrix stays symmetric and positive definite.
  Eigen::MatrixXd matrix = k;
  Eigen::VectorXd right = f, held = Eigen::VectorXd::Zero(f.size());
  const double diagonal = k.diagonal().maxCoeff();
  for (int i = 0; i < f.size(); ++i)
    if (fixed[i]) held[i] = values[i];
  right -= k * held;
  for (int i = 0; i < f.size(); ++i) {
    if (!fixed[i]) continue;
    matrix.row(i).setZero();
    matrix.col(i).setZero();
    matrix(i, i) = diagonal;
    right[i] = diagonal * values[i];
  }
  return dense::solve(matrix, right);
}

inline std::vector<bool> fixed_on_panel(const BoundaryMesh& mesh, int panel) {
  std::vector<bool> fixed(2 * mesh.nodes.size(), false);
  for (const BoundaryElement& e : mesh.elements)
    if (e.panel == panel)
      for (const int n : e.nodes) fixed[2 * n] = fixed[2 * n + 1] = true;
  return fixed;
}

// Three components of two nodes far apart: just enough to stop rigid motions.
inline std::vector<bool> fixed_rigid_motions(const BoundaryMesh& mesh) {
  std::vector<bool> fixed(2 * mesh.nodes.size(), false);
  std::size_t far = 0;
  for (std::size_t n = 1; n < mesh.nodes.size(); ++n)
    if (std::abs(mesh.nodes[n].x() - mesh.nodes[0].x()) > std::abs(mesh.nodes[far].x() - mesh.nodes[0].x())) far = n;
  fixed[0] = fixed[1] = fixed[2 * far + 1] = true;
  return fixed;
}

// Solves K u = f with the given values where `fixed`; K need not be symmetric.
inline Eigen::VectorXd solve_unsymmetric(const Eigen::MatrixXd& k, const Eigen::VectorXd& f,
                                         const std::vector<bool>& fixed, const Eigen::VectorXd& values) {
  Eigen::MatrixXd matrix = k;
  Eigen::VectorXd right = f;
  const double diagonal = k.diagonal().maxCoeff();
  for (int i = 0; i < f.size(); ++i) {
    if (!fixed[i]) continue;
    matrix.row(i).setZero();
    matrix(i, i) = diagonal;
    right[i] = diagonal * values[i];
  }
  return dense::solve(matrix, right);
}

}  // namespace bempd::bem_test

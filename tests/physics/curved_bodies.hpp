#pragma once

#include <numbers>

#include "physics/bem_bodies.hpp"

// Bodies with circular edges, and reference values on them.
namespace bempd::bem_test {

inline Panel arc_panel(const Point& start, const Point& end, double sweep, double target, double grading = 1) {
  const Arc arc{start, end, sweep};
  return {start, end, element_stations(arc.length(), target, grading, sweep), sweep};
}

// Full circle of quarters, counter-clockwise or, for a hole, clockwise.
inline std::vector<Panel> circle(const Point& centre, double radius, double target, double direction = 1) {
  std::vector<Panel> loop;
  const auto at = [&](int quarter) -> Point {
    const double angle = direction * 0.5 * std::numbers::pi * quarter;
    return centre + radius * Point(std::cos(angle), std::sin(angle));
  };
  for (int k = 0; k < 4; ++k) loop.push_back(arc_panel(at(k), at(k + 1), direction * 0.5 * std::numbers::pi, target));
  return loop;
}

inline std::vector<Body> curved_bodies() {
  std::vector<Body> all;
  all.push_back({"disk of 8 elements", {circle({0, 0}, 1, 10)}, {0.3, 0.2}});
  all.push_back({"disk of 32 elements", {circle({0, 0}, 1, 0.2)}, {0.3, 0.2}});
  all.push_back({"ring", {circle({1, 1}, 1, 0.4), circle({1, 1}, 0.7, 0.3, -1)}, {1.85, 1}});
  all.push_back({"plate with eccentric hole", {rectangle(2, 1, 0.25), circle({0.6, 0.6}, 0.35, 0.2, -1)}, {1.5, 0.3}});
  // Rounded notch, and lens with ends of 57 degrees; graded towards the ends.
  std::vector<Panel> notched = polygon({{-1, -1}, {1, -1}, {1, 1}, {0.2, 1}, {0.2, 0.1}}, 0.3);
  notched.pop_back();
  notched.push_back(arc_panel({0.2, 0.1}, {-0.2, 0.1}, -std::numbers::pi, 0.15));
  notched.push_back({{-0.2, 0.1}, {-0.2, 1}, element_stations(0.9, 0.3)});
  notched.push_back({{-0.2, 1}, {-1, 1}, element_stations(0.8, 0.3)});
  notched.push_back({{-1, 1}, {-1, -1}, element_stations(2, 0.3)});
  all.push_back({"plate with rounded notch", {notched}, {0.7, 0.1}});
  all.push_back({"lens", {{arc_panel({-1, 0}, {1, 0}, 1, 0.2, 1.5), arc_panel({1, 0}, {-1, 0}, 1, 0.2, 1.5)}}, {0, 0}});
  // Nearly straight sides: radius a thousand and a million times the side.
  all.push_back({"flat arcs",
                 {{arc_panel({0, 0}, {1, 0}, 1e-3, 0.2), arc_panel({1, 0}, {1, 1}, 1e-6, 0.2),
                   arc_panel({1, 1}, {0, 1}, -1e-9, 0.2), arc_panel({0, 1}, {0, 0}, -1e-12, 0.2)}},
                 {0.4, 0.6}});
  return all;
}

// Outward normal of a panel at one of its points.
inline Point outward_normal(const Panel& panel, const Point& x) {
  const Arc arc = panel.arc();
  const Point along = arc.tangent(closest_fraction(arc, x));
  return {along.y(), -along.x()};
}

using StressField = std::function<Eigen::Matrix2d(const Point&)>;

inline Eigen::VectorXd curved_tractions(const BoundaryMesh& mesh, const std::vector<Panel>& panels,
                                        const StressField& stress) {
  Eigen::VectorXd values(2 * mesh.traction_node_count);
  for (const BoundaryElement& e : mesh.elements)
    for (int k = 0; k < 3; ++k) {
      const Point& x = mesh.nodes[e.nodes[k]];
      values.segment<2>(2 * e.traction_nodes[k]) = stress(x) * outward_normal(panels[e.panel], x);
    }
  return values;
}

inline Eigen::VectorXd curved_forces(const BoundaryMesh& mesh, const std::vector<Panel>& panels,
                                     const StressField& stress, double thickness) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * mesh.nodes.size());
  for (std::size_t p = 0; p < panels.size(); ++p)
    bem::add_traction_forces(
        mesh, static_cast<int>(p), [&](const Point& x) -> Point { return stress(x) * outward_normal(panels[p], x); },
        thickness, forces);
  return forces;
}

}  // namespace bempd::bem_test

#include "bem/boundary_slopes.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::bem {

namespace {

// Five consecutive nodes of the boundary, with their arc lengths `at` along a piece of constant curvature.
struct Row {
  std::array<int, 5> nodes;
  std::array<double, 5> at;
  double curvature;

  double chord(int i, int j) const {
    const double distance = at[i] - at[j];
    return curvature == 0 ? distance : 2 / curvature * std::sin(0.5 * curvature * distance);
  }
};

// Derivative along the boundary, at node `k`, of the interpolation of `values` through all five nodes: by Lagrange's
// polynomial on straight pieces, by Gauss's trigonometric formula on arcs.
Point derivative_at(const Row& row, int k, const Eigen::VectorXd& values) {
  const auto value = [&](int i) -> Point { return values.segment<2>(2 * row.nodes[i]); };
  Point sum = Point::Zero();
  for (int i = 0; i < 5; ++i) {
    if (i == k) continue;
    double weight = 1 / row.chord(i, k);
    for (int j = 0; j < 5; ++j)
      if (j != i && j != k) weight *= row.chord(k, j) / row.chord(i, j);
    sum += weight * (value(i) - value(k));
  }
  return sum;
}

double length_of(const BoundaryMesh& mesh, const BoundaryElement& e) {
  return Arc{mesh.nodes[e.nodes[0]], mesh.nodes[e.nodes[2]], e.sweep}.length();
}

// Whether the mid node lies halfway along the line or arc between the end nodes. If it does not, the element is a
// parabola, whose arc lengths do not follow from its end nodes.
bool has_even_nodes(const BoundaryMesh& mesh, const BoundaryElement& e) {
  const Arc arc{mesh.nodes[e.nodes[0]], mesh.nodes[e.nodes[2]], e.sweep};
  return (arc.at(0.5) - mesh.nodes[e.nodes[1]]).norm() <= 1e-9 * arc.length();
}

}  // namespace

std::vector<ElementSlopes> boundary_slopes(const BoundaryMesh& mesh, const Eigen::VectorXd& displacements) {
  constexpr double similar = 2;
  const int count = static_cast<int>(mesh.elements.size());
  std::vector<ElementSlopes> slopes(mesh.elements.size());
  for (int e = 0; e + 1 < count; ++e) {
    const BoundaryElement &a = mesh.elements[e], &b = mesh.elements[e + 1];
    if (a.panel != b.panel || a.nodes[2] != b.nodes[0]) continue;
    if (!has_even_nodes(mesh, a) || !has_even_nodes(mesh, b)) continue;
    const double first = length_of(mesh, a), second = length_of(mesh, b);
    const Row row{{a.nodes[0], a.nodes[1], a.nodes[2], b.nodes[1], b.nodes[2]},
                  {0, 0.5 * first, first, first + 0.5 * second, first + second},
                  a.sweep / first};
    const auto set = [&](int element, int end, int k) {
      slopes[element].known[end] = true;
      slopes[element].slope[end] = derivative_at(row, k, displacements);
    };
    set(e, 1, 2);
    set(e + 1, 0, 2);
    if (std::max(first, second) > similar * std::min(first, second)) continue;
    const auto same_panel = [&](int other) { return mesh.elements[(other + count) % count].panel == a.panel; };
    if (e == 0 || !same_panel(e - 1)) set(e, 0, 0);
    if (e + 2 == count || !same_panel(e + 2)) set(e + 1, 1, 4);
  }
  return slopes;
}

}  // namespace bempd::bem

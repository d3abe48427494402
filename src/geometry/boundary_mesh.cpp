#include "geometry/boundary_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd {

namespace {

// Relative rounding error of a coordinate that was computed in a few steps.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

Point point_at(const Panel& panel, double fraction) {
  if (panel.sweep != 0) return panel.arc().at(fraction);
  return fraction >= 1 ? panel.end : Point(panel.start + fraction * (panel.end - panel.start));
}

Point middle_of(const Panel& panel, double from, double to) {
  if (panel.sweep != 0) return point_at(panel, 0.5 * (from + to));
  return 0.5 * (point_at(panel, from) + point_at(panel, to));
}

void add_loop(const std::vector<Panel>& panels, int first_panel, BoundaryMesh& mesh) {
  const int first_node = static_cast<int>(mesh.nodes.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Panel& panel = panels[p];
    const std::size_t element_count = panel.stations.size() - 1;
    int traction = mesh.traction_node_count;
    for (std::size_t e = 0; e < element_count; ++e) {
      const bool closes = p + 1 == panels.size() && e + 1 == element_count;
      const double from = panel.stations[e], to = panel.stations[e + 1];
      const int node = static_cast<int>(mesh.nodes.size());
      mesh.nodes.push_back(point_at(panel, from));
      mesh.nodes.push_back(middle_of(panel, from, to));
      mesh.elements.push_back({{node, node + 1, closes ? first_node : node + 2},
                               {traction, traction + 1, traction + 2},
                               first_panel + static_cast<int>(p),
                               (to - from) * panel.sweep});
      traction += 2;
    }
    mesh.traction_node_count = traction + 1;
  }
}

}  // namespace

BoundaryMesh mesh_boundary(const std::vector<std::vector<Panel>>& loops) {
  BoundaryMesh mesh;
  int first_panel = 0;
  for (const auto& loop : loops) {
    add_loop(loop, first_panel, mesh);
    first_panel += static_cast<int>(loop.size());
  }
  return mesh;
}

bool differ_by_translation(const BoundaryMesh& a, const BoundaryMesh& b) {
  if (a.nodes.size() != b.nodes.size() || a.traction_node_count != b.traction_node_count) return false;
  const auto same = [](const BoundaryElement& e, const BoundaryElement& f) {
    return e.nodes == f.nodes && e.traction_nodes == f.traction_nodes && e.panel == f.panel &&
           std::abs(e.sweep - f.sweep) <= rounding * std::abs(e.sweep);
  };
  if (!std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(), same)) return false;
  double largest = 0;
  for (const BoundaryMesh* mesh : {&a, &b}) {
    for (const Point& p : mesh->nodes) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  }
  const Point shift = b.nodes.front() - a.nodes.front();
  return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), [&](const Point& p, const Point& q) {
    return (q - p - shift).lpNorm<Eigen::Infinity>() <= rounding * largest;
  });
}

std::vector<double> element_stations(double length, double target, double grading, double sweep) {
  // The count is reduced by 1e-9, so that a count that is whole up to rounding is not increased.
  const double turns = std::abs(sweep) / largest_element_sweep;
  const int count = std::max(1, static_cast<int>(std::ceil(std::max(length / target, turns) * (1 - 1e-9))));
  std::vector<double> stations(count + 1, 0.0);
  for (int i = 0; i < count; ++i) {
    const int from_end = std::min(i, count - 1 - i);
    stations[i + 1] = stations[i] + std::pow(grading, from_end);
  }
  const double total = stations.back();
  for (double& s : stations) s /= total;
  stations.back() = 1;
  return stations;
}

}  // namespace bempd

#include "pd/face_loads.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bempd::pd {

namespace {

// Abscissas of the Gauss rule with four points on [-1, 1].
constexpr double gauss_abscissa[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
constexpr double gauss_weight[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};

}  // namespace

void for_forces_on_cell_edges(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                              const CellEdgeVisitor& visit) {
  const int along = std::abs(b.x() - a.x()) >= std::abs(b.y() - a.y()) ? 0 : 1, across = 1 - along;
  const int line = static_cast<int>(std::lround(a[across]));
  assert(std::abs(a[across] - line) < 1e-9 && std::abs(b[across] - line) < 1e-9);
  // An end that misses a material point by rounding only is moved to that point.
  const auto snapped = [](double s) { return std::abs(s - std::round(s)) < 1e-9 ? std::round(s) : s; };
  const double from = snapped(std::min(a[along], b[along])), to = snapped(std::max(a[along], b[along]));
  for (int edge = static_cast<int>(std::floor(from)); edge < to; ++edge) {
    Eigen::Vector2i lower_end;
    lower_end[along] = edge;
    lower_end[across] = line;
    const double start = std::max(from, static_cast<double>(edge)), half = 0.5 * (std::min(to, edge + 1.0) - start);
    for (int g = 0; g < 4; ++g) {
      Point at;
      at[along] = start + half * (1 + gauss_abscissa[g]);
      at[across] = line;
      visit(lower_end, along, at[along] - edge, gauss_weight[g] * half * traction(at));
    }
  }
}

void add_face_forces(const CellLattice& lattice, const Point& a, const Point& b,
                     const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces) {
  assert(forces.size() == 2 * lattice.point_count());
  for_forces_on_cell_edges(a, b, traction, [&](const Eigen::Vector2i& end, int along, double s, const Point& force) {
    const int i = lattice.find_point(end), j = lattice.find_point(end + Eigen::Vector2i::Unit(along));
    assert(i >= 0 && j >= 0);
    forces.segment<2>(2 * i) += (1 - s) * force;
    forces.segment<2>(2 * j) += s * force;
  });
}

}  // namespace bempd::pd

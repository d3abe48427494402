#include "pd/face_loads.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace bempd::pd {

namespace {

// Gauss-Legendre rule with four points on [0, 1], exact to degree 7.
constexpr std::array<double, 4> gauss_point{0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                            0.93056815579702629};
constexpr std::array<double, 4> gauss_weight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                             0.17392742256872693};

// Pieces of a cell edge shorter than this are the rounding of fractions of an edge.
constexpr double negligible = 1e-12;

}  // namespace

void add_face_forces(const CellLattice& lattice, const Point& a, const Point& b,
                     const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces) {
  const Point direction = (b - a).normalized();
  const double first = a.dot(direction), last = b.dot(direction);
  const Point base = a - first * direction;  // place with coordinate 0 along the line
  const auto point_at = [&](double along) {
    const Point p = base + along * direction;
    const int point = lattice.find_point({static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))});
    assert(point >= 0);
    return point;
  };
  for (double cell = std::floor(first); cell < last; cell += 1) {
    const double from = std::max(first, cell), to = std::min(last, cell + 1);
    if (to - from < negligible) continue;
    const int start = point_at(cell), end = point_at(cell + 1);
    for (std::size_t q = 0; q < gauss_point.size(); ++q) {
      const double along = from + gauss_point[q] * (to - from);
      const Point force = gauss_weight[q] * (to - from) * traction(base + along * direction);
      forces.segment<2>(2 * start) += (cell + 1 - along) * force;
      forces.segment<2>(2 * end) += (along - cell) * force;
    }
  }
}

}  // namespace bempd::pd

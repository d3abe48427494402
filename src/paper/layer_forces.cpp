#include "paper/layer_forces.hpp"

#include <algorithm>
#include <cassert>

#include "pd/face_loads.hpp"

namespace bempd::paper {

void add_layer_forces(const pd::CellLattice& centres, const Point& a, const Point& b,
                      const std::function<Point(const Point&)>& traction, Eigen::Ref<Eigen::VectorXd> forces) {
  assert(forces.size() == 2 * centres.point_count());
  pd::for_forces_on_cell_edges(a, b, traction, [&](const Eigen::Vector2i& end, int along, double, const Point& force) {
    const int ahead = centres.find_point(end), behind = centres.find_point(end - Eigen::Vector2i::Unit(1 - along));
    assert((ahead >= 0) != (behind >= 0));
    forces.segment<2>(2 * std::max(ahead, behind)) += force;
  });
}

}  // namespace bempd::paper

#include "fracture/line/point_moments.hpp"

namespace bempd::fracture {

namespace {

Eigen::Vector3d moment_of_wide(const coupling::Terms& terms, const std::vector<Point>& positions, std::size_t wide,
                               int node, const Point& direction) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  int nodes = 0;
  terms.for_each_entry(wide, [&](int at, double x, double y) {
    const Point pull(x, y), arm = positions[static_cast<std::size_t>(at)] - positions[static_cast<std::size_t>(node)];
    const double along = pull.dot(direction), across = cross(direction, pull);
    const double arm_along = arm.dot(direction), arm_across = cross(direction, arm);
    moment += Eigen::Vector3d(along * arm_along, across * arm_across, (along * arm_across + across * arm_along) / 2);
    ++nodes;
  });
  return moment / nodes;
}

}  // namespace

Eigen::Vector3d moment_at(const coupling::Terms& terms, const std::vector<Point>& positions, std::size_t term, int node,
                          const Point& direction) {
  if (terms.is_wide(term)) return moment_of_wide(terms, positions, term, node, direction);
  const Point e(terms.cosine[term], terms.sine[term]);
  const double along = e.dot(direction), across = cross(direction, e);
  return terms.length[term] / 2 * Eigen::Vector3d(along * along, across * across, along * across);
}

}  // namespace bempd::fracture

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

// Throws Error (argument) if a peridynamic neighbour would have other points on the interface: the spacings must be
// equal, and the interface must end at lattice points of the neighbour.
void OutlinedRegion::require_common_points(const Preparation& preparation, const Contact& contact) const {
  const int other = contact.other_region + 1;
  const auto* points = dynamic_cast<const PeridynamicDescription*>(&preparation.scene.region(other));
  if (!points || outline().is_around(other)) return;
  require(std::abs(points->spacing() / spacing() - 1) < 1e-9, "peridynamic regions ", id(), " and ", other,
          " touch, but their spacings are ", spacing(), " and ", points->spacing(), "; give them the same one");
  const auto grid = preparation.node_grid(other);
  const Edge edge = preparation.scene.region(id()).edge(contact.edge + 1);
  for (const Point& end : {edge.at(contact.from), edge.at(contact.to)}) {
    const Point scaled = grid ? Point((end - grid->origin) / grid->spacing) : Point::Zero();
    const Point nearest = scaled.array().round();
    require((scaled - nearest).norm() < 1e-6, "peridynamic regions ", id(), " and ", other, " touch as far as (",
            end.x(), ", ", end.y(), "), which is not a lattice point of region ", other,
            "; move that corner to a multiple of the spacing ", spacing(), " from the region's corner");
  }
}

std::vector<Point> OutlinedRegion::interface_points(const Preparation& preparation, const Contact& own) {
  divide(preparation);
  return outline().places_on(preparation.scene.region(id()).edge(own.edge + 1), own);
}

// Ties the points on an interface to the elements of the region `leader`, as points of a row whose spacing is the
// length of the interface's chords.
void OutlinedRegion::follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const {
  const Point &start = leading.places.front(), &end = leading.places.back();
  std::vector<int> points;
  for (int i = 0; i < outline().chords().count(); ++i)
    if (point_at_node(i) >= 0 && distance(Segment{start, end}, position(point_at_node(i))) < 1e-6 * spacing())
      points.push_back(point_at_node(i));
  const auto along = [&](int i) { return (position(i) - start).dot(end - start); };
  std::sort(points.begin(), points.end(), [&](int i, int j) { return along(i) < along(j); });
  // An interface that ends at the mouth of a crack reaches half a chord beyond its last point.
  const double beyond = (position(points.front()) - start).norm() + (end - position(points.back())).norm();
  const double at_mouths = beyond > 1e-6 * spacing() ? beyond : 0;
  const double chord =
      points.size() > 1 ? ((end - start).norm() - at_mouths) / static_cast<double>(points.size() - 1) : spacing();
  tie(row_of(points, chord), leading, leader, ties);
}

}  // namespace bempd::regions

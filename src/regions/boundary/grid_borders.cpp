#include "regions/boundary/grid_borders.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "geometry/segment.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

namespace {

bool is_mouth(const std::vector<Point>& mouths, const Point& x, double tolerance) {
  return std::any_of(mouths.begin(), mouths.end(), [&](const Point& p) { return (p - x).norm() <= 8 * tolerance; });
}

}  // namespace

void require_grid_ends(const Preparation& p, const Contact& contact, const Arc& piece,
                       const std::vector<Point>& mouths) {
  const scene::Region& other = p.scene.region(contact.other_region + 1);
  const scene::NodeGrid grid = *p.node_grid(contact.other_region + 1);
  for (const Point& end : {piece.start, piece.end}) {
    if (is_mouth(mouths, end, p.tolerance)) continue;
    const Point scaled = (end - grid.origin) / grid.spacing;
    const Point nearest = scaled.array().round();
    require((scaled - nearest).norm() * grid.spacing <= 100 * p.tolerance, "the interface between region ",
            contact.region + 1, " and the ", other.adjective(), " region ", contact.other_region + 1, " ends at (",
            end.x(), ", ", end.y(), "), which is not a lattice point; move that corner to a multiple of the spacing ",
            grid.spacing, " from the ", other.adjective(), " region's corner, such as (",
            grid.origin.x() + grid.spacing * nearest.x(), ", ", grid.origin.y() + grid.spacing * nearest.y(), ")");
  }
}

std::vector<double> grid_stations(const Preparation& p, const Contact& contact, const Arc& piece, int step,
                                  const std::vector<Point>& mouths) {
  const double spacing = p.node_grid(contact.other_region + 1)->spacing;
  const double lead = is_mouth(mouths, piece.start, p.tolerance) ? 0.5 : 0;
  const double trail = is_mouth(mouths, piece.end, p.tolerance) ? 0.5 : 0;
  const int count = static_cast<int>(std::lround(piece.length() / spacing - lead - trail));
  std::vector<double> stations;
  if (lead > 0) stations.push_back(0);
  for (int i = 0; i < count; i += step) stations.push_back((lead + i) / (lead + count + trail));
  if (trail > 0) stations.push_back((lead + count) / (lead + count + trail));
  stations.push_back(1);
  return stations;
}

std::vector<Point> points_of_neighbour(const Preparation& p, OutlinedRegion& other, const PanelSource& source,
                                       const Contact& contact, const Arc& piece, const std::vector<Point>& mouths) {
  const auto theirs = [&](double fraction) {
    const double part = (fraction - contact.from) / (contact.to - contact.from);
    return contact.other_from + part * (contact.other_to - contact.other_from);
  };
  const bool at_mouth = is_mouth(mouths, piece.start, p.tolerance) || is_mouth(mouths, piece.end, p.tolerance);
  const double from = at_mouth ? contact.from : source.from, to = at_mouth ? contact.to : source.to;
  std::vector<Point> points = other.interface_points(
      p, {contact.other_region, contact.other_edge, theirs(to), theirs(from), contact.region, contact.edge, to, from});
  std::reverse(points.begin(), points.end());
  if (at_mouth) {
    const Segment straight{piece.start, piece.end};
    std::erase_if(points, [&](const Point& x) {
      const double along = (x - piece.start).dot(straight.direction()) / straight.length();
      return along <= 8 * p.tolerance || along >= straight.length() - 8 * p.tolerance;
    });
    points.insert(points.begin(), piece.start), points.push_back(piece.end);
  }
  points.front() = piece.start, points.back() = piece.end;
  return points;
}

}  // namespace bempd::regions

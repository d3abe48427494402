#include "regions/outlined/cell_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/edge_tree.hpp"
#include "pd/outlined/cell_patches.hpp"
#include "pd/outlined/chord_search.hpp"

namespace bempd::regions {

namespace {

constexpr double chord_deviation = 1e-5;   // distance of chords from their arc, in spacings
constexpr double negligible_share = 1e-9;  // share of a cell's area
constexpr double on_edge = 1e-9;           // tolerance of places on edges, in spacings

std::vector<Point> corners_of(const std::vector<Point>& points, const std::array<int, 4>& cell) {
  std::vector<Point> corners;
  for (int k = 0; k < pd::corner_count(cell); ++k) corners.push_back(points[cell[k]]);
  return corners;
}

double area_of(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * twice;
}

// Signed area of the part of `polygon` inside the polygon `convex` (Sutherland and Hodgman, Comm. ACM 17, 1974). If
// `polygon` is not convex, clipping may leave several parts, joined by lines along sides of `convex`; these lines
// enclose no area.
double area_within(const std::vector<Point>& convex, std::vector<Point> polygon) {
  for (std::size_t side = 0; side < convex.size() && !polygon.empty(); ++side) {
    const Point &a = convex[side], along = convex[(side + 1) % convex.size()] - a;
    std::vector<Point> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
      const double left = cross(along, from - a), left_of_to = cross(along, to - a);
      if (left >= 0) kept.push_back(from);
      if ((left >= 0) != (left_of_to >= 0)) kept.push_back(from + left / (left - left_of_to) * (to - from));
    }
    polygon = std::move(kept);
  }
  return area_of(polygon);
}

// Shape of a region of the body: its edges, and polygons that approximate its loops.
class RegionShape {
 public:
  explicit RegionShape(const std::vector<std::vector<Arc>>& loops) : edges_(edges(loops)) {
    for (const std::vector<Arc>& loop : loops) {
      polygons_.emplace_back();
      for (const Arc& arc : loop) {
        const double radius = arc.straight() ? 0 : arc.length() / std::abs(arc.sweep);
        const double count = arc.straight() ? 1 : std::ceil(arc.length() / std::sqrt(8 * chord_deviation * radius));
        for (int k = 0; k < count; ++k) polygons_.back().push_back(arc.at(k / count));
      }
    }
  }

  bool has(const Point& place) const { return edges_.locate(place, on_edge) == Location::inside; }
  double area_in(const std::vector<Point>& cell) const {
    Box box;
    for (const Point& corner : cell) box.extend(corner);
    if (!edges_.box.intersects(box)) return 0;
    double area = 0;
    for (const std::vector<Point>& polygon : polygons_) area += area_within(cell, polygon);
    return std::max(area, 0.0);
  }

 private:
  static std::vector<Edge> edges(const std::vector<std::vector<Arc>>& loops) {
    std::vector<Edge> all;
    for (const std::vector<Arc>& loop : loops)
      for (const Arc& arc : loop) all.emplace_back(arc);
    return all;
  }

  EdgeTree edges_;
  std::vector<std::vector<Point>> polygons_;
};

// Flags of cells near common edges.
std::vector<char> cells_near(const std::vector<Arc>& arcs, const std::vector<Point>& points,
                             const pd::FillingCells& cells) {
  constexpr double step = 1, margin = 0.25;  // an arc of one step rises less than the margin above its chord
  std::vector<char> found(cells.size(), 0);
  Box all;
  for (const Point& p : points) all.extend(p);
  pd::Buckets buckets(all, 2);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Box box;
    for (const int corner : cells[c]) box.extend(points[corner]);
    buckets.add(box, static_cast<int>(c));
  }
  for (const Arc& arc : arcs) {
    const double count = std::ceil(arc.length() / step);
    for (int k = 0; k < count; ++k) {
      const Point from = arc.at(k / count), to = arc.at((k + 1) / count), pad = Point::Constant(margin);
      buckets.any_near(Box(from.cwiseMin(to) - pad, from.cwiseMax(to) + pad), [&](int c) {
        found[static_cast<std::size_t>(c)] = 1;
        return false;
      });
    }
  }
  return found;
}

}  // namespace

std::vector<std::vector<CellPart>> parts_of_cells(const std::vector<Point>& points, const pd::FillingCells& cells,
                                                  const std::vector<std::vector<std::vector<Arc>>>& regions,
                                                  const std::vector<Arc>& common_edges) {
  const std::vector<RegionShape> shapes(regions.begin(), regions.end());
  const std::vector<char> is_near = cells_near(common_edges, points, cells);
  std::vector<std::vector<CellPart>> parts(regions.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::vector<Point> corners = corners_of(points, cells[c]);
    const auto cell = static_cast<int>(c);
    if (!is_near[c]) {
      Point middle = Point::Zero();
      for (const Point& corner : corners) middle += corner / static_cast<double>(corners.size());
      const auto found =
          std::find_if(shapes.begin(), shapes.end(), [&](const RegionShape& shape) { return shape.has(middle); });
      if (found != shapes.end()) {
        parts[static_cast<std::size_t>(found - shapes.begin())].push_back({cell, 1});
        continue;
      }
    }
    std::vector<double> areas;
    for (const RegionShape& shape : shapes) areas.push_back(shape.area_in(corners));
    const double least = negligible_share * area_of(corners);
    std::replace_if(
        areas.begin(), areas.end(), [&](double area) { return area < least; }, 0.0);
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (std::size_t r = 0; r < areas.size(); ++r)
      if (areas[r] > 0) parts[r].push_back({cell, areas[r] / sum});
  }
  return parts;
}

}  // namespace bempd::regions

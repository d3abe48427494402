#include "pd/outlined/filling_cells.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "cancellation.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector2i;
using Side = std::pair<int, int>;  // directed

// Advancing front of directed sides, with the area to be filled on their left. Each side forms a triangle with the
// point that sees it under the largest angle, which makes a constrained Delaunay triangulation (Shewchuk, 1997). If
// several such points lie on one circle, existing triangles decide between these points.
class Front {
 public:
  Front(const std::vector<Point>& points, const Box& box)
      : points_(points), near_points_(box, 2), near_sides_(box, 2) {}

  void add_point(int i) { near_points_.add(Box(points_[i]), i); }
  // Adds the directed side from a to b; the area on its right is filled already or lies outside.
  void add_side(int a, int b) {
    open_.insert({a, b});
    taken_.insert({b, a});
    store_side(a, b);
  }

  FillingCells triangulate() {
    FillingCells triangles;
    while (!open_.empty()) {
      check_cancelled();
      const auto [a, b] = *open_.begin();
      open_.erase(open_.begin());
      taken_.insert({a, b});
      const int c = best_point(a, b);
      if (c < 0) continue;  // no body there: chords that lie on each other up to rounding
      triangles.push_back({a, b, c, c});
      add_triangle_side(b, c), add_triangle_side(c, a);
    }
    return triangles;
  }

 private:
  void store_side(int a, int b) {
    Box box(points_[a]);
    box.extend(points_[b]);
    near_sides_.add(box, static_cast<int>(sides_.size()));
    sides_.push_back({a, b});
  }
  // Adds the directed side from a to b of a new triangle; the triangle lies on the left of the side.
  void add_triangle_side(int a, int b) {
    if (open_.erase({a, b}) == 0) {
      open_.insert({b, a});
      store_side(a, b);
    }
    taken_.insert({a, b});
  }

  bool is_free(int a, int b) const {
    if (taken_.count({a, b}) > 0) return false;
    Box box(points_[a]);
    box.extend(points_[b]);
    return !near_sides_.any_near(box, [&](int s) {
      const auto [c, d] = sides_[static_cast<std::size_t>(s)];
      if (c == a || c == b || d == a || d == b) return false;
      return proper_crossing({points_[a], points_[b]}, {points_[c], points_[d]}).has_value();
    });
  }

  int best_point(int a, int b) const {
    for (double reach = 2; reach < 40; reach *= 2)
      if (const int found = best_within(a, b, reach); found >= 0) return found;
    return -1;
  }
  int best_within(int a, int b, double reach) const {
    const Point &pa = points_[a], &pb = points_[b], middle = 0.5 * (pa + pb);
    const Box box(middle - Point::Constant(reach), middle + Point::Constant(reach));
    std::vector<std::pair<double, int>> candidates;  // by the cotangent of the angle
    near_points_.any_near(box, [&](int c) {
      const Point to_a = pa - points_[c], to_b = pb - points_[c];
      const double height = cross(to_a, to_b);
      if (c != a && c != b && height > 1e-9) candidates.emplace_back(to_a.dot(to_b) / height, c);
      return false;
    });
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [angle, c] : candidates)
      if (is_free(b, c) && is_free(c, a)) return c;
    return -1;
  }

  const std::vector<Point>& points_;
  Buckets near_points_, near_sides_;
  std::vector<Side> sides_;
  std::set<Side> open_, taken_;
};

void add_cell_sides(const OutlinedPoints& points, const Vector2i& at, Front& front, std::set<int>& used) {
  // Sides of the cell are taken counter-clockwise, each with the neighbour behind it.
  const std::array<Vector2i, 4> corners{at, at + Vector2i(1, 0), at + Vector2i(1, 1), at + Vector2i(0, 1)};
  const std::array<Vector2i, 4> behind{Vector2i(0, -1), Vector2i(1, 0), Vector2i(0, 1), Vector2i(-1, 0)};
  for (int k = 0; k < 4; ++k) {
    if (points.has_cell(at + behind[k])) continue;
    const int a = points.find_point(corners[k]), b = points.find_point(corners[(k + 1) % 4]);
    front.add_side(b, a);
    used.insert({a, b});
  }
}

}  // namespace

FillingCells fill_with_cells(const Chords& chords, const OutlinedPoints& points) {
  Box box;
  for (const Point& p : points.points()) box.extend(p);
  Front front(points.points(), box);
  FillingCells cells;
  std::set<int> at_front;
  std::vector<char> has_cell(points.points().size(), 0);
  for (const Chord& chord : chords.chords) {
    front.add_side(chord.first, chord.second);
    at_front.insert(chord.first);
  }
  for (int y = points.lower().y(); y < points.upper().y(); ++y) {
    for (int x = points.lower().x(); x < points.upper().x(); ++x) {
      const Vector2i at(x, y);
      if (!points.has_cell(at)) continue;
      cells.push_back({points.find_point(at), points.find_point(at + Vector2i(1, 0)),
                       points.find_point(at + Vector2i(1, 1)), points.find_point(at + Vector2i(0, 1))});
      for (const int corner : cells.back()) has_cell[corner] = 1;
      add_cell_sides(points, at, front, at_front);
    }
  }
  for (int i = points.outline_count(); i < points.count(); ++i)
    if (!has_cell[i]) at_front.insert(i);
  for (const int i : at_front) front.add_point(i);
  const FillingCells triangles = front.triangulate();
  cells.insert(cells.end(), triangles.begin(), triangles.end());
  return cells;
}

double area_of_corner(const std::vector<Point>& points, const std::array<int, 4>& cell) {
  if (!is_triangle(cell)) return 0.25;
  return 0.5 * cross(points[cell[1]] - points[cell[0]], points[cell[2]] - points[cell[0]]) / 3;
}

std::vector<double> areas_of_points(const std::vector<Point>& points, const FillingCells& cells) {
  std::vector<double> areas(points.size(), 0.0);
  for (const auto& cell : cells) {
    const double area = area_of_corner(points, cell);
    for (int k = 0; k < (is_triangle(cell) ? 3 : 4); ++k) areas[cell[k]] += area;
  }
  return areas;
}

}  // namespace bempd::pd
